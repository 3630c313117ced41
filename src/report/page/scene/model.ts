/** Where particles and bonds are, in lengths of the model's own diagonal, about its middle. */
import { floats, ids, rows } from '../blocks';
import type { Scene } from '../data';

export type Axis = 0 | 1 | 2;

export interface Model {
  drawn: number;
  bonds: number;
  /** x, y, z, radius of every row of particles, far ends of bonds among them */
  place: Float32Array;
  /** rows of particles at both ends of each bond */
  ends: Uint32Array;
  bondRadius: Float32Array;
  /** diagonal of the box around all drawn spheres, in units of the case */
  size: number;
  /** of that box, relative to the origin of the scene */
  middle: [number, number, number];
  low: [number, number, number];
  high: [number, number, number];
  meanRadius: number;
  /** extents of the particles' centres */
  extent: [number, number, number];
  particleId: BigInt64Array;
  bondId: BigInt64Array;
  /** position of a row as it was written, in units of the case */
  position(row: number): [number, number, number];
  radius(row: number): number;
}

type Box = { low: [number, number, number]; high: [number, number, number] };

function boxAround(stored: Float32Array, scale: number, radius: (row: number) => number, count: number): Box {
  const box: Box = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
  for (let row = 0; row < count; ++row) {
    const r = radius(row);
    for (let c = 0; c < 3; ++c) {
      const x = (stored[row * 3 + c] as number) * scale;
      if (x - r < (box.low[c] as number)) box.low[c] = x - r;
      if (x + r > (box.high[c] as number)) box.high[c] = x + r;
    }
  }
  return box;
}

export async function readModel(scene: Scene): Promise<Model> {
  const [stored, radii, a, b, particleId, bondId, sections] = await Promise.all([
    floats(scene.position),
    floats(scene.radius),
    rows(scene.bond_a),
    rows(scene.bond_b),
    ids(scene.particle_id),
    ids(scene.bond_id),
    scene.bond_radius ? floats(scene.bond_radius) : null,
  ]);
  const radius = (row: number) => (radii[row] as number) * scene.radius.scale;
  const scale = scene.position.scale;
  const { low, high } = boxAround(stored, scale, radius, scene.drawn_particles);
  const centres = boxAround(stored, scale, () => 0, scene.drawn_particles);
  const middle = low.map((x, c) => (x + (high[c] as number)) / 2) as [number, number, number];
  const size = Math.hypot(...low.map((x, c) => (high[c] as number) - x)) || 1;

  const all = radii.length;
  const place = new Float32Array(all * 4);
  let sum = 0;
  for (let row = 0; row < all; ++row) {
    for (let c = 0; c < 3; ++c)
      place[row * 4 + c] = ((stored[row * 3 + c] as number) * scale - (middle[c] as number)) / size;
    place[row * 4 + 3] = radius(row) / size;
    if (row < scene.drawn_particles) sum += radius(row) / size;
  }
  const bonds = a.length;
  const ends = new Uint32Array(bonds * 2);
  const bondRadius = new Float32Array(bonds);
  for (let bond = 0; bond < bonds; ++bond) {
    const [from, to] = [a[bond] as number, b[bond] as number];
    ends[bond * 2] = from;
    ends[bond * 2 + 1] = to;
    const smaller = Math.min(place[from * 4 + 3] as number, place[to * 4 + 3] as number);
    const section =
      sections && scene.bond_radius ? ((sections[bond] as number) * scene.bond_radius.scale) / size : NaN;
    bondRadius[bond] = section > 0 ? section : smaller / 2;
  }
  const inside = (corner: [number, number, number]) =>
    corner.map((x, c) => (x - (middle[c] as number)) / size) as [number, number, number];
  return {
    drawn: scene.drawn_particles,
    bonds,
    place,
    ends,
    bondRadius,
    size,
    middle,
    low: inside(low),
    high: inside(high),
    meanRadius: sum / Math.max(1, scene.drawn_particles),
    extent: centres.low.map((x, c) => (centres.high[c] as number) - x) as [number, number, number],
    particleId,
    bondId,
    position: (row) =>
      [0, 1, 2].map((c) => (stored[row * 3 + c] as number) * scale + (scene.origin[c] as number)) as [
        number,
        number,
        number,
      ],
    radius,
  };
}
