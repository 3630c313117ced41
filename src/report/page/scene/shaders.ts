/** What the shaders of particles, bonds and symbols share. All lengths are of the model's diagonal. */

/** How a thing is painted: up to 1 the place in the colour map, else one of these. */
export const Paint = { plain: 2, none: 3, broken: 4, hidden: 5 } as const;

/** Kinds of a picked thing, in the highest byte of what is drawn for picking. */
export const PickKind = { particle: 1, bond: 2 } as const;

/** Places of particles, moved by the drawn part of their displacements, and the plane that cuts. */
export const vertexHead = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform highp sampler2D places;
uniform highp sampler2D moves;
uniform float warp;
uniform vec4 cut;
ivec2 texel(int row) { return ivec2(row & 2047, row >> 11); }
vec4 placeOf(int row) { return texelFetch(places, texel(row), 0); }
vec3 moved(int row, vec3 at) { return at + warp * texelFetch(moves, texel(row), 0).xyz; }
bool cutAway(vec3 at) { return dot(at, cut.xyz) > cut.w; }
bool isParallel() { return projectionMatrix[3][3] == 1.0; }
int itemOf() { return gl_VertexID >> 2; }
vec2 cornerOf() { return vec2(((gl_VertexID + 1) & 2) - 1, (gl_VertexID & 2) - 1); }
const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0);
`;

/**
 * Light that stays with the eye, and dark rims so that equal neighbours are told apart. A thing that is drawn
 * for picking gets its number as a colour instead.
 */
export const fragmentHead = /* glsl */ `
precision highp float;
precision highp int;
uniform mat4 projectionMatrix;
uniform sampler2D colours;
uniform vec3 plain;
uniform bool picking;
uniform int picked;
out vec4 drawn;
const vec3 highlight = vec3(1.0, 0.0, 0.85);
bool isParallel() { return projectionMatrix[3][3] == 1.0; }
float depthOf(vec3 at) {
  vec4 clip = projectionMatrix * vec4(at, 1.0);
  return 0.5 * clip.z / clip.w + 0.5;
}
vec3 painted(float paint) {
  if (paint <= 1.0) return texture(colours, vec2(paint * (255.0 / 256.0) + 0.5 / 256.0, 0.5)).rgb;
  if (paint < 2.5) return plain;
  if (paint < 3.5) return vec3(0.62);
  return vec3(0.86, 0.1, 0.1);
}
vec3 lit(vec3 colour, vec3 normal, vec3 toEye) {
  float diffuse = max(dot(normal, normalize(vec3(-0.35, 0.55, 0.8))), 0.0);
  float rim = smoothstep(0.0, 0.45, dot(normal, toEye));
  return colour * (0.62 + 0.42 * diffuse) * (0.55 + 0.45 * rim);
}
vec4 numbered(int kind, int item) {
  return vec4(float(item & 255), float((item >> 8) & 255), float((item >> 16) & 255), float(kind)) / 255.0;
}
`;
