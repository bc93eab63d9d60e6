// The page's WebAssembly module in node, called as src/engine/module.ts does.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const kinds = [Float64Array, Float32Array, Uint32Array, Int32Array, Uint8Array];

/** A new module: call(name, arguments, bytes), and memory(), its memory in MiB. */
export async function talwegModule(folder) {
  if (!existsSync(join(folder, 'talweg.js'))) {
    console.log('skipped: the page is not built (./run page)');
    process.exit(77);
  }
  const { default: make } = await import(pathToFileURL(join(folder, 'talweg.js')).href);
  const talweg = await make({ wasmBinary: readFileSync(join(folder, 'talweg.wasm')) });

  function text(string) {
    const room = talweg.lengthBytesUTF8(string) + 1;
    const at = talweg._malloc(room);
    talweg.stringToUTF8(string, at, room);
    return at;
  }
  function revived(_key, value) {
    if (value === null || typeof value !== 'object' || !('$array' in value)) return value;
    const k = value.$array;
    const at = talweg._talweg_array_data(k);
    return new kinds[talweg._talweg_array_kind(k)](talweg.HEAPU8.buffer, at, talweg._talweg_array_count(k)).slice();
  }
  function call(name, args = [], bytes = undefined) {
    if (bytes) {
      const at = talweg._talweg_room(bytes.length);
      talweg.HEAPU8.set(bytes, at);
    }
    const [nameAt, argsAt] = [text(name), text(JSON.stringify(args))];
    const reply = JSON.parse(talweg.UTF8ToString(talweg._talweg_call(nameAt, argsAt)), revived);
    talweg._free(nameAt);
    talweg._free(argsAt);
    if ('error' in reply) throw new Error(reply.error);
    return reply.answer;
  }
  return { call, memory: () => talweg.HEAPU8.length / 2 ** 20 };
}
