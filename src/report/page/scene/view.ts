/** The model in three dimensions: puts the stage, its controls and its words into a place of the page. */
import './scene.css';
import { fileName, save } from '../csv';
import { el } from '../dom';
import { whenPrinted } from '../print';
import { tellProblem } from '../problems';
import type { Scene } from '../data';
import { caption } from './caption';
import { colourControls } from './colour_controls';
import { eyeControls, keysInWords } from './eye_controls';
import { drawMarks, type Marks } from './legend';
import { readModel } from './model';
import { PickPanel } from './pick_panel';
import { picture } from './picture';
import { cutControls, shapeControls, showControls } from './shape_controls';
import { Show } from './show';
import { Stage } from './stage';
import { stepControls } from './step_controls';
import { group } from './widgets';

const noWebGl =
  'The model cannot be drawn here: this browser has no WebGL 2. Turn on hardware acceleration in its ' +
  'settings, or open this file with a current Firefox, Chrome, Edge or Safari. Tables and plots need ' +
  'none of it.';

/** A click is a press that hardly moves. */
function onTap(canvas: HTMLCanvasElement, tap: (x: number, y: number) => void): void {
  let from: { x: number; y: number } | null = null;
  canvas.addEventListener('pointerdown', (event) => {
    from = event.isPrimary && event.button === 0 ? { x: event.clientX, y: event.clientY } : null;
  });
  canvas.addEventListener('pointerup', (event) => {
    if (from && Math.hypot(event.clientX - from.x, event.clientY - from.y) < 5)
      tap(event.offsetX, event.offsetY);
    from = null;
  });
}

function layOver(stage: Stage, over: HTMLCanvasElement, marks: Marks): void {
  const ratio = Math.min(window.devicePixelRatio || 1, 2);
  over.width = Math.round(stage.width * ratio);
  over.height = Math.round(stage.height * ratio);
  const pen = over.getContext('2d') as CanvasRenderingContext2D;
  pen.scale(ratio, ratio);
  drawMarks(pen, stage, marks);
}

export async function showScene(host: HTMLElement, scene: Scene, name: string): Promise<void> {
  const message = el('p', { class: 'scene-message', role: 'status' }, 'Reading the model ...');
  const canvas = el('canvas', {
    class: 'scene-canvas',
    tabindex: '0',
    role: 'img',
    'aria-label': `${name}: model`,
  });
  const over = el('canvas', { class: 'scene-over', 'aria-hidden': 'true' });
  const paper = el('canvas', { class: 'scene-paper', 'aria-hidden': 'true' });
  const words = el('p', { class: 'scene-caption', 'aria-live': 'polite' });
  const box = el('div', { class: 'scene-stage' }, canvas, over, message);
  const frame = el('div', { class: 'scene-grid' }, box);
  host.append(el('div', { class: 'scene-view' }, frame));

  // Asked here, so that no fault of ours is taken for a browser without it; three finds it made.
  if (!canvas.getContext('webgl2', { antialias: false, powerPreference: 'high-performance' })) {
    message.textContent = noWebGl;
    canvas.remove();
    over.remove();
    return;
  }
  const model = await readModel(scene);
  const stage = new Stage(model, canvas);
  const show = new Show(scene, model, stage);
  show.state = scene.states.filter((one) => one.load_case === show.state.load_case).at(-1) ?? show.state;
  await show.chooseColours();
  const panel = new PickPanel(show);
  box.append(panel.box);
  const marks = (): Marks => ({
    legends: show.legends,
    picked: show.pickedSpot(),
    size: model.size,
    unit: scene.length_unit,
  });

  const bonds = model.bonds > 0 ? colourControls(show, 'bond') : null;
  const particles = colourControls(show, 'particle');
  const shape = shapeControls(show);
  const parts = [
    eyeControls(stage, () => {
      picture(stage, marks(), 2).toBlob((png) => png && save(png, fileName(name, 'png')), 'image/png');
    }),
    stepControls(show),
    paper,
    words,
    el(
      'div',
      { class: 'scene-controls' },
      group('Colour', true, ...(bonds ? [bonds.box] : []), particles.box),
      showControls(show),
      ...(shape.box ? [shape.box] : []),
      cutControls(show),
      group('Keys', false, el('p', {}, keysInWords)),
    ),
  ];
  frame.append(...parts.filter((part) => part !== null));

  show.changed = () => {
    for (const part of [bonds, particles, shape]) part?.refresh();
    const text = caption(show);
    if (words.textContent !== text) words.textContent = text;
    canvas.setAttribute('aria-label', `${name}: ${text}`);
    panel.refresh().catch(tellProblem);
  };
  stage.drawn = () => {
    layOver(stage, over, marks());
    frame.dataset['part'] = String(stage.part);
  };
  stage.still = (isStill) => box.setAttribute('aria-busy', String(!isStill));
  frame.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') show.pick(null);
  });
  onTap(canvas, (x, y) => show.pick(stage.under(x, y)));
  canvas.addEventListener('webglcontextlost', () => {
    message.hidden = false;
    message.textContent =
      'The graphics card took the picture back. It is drawn again as soon as there is room.';
  });
  canvas.addEventListener('webglcontextrestored', () => (message.hidden = true));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => stage.ask());
  whenPrinted({ start: () => picture(stage, marks(), 2, paper), end: () => stage.ask() });

  const fit = () => {
    // Nothing while the run is not among those that are shown.
    if (box.clientWidth === 0) return;
    stage.resize(box.clientWidth, box.clientHeight);
    stage.ask();
  };
  fit();
  stage.eye.look('home');
  new ResizeObserver(fit).observe(box);
  show.applyShown();
  await show.go(show.state);
  message.hidden = true;
}
