// Builds the page into a folder: node build.mjs --engine FOLDER --out FOLDER. The first folder has what
// the C++ side of the engine was compiled to.
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));

function option(name) {
  const at = process.argv.indexOf(name);
  return at > 0 ? process.argv[at + 1] : undefined;
}

const given = option('--out');
if (!given) throw new Error('usage: node build.mjs --out FOLDER [--engine FOLDER]');
const out = resolve(given);  // esbuild has a working folder of its own
mkdirSync(out, { recursive: true });

const entries = ['src/main.ts', 'src/pick/prepare_worker.ts', 'src/engine/worker.ts'];
await build({
  absWorkingDir: here,
  entryPoints: entries.filter((file) => existsSync(join(here, file))),
  entryNames: '[name]',
  outdir: out,
  bundle: true,
  splitting: true,  // what page and workers share is loaded once
  chunkNames: 'shared-[hash]',
  format: 'esm',
  target: 'es2022',
  minify: true,
  legalComments: 'none',  // licences.txt has them whole
  logLevel: 'warning',
});
for (const file of ['index.html', 'style.css', 'icon.svg']) cpSync(join(here, file), join(out, file));

const engine = option('--engine');
if (engine) {
  for (const file of readdirSync(engine)) {
    if (/\.(wasm|js)$/.test(file)) cpSync(join(engine, file), join(out, file));
  }
}

/** What is in the page and not ours, with its licence. */
function licences() {
  const ours = readFileSync(join(here, '../../../LICENSE'), 'utf8');
  const others = ['three', 'three-mesh-bvh'].map((name) => {
    const folder = join(here, 'node_modules', name);
    const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    return `${name} ${version}\n\n${readFileSync(join(folder, 'LICENSE'), 'utf8')}`;
  });
  return [`Talweg\n\n${ours}`, ...others].join(`\n${'-'.repeat(72)}\n\n`);
}
writeFileSync(join(out, 'licences.txt'), licences());
