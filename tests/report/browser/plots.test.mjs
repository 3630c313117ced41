/** Plots: the values behind them, and how they answer. */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openReport, report } from './page.mjs';
import { parsedCsv, pngSize } from './parsed.mjs';
import { still } from './scene_page.mjs';
import { downloaded, hover, inSight, plotsOf, readRows, rounded, told } from './shown.mjs';

const picture = (figure) => figure.locator('.uplot canvas').evaluate((canvas) => canvas.toDataURL());

describe('plots of a fracture', () => {
  let page, close, problems, run;
  before(async () => {
    ({ page, close, problems } = await openReport(report('beam.html')));
    await still(page);
    run = (await told(page)).runs[0];
  });
  after(() => close());

  test('the CSV of each plot has every value with all its digits', async () => {
    for (const [index, plot] of run.plots.entries()) {
      const button = plotsOf(page, 0)
        .nth(index)
        .getByRole('button', { name: /as CSV$/ });
      const { name, content } = await downloaded(page, button);
      assert.match(name, /^[a-z0-9-]+\.csv$/);
      const [header, ...rows] = parsedCsv(content.toString('utf8'));
      if (plot.x.unit !== '') assert.ok(header.join().includes(`(${plot.x.unit})`));
      if (plot.y.unit !== '') assert.ok(header.join().includes(`(${plot.y.unit})`));
      const abscissa = (x) => (x === null ? '' : (plot.x.categories[x] ?? x));
      const same = (text, value) =>
        assert.equal(typeof value === 'number' ? Number(text) : text, value ?? '');
      if (header[0] === 'series') {
        const points = plot.series.flatMap((one) => one.x.map((x, i) => [one.name, abscissa(x), one.y[i]]));
        for (const mark of plot.marks) points.push([mark.label, abscissa(mark.x), mark.y]);
        assert.equal(rows.length, points.length);
        points.forEach((point, i) => point.forEach((value, j) => same(rows[i][j], value)));
      } else {
        assert.equal(rows.length, plot.series[0].x.length);
        const intervals = plot.series.map(({ low, high }) => low.length + high.length > 0);
        rows.forEach((row, i) => {
          let column = 0;
          same(row[column++], abscissa(plot.series[0].x[i]));
          plot.series.forEach((one, s) => {
            same(row[column++], one.y[i]);
            if (intervals[s]) for (const side of [one.low, one.high]) same(row[column++], side[i]);
          });
        });
      }
    }
  });

  test('the picture of each plot downloads', async () => {
    for (const [index, plot] of run.plots.entries()) {
      const button = plotsOf(page, 0)
        .nth(index)
        .getByRole('button', { name: /as (PNG|SVG)$/ });
      if ((await button.count()) === 0) continue;
      const { name, content } = await downloaded(page, button);
      if (plot.kind === 'rose') assert.match(content.toString('utf8'), /^<svg[^]*<path[^]*<\/svg>$/, name);
      else assert.ok(pngSize(content).width >= 1500, name);
    }
  });

  test('the cursor reads values of the data', async () => {
    const index = run.plots.findIndex(({ kind }) => kind === 'xy');
    const plot = run.plots[index],
      figure = plotsOf(page, 0).nth(index);
    await inSight(figure);
    const points = new Set(
      plot.series.flatMap((one) =>
        one.x.map((x, i) =>
          [
            one.name,
            x === null ? '' : (plot.x.categories[x] ?? rounded(x)),
            one.y[i] === null ? '' : rounded(one.y[i]),
          ].join('|'),
        ),
      ),
    );
    const places = [
      [0.1, 0.5],
      [0.3, 0.3],
      [0.5, 0.5],
      [0.7, 0.9],
      [0.9, 0.2],
    ];
    const seen = new Set();
    for (const [x, y] of places) {
      await hover(page, figure, x, y);
      const rows = await readRows(figure);
      assert.equal(rows.length, Math.min(12, plot.series.length));
      for (const [name, atX, atY] of rows) {
        const number = (text) => (text === '' || Number.isNaN(Number(text)) ? text : rounded(Number(text)));
        const point = [name, number(atX), number(atY.replace(/ \[.*/, ''))].join('|');
        assert.ok(points.has(point), `${point} is not in the data`);
        seen.add(point);
      }
    }
    assert.ok(seen.size > 2);
    await page.mouse.move(2, 2);
    assert.equal((await readRows(figure)).length, 0);
  });

  test('arrow keys read the values one after the other', async () => {
    const index = run.plots.findIndex(({ kind }) => kind === 'xy');
    const figure = plotsOf(page, 0).nth(index),
      [series] = run.plots[index].series;
    await inSight(figure);
    await figure.locator('.canvas').focus();
    const points = series.x.map((x, i) => [x, series.y[i]]).filter(([x, y]) => x !== null && y !== null);
    for (const [x, y] of points.slice(0, 3)) {
      await page.keyboard.press('ArrowRight');
      const [[, atX, atY]] = await readRows(figure);
      assert.deepEqual([Number(atX), Number(atY)], [rounded(x), rounded(y)]);
    }
    await page.keyboard.press('Escape');
    assert.equal((await readRows(figure)).length, 0);
  });

  test('a path that snaps back is drawn in its order', async () => {
    const backwards = ({ x }) => x.some((value, i) => i > 0 && value < x[i - 1]);
    const index = run.plots.findIndex(
      ({ kind, x, y, series }) =>
        kind === 'xy' &&
        !x.log &&
        !y.log &&
        series.some((one) => backwards(one) && one.draw.startsWith('line')),
    );
    assert.ok(index >= 0, 'the load-displacement path of this beam snaps back');
    const figure = plotsOf(page, 0).nth(index),
      plot = run.plots[index];
    const path = plot.series.find(backwards);
    await inSight(figure);
    // Rings lie where values are: two of them say where all others must be.
    const found = [];
    for (const [x, y] of [
      [0.06, 0.95],
      [0.5, 0.1],
    ]) {
      await hover(page, figure, x, y);
      const rows = await readRows(figure);
      const which = rows.findIndex(([name]) => name === path.name);
      const row = rows[which];
      found.push({
        x: Number(row[1]),
        y: Number(row[2]),
        ...(await figure
          .locator('.ring')
          .nth(which)
          .evaluate((ring) => ({ left: parseFloat(ring.style.left), top: parseFloat(ring.style.top) }))),
      });
    }
    await page.mouse.move(2, 2);
    const [a, b] = found;
    const left = (x) => a.left + ((x - a.x) / (b.x - a.x)) * (b.left - a.left);
    const top = (y) => a.top + ((y - a.y) / (b.y - a.y)) * (b.top - a.top);
    const middles = path.x
      .slice(1)
      .map((x, i) => [(left(x) + left(path.x[i])) / 2, (top(path.y[i + 1]) + top(path.y[i])) / 2]);
    const missing = await figure.evaluate((element, places) => {
      const canvas = element.querySelector('.uplot canvas');
      const pixels = canvas.cloneNode().getContext('2d', { willReadFrequently: true });
      pixels.drawImage(canvas, 0, 0);
      const area = element.querySelector('.u-over').getBoundingClientRect();
      const frame = canvas.getBoundingClientRect(),
        fine = canvas.width / frame.width;
      const inked = ([x, y]) => {
        const at = [(x + area.left - frame.left) * fine, (y + area.top - frame.top) * fine].map(Math.round);
        const { data } = pixels.getImageData(at[0] - 1, at[1] - 1, 3, 3);
        for (let i = 0; i < data.length; i += 4)
          if (Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 35)
            return true;
        return false;
      };
      return places.filter((place) => !inked(place)).length;
    }, middles);
    // A label may cover a few.
    assert.ok(missing <= 0.1 * middles.length, `${missing} of ${middles.length} segments are not drawn`);
  });

  test('dragging zooms and a double click shows all again', async () => {
    const figure = plotsOf(page, 0).nth(run.plots.findIndex(({ kind }) => kind === 'xy'));
    await inSight(figure);
    await page.mouse.move(2, 2);
    const whole = await picture(figure);
    await hover(page, figure, 0.2, 0.2);
    await page.mouse.down();
    await hover(page, figure, 0.6, 0.7);
    await page.mouse.up();
    assert.ok((await picture(figure)) !== whole);
    const area = await figure.locator('.u-over').boundingBox();
    await page.mouse.dblclick(area.x + area.width / 2, area.y + area.height / 2);
    assert.ok((await picture(figure)) === whole);
  });

  test('a click in the legend hides a series, and another brings it back', async () => {
    const index = run.plots.findIndex(({ kind, series }) => kind === 'xy' && series.length > 1);
    assert.ok(index >= 0);
    const figure = plotsOf(page, 0).nth(index),
      name = run.plots[index].series[0].name;
    await inSight(figure);
    const whole = await picture(figure),
      entry = figure.locator('.legend button').first();
    assert.equal(await entry.textContent(), name);
    await entry.click();
    assert.equal(await entry.getAttribute('aria-pressed'), 'false');
    assert.ok((await picture(figure)) !== whole);
    await hover(page, figure, 0.5, 0.5);
    const names = (await readRows(figure)).map(([shown]) => shown);
    assert.ok(names.length > 0 && !names.includes(name));
    await entry.click();
    assert.ok((await picture(figure)) === whole);
  });

  test('nothing went wrong meanwhile', () => assert.deepEqual(problems, []));
});
