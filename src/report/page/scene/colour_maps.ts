/** Colour maps as 256 texels of RGBA: perceptually uniform and told apart with any colour vision. */

/**
 * viridis, every eighth colour of the table that S. van der Walt and N. Smith published (CC0,
 * bids.github.io/colormap; matplotlib/_cm_listed.py).
 */
const viridis =
  '440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d2f6b8e2c728e297a8e26828e23898e' +
  '21918c1f988b1fa08822a78528ae8032b67a3fbc734ec36b5ec96270cf5784d44b98d83eaddc30c2df23d8e219ece51b' +
  'fde725';

function hexTable(table: string): Uint8Array {
  const anchors = table.length / 6;
  const out = new Uint8Array(256 * 4);
  const channel = (anchor: number, c: number) =>
    parseInt(table.substring(anchor * 6 + c * 2, anchor * 6 + c * 2 + 2), 16);
  for (let i = 0; i < 256; ++i) {
    const at = (i / 255) * (anchors - 1);
    const low = Math.min(Math.floor(at), anchors - 2);
    for (let c = 0; c < 3; ++c)
      out[i * 4 + c] = Math.round(channel(low, c) + (at - low) * (channel(low + 1, c) - channel(low, c)));
    out[i * 4 + 3] = 255;
  }
  return out;
}

type Triple = [number, number, number];

/** Msh (the polar form of CIELAB, hue in radians) to sRGB bytes. */
function mshToRgb([m, s, h]: Triple): Triple {
  const l = m * Math.cos(s);
  const a = m * Math.sin(s) * Math.cos(h);
  const b = m * Math.sin(s) * Math.sin(h);
  const fy = (l + 16) / 116;
  const undo = (f: number) => (f > 6 / 29 ? f ** 3 : 3 * (6 / 29) ** 2 * (f - 4 / 29));
  const [x, y, z] = [0.95047 * undo(fy + a / 500), undo(fy), 1.08883 * undo(fy - b / 200)];
  const gamma = (v: number) => (v > 0.0031308 ? 1.055 * v ** (1 / 2.4) - 0.055 : 12.92 * v);
  const byte = (v: number) => Math.round(255 * Math.min(1, Math.max(0, gamma(v))));
  return [
    byte(3.2406 * x - 1.5372 * y - 0.4986 * z),
    byte(-0.9689 * x + 1.8758 * y + 0.0415 * z),
    byte(0.0557 * x - 0.204 * y + 1.057 * z),
  ];
}

/**
 * Blue - white - red of K. Moreland, "Diverging Color Maps for Scientific Visualization" (ISVC 2009):
 * straight lines in Msh from both ends to white, where the hue is turned a little so that the ends stay pure.
 */
function moreland(): Uint8Array {
  const blue: Triple = [80, 1.08, -1.1];
  const red: Triple = [80, 1.08, 0.5];
  const white = 88;
  const turned = ([m, s, h]: Triple): number => {
    const spin = (s * Math.sqrt(white * white - m * m)) / (m * Math.sin(s));
    return h > -Math.PI / 3 ? h + spin : h - spin;
  };
  const out = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; ++i) {
    const t = (i / 255) * 2 - 1;
    const end = t < 0 ? blue : red;
    const part = Math.abs(t);
    const hue = turned(end);
    const msh: Triple = [white + part * (end[0] - white), part * end[1], hue + part * (end[2] - hue)];
    out.set([...mshToRgb(msh), 255], i * 4);
  }
  return out;
}

export const sequential = hexTable(viridis);
export const diverging = moreland();

export function cssColour(map: Uint8Array, t: number): string {
  const i = Math.round(Math.min(1, Math.max(0, t)) * 255) * 4;
  return `rgb(${map[i]} ${map[i + 1]} ${map[i + 2]})`;
}
