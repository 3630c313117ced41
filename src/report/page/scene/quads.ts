import { BufferGeometry, Uint32BufferAttribute } from 'three';

/**
 * So many squares without any numbers of their own: the shader knows by gl_VertexID which square and corner
 * it works on, and reads the rest from textures. Instances of four vertices each would be far slower, as
 * graphics cards (and what stands in for one) take instances one by one.
 */
export function quads(count: number): BufferGeometry {
  const index = new Uint32Array(count * 6);
  for (let i = 0; i < count; ++i)
    for (let k = 0; k < 6; ++k) index[i * 6 + k] = i * 4 + ([0, 1, 2, 0, 2, 3][k] as number);
  const geometry = new BufferGeometry();
  geometry.setIndex(new Uint32BufferAttribute(index, 1));
  return geometry;
}

/** Only the first so many of them. */
export function drawFirst(geometry: BufferGeometry, count: number): void {
  geometry.setDrawRange(0, count * 6);
}
