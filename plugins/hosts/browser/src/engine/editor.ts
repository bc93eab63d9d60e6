// The drawing, and all edits of it: `talweg::editing::Editor`.
import { loadModule } from './load';
import type { Module } from './module';
import type { Curve, Drawing, Ends, OffsetSettings, RidgeKind, Vec3 } from './types';

interface Place {
  face: number;
  barycentric: Vec3;
}

/** Frees editors of the module whose objects were collected. */
const gone = new FinalizationRegistry<{ module: Module; number: number }>(
  ({ module, number }) => module.call(`editor.${number}.end`, []));

/** Each edit is one step of undo; a refused edit throws Error with a sentence. */
export class Editor {
  private constructor(private readonly module: Module, private readonly number: number) {
    gone.register(this, { module, number });
  }

  /** An empty drawing. */
  static async load(): Promise<Editor> {
    const module = await loadModule();
    return new Editor(module, module.call<number>('editor.new', []));
  }

  drawing(): Drawing { return this.call('drawing'); }
  isDrawing(): boolean { return this.call('isDrawing'); }

  addPoint(p: Place): void { this.call('addPoint', p); }
  paintPoint(p: Place): void { this.call('paintPoint', p); }
  takeBackPoint(): void { this.call('takeBackPoint'); }
  finishCurve(): void { this.call('finishCurve'); }
  closeCurve(): void { this.call('closeCurve'); }
  dropCurve(): void { this.call('dropCurve'); }

  removeCurve(curve: number): void { this.call('removeCurve', curve); }
  addCurve(curve: Curve): void { this.call('addCurve', curve); }
  setClosed(curve: number, closed: boolean): void { this.call('setClosed', curve, closed); }
  reverseCurve(curve: number): void { this.call('reverseCurve', curve); }
  continueCurve(curve: number): void { this.call('continueCurve', curve); }
  clear(): void { this.call('clear'); }
  renameCurve(curve: number, name: string): void { this.call('renameCurve', curve, name); }
  setCurveTau(curve: number, tau: number | null): void { this.call('setCurveTau', curve, tau); }
  setCurveTolerance(curve: number, tolerance: number | null): void {
    this.call('setCurveTolerance', curve, tolerance);
  }
  pinCurve(curve: number, pinned: boolean): void { this.call('pinCurve', curve, pinned); }

  movePoint(curve: number, point: number, p: Place): void { this.call('movePoint', curve, point, p); }
  insertPoint(curve: number, before: number, p: Place): void { this.call('insertPoint', curve, before, p); }
  removePoint(curve: number, point: number): void { this.call('removePoint', curve, point); }
  setPinned(curve: number, point: number, pinned: boolean): void {
    this.call('setPinned', curve, point, pinned);
  }

  setTau(tau: number): void { this.call('setTau', tau); }
  setSlack(slack: number | null): void { this.call('setSlack', slack); }
  setMaxDeviation(bound: number | null): void { this.call('setMaxDeviation', bound); }
  setPaper(paper: boolean): void { this.call('setPaper', paper); }
  setEnds(ends: Ends): void { this.call('setEnds', ends); }
  setClickDistance(distance: number | null): void { this.call('setClickDistance', distance); }
  setRidges(strength: number): void { this.call('setRidges', strength); }
  setRidgeKind(kind: RidgeKind): void { this.call('setRidgeKind', kind); }
  setOffset(offset: OffsetSettings): void { this.call('setOffset', offset); }

  /** The name of the step that was undone; null: there was none. */
  undo(): string | null { return this.call('undo'); }
  redo(): string | null { return this.call('redo'); }
  undoName(): string | null { return this.call('undoName'); }
  redoName(): string | null { return this.call('redoName'); }

  /** Until endGesture() all edits are one step. */
  beginGesture(name = 'Change'): void { this.call('beginGesture', name); }
  endGesture(): void { this.call('endGesture'); }

  /** The drawing as JSON, for sessions. */
  state(): string { return JSON.stringify(this.drawing()); }
  /** Replaces the drawing, with a new history. */
  restore(state: string): void { this.call('restore', JSON.parse(state)); }

  /**
   * The index at which a new point is inserted into the given points. The new point was picked on a
   * line through the given points, between the line's points `segment` and `segment + 1`. Arrays
   * have three numbers per point.
   */
  legAt(given: Float64Array, line: Float64Array, closed: boolean, segment: number): number {
    return this.call('legAt', Array.from(given), Array.from(line), closed, segment);
  }

  private call<Result>(name: string, ...args: unknown[]): Result {
    return this.module.call<Result>(`editor.${this.number}.${name}`, args);
  }
}
