/** A plot as a figure: title, buttons, the drawing, legend and notes. */
import { fileName, save, saveText } from '../csv';
import { button, el } from '../dom';
import { tellProblem } from '../problems';
import { legendOf } from './legend';
import { savedPicture } from './picture';
import { plotCsv } from './plot_csv';
import { countWithoutLogarithm } from './range';
import { rosePlot } from './rose';
import { stylesOf } from './style';
import { xyPlot } from './xy';
import type { Plot } from '../data';

interface Drawing {
  element: HTMLElement;
  pictureButton: HTMLButtonElement;
  setVisible(index: number, on: boolean): void;
}

function drawingOf(plot: Plot, gone?: AbortSignal): Drawing | undefined {
  const styles = stylesOf(plot.series);
  if (plot.kind === 'rose') {
    const rose = rosePlot(plot, styles);
    return (
      rose && {
        ...rose,
        pictureButton: button('SVG', `Download the picture of “${plot.title}” as SVG`, () =>
          save(rose.picture(), fileName(plot.title, 'svg')),
        ),
      }
    );
  }
  const xy = xyPlot(plot, styles, gone);
  return (
    xy && {
      ...xy,
      pictureButton: button(
        'PNG',
        `Download the picture of “${plot.title}” as PNG`,
        () =>
          void savedPicture(xy.asked).then((blob) => save(blob, fileName(plot.title, 'png')), tellProblem),
      ),
    }
  );
}

/** `gone`: when another plot has taken its place. */
export function plotOf(plot: Plot, gone?: AbortSignal): HTMLElement {
  const drawing = drawingOf(plot, gone);
  const tools = el(
    'span',
    { class: 'tools' },
    button('CSV', `Download the data of “${plot.title}” as CSV`, () =>
      saveText(plotCsv(plot), 'text/csv', fileName(plot.title, 'csv')),
    ),
  );
  const figure = el(
    'figure',
    { class: 'plot' },
    el('figcaption', {}, el('span', { class: 'plot-title' }, plot.title), tools),
    drawing?.element ?? el('p', { class: 'nothing' }, 'There are no values to be drawn.'),
  );
  if (drawing) {
    tools.append(drawing.pictureButton);
    if (plot.series.length > 1 || plot.series[0]?.reference)
      figure.append(
        legendOf(
          plot.kind === 'rose' ? plot.series.map((one) => ({ ...one, draw: 'bars' })) : plot.series,
          stylesOf(plot.series),
          drawing.setVisible,
        ),
      );
  }
  const lost = plot.kind === 'xy' ? countWithoutLogarithm(plot) : 0;
  if (lost > 0)
    figure.append(
      el(
        'p',
        { class: 'note' },
        `${lost === 1 ? '1 value is' : `${lost} values are`} not above zero and ` +
          'cannot be shown on a logarithmic axis; the CSV file has them.',
      ),
    );
  if (plot.note !== '') figure.append(el('p', { class: 'note' }, plot.note));
  return figure;
}
