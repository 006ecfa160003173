// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Where a sphere is now, and its color: common to impostors and points.
const kMotion = /* glsl */ `
  precision highp float;
  precision highp int;

  in vec4 place;      // center at the reference time, and the path's start relative to it
  in vec4 motion;     // velocity at the reference time, and the collisions so far, or another number to be shown
  in vec3 kind;       // radius without growth, species, and 1 for a kinematic sphere
  in vec3 spin;
  in vec4 turn;       // orientation at the reference time: a quaternion, the real part last

  uniform mat4 projectionMatrix;
  uniform mat4 modelViewMatrix;
  uniform float elapsed;     // since the reference time
  uniform float scale;       // of all radii, by growth
  uniform vec3 gravity;
  uniform vec3 period;       // of the box, zero along axes that are not periodic
  uniform vec3 inversePeriod; // zero, too
  uniform vec2 slid;         // along x, the image above: by how much, and how fast
  uniform int colorBy;
  uniform vec2 colorRange;
  uniform bool colorIsLogarithmic;
  uniform sampler2D colorMap;
  uniform sampler2D speciesColors;
  uniform sampler2D domainColors;
  uniform highp sampler2D domainBlocks; // the lower and the upper end of each
  uniform int domainCount;
  uniform vec3 boxPeriod;    // zero along axes that are not periodic
  uniform int followed;      // id, or -1
  uniform vec3 followedCenter;
  uniform float pixels;      // height of the drawing
  uniform float leastPixels; // diameter of the smallest drawn, lest they vanish
  uniform float reach;       // spheres farther from the followed one are not drawn; 0: all are

  uniform vec3 sliceLow;     // spheres with centers outside are not drawn
  uniform vec3 sliceHigh;

  uniform bool hasMarks;     // which turn with the spheres
  uniform vec3 kinematicColor;

  flat out vec3 color;
  flat out float isFollowed;
  flat out vec4 toMarks;     // from the camera's coordinates to the sphere's own: a quaternion

  vec4 product(vec4 a, vec4 b) {
    return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz));
  }

  void findMarks() {
    toMarks = vec4(0.0);
    if (!hasMarks) return;
    float rate = length(spin);
    float halfAngle = 0.5 * rate * elapsed;
    vec4 since = rate > 0.0 ? vec4(sin(halfAngle) / rate * spin, cos(halfAngle)) : vec4(0.0, 0.0, 0.0, 1.0);
    vec4 now = product(since, turn);
    toMarks = vec4(-now.xyz, now.w);
  }

  float above = 0.0;         // in which layer of images the center is

  vec3 centerNow() {
    vec3 center = place.xyz + elapsed * (motion.xyz + (0.5 * elapsed) * gravity);
    above = floor(center.y * inversePeriod.y);
    center.x -= above * slid.x;
    return center - period * floor(center * inversePeriod);
  }

  bool isHidden(vec3 center, int id) {
    if (kind.x == 0.0) return true; // part of another
    if (any(lessThan(center, sliceLow)) || any(greaterThan(center, sliceHigh))) return true;
    if (reach <= 0.0 || id == followed) return false;
    vec3 apart = center - followedCenter;
    apart.x -= round(apart.y * inversePeriod.y) * slid.x;
    apart -= period * round(apart * inversePeriod);
    return dot(apart, apart) > reach * reach;
  }

  // The domain in whose block a center is; rounding may have put it beside all of them.
  int domainAt(vec3 center) {
    vec3 place = center;
    for (int axis = 0; axis < 3; ++axis)
      if (boxPeriod[axis] > 0.0) place[axis] -= boxPeriod[axis] * floor(place[axis] / boxPeriod[axis]);
    int nearest = 0;
    float least = 1e38;
    for (int domain = 0; domain < domainCount; ++domain) {
      vec3 apart = max(texelFetch(domainBlocks, ivec2(0, domain), 0).xyz - place,
                       place - texelFetch(domainBlocks, ivec2(1, domain), 0).xyz);
      float outside = max(apart.x, max(apart.y, apart.z));
      if (outside < least) {
        least = outside;
        nearest = domain;
      }
    }
    return nearest;
  }

  vec3 colorByNow(vec3 center) {
    if (colorBy == 6) {
      int colors = textureSize(domainColors, 0).x;
      return texelFetch(domainColors, ivec2(domainAt(center) % colors, 0), 0).rgb;
    }
    if (colorBy == 2) return texelFetch(speciesColors, ivec2(int(kind.y), 0), 0).rgb;
    float value = colorBy == 0 ? length(motion.xyz + elapsed * gravity - vec3(above * slid.y, 0.0, 0.0))
                : colorBy == 1 ? kind.x
                : colorBy == 3 || colorBy >= 7 ? motion.w
                : colorBy == 5 ? length(spin)
                : elapsed - place.w;
    float share = colorIsLogarithmic ? log(value / colorRange.x) / log(colorRange.y / colorRange.x)
                                     : (value - colorRange.x) / (colorRange.y - colorRange.x);
    return texture(colorMap, vec2((32.0 * clamp(share, 0.0, 1.0) + 0.5) / 33.0, 0.5)).rgb;
  }

  vec3 colorNow(vec3 center) {
    return mix(colorByNow(center), kinematicColor, 0.75 * kind.z);
  }
`;

