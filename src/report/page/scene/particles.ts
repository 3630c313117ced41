/** Particles as spheres that are cut by the ray of each pixel: exact at any size, two triangles each. */
import { Mesh, Vector3 } from 'three';
import { look, material, RowValues, type Look, type Shared } from './gpu';
import { quads } from './quads';
import { Paint, PickKind } from './shaders';

const vertex = /* glsl */ `
uniform highp sampler2D paints;
uniform float shrink;
flat out vec4 sphere;
flat out float how;
flat out int item;
out vec3 at;
void main() {
  item = itemOf();
  vec2 corner = cornerOf();
  vec4 place = placeOf(item);
  how = texelFetch(paints, texel(item), 0).r;
  gl_Position = nowhere;
  if (how > 4.5 || cutAway(place.xyz)) return;
  vec3 middle = (modelViewMatrix * vec4(moved(item, place.xyz), 1.0)).xyz;
  float r = place.w * shrink;
  vec3 toEye = isParallel() ? vec3(0.0, 0.0, 1.0) : normalize(-middle);
  vec3 side = normalize(cross(vec3(0.0, 1.0, 0.0), toEye));
  at = middle + r * (toEye + corner.x * side + corner.y * cross(toEye, side));
  sphere = vec4(middle, r);
  gl_Position = projectionMatrix * vec4(at, 1.0);
}`;

const fragment = /* glsl */ `
flat in vec4 sphere;
flat in float how;
flat in int item;
in vec3 at;
void main() {
  vec3 ray = isParallel() ? vec3(0.0, 0.0, -1.0) : normalize(at);
  vec3 from = at - sphere.xyz;
  float along = dot(from, ray);
  vec3 nearest = from - along * ray;
  float inside = sphere.w * sphere.w - dot(nearest, nearest);
  if (inside < 0.0) discard;
  vec3 hit = nearest - sqrt(inside) * ray;
  gl_FragDepth = depthOf(hit + sphere.xyz);
  if (picking) { drawn = numbered(${PickKind.particle}, item); return; }
  vec3 normal = hit / sphere.w;
  vec3 colour = lit(painted(how), normal, -ray);
  if (item == picked && dot(normal, -ray) < 0.72) colour = highlight;
  drawn = vec4(colour, 1.0);
}`;

export class Particles {
  readonly mesh: Mesh;
  readonly paint: RowValues;
  readonly look: Look;
  private shrink_ = { value: 1 };

  constructor(
    shared: Shared,
    readonly count: number,
  ) {
    this.look = look(new Vector3(0.8, 0.79, 0.76));
    this.paint = new RowValues(count, Paint.plain);
    const uniforms = { ...shared, ...this.look, paints: { value: this.paint.texture }, shrink: this.shrink_ };
    this.mesh = new Mesh(quads(count), material(uniforms, vertex, fragment));
    this.mesh.frustumCulled = false;
  }

  set shrink(factor: number) {
    this.shrink_.value = factor;
  }
}
