// The licences of the parts by others, as texts.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** The licence of a Debian package, from its copyright file. */
function ofDebian(name) {
  const path = join('/usr/share/doc', name, 'copyright');
  if (existsSync(path)) return [`${name}\n\n${readFileSync(path, 'utf8')}`];
  throw new Error(`${path} does not exist, but the page must include the licence of ${name}.`);
}

/** The libraries in the engine: header files of this machine, and sources that CMake has
   unpacked. */
export function inTheEngine(folder) {
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

/** Talweg's licence, and those of parts, as one text. */
export function joined(parts) {
  const ours = readFileSync(new URL('../../../LICENSE', import.meta.url), 'utf8');
  return [`Talweg\n\n${ours}`, ...parts].join(`\n${'-'.repeat(72)}\n\n`);
}
