/** Numbers in words; with plain hyphens and exponents, so that programs can read what is copied. */
export function said(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return 'none';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) {
    const text = value.toPrecision(digits);
    const plain = text.includes('e') ? String(Number(text)) : text;
    return plain.includes('.') ? plain.replace(/\.?0+$/, '') : plain;
  }
  return value
    .toExponential(digits - 1)
    .replace(/\.?0+e/, 'e')
    .replace('e+', 'e');
}

export function withUnit(value: number, unit: string, digits = 4): string {
  return unit ? `${said(value, digits)} ${unit}` : said(value, digits);
}

/** The nearest of 1, 2 and 5 times a power of ten. */
export function round125(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  const lead = value / power;
  const step = lead < Math.SQRT2 ? 1 : lead < Math.sqrt(10) ? 2 : lead < Math.sqrt(50) ? 5 : 10;
  return Number((step * power).toPrecision(1));
}

/** Bits of `fixed`: 1 x, 2 y, 4 z, 8 rx, 16 ry, 32 rz. */
export function fixedInWords(mask: number): string {
  const names = ['x', 'y', 'z', 'rx', 'ry', 'rz'].filter((_, bit) => mask & (1 << bit));
  return names.length ? names.join(', ') : 'free';
}
