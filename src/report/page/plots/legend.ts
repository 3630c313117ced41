/** The legend: names that wrap, each a switch of its series. */
import { el, svg } from '../dom';
import { hasLine, hasMarkers, type Style } from './style';
import { traceMarker } from './paths';
import type { Series } from '../data';

/** traceMarker() draws on whatever takes its calls; here they become the path of an SVG. */
class SvgPen {
  text = '';
  moveTo(x: number, y: number): void {
    this.text += `M${x} ${y}`;
  }
  lineTo(x: number, y: number): void {
    this.text += `L${x} ${y}`;
  }
  closePath(): void {
    this.text += 'Z';
  }
  rect(x: number, y: number, w: number, h: number): void {
    this.text += `M${x} ${y}h${w}v${h}h${-w}Z`;
  }
  arc(x: number, y: number, r: number): void {
    this.text += `A${r} ${r} 0 1 1 ${x - r} ${y}A${r} ${r} 0 1 1 ${x + r} ${y}`;
  }
}

/** How the series is drawn, small. */
export function swatch(series: Series, style: Style): SVGElement {
  const colour = `var(${style.colour})`;
  const made = svg('svg', {
    class: 'swatch',
    width: 26,
    height: 12,
    viewBox: '0 0 26 12',
    'aria-hidden': 'true',
  });
  const dash = style.dash.join(' ');
  if (series.draw === 'bars')
    made.append(
      svg('rect', {
        x: 4,
        y: 1,
        width: 18,
        height: 10,
        'stroke-dasharray': style.hollow ? dash : '',
        stroke: colour,
        fill: style.hollow ? 'none' : colour,
      }),
    );
  if (hasLine(series))
    made.append(
      svg('path', {
        d: 'M1 6H25',
        fill: 'none',
        stroke: colour,
        'stroke-width': 2,
        'stroke-dasharray': dash,
      }),
    );
  if (hasMarkers(series)) {
    const pen = new SvgPen();
    traceMarker(pen, style.marker, 13, 6, 4);
    made.append(svg('path', { d: pen.text, stroke: colour, fill: style.hollow ? 'var(--paper)' : colour }));
  }
  return made;
}

export function legendOf(
  series: Series[],
  styles: Style[],
  toggled: (index: number, on: boolean) => void,
): HTMLElement {
  const names = series.map((one, i) => {
    const name = el(
      'button',
      { type: 'button', 'aria-pressed': 'true', title: 'show or hide' },
      swatch(one, styles[i] as Style),
      el('span', {}, one.name),
    );
    name.addEventListener('click', () => {
      const on = name.getAttribute('aria-pressed') !== 'true';
      name.setAttribute('aria-pressed', String(on));
      toggled(i, on);
    });
    return el('li', {}, name);
  });
  return el('ul', { class: 'legend', 'aria-label': 'series' }, ...names);
}
