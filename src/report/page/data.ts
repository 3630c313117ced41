/** What the page is told: the mirror of src/report/page_data.hpp. NaN and infinity come as null. */

export type Num = number | null;

/** Numbers in a block of their own: `value = scale * stored`; integers are not scaled. */
export interface BlockRef {
  block: number;
  type: 'f32' | 'u32' | 'i64';
  /** of numbers: rows times components, row by row */
  count: number;
  components: number;
  scale: number;
}

export interface Table {
  title: string;
  columns: string[];
  rows: (string | Num)[][];
  note: string;
}

export interface Axis {
  label: string;
  unit: string;
  log: boolean;
  categories: string[];
}

export interface Series {
  name: string;
  x: Num[];
  y: Num[];
  draw: 'line' | 'points' | 'line_and_points' | 'bars' | 'steps';
  /** interval of each y; may be empty */
  low: Num[];
  high: Num[];
  /** what the others are compared with */
  reference: boolean;
  /** whose colour and marker it has, so that plots agree; null: its own in the plot */
  place: number | null;
}

export interface Mark {
  x: Num;
  y: Num;
  label: string;
}

export interface Plot {
  title: string;
  kind: 'xy' | 'rose';
  x: Axis;
  y: Axis;
  series: Series[];
  marks: Mark[];
  note: string;
}

export interface SweepColumn {
  name: string;
  unit: string;
  values: Num[];
  /** where values count names */
  categories: string[];
}

export interface Abscissa {
  column: number;
  curves: number;
  log: boolean;
}

export interface Ordinate {
  title: string;
  column: number;
  log: boolean;
}

/** Row by row; of the abscissae the first is shown first. */
export interface Sweep {
  columns: SweepColumn[];
  curves: { names: string[]; of_row: number[] }[];
  abscissae: Abscissa[];
  ordinates: Ordinate[];
}

export interface Column {
  name: string;
  unit: string;
  components: 1 | 3;
  is_signed: boolean;
  is_whole: boolean;
}

export interface State {
  load_case: string;
  label: string;
  step: Num;
  particle: (BlockRef | null)[];
  bond: (BlockRef | null)[];
}

export interface Scene {
  length_unit: string;
  all_particles: number;
  all_bonds: number;
  drawn_particles: number;
  origin: [number, number, number];
  particle_id: BlockRef;
  position: BlockRef;
  radius: BlockRef;
  bond_id: BlockRef;
  bond_a: BlockRef;
  bond_b: BlockRef;
  bond_radius: BlockRef | null;
  particle_columns: Column[];
  bond_columns: Column[];
  states: State[];
}

export interface Run {
  folder: string;
  kind: 'solve' | 'relax' | 'check' | 'compare' | 'sweep' | 'fracture' | 'calibrate';
  title: string;
  notes: string[];
  warnings: string[];
  tables: Table[];
  plots: Plot[];
  sweep: Sweep | null;
  scene: Scene | null;
  resolved_case: string;
}

export interface PageData {
  version: string;
  runs: Run[];
}
