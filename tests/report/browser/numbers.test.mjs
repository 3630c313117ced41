/** How the page writes numbers, and where it draws them: its own functions, without a browser. */
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { parsedCsv } from './parsed.mjs';

const modules = resolve(process.env.BONDSTATIC_NODE_MODULES);
const sources = resolve(dirname(fileURLToPath(import.meta.url)), '../../../src/report/page');
const { buildSync } = createRequire(join(modules, 'any.js'))('esbuild');

async function exported(path) {
  const { outputFiles } = buildSync({
    entryPoints: [join(sources, path)],
    bundle: true,
    format: 'esm',
    write: false,
    nodePaths: [modules],
  });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);
}

const { axisTitle, exact, sharedExponent, shown, tickTexts } = await exported('format.ts');
const { csv, fileName } = await exported('csv.ts');
const { fullView } = await exported('plots/range.ts');
const { nearestOf } = await exported('plots/nearest.ts');
const { traceLine } = await exported('plots/paths.ts');
const { plotCsv } = await exported('plots/plot_csv.ts');

const axis = (label, more = {}) => ({ label, unit: '', log: false, categories: [], ...more });
const series = (name, x, y, more = {}) => ({
  name,
  x,
  y,
  draw: 'line',
  low: [],
  high: [],
  reference: false,
  ...more,
});
const plot = (all, more = {}) => ({
  title: 't',
  kind: 'xy',
  x: axis('x'),
  y: axis('y'),
  series: all,
  marks: [],
  note: '',
  ...more,
});

test('a shown number has ten digits at most, a whole one all of its own', () => {
  for (const [value, text] of [
    [0, '0'],
    [-0, '0'],
    [0.1 + 0.2, '0.3'],
    [2.480708580664647e-5, '2.480708581e-5'],
    [-36.670303834606685, '-36.67030383'],
    [157025690449.2091, '1.570256904e11'],
    [25276080128, '25276080128'],
    [5e10, '5e10'],
    [1e22, '1e22'],
    [0.0001, '0.0001'],
    [9999999999.5, '1e10'],
    [null, '–'],
  ])
    assert.equal(shown(value), text);
});

test('an exact number reads back as itself', () => {
  for (const value of [
    0.1 + 0.2,
    5e-324,
    1.7976931348623157e308,
    -2.480708580664647e-5,
    123456789012345680000,
    1 / 3,
  ])
    assert.equal(Number(exact(value)), value);
  assert.equal(exact(null), '');
});

test('ticks leave a power of a thousand to the title of their axis', () => {
  const exponent = sharedExponent(0, 5.6e-5);
  assert.equal(exponent, -6);
  assert.deepEqual(tickTexts([-2e-5, 0, 2e-5], 2e-5, exponent), ['−20', '0', '20']);
  assert.equal(axisTitle(axis('displacement', { unit: 'm' }), exponent), 'displacement (10⁻⁶ m)');
  assert.equal(axisTitle(axis('cost'), 12), 'cost (10¹²)');
  assert.equal(axisTitle(axis('load', { unit: 'N' })), 'load (N)');
  assert.deepEqual([sharedExponent(0, 9999), sharedExponent(-10000, 0), sharedExponent(0, 0)], [0, 3, 0]);
});

test('ticks of a deep zoom still differ', () => {
  const ticks = [5.000005, 5.0000075, 5.00001];
  assert.deepEqual(tickTexts(ticks, 2.5e-6, 0), ['5.0000050', '5.0000075', '5.0000100']);
});

test('CSV keeps commas, quotes and line ends inside of their fields', () => {
  const rows = [
    ['a,b', 'say "x"', 'two\r\nlines'],
    [1.5, null, -2e-300],
  ];
  assert.deepEqual(parsedCsv(csv(rows)), [
    ['a,b', 'say "x"', 'two\r\nlines'],
    ['1.5', '', '-2e-300'],
  ]);
  assert.equal(fileName('</script><script>alert(1)</script>', 'csv'), 'script-script-alert-1-script.csv');
  assert.equal(fileName('…', 'png'), 'bondstatic.png');
});

