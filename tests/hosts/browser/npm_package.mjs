// The npm package that ./run page has built: packed by npm, and installed as users install it.
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const built = process.env.TALWEG_NPM;
const examples = fileURLToPath(new URL('../../../docs/examples/npm/', import.meta.url));

if (!existsSync(join(built, 'package.json'))) {
  console.log('skipped: the npm package is not built (./run page)');
  process.exit(77);
}

export function run(folder, program, ...args) {
  return execFileSync(program, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}

/** A new folder, with the examples. */
export function withExamples() {
  const folder = mkdtempSync(join(tmpdir(), 'talweg-npm-'));
  cpSync(examples, folder, { recursive: true });
  return folder;
}

/** A new folder with the examples, and with the package in node_modules/. */
export function installed() {
  const folder = withExamples();
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }');
  run(built, 'npm', 'pack', '--offline', '--silent', '--pack-destination', folder);
  const archive = readdirSync(folder).find((name) => name.endsWith('.tgz'));
  run(folder, 'npm', 'install', '--offline', '--silent', '--no-audit', '--no-fund', `./${archive}`);
  return folder;
}

/** The package's exports. */
export const load = () => import(pathToFileURL(join(built, 'index.js')).href);
