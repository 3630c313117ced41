/** Labelled controls of the browser's own kinds: keys, fingers and screen readers work as elsewhere. */
import { el } from '../dom';

/** `name` says more than the label where the label stands under a heading. */
export function select(
  label: string,
  options: [string, string][],
  value: string,
  change: (value: string) => void,
  name = label,
): HTMLLabelElement {
  const made = el(
    'select',
    { 'aria-label': name },
    ...options.map(([key, text]) => el('option', { value: key }, text)),
  );
  made.value = value;
  made.addEventListener('change', () => change(made.value));
  return el('label', { class: 'scene-row' }, el('span', {}, label), made);
}

export function check(label: string, value: boolean, change: (value: boolean) => void): HTMLLabelElement {
  const made = el('input', { type: 'checkbox' });
  made.checked = value;
  made.addEventListener('change', () => change(made.checked));
  return el('label', { class: 'scene-check' }, made, ` ${label}`);
}

export interface Slider {
  row: HTMLElement;
  set(value: number): void;
}

/** `text` says the value; what it says is also what a screen reader hears. */
export function slider(
  label: string,
  [low, high, step]: [number, number, number],
  value: number,
  text: (value: number) => string,
  change: (value: number) => void,
): Slider {
  const input = el('input', {
    type: 'range',
    'aria-label': label,
    min: `${low}`,
    max: `${high}`,
    step: `${step}`,
  });
  const output = el('output', {}, '');
  const show = (v: number) => {
    input.value = String(v);
    output.textContent = text(v);
    input.setAttribute('aria-valuetext', text(v));
  };
  input.addEventListener('input', () => {
    show(Number(input.value));
    change(Number(input.value));
  });
  show(value);
  return { row: el('label', { class: 'scene-row' }, el('span', {}, label), input, output), set: show };
}

export interface NumberField {
  row: HTMLElement;
  /** shown where nothing is typed in */
  suggest(text: string): void;
  clear(): void;
}

/** Empty: null. What is no number stays and is marked, and changes nothing. */
export function numberField(label: string, change: (value: number | null) => void): NumberField {
  const input = el('input', { type: 'text', inputmode: 'decimal', 'aria-label': label, size: '9' });
  input.addEventListener('change', () => {
    const text = input.value.trim().replace('−', '-');
    const value = text === '' ? null : Number(text);
    input.setAttribute('aria-invalid', String(value !== null && !Number.isFinite(value)));
    if (value === null || Number.isFinite(value)) change(value);
  });
  return {
    row: input,
    suggest: (text) => (input.placeholder = text),
    clear: () => {
      input.value = '';
      input.removeAttribute('aria-invalid');
    },
  };
}

export function group(title: string, open: boolean, ...children: Node[]): HTMLDetailsElement {
  const made = el('details', { class: 'scene-group' }, el('summary', {}, title), ...children);
  made.open = open;
  return made;
}

export function line(...children: (Node | string)[]): HTMLDivElement {
  return el('div', { class: 'scene-line' }, ...children);
}
