// What the page expects of the editor.
import type { Curve, Drawing, Vec3 } from './types';

interface Place {
  face: number;
  barycentric: Vec3;
}

/** `talweg::editing::Editor`. Each edit is one step; one that cannot be done throws Error with a sentence. */
export class Editor {
  static load(): Promise<Editor>;
  drawing(): Drawing;
  isDrawing(): boolean;
  addPoint(p: Place): void;
  paintPoint(p: Place): void;
  takeBackPoint(): void;
  finishCurve(): void;
  closeCurve(): void;
  dropCurve(): void;
  removeCurve(curve: number): void;
  addCurve(curve: Curve): void;
  setClosed(curve: number, closed: boolean): void;
  reverseCurve(curve: number): void;
  continueCurve(curve: number): void;
  clear(): void;
  renameCurve(curve: number, name: string): void;
  setCurveTau(curve: number, tau: number | null): void;
  setCurveTolerance(curve: number, tolerance: number | null): void;
  pinCurve(curve: number, pinned: boolean): void;
  movePoint(curve: number, point: number, p: Place): void;
  insertPoint(curve: number, before: number, p: Place): void;
  removePoint(curve: number, point: number): void;
  setPinned(curve: number, point: number, pinned: boolean): void;
  setTau(tau: number): void;
  setSlack(slack: number | null): void;
  setMaxDeviation(bound: number | null): void;
  /** The name of the step that was undone; null: there was none. */
  undo(): string | null;
  redo(): string | null;
  undoName(): string | null;
  redoName(): string | null;
  /** One step for a whole drag or slide. */
  beginGesture(): void;
  endGesture(): void;
  /** The drawing as JSON, for sessions. */
  state(): string;
  restore(state: string): void;
  /** Before which of the given points one belongs that was picked on the line; three numbers per point. */
  legAt(given: Float64Array, line: Float64Array, closed: boolean, segment: number): number;
}
