// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

function onPage(view, place) {
  const { left, top } = view.canvas.getBoundingClientRect();
  const spot = view.project(place);
  return spot && { x: spot.x + left, y: spot.y + top };
}

/** window.hardball: the API for tests and for the console. */
export function createApi(viewer) {
  const { player, store, view, quality, source } = viewer;
  return {
    /** The time shown [T]. */
    get time() {
      return player.time;
    },
    /** Shows `time`; the promise resolves to the time shown once it is drawn. */
    async setTime(time) {
      const shown = await player.seek(time);
      viewer.drawMoment();
      return shown;
    },
    play: () => player.play(),
    pause: () => player.pause(),
    /** Center of sphere `id` at `time`, now if none is given; a promise of three numbers [L]. */
    position: (id, time = player.time) => viewer.centerAt(id, time),
    /** Where the point of surface `k` is at `time`, now if none is given: three numbers [L]. */
    surfacePoint: (k, time = player.time) => viewer.surfaces[k].pointAt(time),
    /** Where on the page the center of sphere `id` is drawn: {x, y} in CSS pixels; null if behind the camera. */
    screenPosition: (id) => onPage(view, viewer.center(id)),
    /** Where on the page `place`, three numbers [L], is drawn; as screenPosition. */
    screenPlace: (place) => onPage(view, place),
    /** The radius of sphere `id` now [L]; zero once it is part of another. */
    radius: (id) => viewer.bodies.radii[id],
    /** The domain in whose block sphere `id` is now; -1 if the run has no domains. */
    domain: (id) => viewer.domainOf(id),
    /** The orientation of sphere `id` now: a quaternion, its real part last. */
    orientation: (id) => viewer.orientation(id),
    /** How long a CSS pixel is in space, at the distance of the middle of the picture [L]. */
    lengthOfPixel: () => view.lengthOfPixel,
    /** Follows sphere `id`, or none if it is null. */
    follow: (id) => viewer.follow(id),
    /** Draws in quality `name`: "full", "reduced", "points" or "coarse". */
    setQuality: (name) => viewer.setQuality(name),
    /** What a link to the picture says after its #. */
    link: () => viewer.link.state,
    /** Shows what a link says after its #; the promise resolves once it is read. */
    show: (state) => viewer.link.show(state),
    /** Everything else, in numbers. */
    state: () => ({
      time: player.time,
      begin: source.header.begin,
      knownEnd: player.knownEnd,
      isPlaying: player.isPlaying,
      isBuffering: player.isBuffering,
      isReady: viewer.scales !== null,
      isLost: viewer.isLost,
      speed: player.speed,
      followed: viewer.followed,
      next: viewer.next ?? null,
      spheres: source.header.spheres,
      surfaces: viewer.surfaces.map((surface) => surface.name),
      flashes: viewer.flashes.total,
      forces: viewer.forceLines.forces.length,
      bonds: viewer.bondLines.bonds.length,
      images: viewer.surroundings.images.count,
      arrows: viewer.arrows.object.visible ? viewer.arrows.lines.count : 0,
      trails: viewer.trails.object.visible ? viewer.trails.lines.count : 0,
      chunks: source.ends.length,
      chunksInMemory: store.chunks.size,
      bytesInMemory: store.bytes,
      colorBy: viewer.colorBy,
      quality: quality.way.name,
      framesPerSecond: quality.framesPerSecond,
      status: source.status,
    }),
  };
}
