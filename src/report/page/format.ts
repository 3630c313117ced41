/** Numbers as text. */
import type { Axis, Num } from './data';

/** All digits: the shortest decimal that reads back as the same number; empty where there is none. */
export function exact(value: string | Num): string {
  if (typeof value !== 'number') return value ?? '';
  const fixed = String(value),
    scientific = value.toExponential().replace('e+', 'e');
  return scientific.length < fixed.length && !Number.isInteger(value) ? scientific : fixed;
}

/** At most ten significant digits; whole numbers (ids, counts) keep all of theirs. */
export function shown(value: Num): string {
  if (value === null || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e15) {
    const short = value.toExponential().replace('e+', 'e');
    return size >= 1e10 && short.length <= 6 ? short : String(value + 0);
  }
  const rounded = Number(value.toPrecision(10));
  return size < 1e-4 || Math.abs(rounded) >= 1e10
    ? rounded.toExponential().replace('e+', 'e')
    : String(rounded);
}

/** Counts in running text: 12,236. */
export function count(value: number): string {
  return value.toLocaleString('en-US');
}

function superscript(exponent: number): string {
  return String(exponent).replace(/./g, (sign) =>
    sign === '-' ? '⁻' : ('⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(sign)] as string),
  );
}

/** "10⁻³" */
export function powerOfTen(exponent: number): string {
  return `10${superscript(exponent)}`;
}

/** The power of ten that the ticks of a linear axis leave to its title: a multiple of three, 0 for none. */
export function sharedExponent(min: number, max: number): number {
  const size = Math.max(Math.abs(min), Math.abs(max));
  if (size === 0 || !Number.isFinite(size) || (size >= 0.1 && size < 1e4)) return 0;
  return 3 * Math.floor(Math.log10(size) / 3);
}

/** Tick labels in units of 10^exponent, with as many decimals as their increment needs. */
export function tickTexts(ticks: number[], increment: number, exponent: number): string[] {
  const step = increment / 10 ** exponent;
  let decimals = 0;
  while (decimals < 12 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6)
    ++decimals;
  return ticks.map((tick) => {
    const text = (tick / 10 ** exponent).toFixed(decimals);
    return Number(text) === 0 ? '0' : text.replace('-', '−');
  });
}

/** "load (N)", "displacement (10⁻⁶ m)". */
export function axisTitle(axis: Axis, exponent = 0): string {
  const scale = exponent === 0 ? '' : powerOfTen(exponent);
  const unit = [scale, axis.unit].filter((part) => part !== '').join(' ');
  return unit === '' ? axis.label : `${axis.label} (${unit})`.trim();
}
