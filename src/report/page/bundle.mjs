/**
 * node bundle.mjs MODULES OUT: makes one script and one style sheet of the page, and writes them as the C++
 * file OUT. MODULES is the folder node_modules, wherever it lies.
 */
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const [modules, out] = process.argv.slice(2).map((path) => resolve(path));
const page = dirname(fileURLToPath(import.meta.url));
const { buildSync } = createRequire(join(modules, 'any'))('esbuild');

const shipped = ['three', 'uplot'];
const licences = shipped.map((name) => `${name}\n\n${readFileSync(join(modules, name, 'LICENSE'), 'utf8').trim()}`);

const { outputFiles } = buildSync({
  entryPoints: [join(page, 'main.ts')],
  outdir: page,
  write: false,
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  nodePaths: [modules],
  legalComments: 'none',
  banner: { js: `/*! This page contains:\n\n${licences.join('\n\n')}\n*/` },
});

const text = (ending) => outputFiles.find((file) => file.path.endsWith(ending))?.text ?? '';
const script = text('.js');
const style = text('.css');
for (const [what, found] of [['a script', script], ['a style', style]])
  if (found === '' || /<\/(script|style)/i.test(found)) throw new Error(`${what} that cannot stand inline`);

/** A compiler need not take a literal of a megabyte, but adjacent ones; "sv" spares it counting the letters. */
function literal(content) {
  const pieces = content.match(/[\s\S]{1,16000}/g) ?? [''];
  if (content.includes(')page"')) throw new Error('the delimiter of the literals is taken');
  return `${pieces.map((piece) => `R"page(${piece})page"`).join('\n')}sv`;
}

const hash = createHash('sha256').update(script).digest('base64');
writeFileSync(
  out,
  `#include "report/page_bundle.hpp"

namespace bondstatic {

const PageBundle* page_bundle() {
  using namespace std::string_view_literals;
  static constexpr PageBundle bundle{
      ${literal(script)},
      ${literal(style)},
      "sha256-${hash}"};
  return &bundle;
}

}  // namespace bondstatic
`,
);
