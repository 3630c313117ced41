/**
 * Supports, loads and reactions as symbols at spheres, which they follow: an arrow for a force, a bent one
 * about the sphere for a moment (right hand), a cone against the sphere for a fixed direction, a double cone
 * for a fixed rotation, a pyramid where all directions are fixed, and a block where all rotations are too.
 */
import {
  Float32BufferAttribute,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  Vector3,
} from 'three';
import { material, type Shared } from './gpu';

export interface Symbol3 {
  row: number;
  /** where it points; unit length */
  toward: [number, number, number];
  length: number;
  /** starts on the sphere and points away from it; else it ends there */
  leaves: boolean;
}

export type Shape = 'cone' | 'double cone' | 'arrow' | 'arc' | 'block' | 'pyramid';

/** A ring, from the tip: part of the symbol's length, then lengths of its head, and radius in heads. */
type Ring = [number, number, number];

function cone(tip: number): Ring[] {
  return [
    [0, tip, 0],
    [0, tip + 1, 0.38],
    [0, tip + 1, 0],
  ];
}

function shaft(from: number): Ring[] {
  return [
    [0, from, 0.11],
    [1, 0, 0.11],
  ];
}

const rings: Record<Shape, Ring[][]> = {
  cone: [cone(0)],
  pyramid: [cone(0)],
  'double cone': [cone(0), cone(1)],
  block: [
    [
      [0, 0, 0],
      [0, 0, 0.5],
      [0, 0.7, 0.5],
      [0, 0.7, 0],
    ],
  ],
  arrow: [cone(0), shaft(1)],
  arc: [],
};

/** Three quarters of a ring of radius one about x, with a head. The first number tells the shader so. */
function bent(spots: number[], index: number[]): void {
  const [steps, sides] = [30, 8];
  for (let step = 0; step <= steps + 2; ++step) {
    const head = step > steps;
    const along = (1.5 * Math.PI * Math.min(step, steps)) / steps;
    const forward = step === steps + 2 ? 0.75 : 0;
    const tube = step === steps + 2 ? 0 : head ? 0.28 : 0.09;
    for (let i = 0; i <= sides; ++i) {
      const angle = (2 * Math.PI * i) / sides;
      const out = 1 + tube * Math.cos(angle);
      const y = out * Math.cos(along) - forward * Math.sin(along);
      const z = out * Math.sin(along) + forward * Math.cos(along);
      spots.push(2, tube * Math.sin(angle), y, z);
    }
    for (let i = step * (sides + 1); step < steps + 2 && i < step * (sides + 1) + sides; ++i)
      index.push(i, i + 1, i + sides + 1, i + 1, i + sides + 2, i + sides + 1);
  }
}

function turned(shape: Shape): InstancedBufferGeometry {
  const sides = shape === 'block' || shape === 'pyramid' ? 4 : 20;
  const spots: number[] = [];
  const index: number[] = [];
  if (shape === 'arc') bent(spots, index);
  for (const body of rings[shape])
    body.forEach(([far, heads, radius], ring) => {
      const at = spots.length / 4;
      for (let i = 0; i <= sides; ++i) {
        const angle = (2 * Math.PI * (i + 0.5)) / sides;
        spots.push(far, heads, radius * Math.cos(angle), radius * Math.sin(angle));
      }
      for (let i = at; ring + 1 < body.length && i < at + sides; ++i)
        index.push(i, i + 1, i + sides + 1, i + 1, i + sides + 2, i + sides + 1);
    });
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('spot', new Float32BufferAttribute(spots, 4));
  geometry.setIndex(index);
  return geometry;
}

const vertex = /* glsl */ `
in vec4 spot;
in vec2 row;
in vec4 toward;
uniform float head;
uniform float shrink;
out vec3 at;
void main() {
  vec4 place = placeOf(int(row.x));
  gl_Position = nowhere;
  if (toward.w <= 0.0 || cutAway(place.xyz)) return;
  vec3 x = toward.xyz;
  vec3 y = normalize(cross(x, abs(x.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  vec3 z = cross(x, y);
  float size = min(head, toward.w * 0.5);
  float back = spot.x > 0.5 ? max(toward.w, size) : spot.y * size;
  float away = row.y > 0.5 ? place.w * shrink + max(toward.w, size) : -place.w * shrink;
  vec3 tip = moved(int(row.x), place.xyz) + x * away;
  vec3 here = tip - x * back + size * (spot.z * y + spot.w * z);
  if (spot.x > 1.5) {
    float ring = place.w * shrink + 0.3 * toward.w;
    here = moved(int(row.x), place.xyz) + ring * (spot.y * x + spot.z * y + spot.w * z);
  }
  vec4 seen = modelViewMatrix * vec4(here, 1.0);
  at = seen.xyz;
  gl_Position = projectionMatrix * seen;
}`;

const fragment = /* glsl */ `
in vec3 at;
void main() {
  if (picking) discard;
  vec3 toEye = isParallel() ? vec3(0.0, 0.0, 1.0) : normalize(-at);
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  if (dot(normal, toEye) < 0.0) normal = -normal;
  drawn = vec4(lit(plain, normal, toEye), 1.0);
}`;

export class Symbols {
  readonly mesh: Mesh;
  private geometry_: InstancedBufferGeometry;
  private shrink_ = { value: 1 };

  /** A cone is `head` long whatever its symbol's length says; an arrow's head is. */
  constructor(shared: Shared, shape: Shape, colour: Vector3, head: number) {
    this.geometry_ = turned(shape);
    this.geometry_.instanceCount = 0;
    const uniforms = { ...shared, plain: { value: colour }, head: { value: head }, shrink: this.shrink_ };
    this.mesh = new Mesh(this.geometry_, material(uniforms, vertex, fragment));
    this.mesh.material = Object.assign(this.mesh.material, { side: 2 });
    this.mesh.frustumCulled = false;
  }

  set(symbols: Symbol3[]): void {
    const rows = new Float32Array(symbols.flatMap((s) => [s.row, s.leaves ? 1 : 0]));
    const toward = new Float32Array(symbols.length * 4);
    symbols.forEach((s, i) => toward.set([...s.toward, s.length], i * 4));
    // three keeps the buffer of a name for good, so the old one is given back first.
    this.geometry_.dispose();
    this.geometry_.setAttribute('row', new InstancedBufferAttribute(rows, 2));
    this.geometry_.setAttribute('toward', new InstancedBufferAttribute(toward, 4));
    this.geometry_.instanceCount = symbols.length;
  }

  set shrink(factor: number) {
    this.shrink_.value = factor;
  }
}
