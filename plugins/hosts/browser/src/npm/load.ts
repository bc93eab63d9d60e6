// Engines for meshes: talweg.wasm is read and compiled once, and each engine has a memory of its own.
import talweg from 'talweg-engine';
import { Module } from '../engine/module.js';
import { TalwegError } from './talweg_error.js';

let compiled: Promise<WebAssembly.Module> | undefined;

async function read(url: URL): Promise<Uint8Array | ArrayBuffer> {
  if (url.protocol === 'file:') {
    const files = 'node:fs/promises';  // a name in a variable, and comments: bundlers for browsers leave it alone
    const { readFile } = (await import(/* @vite-ignore */ /* webpackIgnore: true */ files)) as
      { readFile(from: URL): Promise<Uint8Array> };
    return readFile(url);
  }
  const answer = await fetch(url);
  if (!answer.ok) throw new Error(`the server answers ${answer.status}`);
  return answer.arrayBuffer();
}

async function compile(): Promise<WebAssembly.Module> {
  const url = new URL('./talweg.wasm', import.meta.url);
  try {
    return await WebAssembly.compile((await read(url)) as BufferSource);
  } catch (error) {
    compiled = undefined;  // the next mesh tries again
    const why = error instanceof Error ? error.message : String(error);
    throw new TalwegError(`Cannot load ${url.href}: ${why}. The file belongs beside the package's index.js.`, 'file');
  }
}

/** An engine with a memory of its own. */
export async function newModule(): Promise<Module> {
  const wasm = await (compiled ??= compile());
  return new Promise((resolve, reject) => {
    function instantiateWasm(imports: WebAssembly.Imports, receive: (made: WebAssembly.Instance) => void): object {
      WebAssembly.instantiate(wasm, imports).then(receive, reject);
      return {};
    }
    talweg({ instantiateWasm }).then((made) => resolve(new Module(made)), reject);
  });
}
