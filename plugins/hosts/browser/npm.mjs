// Makes the folder of the npm package: node npm.mjs --engine FOLDER --out FOLDER. The first folder has the
// compiled C++ part of the engine.
import { execFileSync } from 'node:child_process';
import { cpSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from 'esbuild';
import { inTheEngine, joined } from './licences.mjs';

const here = dirname(fileURLToPath(import.meta.url)), root = join(here, '../../..');
const { values } = parseArgs({ options: { engine: { type: 'string' }, out: { type: 'string' } } });
if (!values.engine || !values.out) throw new Error('usage: node npm.mjs --engine FOLDER --out FOLDER');
const engine = resolve(values.engine), out = resolve(values.out);

rmSync(out, { recursive: true, force: true });
await build({
  absWorkingDir: here,
  entryPoints: ['src/npm/index.ts'],
  alias: { 'talweg-engine': join(engine, 'talweg.js') },
  outfile: join(out, 'index.js'),
  bundle: true,
  format: 'esm',
  target: 'es2022',
  legalComments: 'none',  // licences.txt has the whole licences; bundlers of users make it smaller
  logLevel: 'warning',
});
execFileSync(process.execPath, [join(here, 'node_modules/typescript/bin/tsc'), '--project',
  join(here, 'tsconfig.npm.json'), '--outDir', join(out, 'types')], { stdio: 'inherit' });
cpSync(join(engine, 'talweg.wasm'), join(out, 'talweg.wasm'));
cpSync(join(root, 'LICENSE'), join(out, 'LICENSE'));
cpSync(join(here, 'src/npm/README.md'), join(out, 'README.md'));
writeFileSync(join(out, 'licences.txt'), joined(inTheEngine(engine)));

const version = /^project\(talweg VERSION ([\d.]+)/m.exec(readFileSync(join(root, 'CMakeLists.txt'), 'utf8'))[1];
writeFileSync(join(out, 'package.json'), `${JSON.stringify({
  name: 'talweg',
  version,
  description: 'Smooth curves on triangle meshes, in Node and browsers',
  license: 'MIT',
  type: 'module',
  exports: { '.': { types: './types/npm/index.d.ts', default: './index.js' }, './talweg.wasm': './talweg.wasm' },
  types: './types/npm/index.d.ts',
  engines: { node: '>=18' },
  sideEffects: false,
}, null, 2)}\n`);
