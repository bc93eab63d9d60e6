// The page's engine: talweg.js and talweg.wasm beside the page.
import { Module, type Talweg } from './module';

let loaded: Promise<Module> | undefined;

async function make(): Promise<Module> {
  const address = new URL('./talweg.js', import.meta.url).href;
  const { default: talweg } = (await import(address)) as { default: () => Promise<Talweg> };
  return new Module(await talweg());
}

/** The module of this thread. */
export function loadModule(): Promise<Module> {
  loaded ??= make();
  return loaded;
}
