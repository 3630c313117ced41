/** Sweeps: over what they are drawn is the reader's choice. */
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openReport, report } from './page.mjs';
import { parsedCsv } from './parsed.mjs';
import { downloaded, hover, inSight, plotsOf, readRows, rounded, told } from './shown.mjs';

describe('plots of sweeps', () => {
  let page, close, problems, runs;
  before(async () => {
    ({ page, close, problems } = await openReport(report('sweeps.html')));
    runs = (await told(page)).runs;
  });
  after(() => close());

  const column = (run) => page.locator(`#plots .column[data-run="${run}"]`);
  const over = (run, name) => column(run).getByLabel('abscissa', { exact: true }).selectOption({ label: name });
  const tick = (run, name) => column(run).getByRole('checkbox', { name, exact: true });
  const figure = (run, title) =>
    plotsOf(page, run).filter({ has: page.getByText(title, { exact: true }) });

  /** Header and rows of numbers of the CSV that a plot gives away. */
  async function numbers(run, title) {
    const button = figure(run, title).getByRole('button', { name: /as CSV$/ });
    const [header, ...rows] = parsedCsv((await downloaded(page, button)).content.toString('utf8'));
    return { header, rows: rows.map((row) => row.map(Number)) };
  }
  /** A column of the data that the page was told, of one law, by the number of bonds. */
  function values(run, name, law) {
    const { columns } = runs[run].sweep;
    const of = (wanted) => columns.find((one) => one.name === wanted).values;
    const [laws, bonds, all] = [of('bonds.0.law'), of('number of bonds'), of(name)];
    const code = columns.find((one) => one.name === 'bonds.0.law').categories.indexOf(law);
    return all
      .map((value, row) => ({ value, bonds: bonds[row], law: laws[row] }))
      .filter((one) => one.law === code)
      .sort((a, b) => a.bonds - b.bonds)
      .map(({ value }) => value);
  }

  test('Fig. 12: the number of bonds is the abscissa, a curve a law', async () => {
    const { header, rows } = await numbers(0, 'tip');
    assert.deepEqual(header, ['number of bonds', 'law = parallel', 'law = euler-bernoulli', 'law = timoshenko']);
    assert.deepEqual(
      rows,
      [1, 2, 4, 10].map((bonds, i) => [
        bonds,
        ...['parallel', 'euler-bernoulli', 'timoshenko'].map((law) => values(0, 'tip', law)[i]),
      ]),
    );
  });

  test('the cursor and the file tell of the abscissa that is chosen', async () => {
    await over(0, 'bonds.0.gap');
    const { header, rows } = await numbers(0, 'tip');
    assert.equal(header[0], 'bonds.0.gap');
    assert.deepEqual(
      rows.map(([gap]) => gap),
      [0, 0.6, 1.6, 3.6],
    );
    assert.deepEqual(
      rows.map((row) => row[1]),
      values(0, 'tip', 'parallel').reverse(),
    );
    await inSight(figure(0, 'tip'));
    await hover(page, figure(0, 'tip'), 0.98, 0.5);
    const told = await readRows(figure(0, 'tip'));
    assert.deepEqual(
      told.map(([name, x, y]) => [name, Number(x), Number(y)]),
      header.slice(1).map((name, i) => [name, 3.6, rounded(rows[3][i + 1])]),
    );
    await over(0, 'number of bonds');
  });

  test('names as abscissa make bars, without scales to choose', async () => {
    await over(0, 'bonds.0.law');
    const { header, rows } = await numbers(0, 'tip');
    assert.deepEqual(header, [
      'bonds.0.law',
      ...['2, gap = 3.6', '3, gap = 1.6', '5, gap = 0.6', '11, gap = 0'].map((rest) => `count = ${rest}`),
    ]);
    assert.equal(rows.length, 3);
    assert.equal(await tick(0, 'log').count(), 0);
    await over(0, 'number of bonds');
    assert.equal(await tick(0, 'log').count(), 1);
  });

  test('a law keeps its colour in the plot of differences', async () => {
    const swatches = (title) =>
      figure(0, title)
        .locator('.legend li')
        .evaluateAll((all) => Object.fromEntries(all.map((one) => [one.textContent, one.querySelector('svg').innerHTML])));
    const [own, difference] = [await swatches('tip'), await swatches('tip: difference from law = timoshenko')];
    assert.deepEqual(Object.keys(difference), ['law = parallel', 'law = euler-bernoulli']);
    for (const [name, swatch] of Object.entries(difference)) assert.equal(swatch, own[name]);
    assert.equal(new Set(Object.values(own)).size, 3);
  });

  test('Fig. 10: over the inverse of the slenderness, which is an output', async () => {
    await over(1, 'slenderness');
    await tick(1, '1/x').check();
    assert.equal(await figure(1, 'slenderness').count(), 0, 'nothing is drawn over itself');
    const { header, rows } = await numbers(1, 'tip');
    assert.equal(header[0], '1/slenderness');
    const slenderness = values(1, 'slenderness', 'parallel').reverse();
    assert.deepEqual(
      rows.map(([x]) => x),
      slenderness.map((value) => 1 / value),
    );
    assert.ok(Math.abs(rows[0][0] - 0.1) < 1e-15 && Math.abs(rows[9][0] - 1) < 1e-15);
    assert.deepEqual(
      rows.map((row) => row[1]),
      values(1, 'tip', 'timoshenko').reverse(),
    );
  });

  test('a logarithmic abscissa is drawn otherwise, of the same values', async () => {
    await over(1, 'number of bonds');
    const plot = figure(1, 'tip');
    await inSight(plot);
    const picture = () => plot.locator('.uplot canvas').evaluate((canvas) => canvas.toDataURL());
    const linear = await picture(),
      data = await numbers(1, 'tip');
    await tick(1, 'log').check();
    await inSight(plot);
    assert.notEqual(await picture(), linear);
    assert.deepEqual(await numbers(1, 'tip'), data);
    await tick(1, 'log').uncheck();
    await inSight(plot);
    assert.equal(await picture(), linear);
  });

  test('what is left of plots that others have replaced does not come to paper', async () => {
    const printed = column(0).locator('canvas.printed');
    await page.emulateMedia({ media: 'print' });
    await printed.first().waitFor();
    assert.equal(await printed.count(), await plotsOf(page, 0).count());
    assert.ok(!(await column(0).locator('.sweep-over').isVisible()));
    await page.emulateMedia({ media: 'screen' });
    await printed.first().waitFor({ state: 'detached' });
  });

  test('nothing went wrong meanwhile', () => assert.deepEqual(problems, []));
});
