// talweg.wasm: calls by name, with arguments and answers in JSON and arrays of numbers beside them
// (engine/calls.cpp). The page and the npm package load it in ways of their own.

/** The object that talweg.js, written by the compiler, makes. */
export interface Talweg {
  HEAPU8: Uint8Array;
  _malloc(bytes: number): number;
  _free(at: number): void;
  _talweg_call(name: number, args: number): number;
  _talweg_room(bytes: number): number;
  _talweg_array_kind(array: number): number;
  _talweg_array_count(array: number): number;
  _talweg_array_data(array: number): number;
  UTF8ToString(at: number): string;
  stringToUTF8(text: string, at: number, room: number): void;
  lengthBytesUTF8(text: string): number;
}

/** An error that the engine has told; the message is a sentence, the status a `talweg_status`. */
export class EngineError extends Error {
  constructor(sentence: string, readonly status: number) { super(sentence); }
}

const outOfMemory = 6;  // TALWEG_OUT_OF_MEMORY

/** In the order of NumberKind in engine/answer.hpp. */
const kinds = [Float64Array, Float32Array, Uint32Array, Int32Array, Uint8Array];

export class Module {
  constructor(private readonly talweg: Talweg) {}

  /** Throws EngineError with the library's sentence. Arrays in the result are copies. */
  call<Result>(name: string, args: unknown[], bytes?: Uint8Array): Result {
    const { talweg } = this;
    if (bytes) this.put(bytes);
    const name_at = this.text(name);
    const args_at = this.text(JSON.stringify(args));
    const text = talweg.UTF8ToString(talweg._talweg_call(name_at, args_at));
    talweg._free(name_at);
    talweg._free(args_at);
    const result = JSON.parse(text, (_key, value: unknown) => this.revived(value)) as
      { answer: Result } | { error: string; status: number };
    if ('error' in result) throw new EngineError(result.error, result.status);
    return result.answer;
  }

  private put(bytes: Uint8Array): void {
    const at = this.talweg._talweg_room(bytes.length);
    if (at === 0 && bytes.length > 0) throw new EngineError('There is not enough memory for the file.', outOfMemory);
    this.talweg.HEAPU8.set(bytes, at);
  }

  private text(text: string): number {
    const room = this.talweg.lengthBytesUTF8(text) + 1;
    const at = this.talweg._malloc(room);
    if (at === 0) throw new EngineError('There is not enough memory.', outOfMemory);
    this.talweg.stringToUTF8(text, at, room);
    return at;
  }

  private revived(value: unknown): unknown {
    if (value === null || typeof value !== 'object' || !('$array' in value)) return value;
    const array = value.$array as number;
    const Numbers = kinds[this.talweg._talweg_array_kind(array)]!;
    const at = this.talweg._talweg_array_data(array);
    const count = this.talweg._talweg_array_count(array);
    return new Numbers(this.talweg.HEAPU8.buffer as ArrayBuffer, at, count).slice();
  }
}
