/**
 * The blocks of numbers, each in a `<script type="text/plain" id="block-N">`: base64 of a zlib stream of the
 * numbers' bytes, plane by plane (first all lowest bytes, then all second bytes, ...), little endian.
 */
import type { BlockRef } from './data';

async function inflated(base64: string): Promise<Uint8Array> {
  const letters = atob(base64);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = letters.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function gathered(planes: Uint8Array, width: number): ArrayBuffer {
  const count = planes.length / width;
  const out = new Uint8Array(planes.length);
  for (let plane = 0; plane < width; ++plane)
    for (let i = 0, from = plane * count; i < count; ++i) out[i * width + plane] = planes[from + i] as number;
  return out.buffer;
}

async function bytesOf(ref: BlockRef): Promise<ArrayBuffer> {
  const element = document.getElementById(`block-${ref.block}`);
  if (!element) throw new Error(`block ${ref.block} is missing: the file is not whole`);
  const width = ref.type === 'i64' ? 8 : 4;
  const planes = await inflated(element.textContent ?? '');
  if (planes.length !== width * ref.count) throw new Error(`block ${ref.block} is damaged: the file is not whole`);
  return gathered(planes, width);
}

/** Stored numbers, not yet scaled; NaN where there is none. */
export async function floats(ref: BlockRef): Promise<Float32Array> {
  return new Float32Array(await bytesOf(ref));
}

export async function rows(ref: BlockRef): Promise<Uint32Array> {
  return new Uint32Array(await bytesOf(ref));
}

export async function ids(ref: BlockRef): Promise<BigInt64Array> {
  return new BigInt64Array(await bytesOf(ref));
}
