// talweg.js, written by the compiler; npm.mjs puts it into the package.
declare module 'talweg-engine' {
  type Instantiate = (imports: WebAssembly.Imports, receive: (made: WebAssembly.Instance) => void) => object;
  export default function talweg(given: { instantiateWasm: Instantiate }): Promise<import('../engine/module.js').Talweg>;
}
