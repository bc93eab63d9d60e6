// The engine, all code with the mesh, in a worker.
import { commandOf, repairOption } from './command';
import type {
  Curve, CutResult, Drawing, Line, MeshInfo, Offset, OffsetWish, Point, SavedFile, Smoothed,
} from './types';
import type { Reply, Request } from './worker';

/** A newer request of the same kind has replaced this one. */
export class Replaced extends Error {}
/** The engine was ended. */
export class Ended extends Error {}

interface Waiting {
  request: Request;
  resolve(answer: unknown): void;
  reject(error: Error): void;
}

const onlyNewest = new Set(['smooth', 'draw', 'leg', 'offset']);

/**
 * Requests are done one after the other; a leg precedes waiting requests. Of smooth(), draw(),
 * leg() and offset() only the newest request of each kind waits; a replaced request rejects with
 * Replaced.
 */
export class Engine {
  private ids = 0;
  private waiting: Waiting[] = [];
  private running: Waiting | null = null;
  private ended = false;
  private mesh = { name: '', repair: '', unit: '' };
  private last: Drawing | null = null;

  private constructor(private readonly worker: Worker) {}

  static start(): Promise<Engine> {
    const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    const engine = new Engine(worker);
    const failed = 'The engine cannot be loaded: is talweg.wasm beside the page?';
    return new Promise((resolve, reject) => {
      engine.running = {
        request: { id: 0, name: '', args: [] },
        resolve: () => resolve(engine),
        reject: (error) => reject(new Error(`${failed} (${error.message})`)),
      };
      worker.onmessage = (event: MessageEvent<Reply>) => engine.take(event.data);
      worker.onerror = (event) => engine.fail(new Error(event.message || failed));
    });
  }

  /**
   * OBJ, OFF, PLY, STL, OM, VTK, VTP, MSH, glTF or 3MF, also packed by gzip. The bytes are
   * transferred, so the caller loses them. `weld` as in `Opening`.
   */
  async open(name: string, bytes: ArrayBuffer, repair = false, weld: number | null = null): Promise<MeshInfo> {
    const info = await this.ask<MeshInfo>('open', [name, repair, weld], bytes);
    this.mesh = { name, repair: repair ? repairOption(weld ?? info.weld?.tolerance ?? 0) : '', unit: '' };
    this.last = null;
    return info;
  }

  /** The unit of the mesh, for files that name a unit; empty: the unit of the mesh's file. */
  async setUnit(unit: string): Promise<void> {
    await this.ask('setUnit', [unit]);
    this.mesh = { ...this.mesh, unit };
  }

  /** Sizes and defects of the mesh as a text (mesh_words.hpp). */
  words(): Promise<string> { return this.ask('words', []); }

  sample(): Promise<{ name: string; bytes: Uint8Array }> { return this.ask('sample', []); }

  async smooth(drawing: Drawing, hand: 'rests' | 'slides' | 'drags'): Promise<Smoothed> {
    this.last = drawing;
    return this.ask('smooth', [drawing, hand]);
  }
  draw(drawing: Drawing): Promise<Line[]> { return this.ask('draw', [drawing]); }
  leg(from: Point, to: Point): Promise<Float64Array> { return this.ask('leg', [from, to]); }
  /** The comb of a curve of the last smoothing; empty during a movement of the hand. */
  comb(curve: number, spacing: number):
    Promise<{ roots: Float64Array; tips: Float64Array; curvature: Float64Array }> {
    return this.ask('comb', [curve, spacing]);
  }

  /** Offset of the curves that were last smoothed with the hand at rest. */
  offset(wish: OffsetWish): Promise<Offset> { return this.ask('offset', [wish]); }

  /** Cuts along the smoothed curves, or along their last offset. */
  cut(drawing: Drawing, alongOffset = false): Promise<CutResult> { return this.ask('cut', [drawing, alongOffset]); }
  keep(part: number, lids: boolean): Promise<CutResult> { return this.ask('keep', [part, lids]); }
  /** Borders of labels, one for each face; null: of the mesh's own labels. */
  labels(values: Int32Array | null): Promise<Curve[]> {
    return this.ask('labels', [values !== null], values?.slice().buffer);
  }

  /** "drawn.json" is the drawing itself; all other formats have the smoothed curves or their
     offset. */
  saveCurves(format: string, what: 'smooth' | 'offset' = 'smooth'): Promise<SavedFile> {
    return this.ask('saveCurves', [format, what]);
  }
  /** The mesh, or the result of the last cut. */
  saveMesh(format: string): Promise<SavedFile> { return this.ask('saveMesh', [format]); }
  /** A file for each part of the cut mesh. */
  saveParts(format: string, lids: boolean): Promise<SavedFile[]> { return this.ask('saveParts', [format, lids]); }
  readCurves(name: string, bytes: ArrayBuffer): Promise<Curve[]> {
    return this.ask('readCurves', [name], bytes);
  }

  /** The driver's command line for the saved files; `offset`: the offset of all curves, if there is
     one. */
  command(offset: Omit<OffsetWish, 'curves'> | null): string {
    return commandOf(this.mesh, this.last, offset);
  }

  /** Ends the worker at once. */
  end(): void {
    this.ended = true;
    this.worker.terminate();
    this.fail(new Ended('The engine was ended.'));
  }

  private ask<Result>(name: string, args: unknown[], bytes?: ArrayBuffer): Promise<Result> {
    if (this.ended) return Promise.reject(new Ended('The engine was ended.'));
    return new Promise<Result>((resolve, reject) => {
      const request: Request = { id: ++this.ids, name, args, ...(bytes && { bytes }) };
      const mine: Waiting = { request, resolve: (answer) => resolve(answer as Result), reject };
      if (onlyNewest.has(name)) this.replace(name);
      if (name === 'leg') this.waiting.unshift(mine);
      else this.waiting.push(mine);
      this.next();
    });
  }

  private replace(name: string): void {
    const old = this.waiting.filter(({ request }) => request.name === name);
    this.waiting = this.waiting.filter(({ request }) => request.name !== name);
    for (const { reject } of old) reject(new Replaced('A newer request has taken its place.'));
  }

  private next(): void {
    if (this.running) return;
    this.running = this.waiting.shift() ?? null;
    if (!this.running) return;
    const { request } = this.running;
    this.worker.postMessage(request, request.bytes ? [request.bytes] : []);
  }

  private take(reply: Reply): void {
    const done = this.running;
    if (!done || done.request.id !== reply.id) return;
    this.running = null;
    if ('error' in reply) done.reject(new Error(reply.error));
    else done.resolve(reply.answer);
    this.next();
  }

  private fail(error: Error): void {
    const all = [...(this.running ? [this.running] : []), ...this.waiting];
    this.running = null;
    this.waiting = [];
    for (const { reject } of all) reject(error);
  }
}