test('series with the same x share its column, others and marks follow each other', () => {
  const y = { unit: 'N' };
  const both = plot(
    [series('a', [1, 2], [3, null]), series('b', [1, 2], [5, 6], { low: [4, 5], high: [6, 7] })],
    { y: axis('load', y) },
  );
  assert.deepEqual(parsedCsv(plotCsv(both)), [
    ['x', 'a (N)', 'b (N)', 'b low (N)', 'b high (N)'],
    ['1', '3', '5', '4', '6'],
    ['2', '', '6', '5', '7'],
  ]);
  const apart = plot([series('a', [1], [3]), series('b', [2], [4])], {
    marks: [{ x: 1, y: 3, label: 'peak' }],
  });
  assert.deepEqual(parsedCsv(plotCsv(apart)), [
    ['series', 'x', 'y'],
    ['a', '1', '3'],
    ['b', '2', '4'],
    ['peak', '1', '3'],
  ]);
  const named = plot([series('a', [0, 1], [3, 4])], { x: axis('output', { categories: ['tip', 'root'] }) });
  assert.deepEqual(parsedCsv(plotCsv(named)), [
    ['output', 'a'],
    ['tip', '3'],
    ['root', '4'],
  ]);
});

test('the whole view has every value, its interval and what a logarithm can show', () => {
  const wide = plot([series('a', [1, 2], [3, 4], { low: [-10, 4], high: [3, 50] })]);
  const { x, y } = fullView(wide, wide.series);
  assert.ok(x.min < 1 && x.max > 2 && y.min < -10 && y.max > 50);
  const log = plot([series('a', [-1, 0.1, 10], [1, 1, 100])], {
    x: axis('x', { log: true }),
    y: axis('y', { log: true }),
  });
  const view = fullView(log, log.series);
  assert.ok(view.x.min > 0.05 && view.x.min < 0.1 && view.y.min > 0.5 && view.y.min < 1 && view.y.max > 100);
  const bars = plot([series('a', [5, 6], [2, 3], { draw: 'bars' })]);
  assert.equal(fullView(bars, bars.series).y.min, 0);
  assert.equal(fullView(plot([]), []), undefined);
  const gaps = plot([series('a', [1, null], [null, 2])]);
  assert.equal(fullView(gaps, gaps.series), undefined);
});

const everywhere = { left: -1e9, right: 1e9, top: -1e9, bottom: 1e9 };

function traced(x, y, steps = false, box = everywhere) {
  const strokes = [];
  traceLine(
    { moveTo: (a, b) => strokes.push([[a, b]]), lineTo: (a, b) => strokes.at(-1).push([a, b]) },
    { x: Float64Array.from(x), y: Float64Array.from(y) },
    steps,
    box,
  );
  return strokes;
}

test('a line goes through its points in their order, back in x as well, and not over a gap', () => {
  assert.deepEqual(traced([0, 10, 5, NaN, 20, 30], [0, 1, 2, 0, 4, 5]), [
    [
      [0, 0],
      [10, 1],
      [5, 2],
    ],
    [
      [20, 4],
      [30, 5],
    ],
  ]);
});

test('steps hold a value until the next', () => {
  assert.deepEqual(traced([0, 10, 20], [1, 2, 0], true), [
    [
      [0, 1],
      [10, 1],
      [10, 2],
      [20, 2],
      [20, 0],
    ],
  ]);
});

test('of points in one column of pixels those remain that can be seen', () => {
  const [[...points]] = traced([0, 5.1, 5.2, 5.3, 5.4, 5.5, 9], [0, 1, 9, 3, -7, 2, 0]);
  assert.deepEqual(points, [
    [0, 0],
    [5.1, 1],
    [5.2, 9],
    [5.4, -7],
    [5.5, 2],
    [9, 0],
  ]);
});

test('what lies outside of the box is cut off at its edge', () => {
  const box = { left: 0, right: 10, top: 0, bottom: 10 };
  assert.deepEqual(traced([-1e7, 1e7], [5, 5], false, box), [
    [
      [0, 5],
      [10, 5],
    ],
  ]);
  assert.deepEqual(traced([-5, -5, 5], [-5, 20, 20], false, box), []);
});

test('nearest means in x along a function, and in the plane where x goes back', () => {
  const drawn = (x, y, ascending) => ({
    series: series('a', [], []),
    style: {},
    screen: { x: Float64Array.from(x), y: Float64Array.from(y), ascending },
  });
  const box = { left: 0, right: 100, top: 0, bottom: 100 };
  const index = (one, x, y) => nearestOf([one], x, y, box)[0]?.index;
  assert.equal(index(drawn([10, 20, 30], [90, 0, 90], true), 19, 90), 1);
  assert.equal(index(drawn([10, 20, 15], [90, 0, 85], false), 19, 90), 2);
  assert.equal(
    index(drawn([10, 10, 10], [0, 50, 90], true), 12, 55),
    1,
    'on a vertical line the nearest in y',
  );
  assert.equal(
    index(drawn([200, NaN], [50, 50], true), 50, 50),
    undefined,
    'what is out of sight is not told of',
  );
});
