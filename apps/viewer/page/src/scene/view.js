// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
import {
  Color,
  MOUSE,
  PerspectiveCamera,
  Quaternion,
  Scene,
  Spherical,
  TOUCH,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { BoxFrame } from './box_frame.js';

const kDirections = 36;
const kNoHaze = 1e30; // a distance that nothing has

/**
 * The picture: camera, box, and what else is added to `scene`. A plane is seen along z and cannot be turned, so that
 * its picture is a true map: at right angles to the view, perspective only scales.
 */
export class View {
  /** `up`: the direction that is upward in the picture. */
  constructor(canvas, box, up) {
    this.canvas = canvas;
    /** Whether the graphics card is only emulated. */
    this.isSoftware = isSoftware();
    this.renderer = new WebGLRenderer({
      canvas,
      antialias: !this.isSoftware,
      powerPreference: 'high-performance',
    });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.1, 1000);
    this.camera.up.set(...up);
    this.controls = new OrbitControls(this.camera, canvas);
    // Who wants less motion moves the camera by hand alone.
    const isCalm = matchMedia('(prefers-reduced-motion: reduce)');
    this.controls.enableDamping = !isCalm.matches;
    isCalm.addEventListener('change', () => (this.controls.enableDamping = !isCalm.matches));
    this.controls.dampingFactor = 0.12;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => (this.isStale = true));
    this.isFlat = box.isFlat;
    if (this.isFlat) {
      this.controls.enableRotate = false;
      this.controls.mouseButtons.LEFT = MOUSE.PAN;
      this.controls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN };
    }
    this.frame = new BoxFrame(box.boundary);
    this.scene.add(this.frame.object);
    this.extent = 1;
    /** Whether the picture has to be drawn again. */
    this.isStale = true;
    this.mostPixelRatio = 2;
    /** The pixels of the picture, {width, height}, if they are not those of its element. */
    this.size = null;
  }

  /** Takes over the colors of the page. */
  style(background, ink) {
    this.renderer.setClearColor(new Color(background), 1);
    this.frame.uniforms.ink.value.set(ink);
    this.frame.uniforms.ink.value.convertLinearToSRGB();
    this.isStale = true;
  }

  /** Fits the picture to its element on the page. */
  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    if (this.size) return this.resizeTo(this.size, width, height);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, this.mostPixelRatio));
    this.renderer.setSize(width, height, false);
    this.camera.zoom = 1;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.isStale = true;
  }

  // Lines and points are as thick as on the page, and at least what that shows is seen, on an element of `clientWidth` by
  // `clientHeight`.
  resizeTo({ width, height }, clientWidth, clientHeight) {
    const scale = Math.min(width / clientWidth, height / clientHeight);
    this.renderer.setPixelRatio(scale);
    // Rounded down afterwards.
    this.renderer.setSize((width + 0.01) / scale, (height + 0.01) / scale, false);
    this.camera.zoom = Math.min(1, width / height / (clientWidth / clientHeight));
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.isStale = true;
  }

  /**
   * Draws `size`, {width, height}, pixels from now on; those of the element if it is null. Error: this browser cannot draw so
   * many.
   */
  takeSize(size) {
    this.size = size;
    this.resize();
    const { drawingBufferWidth: width, drawingBufferHeight: height } = this.renderer.getContext();
    if (size === null || (width === size.width && height === size.height)) return;
    throw new Error(`this browser draws no picture of ${size.width} by ${size.height} pixels`);
  }

  /**
   * Shows the `extent`, two corners [L], from where the camera is, or from the direction `begin`: to the right,
   * upward, and to the front; a plane always from its front. If `isTurned`, the extent is seen from all directions to which
   * the camera can turn aside.
   */
  fit([low, high], begin = null, isTurned = false) {
    const from = this.isFlat ? [0, 0, 1] : begin;
    const size = this.span([low, high]);
    const center = new Vector3(...low).addScaledVector(size, 0.5);
    const direction = from ? new Vector3(...from) : this.camera.position.clone().sub(this.controls.target);
    if (from)
      direction.applyQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), this.camera.up));
    direction.normalize();
    this.controls.target.copy(center);
    this.camera.position.copy(center).add(direction);
    this.camera.lookAt(center);
    // Perspective enlarges the near side: the box is moved until it is in the middle of the picture.
    for (let round = 0; round < 4; ++round) {
      const [distance, aside, above] = this.frameCorners(low, high, isTurned);
      this.controls.target.add(new Vector3(aside, above, 0).applyQuaternion(this.camera.quaternion));
      this.camera.position.copy(this.controls.target).addScaledVector(direction, distance);
    }
    this.moved();
  }

  /** Lets frame, haze and depth reach over an extent, two corners [L]; returns its size. */
  span([low, high]) {
    this.frame.span(low, high);
    const size = new Vector3(...high.map((end, axis) => end - low[axis]));
    this.extent = size.length();
    this.controls.minDistance = 1e-4 * this.extent;
    this.controls.maxDistance = 20 * this.extent;
    this.isStale = true;
    return size;
  }

  // The distance from its target at which the camera, in its present direction, sees all corners of a box; and by
  // how much the box would then be off the middle of the picture, sideways and upwards [L].
  frameCorners(low, high, isTurned) {
    const tangent = Math.tan((this.camera.fov * Math.PI) / 360) * 0.95;
    const turn = this.camera.quaternion.clone().invert();
    const corners = Array.from({ length: 8 }, (_, corner) => {
      const place = [0, 1, 2].map((axis) => ((corner >> axis) & 1 ? high : low)[axis]);
      return new Vector3(...place);
    });
    const middle = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5);
    const angles = Array.from({ length: isTurned ? kDirections : 1 }, (_, k) => (2 * Math.PI * k) / kDirections);
    const seen = angles.flatMap((angle) =>
      corners.map((corner) =>
        corner.clone().sub(middle).applyAxisAngle(this.camera.up, angle).add(middle).sub(this.controls.target).applyQuaternion(turn),
      ),
    );
    const needed = seen.map(
      ({ x, y, z }) => z + Math.max(Math.abs(y), Math.abs(x) / this.camera.aspect) / tangent,
    );
    const distance = Math.max(...needed);
    const off = (places) => (distance * (Math.min(...places) + Math.max(...places))) / 2;
    const aside = off(seen.map(({ x, z }) => x / (distance - z)));
    const above = off(seen.map(({ y, z }) => y / (distance - z)));
    return [distance, aside, above];
  }

  /** Turns the camera to `center` at the distance at which `length` fills the picture [L]. */
  zoomTo(center, length) {
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    const aspect = Math.min(1, this.camera.aspect);
    const distance = length / (2 * aspect * Math.tan((this.camera.fov * Math.PI) / 360));
    this.controls.target.set(...center);
    this.camera.position.copy(this.controls.target).addScaledVector(direction, distance);
    this.controls.update();
    this.isStale = true;
  }

  /** Where the camera is, and what it is directed at: three numbers of each [L]. */
  get pose() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  /** Moves the camera to a `pose`. */
  place(pose) {
    this.camera.position.set(...pose.slice(0, 3));
    this.controls.target.set(...pose.slice(3));
    this.moved();
  }

  /** Moves the camera so that it is directed at `center` [L]. */
  lookAlong(center) {
    const shift = new Vector3(...center).sub(this.controls.target);
    if (shift.lengthSq() === 0) return;
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.isStale = true;
  }

  /** Turns the camera about what it is directed at, by two angles: to the right and upward. */
  turn(aside, upward) {
    const toVertical = new Quaternion().setFromUnitVectors(this.camera.up, new Vector3(0, 1, 0));
    const offset = this.camera.position.clone().sub(this.controls.target).applyQuaternion(toVertical);
    const angles = new Spherical().setFromVector3(offset);
    angles.theta += aside;
    angles.phi = Math.min(Math.PI, Math.max(0, angles.phi - upward));
    offset.setFromSpherical(angles.makeSafe()).applyQuaternion(toVertical.invert());
    this.camera.position.copy(this.controls.target).add(offset);
    this.moved();
  }

  /** Moves the camera to the right and upward, by so many heights of the picture. */
  pan(aside, upward) {
    const height = this.lengthOfPixel * this.canvas.clientHeight;
    const shift = new Vector3(height * aside, height * upward, 0).applyQuaternion(this.camera.quaternion);
    this.controls.target.add(shift);
    this.camera.position.add(shift);
    this.moved();
  }

  /** Moves the camera so that what it is directed at looks larger by `factor`. */
  zoom(factor) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const { minDistance, maxDistance } = this.controls;
    offset.multiplyScalar(1 / factor).clampLength(minDistance, maxDistance);
    this.camera.position.copy(this.controls.target).add(offset);
    this.moved();
  }

  /** Directs the camera along an axis: from its upper end, or if it is there, from its lower end. */
  lookAlongAxis(axis) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const distance = offset.length();
    const isThere = offset.getComponent(axis) > 0.9999 * distance;
    offset.set(0, 0, 0).setComponent(axis, isThere ? -distance : distance);
    this.camera.position.copy(this.controls.target).add(offset);
    this.moved();
  }

  moved() {
    this.controls.update();
    this.isStale = true;
  }

  /** Pixels of the drawing in a CSS pixel. */
  get pixelRatio() {
    return this.renderer.getPixelRatio();
  }

  /** Height of the drawing in its own pixels. */
  get pixels() {
    return this.renderer.domElement.height;
  }

  /** Updates the camera; haze and depth range follow from its position. */
  prepare(haze) {
    this.controls.update();
    const distance = this.camera.position.distanceTo(this.controls.target);
    const middle = this.camera.position.distanceTo(this.frame.object.position);
    this.camera.near = Math.max(middle - this.extent, 0.004 * Math.min(distance, this.extent));
    this.camera.far = middle + 2 * this.extent;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    if (this.isFlat) haze.set(kNoHaze, 2 * kNoHaze);
    else haze.set(Math.max(0, middle - 0.35 * this.extent), middle + 0.65 * this.extent);
  }

  render() {
    this.renderer.render(this.scene, this.camera);
    this.isStale = false;
  }

  /** Where `place` [L] is on the canvas, in CSS pixels from its upper left corner; null if it is behind the camera. */
  project(place) {
    this.camera.updateMatrixWorld();
    const seen = new Vector3(...place).applyMatrix4(this.camera.matrixWorldInverse);
    if (seen.z >= 0) return null;
    seen.applyMatrix4(this.camera.projectionMatrix);
    return {
      x: ((seen.x + 1) / 2) * this.canvas.clientWidth,
      y: ((1 - seen.y) / 2) * this.canvas.clientHeight,
    };
  }

  /** The ray that runs through the point (x, y) of the canvas, in CSS pixels: origin and unit direction. */
  ray(x, y) {
    this.camera.updateMatrixWorld();
    const end = new Vector3(
      (2 * x) / this.canvas.clientWidth - 1,
      1 - (2 * y) / this.canvas.clientHeight,
      0.5,
    );
    const direction = end.unproject(this.camera).sub(this.camera.position).normalize();
    return { origin: this.camera.position.clone(), direction };
  }

  /** Length in space [L] of one CSS pixel at the distance of what the camera is directed at. */
  get lengthOfPixel() {
    return this.pixelTangent * this.camera.position.distanceTo(this.controls.target);
  }

  /** Length in space [L] of one CSS pixel at unit distance. */
  get pixelTangent() {
    return (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / this.canvas.clientHeight;
  }
}

function isSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) throw new Error('this browser has no WebGL 2');
  const details = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(details ? details.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}
