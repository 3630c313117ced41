/** The picture with its legends as one drawing: for a file and for paper. */
import { cssValue } from '../dom';
import { drawMarks, type Marks } from './legend';
import type { Stage } from './stage';

/** On white, as on paper. `ratio`: pixels per pixel of the page. */
export function picture(
  stage: Stage,
  marks: Marks,
  ratio: number,
  into = document.createElement('canvas'),
): HTMLCanvasElement {
  into.width = Math.round(stage.width * ratio);
  into.height = Math.round(stage.height * ratio);
  const pen = into.getContext('2d') as CanvasRenderingContext2D;
  const root = document.documentElement.dataset;
  const isPrinting = 'print' in root;
  root['print'] = '';
  pen.fillStyle = cssValue('--paper') || '#fff';
  pen.fillRect(0, 0, into.width, into.height);
  // Drawn in this very task: the browser may empty it afterwards.
  pen.drawImage(stage.now(ratio), 0, 0, into.width, into.height);
  pen.scale(ratio, ratio);
  drawMarks(pen, stage, marks);
  if (!isPrinting) delete root['print'];
  stage.ask();
  return into;
}
