/** What all meshes of a scene are told, and textures of numbers by row. */
import {
  DataTexture,
  FloatType,
  GLSL3,
  LinearFilter,
  RawShaderMaterial,
  RedFormat,
  RGBAFormat,
  Vector3,
  Vector4,
  type IUniform,
} from 'three';
import { fragmentHead, vertexHead } from './shaders';

/** As wide as every WebGL 2 allows; the shaders take rows apart by it. */
const width = 2048;

/** A texel of four numbers a row. */
export function rowTexture(values: Float32Array): DataTexture {
  const height = Math.max(1, Math.ceil(values.length / 4 / width));
  const padded = new Float32Array(width * height * 4);
  padded.set(values);
  const texture = new DataTexture(padded, width, height, RGBAFormat, FloatType);
  texture.needsUpdate = true;
  return texture;
}

/** One number a row, which changes. */
export class RowValues {
  readonly texture: DataTexture;
  /** of the rows; write here, then call `send` */
  readonly values: Float32Array;

  constructor(count: number, value: number) {
    const height = Math.max(1, Math.ceil(count / width));
    const padded = new Float32Array(width * height).fill(value);
    this.values = padded.subarray(0, count);
    this.texture = new DataTexture(padded, width, height, RedFormat, FloatType);
    this.send();
  }

  send(): void {
    this.texture.needsUpdate = true;
  }
}

export function mapTexture(map: Uint8Array): DataTexture {
  const texture = new DataTexture(map, 256, 1, RGBAFormat);
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export interface Shared {
  [name: string]: IUniform;
  places: IUniform<DataTexture>;
  moves: IUniform<DataTexture>;
  warp: IUniform<number>;
  cut: IUniform<Vector4>;
  picking: IUniform<boolean>;
}

export function sharedUniforms(places: Float32Array): Shared {
  return {
    places: { value: rowTexture(places) },
    moves: { value: rowTexture(new Float32Array(places.length)) },
    warp: { value: 0 },
    cut: { value: new Vector4(0, 0, 0, 1) },
    picking: { value: false },
  };
}

export interface Look {
  [name: string]: IUniform;
  colours: IUniform<DataTexture | null>;
  plain: IUniform<Vector3>;
  picked: IUniform<number>;
}

export function look(plain: Vector3): Look {
  return { colours: { value: null }, plain: { value: plain }, picked: { value: -1 } };
}

export function material(
  uniforms: { [name: string]: IUniform },
  vertex: string,
  fragment: string,
): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    uniforms,
    vertexShader: vertexHead + vertex,
    fragmentShader: fragmentHead + fragment,
  });
}
