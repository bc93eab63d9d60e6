// Builds the page into a folder: node build.mjs --engine FOLDER --out FOLDER. The first folder has
// the compiled C++ part of the engine.
import { createHash } from 'node:crypto';
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build, transform } from 'esbuild';
import { inTheEngine, joined } from './licences.mjs';

const here = dirname(fileURLToPath(import.meta.url));

function option(name) {
  const at = process.argv.indexOf(name);
  return at > 0 ? process.argv[at + 1] : undefined;
}

const given = option('--out');
if (!given) throw new Error('usage: node build.mjs --out FOLDER [--engine FOLDER]');
const out = resolve(given);  // esbuild works in another folder
mkdirSync(out, { recursive: true });

const entries = ['src/main.ts', 'src/pick/prepare_worker.ts', 'src/view/coarse_worker.ts', 'src/engine/worker.ts'];
await build({
  absWorkingDir: here,
  entryPoints: entries.filter((file) => existsSync(join(here, file))),
  entryNames: '[name]',
  outdir: out,
  bundle: true,
  splitting: true,  // code that page and workers share is loaded once
  chunkNames: 'shared-[hash]',
  format: 'esm',
  target: 'es2022',
  minify: true,
  legalComments: 'none',  // licences.txt has the whole licences
  logLevel: 'warning',
});
for (const file of ['index.html', 'style.css', 'icon.svg', 'manifest.webmanifest']) cpSync(join(here, file), join(out, file));

const engine = option('--engine');
if (engine) {
  cpSync(join(engine, 'talweg.wasm'), join(out, 'talweg.wasm'));
  const script = readFileSync(join(engine, 'talweg.js'), 'utf8');
  writeFileSync(join(out, 'talweg.js'), (await transform(script, { minify: true, target: 'es2022' })).code);
}

/** The parts of the page by others, with their licences. */
function licences() {
  const others = ['three', 'three-mesh-bvh', 'meshoptimizer'].map((name) => {
    const folder = join(here, 'node_modules', name);
    const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    return `${name} ${version}\n\n${readFileSync(join(folder, readdirSync(folder).find((file) => /^LICENSE/.test(file))), 'utf8')}`;
  });
  return joined([...others, ...(engine ? inTheEngine(engine) : [])]);
}
writeFileSync(join(out, 'licences.txt'), licences());

/** All files of the folder with their SHA-256, which the service worker keeps. */
function filesOf(folder) {
  const names = readdirSync(folder).filter((name) => name !== 'service_worker.js').sort();
  return names.map((name) => {
    const hash = createHash('sha256').update(readFileSync(join(folder, name))).digest('base64');
    return [name, `sha256-${hash}`];
  });
}
const files = filesOf(out);
await build({
  absWorkingDir: here,
  entryPoints: ['src/offline/service_worker.ts'],
  outdir: out,
  bundle: true,
  format: 'iife',  // not every browser accepts modules as service workers
  target: 'es2022',
  minify: true,
  define: {
    FILES: JSON.stringify(Object.fromEntries(files)),
    VERSION: JSON.stringify(createHash('sha256').update(JSON.stringify(files)).digest('hex').slice(0, 16)),
  },
  logLevel: 'warning',
});
