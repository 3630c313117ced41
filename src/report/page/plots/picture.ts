/** The picture of a plot that is saved: title, plot and legend on one canvas. */
import { cssValue } from '../dom';
import { cutTo, fontOf } from './axes';
import { pictureOf, type Asked } from './chart';
import { traceMarker } from './paths';
import { colourOf, hasLine, hasMarkers } from './style';

const width = 760,
  height = 440,
  zoom = 3,
  line = 22;

interface Entry {
  index: number;
  x: number;
  row: number;
  text: string;
}

/** Names in rows, as many to a row as fit. */
function legendRows(context: CanvasRenderingContext2D, { plot, visible }: Asked): Entry[] {
  const entries: Entry[] = [];
  let x = 16,
    row = 0;
  plot.series.forEach(({ name }, index) => {
    if (!visible[index]) return;
    const text = cutTo(context, name, width - 80);
    const length = 34 + context.measureText(text).width + 18;
    if (x + length > width && x > 16) {
      x = 16;
      ++row;
    }
    entries.push({ index, x, row, text });
    x += length;
  });
  return entries;
}

function drawEntry(
  context: CanvasRenderingContext2D,
  { plot, styles }: Asked,
  { index, x, text }: Entry,
  y: number,
): void {
  const series = plot.series[index],
    style = styles[index];
  if (!series || !style) return;
  context.strokeStyle = context.fillStyle = colourOf(style);
  context.lineWidth = 2;
  context.setLineDash(style.dash);
  context.beginPath();
  if (series.draw === 'bars') context.rect(x + 4, y - 5, 18, 10);
  if (hasLine(series)) {
    context.moveTo(x, y);
    context.lineTo(x + 26, y);
  }
  context.stroke();
  if (series.draw === 'bars' && !style.hollow) context.fill();
  context.setLineDash([]);
  context.beginPath();
  if (hasMarkers(series)) traceMarker(context, style.marker, x + 13, y, 4);
  if (style.hollow) context.fillStyle = cssValue('--paper');
  context.fill();
  context.stroke();
  context.fillStyle = cssValue('--ink');
  context.fillText(text, x + 34, y);
}

export function savedPicture(asked: Asked): Promise<Blob> {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d') as CanvasRenderingContext2D;
  context.font = fontOf(1, 13);
  const entries = asked.plot.series.length > 1 ? legendRows(context, asked) : [];
  const rows = entries.length === 0 ? 0 : (entries.at(-1)?.row ?? 0) + 1;
  canvas.width = width * zoom;
  canvas.height = (36 + height + rows * line + 8) * zoom;
  context.fillStyle = cssValue('--paper');
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(pictureOf(asked, width, height, zoom), 0, 36 * zoom);
  context.scale(zoom, zoom);
  context.textBaseline = 'middle';
  context.font = fontOf(1, 15).replace(/^/, '600 ');
  context.fillStyle = cssValue('--ink');
  context.fillText(cutTo(context, asked.plot.title, width - 32), 16, 20);
  context.font = fontOf(1, 13);
  for (const entry of entries) drawEntry(context, asked, entry, 36 + height + (entry.row + 0.5) * line);
  return new Promise((done, failed) =>
    canvas.toBlob((blob) =>
      blob ? done(blob) : failed(new Error('the browser could not make the picture')),
    ),
  );
}
