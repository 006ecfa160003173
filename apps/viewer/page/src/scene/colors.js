// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import { ClampToEdgeWrapping, DataTexture, LinearFilter, NearestFilter, RGBAFormat } from 'three';

/** Viridis (Smith and van der Walt, 2015, public domain) at 33 even steps: perceptually uniform. */
const kViridis =
  '440154 470d60 48186a 482374 472d7b 453781 424086 3e4989 3b528b 375b8d 33638d 2f6b8e 2c728e 297a8e 26828e 23898e ' +
  '21918c 1f978b 1f9f88 21a685 27ad81 31b57b 3dbc74 4cc26c 5cc863 6ece58 81d34d 95d840 aadc32 c0df25 d5e21a eae51a ' +
  'fde725';

/** The colors of the species, distinct also for the color-blind; Okabe and Ito, 2008. */
const kSpecies = '0072b2 e69f00 009e73 cc79a7 56b4e9 d55e00 f0e442 8c8c8c';

/** Those that domains have besides, as distinct. */
const kMoreDomains = '332288 882255 663311 7dff9e 999933 ff3d7f 004d40 a98bf0';

/** The colors of events: red, green, blue from 0 to 1. */
export const kEventColors = {
  collision: color('d55e00'),
  wall: color('cc79a7'),
  merger: color('56b4e9'),
  enter: color('009e73'),
  leave: color('e69f00'),
};

/** The colors of windows of time, by how they end. */
export const kWindowColors = { committed: color('56b4e9'), failed: color('d55e00'), steps: color('e69f00') };

export const kSpeciesColors = colors(kSpecies);
export const kDomainColors = [...kSpeciesColors, ...colors(kMoreDomains)];
export const kMapColors = colors(kViridis);

/** "rgb(…)" of a color whose parts are from 0 to 1. */
export function toCss([red, green, blue]) {
  return `rgb(${[red, green, blue].map((part) => Math.round(255 * part)).join(' ')})`;
}

/** A texture of the colors in `list` side by side, blended if `isSmooth`. */
export function colorTexture(list, isSmooth) {
  const data = new Uint8Array(list.flatMap((entry) => [...entry.map((part) => Math.round(255 * part)), 255]));
  const texture = new DataTexture(data, list.length, 1, RGBAFormat);
  texture.magFilter = texture.minFilter = isSmooth ? LinearFilter : NearestFilter;
  texture.wrapS = texture.wrapT = ClampToEdgeWrapping;
  texture.needsUpdate = true;
  return texture;
}

function colors(text) {
  return text.split(' ').map(color);
}

function color(hexadecimal) {
  return [0, 2, 4].map((start) => parseInt(hexadecimal.slice(start, start + 2), 16) / 255);
}

/** Kinematic spheres tend to this color. */
export const kKinematicColor = color('8a8f98');

/** Of arrows along velocities, and of trails. */
export const kArrowColor = color('b3361a');
export const kTrailColor = color('7d8794');

/** Of bonds between spheres. */
export const kBondColor = color('c98a1b');

const kWallColor = color('66789a');
const kObstacleColor = color('4a4f58');
const kCold = color('2166ac');
const kHot = color('c9361f');

/** A color for each of `surfaces`: thermal ones from cold to hot, the others gray. */
export function surfaceColors(surfaces) {
  const temperatures = surfaces.map((surface) => surface.temperature).filter((value) => value !== null);
  const [least, most] = [Math.min(...temperatures), Math.max(...temperatures)];
  return surfaces.map(({ temperature, isMetFromOutside }) => {
    if (temperature === null) return isMetFromOutside ? kObstacleColor : kWallColor;
    const share = most > least ? (temperature - least) / (most - least) : 1;
    return kCold.map((part, k) => part + share * (kHot[k] - part));
  });
}
