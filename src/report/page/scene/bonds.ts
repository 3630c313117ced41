/** Bonds as cylinders with ends, cut by the ray of each pixel, on a square that faces the eye. */
import { Mesh, Vector3 } from 'three';
import { look, material, rowTexture, RowValues, type Look, type Shared } from './gpu';
import type { Model } from './model';
import { quads } from './quads';
import { Paint, PickKind } from './shaders';

/**
 * The square lies in a plane across the sight of the bond's middle, just before all of the bond: what is
 * behind it looks smaller, so it covers the bond in perspective too.
 */
const vertex = /* glsl */ `
uniform highp sampler2D paints;
uniform highp sampler2D bonds;
uniform float thick;
uniform int picked;
flat out vec3 start;
flat out vec4 axis;
flat out vec2 body;
flat out int item;
out vec3 at;
void main() {
  item = itemOf();
  vec2 corner = cornerOf();
  float paint = texelFetch(paints, texel(item), 0).r;
  gl_Position = nowhere;
  if (paint > 4.5) return;
  vec4 bond = texelFetch(bonds, texel(item), 0);
  ivec2 ends = ivec2(bond.xy);
  vec3 a = placeOf(ends.x).xyz;
  vec3 b = placeOf(ends.y).xyz;
  if (cutAway(0.5 * (a + b))) return;
  start = (modelViewMatrix * vec4(moved(ends.x, a), 1.0)).xyz;
  vec3 along = (modelViewMatrix * vec4(moved(ends.y, b), 1.0)).xyz - start;
  float l = length(along);
  if (l == 0.0) return;
  axis = vec4(along / l, l);
  float r = bond.z * thick * (paint > 2.5 ? 0.45 : 1.0) * (item == picked ? 1.6 : 1.0);
  vec3 middle = start + 0.5 * along;
  vec3 toEye = isParallel() ? vec3(0.0, 0.0, 1.0) : normalize(-middle);
  float depth = dot(axis.xyz, toEye);
  vec3 side = cross(axis.xyz, toEye);
  side = dot(side, side) > 1e-8 ? normalize(side) : normalize(cross(vec3(0.3, 1.0, 0.1), toEye));
  vec3 up = cross(toEye, side);
  float high = 0.5 * l * abs(dot(axis.xyz, up)) + r * abs(depth);
  at = middle + toEye * (0.5 * l * abs(depth) + r) + corner.x * r * side + corner.y * high * up;
  body = vec2(r, paint);
  gl_Position = projectionMatrix * vec4(at, 1.0);
}`;

const fragment = /* glsl */ `
flat in vec3 start;
flat in vec4 axis;
flat in vec2 body;
flat in int item;
in vec3 at;
void main() {
  vec3 ray = isParallel() ? vec3(0.0, 0.0, -1.0) : normalize(at);
  vec3 from = at - start;
  float slope = dot(ray, axis.xyz);
  float base = dot(from, axis.xyz);
  float r = body.x;
  vec3 across = ray - slope * axis.xyz;
  vec3 off = from - base * axis.xyz;
  float a = dot(across, across);
  float half_b = dot(across, off);
  float c = dot(off, off) - r * r;
  float inside = half_b * half_b - a * c;
  if (inside < 0.0) discard;
  float t = a > 1e-10 ? (-half_b - sqrt(inside)) / a : 0.0;
  float height = base + t * slope;
  vec3 normal = (off + t * across) / r;
  if (height < 0.0 || height > axis.w || a <= 1e-10) {
    float cap = slope > 0.0 ? 0.0 : axis.w;
    t = (cap - base) / slope;
    vec3 spot = off + t * across;
    if (dot(spot, spot) > r * r) discard;
    height = cap;
    normal = axis.xyz * (slope > 0.0 ? -1.0 : 1.0);
  }
  if (body.y > 3.5 && fract(3.5 * height / axis.w) > 0.6) discard;
  gl_FragDepth = depthOf(at + t * ray);
  if (picking) { drawn = numbered(${PickKind.bond}, item); return; }
  vec3 colour = lit(painted(body.y), normal, -ray);
  if (item == picked && dot(normal, -ray) < 0.8) colour = highlight;
  drawn = vec4(colour, 1.0);
}`;

export class Bonds {
  readonly mesh: Mesh;
  readonly paint: RowValues;
  readonly look: Look;
  readonly count: number;
  private thick_ = { value: 1 };

  constructor(shared: Shared, model: Model) {
    this.count = model.bonds;
    this.look = look(new Vector3(0.5, 0.56, 0.64));
    this.paint = new RowValues(this.count, Paint.plain);
    // Rows are whole numbers far below 2^24, which single precision holds.
    const bonds = new Float32Array(this.count * 4);
    for (let i = 0; i < this.count; ++i)
      bonds.set(
        [model.ends[i * 2] as number, model.ends[i * 2 + 1] as number, model.bondRadius[i] as number],
        i * 4,
      );
    const own = {
      paints: { value: this.paint.texture },
      bonds: { value: rowTexture(bonds) },
      thick: this.thick_,
    };
    this.mesh = new Mesh(quads(this.count), material({ ...shared, ...this.look, ...own }, vertex, fragment));
    this.mesh.frustumCulled = false;
  }

  set thick(factor: number) {
    this.thick_.value = factor;
  }
}
