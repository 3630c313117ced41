/** From values to places in the colour map. */
import type { Column, State } from '../data';
import { diverging, sequential } from './colour_maps';
import type { Legend } from './legend';
import { Paint } from './shaders';
import { choiceName, isSigned, type Choice, type Range, type Values } from './values';

export interface Colouring {
  /** null: plain */
  choice: Choice | null;
  over: 'load case' | 'state';
  /** cut off two hundredths at either end */
  tails: boolean;
  /** by powers of ten; for what has no sign */
  log: boolean;
  /** typed in; null: found */
  low: number | null;
  high: number | null;
  /** hidden are those below and above */
  least: number | null;
  most: number | null;
}

export function plainColouring(): Colouring {
  return {
    choice: null,
    over: 'load case',
    tails: false,
    log: false,
    low: null,
    high: null,
    least: null,
    most: null,
  };
}

/** Bonds that are broken in a state. */
export function isBroken(step: number, state: State): boolean {
  return step > 0 && (state.step === null || step <= state.step);
}

function endWords(column: Column, signed: boolean): [string, string] {
  const ofStress = /^(normal_force|sigma)/.test(column.name);
  return signed && ofStress ? ['compression', 'tension'] : ['', ''];
}

/** Where powers of ten begin if values reach down to zero. */
const decades = 1e-6;

function isLog(values: Values, how: Colouring): boolean {
  return how.log && how.choice !== null && !isSigned(values.column(how.choice), how.choice);
}

export interface ShownRange extends Range {
  log: boolean;
}

export async function shownRange(
  values: Values,
  how: Colouring,
  state: State,
  states: State[],
): Promise<ShownRange> {
  const choice = how.choice as Choice;
  const over = how.over === 'state' ? [state] : states;
  const found = { low: 0, high: 0, ...(await values.range(choice, over, how.tails ? 0.02 : 0)) };
  if (isSigned(values.column(choice), choice)) {
    const most = Math.max(Math.abs(found.low), Math.abs(found.high));
    [found.low, found.high] = [-most, most];
  }
  const [low, high] = [how.low ?? found.low, how.high ?? found.high];
  if (!isLog(values, how) || !(high > 0)) return { low, high, log: false };
  return { low: low > 0 ? low : high * decades, high, log: true };
}

export function legendOf(values: Values, choice: Choice, range: ShownRange): Legend {
  const column = values.column(choice);
  const signed = isSigned(column, choice);
  const [lowWord, highWord] = endWords(column, signed);
  const unit = column.unit ? ` (${column.unit})` : '';
  return {
    title: `${choice.kind === 'bond' ? 'Bonds' : 'Particles'}: ${choiceName(column, choice)}${unit}`,
    map: signed ? diverging : sequential,
    ...range,
    lowWord,
    highWord,
  };
}

/** Fills `paint`; `values` null: plain. What has no value stays grey unless a threshold asks for one. */
export function fillPaint(
  paint: Float32Array,
  values: Float64Array | null,
  range: ShownRange,
  how: Colouring,
): number {
  const on = range.log ? (v: number) => Math.log(Math.max(v, Number.MIN_VALUE)) : (v: number) => v;
  const low = on(range.low);
  const span = on(range.high) - low;
  const [least, most] = [how.least ?? -Infinity, how.most ?? Infinity];
  const filtered = how.least !== null || how.most !== null;
  let hidden = 0;
  for (let i = 0; i < paint.length; ++i) {
    const v = values ? (values[i] as number) : NaN;
    let t: number = Paint.plain;
    if (values) {
      if (Number.isNaN(v)) t = filtered ? Paint.hidden : Paint.none;
      else if (v < least || v > most) t = Paint.hidden;
      else t = span > 0 ? Math.min(1, Math.max(0, (on(v) - low) / span)) : 0.5;
      if (t === Paint.hidden) ++hidden;
    }
    paint[i] = t;
  }
  return hidden;
}
