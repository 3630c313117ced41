/** Which supports, loads and reactions of a state are drawn, and what is said where not all of them are. */
import { Vector3 } from 'three';
import { count } from '../format';
import type { Scene, State } from '../data';
import type { Model } from './model';
import type { Stage } from './stage';
import { Symbols, type Shape, type Symbol3 } from './symbols';
import type { Values } from './values';

/** Of a kind; the rows' order is random, so the first are a fair choice that is always the same. */
const most = 300;

interface Kind {
  column: string;
  label: string;
  shown: boolean;
  shapes: Shape[];
  colour: Vector3;
}

const kinds: Kind[] = [
  {
    column: 'fixed',
    label: 'supports',
    shown: true,
    shapes: ['cone', 'double cone', 'pyramid', 'block'],
    colour: new Vector3(0.05, 0.6, 0.52),
  },
  {
    column: 'applied_force',
    label: 'forces',
    shown: true,
    shapes: ['arrow'],
    colour: new Vector3(0.9, 0.45, 0.05),
  },
  {
    column: 'applied_moment',
    label: 'moments',
    shown: true,
    shapes: ['arc'],
    colour: new Vector3(0.55, 0.25, 0.75),
  },
  {
    column: 'reaction_force',
    label: 'reactions',
    shown: false,
    shapes: ['arrow'],
    colour: new Vector3(0.1, 0.45, 0.75),
  },
  {
    column: 'reaction_moment',
    label: 'reaction moments',
    shown: false,
    shapes: ['arc'],
    colour: new Vector3(0.3, 0.6, 0.85),
  },
];

interface Drawn extends Kind {
  at: number;
  symbols: Symbols[];
}

export class Marks {
  readonly kinds: Drawn[];
  private head_: number;

  constructor(
    scene: Scene,
    private model_: Model,
    private values_: Values,
    stage: Stage,
  ) {
    this.head_ = Math.min(0.03, Math.max(0.014, 1.2 * model_.meanRadius));
    this.kinds = kinds.flatMap((kind) => {
      const at = scene.particle_columns.findIndex((column) => column.name === kind.column);
      if (at < 0 || !scene.states.some((state) => state.particle[at])) return [];
      const symbols = kind.shapes.map((shape) => new Symbols(stage.shared, shape, kind.colour, this.head_));
      stage.space.add(...symbols.map((s) => s.mesh));
      return [{ ...kind, at, symbols }];
    });
  }

  set shrink(factor: number) {
    for (const kind of this.kinds) for (const symbols of kind.symbols) symbols.shrink = factor;
  }

  /** What has to be said about them. */
  async set(state: State): Promise<string[]> {
    const notes: string[] = [];
    for (const kind of this.kinds) {
      const all = kind.shown ? await this.values_.all('particle', kind.at, state) : null;
      const found = !all
        ? []
        : kind.column === 'fixed'
          ? this.fixed_(all, notes)
          : this.arrows_(all, kind, notes);
      kind.symbols.forEach((symbols, i) => symbols.set(found[i] ?? []));
    }
    return notes;
  }

  private place_(row: number): Vector3 {
    return new Vector3().fromArray(this.model_.place, row * 4);
  }

  private fixed_(masks: Float64Array, notes: string[]): Symbol3[][] {
    const rows: number[] = [];
    let everywhere = 63;
    for (let row = 0; row < this.model_.drawn; ++row) {
      everywhere &= masks[row] as number;
      if (masks[row]) rows.push(row);
    }
    const names = ['x', 'y', 'z', 'rx', 'ry', 'rz'].filter((_, bit) => everywhere & (1 << bit));
    if (names.length > 0) notes.push(`${names.join(', ')} fixed at every particle: not drawn`);
    const some = rows.filter((row) => (masks[row] as number) & ~everywhere);
    if (some.length > most) notes.push(`${most} of ${count(some.length)} supports drawn`);
    const symbols: Symbol3[][] = [[], [], [], []];
    for (const row of some.slice(0, most)) {
      const mask = masks[row] as number;
      const at = this.place_(row);
      const add = (kind: number, axis: number) => {
        const toward: [number, number, number] = [0, 0, 0];
        toward[axis] = at.getComponent(axis) > 0 ? -1 : 1;
        symbols[kind]?.push({ row, toward, length: 2 * this.head_, leaves: false });
      };
      const isHeld = (mask & 7) === 7 && everywhere === 0;
      const isClamped = isHeld && mask === 63;
      if (isHeld) add(isClamped ? 3 : 2, this.outward_(at));
      for (let bit = isClamped ? 6 : isHeld ? 3 : 0; bit < 6; ++bit)
        if (mask & ~everywhere & (1 << bit)) add(bit < 3 ? 0 : 1, bit % 3);
    }
    return symbols;
  }

  /** The axis along which the spot is nearest to the side of the model's box. */
  private outward_(at: Vector3): number {
    const { low, high } = this.model_;
    const near = ([0, 1, 2] as const).map((c) => (high[c] - low[c]) / 2 - Math.abs(at.getComponent(c)));
    return near.indexOf(Math.min(...near));
  }

  private arrows_(all: Float64Array, kind: Drawn, notes: string[]): Symbol3[][] {
    const found: { row: number; vector: Vector3 }[] = [];
    let largest = 0;
    for (let row = 0; row < this.model_.drawn; ++row) {
      const vector = new Vector3().fromArray(all, row * 3);
      const size = vector.length();
      if (!(size > 0)) continue;
      largest = Math.max(largest, size);
      found.push({ row, vector });
    }
    // Rounding leaves reactions of next to nothing at particles that are free.
    const drawn = found.filter(({ vector }) => vector.length() > 1e-9 * largest);
    if (drawn.length > most) notes.push(`${most} of ${count(drawn.length)} ${kind.label} drawn`);
    return [
      drawn.slice(0, most).map(({ row, vector }) => {
        const length = (0.1 * vector.length()) / largest;
        const toward = vector.normalize().toArray();
        return { row, toward, length, leaves: this.place_(row).dot(vector) > 0 };
      }),
    ];
  }
}
