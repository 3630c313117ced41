/** What is shown now, and bringing it to the stage; the controls change `now` and call what they changed. */
import { Vector3 } from 'three';
import type { Scene, State } from '../data';
import { sequential } from './colour_maps';
import { mapTexture } from './gpu';
import type { Legend } from './legend';
import { Marks } from './marks';
import type { Axis, Model } from './model';
import { fillPaint, isBroken, legendOf, plainColouring, shownRange, type Colouring } from './paint';
import { Paint } from './shaders';
import type { Picked, Stage } from './stage';
import { breakStep, type Choice, type Kind, Values } from './values';
import { round125 } from './words';

export class Show {
  readonly values: Values;
  readonly marks: Marks;
  state: State;
  particle: Colouring = plainColouring();
  bond: Colouring = plainColouring();
  showParticles = true;
  showBonds: boolean;
  shrink = 1;
  thick = 1;
  showBroken = false;
  /** column of the displacements that move the picture; -1: none */
  moves: number;
  factor = 0;
  automatic = 0;
  cut: { axis: Axis | null; at: number; flipped: boolean } = { axis: null, at: 0, flipped: false };
  legends: Legend[] = [];
  picked: Picked | null = null;
  hidden: Record<Kind, number> = { particle: 0, bond: 0 };
  broken = 0;
  notes: string[] = [];
  /** told when what is shown has changed */
  changed: () => void = () => {};
  private moved_: Float32Array | null = null;
  private furthest_ = 0.5;
  private turn_ = 0;
  private map_ = { particle: sequential, bond: sequential };

  constructor(
    readonly scene: Scene,
    readonly model: Model,
    readonly stage: Stage,
  ) {
    this.values = new Values(scene);
    this.marks = new Marks(scene, model, this.values, stage);
    this.state = scene.states[0] ?? { load_case: '', label: '', step: null, particle: [], bond: [] };
    this.showBonds = model.bonds > 0;
    if (model.bonds > 0) {
      // Balls and sticks: both are seen.
      let sum = 0;
      for (const r of model.bondRadius) sum += r / model.bonds;
      this.shrink = 0.45;
      this.thick = Math.min(1, Math.max(0.05, Math.round((20 * 0.22 * model.meanRadius) / sum) / 20));
    }
    const named = (name: string) =>
      scene.particle_columns.findIndex((c) => c.name === name && c.components === 3);
    this.moves = named('displacement') >= 0 ? named('displacement') : (this.movable()[0] ?? -1);
    const { place } = model;
    for (let at = 0; at < place.length; at += 4) {
      const away = Math.hypot(place[at] as number, place[at + 1] as number, place[at + 2] as number);
      this.furthest_ = Math.max(this.furthest_, away + (place[at + 3] as number));
    }
  }

  /** By what most want to see first: the bonds' normal force, or what else is not the same everywhere. */
  async chooseColours(): Promise<void> {
    const names = this.scene.bond_columns.map((column) => column.name);
    const wanted = ['normal_force', 'sigma', 'shear_force', 'energy'].filter((name) => names.includes(name));
    for (const column of [...wanted, ...names].map((name) => names.indexOf(name))) {
      if (this.model.bonds === 0) break;
      const choice: Choice = { kind: 'bond', column, component: -1 };
      const range = await this.values.range(choice, this.statesOfCase(), 0);
      if (!range || range.low === range.high) continue;
      this.bond.choice = choice;
      return;
    }
    if (this.moves >= 0) this.particle.choice = { kind: 'particle', column: this.moves, component: -1 };
  }

  movable(): number[] {
    return this.scene.particle_columns.flatMap((c, i) =>
      c.components === 3 && c.name.endsWith('displacement') ? [i] : [],
    );
  }

  statesOfCase(): State[] {
    return this.scene.states.filter((state) => state.load_case === this.state.load_case);
  }

  /** Everything again: the state or its load case is another. Only the latest of hurried calls ends. */
  async go(state: State): Promise<void> {
    const turn = ++this.turn_;
    const isOther = state.load_case !== this.state.load_case || this.moved_ === null;
    this.state = state;
    if (isOther) await this.findScale();
    if (turn !== this.turn_) return;
    await Promise.all([this.moveParticles(), this.paint('particle'), this.paint('bond'), this.symbols()]);
  }

  /** The factor that draws the largest displacement of the load case as about 8 % of the diagonal. */
  async findScale(): Promise<void> {
    this.automatic = 0;
    if (this.moves >= 0) {
      const choice = { kind: 'particle', column: this.moves, component: -1 } as const;
      const found = await this.values.range(choice, this.statesOfCase(), 0);
      const ideal = found && found.high > 0 ? (0.08 * this.model.size) / found.high : 0;
      // What is seen as it is, is shown as it is.
      this.automatic = ideal > 0.05 && ideal < 1 ? 1 : ideal > 0 ? round125(ideal) : 0;
    }
    this.factor = this.automatic;
  }

