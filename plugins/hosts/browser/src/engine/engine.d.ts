// What the page expects of the engine.
import type { Curve, CutResult, Drawing, Line, MeshInfo, Point, SavedFile, Smoothed } from './types';

/** A newer request of the same kind has taken this one's place. */
export class Replaced extends Error {}
/** The engine was ended. */
export class Ended extends Error {}

/** Everything that knows the mesh, in a worker. Of smooth(), draw() and leg() only the newest counts. */
export class Engine {
  static start(): Promise<Engine>;
  open(name: string, bytes: ArrayBuffer, repair?: boolean): Promise<MeshInfo>;
  sample(): Promise<{ name: string; bytes: Uint8Array }>;
  smooth(drawing: Drawing, hand: 'rests' | 'slides' | 'drags'): Promise<Smoothed>;
  draw(drawing: Drawing): Promise<Line[]>;
  leg(from: Point, to: Point): Promise<Float64Array>;
  comb(curve: number, spacing: number):
    Promise<{ roots: Float64Array; tips: Float64Array; curvature: Float64Array }>;
  cut(drawing: Drawing): Promise<CutResult>;
  keep(part: number, lids: boolean): Promise<CutResult>;
  /** Borders of a label per face, or of the mesh's own labels. */
  labels(values: Int32Array | null): Promise<Curve[]>;
  saveCurves(format: string): Promise<SavedFile>;
  saveMesh(format: string): Promise<SavedFile>;
  readCurves(name: string, bytes: ArrayBuffer): Promise<Curve[]>;
  /** The command line that does the same. */
  command(): string;
  /** Ends the worker, whatever it does. */
  end(): void;
}