const kShading = /* glsl */ `
  precision highp float;
  uniform vec3 background;
  uniform vec2 haze;         // distances at which the depth cue starts and is full
  flat in vec3 color;
  flat in float isFollowed;
  flat in vec4 toMarks;
  uniform mat3 fromCamera;   // to directions in space
  uniform bool isFlat;       // discs: seen along z, and not shaded
  out vec4 outColor;

  // How dark the mark at the sphere's side "normal" is: a cap about its own z axis, and the half circle from there
  // over y to the other end, by which a disc turns like the hand of a clock.
  float markAt(vec3 normal) {
    if (toMarks == vec4(0.0)) return 0.0;
    vec3 place = fromCamera * normal;
    place += 2.0 * cross(toMarks.xyz, cross(toMarks.xyz, place) + toMarks.w * place);
    float soft = max(fwidth(place.x), fwidth(place.z)) + 0.01;
    float cap = isFlat ? 0.0 : smoothstep(0.88 - soft, 0.88 + soft, place.z);
    float line = (1.0 - smoothstep(0.1 - soft, 0.1 + soft, abs(place.x))) * smoothstep(-soft, soft, place.y);
    // On small spheres it would only be dirt.
    float clarity = 1.0 - smoothstep(0.12, 0.3, soft);
    return 0.62 * clarity * max(cap, line);
  }

  vec3 shade(vec3 normal, float distance) {
    vec3 color = color * (1.0 - markAt(normal));
    if (isFlat) {
      float edge = smoothstep(0.3, 0.42, normal.z);
      if (isFollowed > 0.5) return mix(vec3(1.0), color, edge);
      return color * (0.72 + 0.28 * edge);
    }
    float light = max(dot(normal, normalize(vec3(-0.45, 0.65, 0.75))), 0.0);
    float rim = normal.z;
    vec3 lit = color * (0.5 + 0.62 * light) * (0.7 + 0.3 * rim);
    lit += 0.16 * pow(light, 24.0);
    if (isFollowed > 0.5) lit = mix(vec3(1.0), lit, smoothstep(0.3, 0.5, rim));
    float veil = 0.55 * clamp((distance - haze.x) / (haze.y - haze.x), 0.0, 1.0);
    return mix(lit, background, isFollowed > 0.5 ? 0.0 : veil);
  }
`;

/** A square that faces the camera for each sphere, on which rays meet a true sphere, at its true depth. */
export const kImpostorVertex = /* glsl */ `
  ${kMotion}
  in vec3 position;          // a corner of the square, from -1 to 1
  uniform bool isFlat;
  flat out vec4 ball;        // center in the camera's coordinates, radius
  out vec3 ray;

  void main() {
    vec3 center = centerNow();
    ball.xyz = (modelViewMatrix * vec4(center, 1.0)).xyz;
    float distance = length(ball.xyz);
    ball.w = max(scale * kind.x, leastPixels * distance / (projectionMatrix[1][1] * pixels));
    color = colorNow(center);
    findMarks();
    isFollowed = gl_InstanceID == followed ? 1.0 : 0.0;
    if (isHidden(center, gl_InstanceID) || (!isFlat && distance <= 1.01 * ball.w)) {
      gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
      return;
    }
    if (isFlat) {
      ray = ball.xyz + 1.02 * ball.w * vec3(position.xy, 0.0);
      gl_Position = projectionMatrix * vec4(ray, 1.0);
      return;
    }
    vec3 forward = ball.xyz / distance;
    vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
    vec3 up = cross(right, forward);
    float extent = ball.w * distance / sqrt(distance * distance - ball.w * ball.w);
    ray = ball.xyz + 1.02 * extent * (position.x * right + position.y * up);
    gl_Position = projectionMatrix * vec4(ray, 1.0);
  }
`;

export const kImpostorFragment = /* glsl */ `
  ${kShading}
  uniform mat4 projectionMatrix;
  flat in vec4 ball;
  in vec3 ray;

  void main() {
    if (isFlat) {
      vec2 side = (ray - ball.xyz).xy / ball.w;
      float miss = dot(side, side);
      if (miss > 1.0) discard;
      gl_FragDepth = gl_FragCoord.z;
      outColor = vec4(shade(vec3(side, sqrt(1.0 - miss)), 0.0), 1.0);
      return;
    }
    vec3 direction = normalize(ray);
    float along = dot(direction, ball.xyz);
    vec3 nearest = along * direction - ball.xyz;
    float miss = dot(nearest, nearest);
    float within = ball.w * ball.w - miss;
    if (within <= 0.0) discard;
    vec3 hit = (along - sqrt(within)) * direction;
    vec4 clip = projectionMatrix * vec4(hit, 1.0);
    gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;
    outColor = vec4(shade((hit - ball.xyz) / ball.w, -hit.z), 1.0);
  }
`;

/** A round point for each sphere: cheaper, and of the same size and color, but flat in depth. */
export const kPointVertex = /* glsl */ `
  ${kMotion}
  in vec3 position;

  void main() {
    vec3 center = centerNow();
    vec4 seen = modelViewMatrix * vec4(center, 1.0);
    color = colorNow(center);
    findMarks();
    isFollowed = gl_VertexID == followed ? 1.0 : 0.0;
    gl_Position = isHidden(center, gl_VertexID) ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * seen;
    gl_PointSize = max(leastPixels, scale * kind.x * projectionMatrix[1][1] * pixels / max(-seen.z, 1e-6));
  }
`;

export const kPointFragment = /* glsl */ `
  ${kShading}

  void main() {
    vec2 side = vec2(2.0, -2.0) * gl_PointCoord + vec2(-1.0, 1.0);
    float miss = dot(side, side);
    if (miss > 1.0) discard;
    outColor = vec4(shade(vec3(side, sqrt(1.0 - miss)), 1.0 / gl_FragCoord.w), 1.0);
  }
`;
