/**
 * Opens reports as a reader does: by a file:// URL, in headless Chromium, with nothing else running.
 *
 * Environment: BONDSTATIC_NODE_MODULES, the folder where playwright-core is installed; BONDSTATIC_REPORT_DIR,
 * the folder of report files that the program made; BONDSTATIC_CHROMIUM, the browser (/usr/bin/chromium).
 */
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

function fromEnvironment(name) {
  const value = process.env[name];
  if (!value) throw new Error(`${name} is not set; see the head of page.mjs`);
  return resolve(value);
}

const { chromium } = createRequire(join(fromEnvironment('BONDSTATIC_NODE_MODULES'), 'any.js'))('playwright-core');

/** WebGL without a graphics card, and no traffic of the browser's own. */
const flags = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist',
  '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'];

/** What the software renderer says about its own speed is nothing that a page could cure. */
const ofTheRenderer = /GL Driver Message \(OpenGL, Performance|software WebGL|GPU stall due to ReadPixels/;

/** A report file that the program made. */
export function report(name) {
  return join(fromEnvironment('BONDSTATIC_REPORT_DIR'), name);
}

/**
 * The page of `path` after it has loaded, and `problems`: what the console warned of, what was thrown, and each
 * request for anything but the file itself. The list goes on growing while the page is used.
 */
export async function openReport(path, { width = 1400, height = 900, colorScheme = 'light', deviceScaleFactor = 1 } = {}) {
  const browser = await chromium.launch({
    executablePath: process.env.BONDSTATIC_CHROMIUM ?? '/usr/bin/chromium', args: flags,
  });
  try {
    const context = await browser.newContext({ viewport: { width, height }, colorScheme, deviceScaleFactor, acceptDownloads: true });
    const page = await context.newPage();
    const url = pathToFileURL(resolve(path)).href;
    const problems = [];
    page.on('console', (message) => {
      const told = ['error', 'warning'].includes(message.type());
      if (told && !ofTheRenderer.test(message.text())) problems.push(`${message.type()}: ${message.text()}`);
    });
    page.on('pageerror', (error) => problems.push(`thrown: ${error.stack ?? error}`));
    page.on('dialog', (dialog) => {
      problems.push(`dialog: ${dialog.message()}`);
      dialog.dismiss();
    });
    page.on('request', (request) => {
      const asked = request.url().split('#')[0];
      if (asked !== url && !/^(data|blob):/.test(asked)) problems.push(`request: ${asked}`);
    });
    await page.goto(url, { waitUntil: 'load' });
    return { page, problems, close: () => browser.close() };
  } catch (error) {
    await browser.close();
    throw error;
  }
}
