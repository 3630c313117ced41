/** Buttons and keys that turn the model. */
import { button, el } from '../dom';
import type { Toward } from './eye';
import type { Stage } from './stage';
import { check } from './widgets';

const numbered: Toward[] = ['slanted', 'x', '-x', 'y', '-y', 'z', '-z'];

export const keysInWords =
  'Keys, once the picture is clicked: 1 to 6 or x, y, z (with shift from the other side) look along an ' +
  'axis, 0 slanted, f from behind, r the whole model, Esc no choice; arrows move, with shift they turn. ' +
  'Mouse: left turns, right moves, wheel zooms. Fingers: one turns, two zoom and move.';

function towardOf(key: string): Toward | null {
  if (/^[0-6]$/.test(key)) return numbered[Number(key)] as Toward;
  if (/^[XYZ]$/.test(key)) return `-${key.toLowerCase()}` as Toward;
  if (/^[xyz]$/.test(key)) return key as Toward;
  return key.toLowerCase() === 'r' ? 'home' : null;
}

export function eyeControls(stage: Stage, save: () => void): HTMLElement {
  const look = (toward: Toward) => {
    stage.eye.look(toward);
    stage.ask();
  };
  stage.canvas.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const toward = towardOf(event.key);
    if (toward) look(toward);
    else if (event.key.toLowerCase() === 'f') stage.eye.flip();
    else return;
    event.preventDefault();
  });
  const perspective = check('perspective', false, (on) => {
    stage.eye.perspective = on;
    stage.ask();
  });
  return el(
    'div',
    { class: 'scene-eye', role: 'toolbar', 'aria-label': 'Views' },
    button('x', 'Look from +x (key x or 1)', () => look('x')),
    button('y', 'Look from +y (key y or 3)', () => look('y')),
    button('z', 'Look from +z (key z or 5)', () => look('z')),
    button('Behind', 'Look from the opposite side (key f)', () => stage.eye.flip()),
    button('Slanted', 'Slanted view (key 0)', () => look('slanted')),
    button('Whole', 'The whole model (key r)', () => look('home')),
    perspective,
    button('Save picture', 'Save the picture as PNG', save),
  );
}
