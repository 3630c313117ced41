/** Values of columns by state, decoded when they are asked for and kept while there is room. */
import { floats, ids, rows } from '../blocks';
import type { BlockRef, Column, Scene, State } from '../data';

export type Kind = 'particle' | 'bond';

/** A column, and of a vector its length (-1) or a component. */
export interface Choice {
  kind: Kind;
  column: number;
  component: -1 | 0 | 1 | 2;
}

export interface Range {
  low: number;
  high: number;
}

/** The step at which a bond broke; 0: it did not. */
export const breakStep = 'break_step';

const room = 256 * 1024 * 1024;

async function decoded(ref: BlockRef): Promise<Float64Array> {
  if (ref.type === 'u32') return Float64Array.from(await rows(ref));
  if (ref.type === 'i64') return Float64Array.from(await ids(ref), Number);
  const stored = await floats(ref);
  const out = new Float64Array(stored.length);
  for (let i = 0; i < out.length; ++i) out[i] = (stored[i] as number) * ref.scale;
  return out;
}

export class Values {
  private kept_ = new Map<number, { values: Promise<Float64Array>; bytes: number }>();
  private bytes_ = 0;
  private ranges_ = new Map<string, Range>();

  constructor(private scene_: Scene) {}

  columns(kind: Kind): Column[] {
    return kind === 'particle' ? this.scene_.particle_columns : this.scene_.bond_columns;
  }

  column(choice: Choice): Column {
    return this.columns(choice.kind)[choice.column] as Column;
  }

  /** All components, in units of the column; null where the state has none. */
  async all(kind: Kind, column: number, state: State): Promise<Float64Array | null> {
    const ref = state[kind][column];
    if (!ref) return null;
    const kept = this.kept_.get(ref.block) ?? { values: decoded(ref), bytes: ref.count * 8 };
    if (!this.kept_.delete(ref.block)) this.bytes_ += kept.bytes;
    this.kept_.set(ref.block, kept);
    for (const [block, oldest] of this.kept_) {
      if (this.bytes_ <= room || block === ref.block) break;
      this.bytes_ -= oldest.bytes;
      this.kept_.delete(block);
    }
    return kept.values;
  }

  /** One number a row; a bond that did not break has no step of its break. */
  async scalar(choice: Choice, state: State): Promise<Float64Array | null> {
    const all = await this.all(choice.kind, choice.column, state);
    const { components, name } = this.column(choice);
    if (all && name === breakStep) return all.map((step) => (step > 0 ? step : NaN));
    if (!all || components === 1) return all;
    const out = new Float64Array(all.length / components);
    for (let i = 0; i < out.length; ++i) {
      const [x, y, z] = [all[i * 3] as number, all[i * 3 + 1] as number, all[i * 3 + 2] as number];
      out[i] = choice.component < 0 ? Math.hypot(x, y, z) : (all[i * 3 + choice.component] as number);
    }
    return out;
  }

  /**
   * Smallest and largest value over the states, or with `tails` what is left when so large a part is cut off
   * at either end: then of a sample, as the first rows are one. Null where there is no value at all.
   */
  async range(choice: Choice, states: State[], tails: number): Promise<Range | null> {
    const key = JSON.stringify([choice, tails, states.map((s) => s[choice.kind][choice.column]?.block)]);
    const known = this.ranges_.get(key);
    if (known) return known;
    const sample: number[] = [];
    const each = Math.ceil(400000 / states.length);
    let [low, high] = [Infinity, -Infinity];
    for (const state of states) {
      const values = await this.scalar(choice, state);
      if (!values) continue;
      for (let i = 0; i < values.length; ++i) {
        const v = values[i] as number;
        if (!Number.isFinite(v)) continue;
        if (v < low) low = v;
        if (v > high) high = v;
        if (tails > 0 && i < each) sample.push(v);
      }
    }
    if (!(low <= high)) return null;
    const range = { low, high };
    if (tails > 0 && sample.length > 0) {
      const sorted = Float64Array.from(sample).sort();
      range.low = sorted[Math.floor(tails * (sorted.length - 1))] as number;
      range.high = sorted[Math.ceil((1 - tails) * (sorted.length - 1))] as number;
    }
    this.ranges_.set(key, range);
    return range;
  }
}

/** "displacement, length" or "displacement, x". */
export function choiceName(column: Column, choice: Choice): string {
  if (column.components === 1) return column.name;
  return `${column.name}, ${choice.component < 0 ? 'length' : 'xyz'[choice.component]}`;
}

/** A vector's length has no sign. */
export function isSigned(column: Column, choice: Choice): boolean {
  return column.components === 3 ? choice.component >= 0 : column.is_signed;
}
