// Packs bytes as text, and back: sessions hold whole meshes.

/** The bytes, gzipped, in base 64. */
export async function packed(bytes: Uint8Array): Promise<string> {
  const zipped = await through(bytes, new CompressionStream('gzip'));
  let text = '';
  // A call has a limited number of arguments.
  for (let k = 0; k < zipped.length; k += 0x8000) text += String.fromCharCode(...zipped.subarray(k, k + 0x8000));
  return btoa(text);
}

/** Throws for text that is not an output of packed(). */
export async function unpacked(text: string): Promise<Uint8Array> {
  const zipped = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return through(zipped, new DecompressionStream('gzip'));
}

async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream) {
  const out = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(out).arrayBuffer());
}
