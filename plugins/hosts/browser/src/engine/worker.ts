// The worker of the engine: does requests one after the other.
import { loadModule } from './load';

/** A call of the module. */
export interface Request {
  id: number;
  name: string;
  args: unknown[];
  bytes?: ArrayBuffer;
}
/** A message with the id 0 comes once, when the module is loaded. */
export type Reply = { id: number; answer: unknown } | { id: number; error: string };

const page = self as unknown as {
  postMessage(reply: Reply, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<Request>) => void) | null;
};

/** The buffers of all arrays in an answer, which are transferred without a copy. */
function buffers(value: unknown): Transferable[] {
  if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
  if (Array.isArray(value)) return value.flatMap(buffers);
  return value !== null && typeof value === 'object' ? Object.values(value).flatMap(buffers) : [];
}

async function unpacked(name: string, bytes: ArrayBuffer): Promise<Uint8Array> {
  if (!/\.gz$/i.test(name)) return new Uint8Array(bytes);
  try {
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new Error(`Cannot read ${name}: it is not packed by gzip, or damaged.`);
  }
}

async function answer({ id, name, args, bytes }: Request): Promise<void> {
  try {
    const module = await loadModule();
    const file = typeof args[0] === 'string' ? args[0] : '';
    const unpackedBytes = bytes && (await unpacked(file, bytes));
    if (unpackedBytes) args = args.map((arg, k) => (k === 0 && file ? file.replace(/\.gz$/i, '') : arg));
    const result = module.call(name, args, unpackedBytes);
    page.postMessage({ id, answer: result }, buffers(result));
  } catch (error) {
    page.postMessage({ id, error: error instanceof Error ? error.message : String(error) }, []);
  }
}

page.onmessage = (event) => void answer(event.data);
loadModule().then(() => page.postMessage({ id: 0, answer: null }, []),
  (error: unknown) => page.postMessage({ id: 0, error: String(error) }, []));
