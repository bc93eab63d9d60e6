// Builds the page into a folder: node build.mjs --engine FOLDER --out FOLDER. The first folder has
// the compiled C++ part of the engine.
import { createHash } from 'node:crypto';
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build, transform } from 'esbuild';

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

/** The licence of a Debian package, from its copyright file. */
function ofDebian(name) {
  const path = join('/usr/share/doc', name, 'copyright');
  if (existsSync(path)) return [`${name}\n\n${readFileSync(path, 'utf8')}`];
  throw new Error(`${path} is not there; the page gives the licence of ${name} on.`);
}

/** The libraries in the engine: header files of this machine, and sources that CMake has
   unpacked. */
function inTheEngine(folder) {
  const headers = ['libopenmesh-dev', 'libeigen3-dev', 'libfmt-dev', 'nlohmann-json3-dev', 'libfast-float-dev'];
  const sources = join(folder, '../sources');
  const texts = { pugixml: 'LICENSE.md', zlib: 'LICENSE' };
  const unpacked = Object.entries(texts).map(([name, file]) => {
    const archive = readdirSync(sources).find((one) => one.startsWith(`${name}_`));
    const inside = join(sources, archive, readdirSync(join(sources, archive))[0]);
    return `${name}\n\n${readFileSync(join(inside, file), 'utf8')}`;
  });
  return [...headers.flatMap((name) => ofDebian(name)), ...unpacked, ...ofDebian('emscripten')];
}

/** The parts of the page by others, with their licences. */
function licences() {
  const ours = readFileSync(join(here, '../../../LICENSE'), 'utf8');
  const others = ['three', 'three-mesh-bvh', 'meshoptimizer'].map((name) => {
    const folder = join(here, 'node_modules', name);
    const { version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    return `${name} ${version}\n\n${readFileSync(join(folder, readdirSync(folder).find((file) => /^LICENSE/.test(file))), 'utf8')}`;
  });
  return [`Talweg\n\n${ours}`, ...others, ...(engine ? inTheEngine(engine) : [])].join(`\n${'-'.repeat(72)}\n\n`);
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
