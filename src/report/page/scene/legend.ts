/** What the colours mean, and the marks that tell directions and lengths: drawn over the picture. */
import { Vector3 } from 'three';
import { cssValue } from '../dom';
import { cssColour } from './colour_maps';
import type { Stage } from './stage';
import { round125, said, withUnit } from './words';

export interface Legend {
  title: string;
  map: Uint8Array;
  low: number;
  high: number;
  /** by powers of ten */
  log: boolean;
  /** what the two ends are called; may be empty */
  lowWord: string;
  highWord: string;
}

type Pen = CanvasRenderingContext2D;

const font = '12px system-ui, sans-serif';
const margin = 12;

function words(pen: Pen, text: string, x: number, y: number, align: CanvasTextAlign = 'left'): void {
  pen.textAlign = align;
  pen.lineWidth = 3;
  pen.lineJoin = 'round';
  pen.strokeStyle = cssValue('--paper') || '#fff';
  pen.strokeText(text, x, y);
  pen.fillStyle = cssValue('--ink') || '#000';
  pen.fillText(text, x, y);
}

function bar(pen: Pen, legend: Legend, y: number): void {
  const width = 200;
  words(pen, legend.title, margin, y);
  for (let i = 0; i < width; ++i) {
    pen.fillStyle = cssColour(legend.map, legend.low === legend.high ? 0.5 : i / (width - 1));
    pen.fillRect(margin + i, y + 7, 1.5, 10);
  }
  const low = said(legend.low);
  words(pen, low, margin, y + 31);
  if (legend.low !== legend.high) {
    words(pen, said(legend.high), margin + width, y + 31, 'right');
    const middle = legend.log ? Math.sqrt(legend.low * legend.high) : (legend.low + legend.high) / 2;
    const told = said(Math.abs(middle) < 1e-9 * legend.high ? 0 : middle, 3);
    words(pen, told, margin + width / 2, y + 31, 'center');
  }
  if (legend.lowWord) words(pen, legend.lowWord, margin, y + 45);
  if (legend.highWord) words(pen, legend.highWord, margin + width, y + 45, 'right');
}

function legendHeight(legend: Legend): number {
  return legend.lowWord || legend.highWord ? 66 : 52;
}

function triad(pen: Pen, stage: Stage): void {
  const size = 26;
  const [x0, y0] = [margin + size + 8, stage.height - margin - size - 8];
  const toEye = stage.eye.camera.matrixWorldInverse;
  const axes = ['x', 'y', 'z'].map((name, c) => {
    const at = new Vector3().setComponent(c, 1).transformDirection(toEye);
    return { name, at };
  });
  for (const { name, at } of axes.sort((a, b) => a.at.z - b.at.z)) {
    const [x, y] = [x0 + at.x * size, y0 - at.y * size];
    pen.strokeStyle = pen.fillStyle = cssValue('--ink') || '#000';
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(x0, y0);
    pen.lineTo(x, y);
    pen.stroke();
    pen.beginPath();
    pen.arc(x, y, 2.5, 0, 2 * Math.PI);
    pen.fill();
    const out = Math.max(0.35, Math.hypot(at.x, at.y));
    words(pen, name, x + (at.x / out) * 8, y - (at.y / out) * 8 + 4, 'center');
  }
}

function scaleBar(pen: Pen, stage: Stage, size: number, unit: string): void {
  if (!stage.eye.isParallel) return;
  const pixels = stage.eye.scale(stage.height) / size;
  const length = round125(90 / pixels);
  const [right, y] = [stage.width - margin, stage.height - margin - 6];
  const left = right - length * pixels;
  pen.strokeStyle = cssValue('--ink') || '#000';
  pen.lineWidth = 2;
  pen.beginPath();
  pen.moveTo(left, y - 5);
  pen.lineTo(left, y);
  pen.lineTo(right, y);
  pen.lineTo(right, y - 5);
  pen.stroke();
  words(pen, withUnit(length, unit), right, y - 8, 'right');
}

/** `at`: the picked thing's spot, in pixels of the page. */
function ring(pen: Pen, [x, y]: [number, number]): void {
  for (const [colour, width] of [
    [cssValue('--paper') || '#fff', 5],
    ['#ff00d9', 2],
  ] as const) {
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.beginPath();
    pen.arc(x, y, 11, 0, 2 * Math.PI);
    pen.stroke();
  }
}

export interface Marks {
  legends: Legend[];
  picked: Vector3 | null;
  size: number;
  unit: string;
}

export function drawMarks(pen: Pen, stage: Stage, marks: Marks): void {
  pen.font = font;
  pen.textBaseline = 'alphabetic';
  let y = margin + 10;
  for (const legend of marks.legends) {
    bar(pen, legend, y);
    y += legendHeight(legend);
  }
  triad(pen, stage);
  scaleBar(pen, stage, marks.size, marks.unit);
  if (stage.part < 1) {
    const part = (stage.part * 100).toPrecision(2);
    words(pen, `${part} % drawn while it turns`, stage.width / 2, stage.height - margin, 'center');
  }
  if (marks.picked) ring(pen, stage.onPage(marks.picked));
}
