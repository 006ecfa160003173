// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Outside the box there are no spheres, and no surface is drawn.
const kClip = /* glsl */ `
  uniform vec3 low;
  uniform vec3 high;

  bool isOutside(vec3 place) {
    vec3 margin = 1e-4 * (high - low);
    return any(lessThan(place, low - margin)) || any(greaterThan(place, high + margin));
  }
`;

/** A translucent wall with lines: a plane, or the inside of a cylinder or sphere. */
export const kWallVertex = /* glsl */ `
  precision highp float;
  in vec3 position;
  in vec3 normal;
  in vec2 spot;              // where on the wall, in units of the distance between lines
  uniform mat4 projectionMatrix;
  uniform mat4 viewMatrix;
  uniform mat4 modelMatrix;
  out vec3 place;
  out vec3 seen;
  out vec3 side;
  out vec2 line;

  void main() {
    vec4 world = modelMatrix * vec4(position, 1.0);
    place = world.xyz;
    seen = (viewMatrix * world).xyz;
    side = mat3(viewMatrix) * (transpose(inverse(mat3(modelMatrix))) * normal);
    line = spot;
    gl_Position = projectionMatrix * vec4(seen, 1.0);
  }
`;

export const kWallFragment = /* glsl */ `
  precision highp float;
  ${kClip}
  in vec3 place;
  in vec3 seen;
  in vec3 side;
  in vec2 line;
  uniform vec3 tint;
  uniform float nearStrength; // of the part in front of the spheres
  out vec4 outColor;

  void main() {
    vec2 width = fwidth(line);
    if (isOutside(place)) discard;
    vec2 toLine = abs(line - round(line)) / width;
    vec2 drawn = (1.0 - smoothstep(0.4, 1.3, toLine)) * (1.0 - smoothstep(0.12, 0.4, width));
    float slant = 1.0 - abs(dot(normalize(side), normalize(seen)));
    float fill = 0.09 + 0.22 * slant * slant * slant;
    float alpha = max(fill, 0.42 * max(drawn.x, drawn.y));
    outColor = vec4(tint, alpha * (gl_FrontFacing ? nearStrength : 1.0));
  }
`;

/** The outline of a plane, and ticks along its normal. */
export const kLineVertex = /* glsl */ `
  precision highp float;
  in vec3 position;
  uniform mat4 projectionMatrix;
  uniform mat4 modelViewMatrix;

  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`;

export const kLineFragment = /* glsl */ `
  precision highp float;
  uniform vec3 tint;
  out vec4 outColor;

  void main() {
    outColor = vec4(tint, 0.75);
  }
`;

/** Obstacles: solid balls with circles of latitude and longitude, which spheres do not have. */
export const kObstacleVertex = /* glsl */ `
  precision highp float;
  in vec3 position;          // on the unit sphere
  in vec2 uv;
  in vec4 ball;              // center, radius
  in vec3 tint;
  uniform mat4 projectionMatrix;
  uniform mat4 viewMatrix;
  out vec3 place;
  out vec3 seen;
  out vec3 side;
  out vec2 line;
  flat out vec3 color;

  void main() {
    place = ball.xyz + ball.w * position;
    seen = (viewMatrix * vec4(place, 1.0)).xyz;
    side = mat3(viewMatrix) * position;
    line = vec2(16.0, 8.0) * uv;
    color = tint;
    gl_Position = projectionMatrix * vec4(seen, 1.0);
  }
`;

export const kObstacleFragment = /* glsl */ `
  precision highp float;
  in vec3 seen;
  in vec3 side;
  in vec2 line;
  flat in vec3 color;
  uniform vec3 background;
  uniform vec2 haze;
  out vec4 outColor;

  void main() {
    vec3 normal = normalize(side);
    vec2 width = fwidth(line);
    vec2 drawn = (1.0 - smoothstep(0.5, 1.5, abs(line - round(line)) / width)) * (1.0 - smoothstep(0.15, 0.5, width));
    float light = max(dot(normal, normalize(vec3(-0.45, 0.65, 0.75))), 0.0);
    vec3 lit = mix(color, vec3(1.0), 0.35 * max(drawn.x, drawn.y)) * (0.45 + 0.6 * light);
    float veil = 0.55 * clamp((-seen.z - haze.x) / (haze.y - haze.x), 0.0, 1.0);
    outColor = vec4(mix(lit, background, veil), 1.0);
  }
`;