  async moveParticles(): Promise<void> {
    const state = this.state;
    const all = this.moves >= 0 ? await this.values.all('particle', this.moves, state) : null;
    if (state !== this.state) return;
    this.moved_ = new Float32Array(all?.length ?? 0);
    all?.forEach((u, i) => ((this.moved_ as Float32Array)[i] = Number.isFinite(u) ? u / this.model.size : 0));
    this.stage.setMoves(this.moved_);
    this.applyFactor();
  }

  applyFactor(): void {
    let most = 0;
    for (const u of this.moved_ ?? []) most = Math.max(most, Math.abs(u));
    this.stage.shared.warp.value = this.factor;
    this.stage.reach = this.furthest_ + 0.15 + Math.sqrt(3) * most * this.factor;
    this.told_();
  }

  async paint(kind: Kind): Promise<void> {
    const { state } = this;
    const how = this[kind];
    const body = kind === 'particle' ? this.stage.particles : this.stage.bonds;
    const values = how.choice ? await this.values.scalar(how.choice, state) : null;
    const none = { low: 0, high: 0, log: false };
    const range = how.choice ? await shownRange(this.values, how, state, this.statesOfCase()) : none;
    const steps = kind === 'bond' ? await this.brokenSteps_(state) : null;
    if (state !== this.state || how !== this[kind]) return;
    const paint = body.paint.values;
    this.hidden[kind] = fillPaint(paint, values, range, how);
    if (steps) this.paintBroken_(paint, steps);
    body.paint.send();
    const legend = how.choice ? legendOf(this.values, how.choice, range) : null;
    const others = this.legends.filter(
      (one) => !one.title.startsWith(kind === 'bond' ? 'Bonds' : 'Particles'),
    );
    this.legends = legend ? [...others, legend].sort((a, b) => (a.title < b.title ? -1 : 1)) : others;
    const map = legend?.map ?? sequential;
    if (map !== this.map_[kind] || !body.look.colours.value) {
      body.look.colours.value?.dispose();
      body.look.colours.value = mapTexture(map);
      this.map_[kind] = map;
    }
    this.told_();
  }

  breakColumn(): number {
    return this.scene.bond_columns.findIndex((column) => column.name === breakStep);
  }

  /** Colours that tell when bonds broke are of no use where those are hidden. */
  isByBreak(): boolean {
    return this.bond.choice !== null && this.bond.choice.column === this.breakColumn();
  }

  private async brokenSteps_(state: State): Promise<Float64Array | null> {
    const column = this.breakColumn();
    return column < 0 ? null : this.values.all('bond', column, state);
  }

  private paintBroken_(paint: Float32Array, steps: Float64Array): void {
    const byStep = this.isByBreak();
    this.broken = 0;
    for (let i = 0; i < paint.length; ++i) {
      if (!isBroken(steps[i] as number, this.state)) continue;
      ++this.broken;
      if (!byStep && paint[i] !== Paint.hidden) paint[i] = this.showBroken ? Paint.broken : Paint.hidden;
    }
  }

  async symbols(): Promise<void> {
    const state = this.state;
    const notes = await this.marks.set(state);
    if (state !== this.state) return;
    this.notes = notes;
    this.told_();
  }

  applyShown(): void {
    const { stage } = this;
    stage.particles.mesh.visible = this.showParticles;
    stage.bonds.mesh.visible = this.showBonds;
    stage.particles.shrink = this.shrink;
    stage.bonds.thick = this.thick;
    this.marks.shrink = this.showParticles ? this.shrink : 0;
    this.told_();
  }

  applyCut(): void {
    this.stage.setCut(this.cut.axis, this.cut.at, this.cut.flipped);
    this.told_();
  }

  pick(picked: Picked | null): void {
    this.picked = picked;
    this.stage.mark(picked);
    this.told_();
  }

  /** Where a row of particles is drawn, in lengths of the diagonal. */
  spot(row: number): Vector3 {
    const at = new Vector3().fromArray(this.model.place, row * 4);
    if (this.moved_ && row * 3 + 2 < this.moved_.length)
      at.addScaledVector(new Vector3().fromArray(this.moved_, row * 3), this.factor);
    return at;
  }

  pickedSpot(): Vector3 | null {
    if (!this.picked) return null;
    if (this.picked.kind === 'particle') return this.spot(this.picked.row);
    const [a, b] = [
      this.model.ends[this.picked.row * 2] as number,
      this.model.ends[this.picked.row * 2 + 1] as number,
    ];
    return this.spot(a).add(this.spot(b)).multiplyScalar(0.5);
  }

  private told_(): void {
    this.stage.ask();
    this.changed();
  }
}
