/** Looks at the model of a report as a reader does. */
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { openReport, report } from './page.mjs';

export const canvas = (page) => page.locator('.scene-canvas');
export const caption = (page) => page.locator('.scene-caption').textContent();

/** All that was asked for is drawn. */
export async function still(page) {
  await page.locator('.scene-stage[aria-busy="false"]').waitFor({ timeout: 120_000 });
}

/** On a dense screen every picture at rest has the same number of pixels, however quick the machine is. */
export async function opened(name, size) {
  const one = await openReport(report(name), { ...size, deviceScaleFactor: 2 });
  await canvas(one.page).scrollIntoViewIfNeeded();
  await one.page.locator('.scene-message').waitFor({ state: 'hidden', timeout: 60_000 });
  await still(one.page);
  return one;
}

/** Plays to the end: the numbers of the states that were shown. None is missed, however short it is to be seen. */
export async function played(page) {
  const shown = await page.evaluateHandle(() => {
    const label = document.querySelector('.scene-state');
    const numbers = [];
    new MutationObserver(() => numbers.push(Number.parseInt(label.textContent, 10)))
      .observe(label, { childList: true, characterData: true, subtree: true });
    return numbers;
  });
  await page.getByRole('button', { name: 'Play the states' }).click();
  await page.locator('button[aria-label="Play the states"][aria-pressed="false"]').waitFor({ timeout: 120_000 });
  return shown.jsonValue();
}

/** Waits until the caption says so, and the picture shows it. */
export async function says(page, text) {
  await page.locator('.scene-caption').filter({ hasText: text }).waitFor();
  await still(page);
}

/** Of a PNG: how many pixels are not white, how many colours there are, and which lean to red and blue. */
export async function seen(page, png) {
  return page.evaluate(
    async (address) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      const drawing = document.createElement('canvas');
      [drawing.width, drawing.height] = [image.width, image.height];
      const pen = drawing.getContext('2d');
      pen.drawImage(image, 0, 0);
      const { data } = pen.getImageData(0, 0, image.width, image.height);
      const colours = new Set();
      let [marked, red, blue] = [0, 0, 0];
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b] = [data[i], data[i + 1], data[i + 2]];
        colours.add((r << 16) | (g << 8) | b);
        if (r < 245 || g < 245 || b < 245) ++marked;
        if (r > b + 60) ++red;
        if (b > r + 60) ++blue;
      }
      return { marked, red, blue, colours: colours.size };
    },
    `data:image/png;base64,${png.toString('base64')}`,
  );
}

/** The picture without what is written over it and the frame of what has the focus. */
export async function picture(page) {
  await still(page);
  await page.evaluate(() => document.activeElement.blur());
  const over = page.locator('.scene-over, .scene-picked');
  await over.evaluateAll((parts) => parts.forEach((part) => (part.style.visibility = 'hidden')));
  const png = await canvas(page).screenshot();
  await over.evaluateAll((parts) => parts.forEach((part) => (part.style.visibility = '')));
  return png;
}

export function same(one, other, what = 'the same picture') {
  assert.ok(one.equals(other), what);
}

export function different(one, other) {
  assert.ok(!one.equals(other), 'another picture');
}

export async function press(page, key) {
  await canvas(page).focus();
  await page.keyboard.press(key);
  // A frame is asked for by the key already.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** Columns of a CSV file of results, by name. */
export async function columns(path) {
  const [head, ...lines] = (await readFile(report(path), 'utf8')).trim().split('\n');
  const names = head.split(',');
  return Object.fromEntries(names.map((name, i) => [name, lines.map((line) => Number(line.split(',')[i]))]));
}

/** What the panel of a picked thing says: its kind and id, and numbers by name. */
export async function panel(page) {
  const box = page.locator('.scene-picked');
  const [kind, id] = (await box.locator('strong').textContent()).split(' ');
  const rows = await box
    .locator('tr')
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  return { kind, id: Number(id), said: Object.fromEntries(rows) };
}

/** Single precision, stored and scaled (1e-7), shown with seven digits (5e-7). */
export function near(text, value, name, size = Math.abs(value)) {
  assert.ok(Math.abs(parseFloat(text) - value) <= 6e-7 * size, `${name}: ${text} is not ${value}`);
}
