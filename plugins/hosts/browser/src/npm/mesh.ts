// An open mesh, and all that is done on it.
import { EngineError, type Module } from '../engine/module.js';
import type { Caps, Curve, CutResult, Line, Offset, SavedFile, Side, Smoothed } from '../engine/types.js';
import { drawingOf, drawnOf, type Drawn, type Options, type Place } from './drawing.js';
import { lengthOf } from './ply.js';
import { TalwegError, talwegError } from './talweg_error.js';

/** Whole numbers for faces, as the bytes of an Int32Array. */
function labelBytes(labels: ArrayLike<number>): Uint8Array {
  const values = new Int32Array(lengthOf('labels', labels));
  for (let face = 0; face < values.length; ++face) {
    values[face] = labels[face]!;
    if (values[face] !== labels[face]) {
      throw new TalwegError(`The label of face ${face} is ${String(labels[face])}: give whole numbers of 32 bits.`, 'usage');
    }
  }
  return new Uint8Array(values.buffer);
}

/** The ending of a file's name, with or without a point before. */
function endingOf(format: string): string {
  const ending = /^\.?([a-z0-9]+(?:\.[a-z0-9]+)*)$/i.exec(format)?.[1];
  if (ending) return ending;
  throw new TalwegError(`The format is "${String(format)}": give the ending of a file's name, such as "ply".`, 'usage');
}

/** A face of each vertex, and the vertex' corner in it: 3 * face + corner; -1 for a vertex of no face. */
function cornersOf(vertices: number, indices: ArrayLike<number>): Int32Array {
  const corners = new Int32Array(vertices).fill(-1);
  for (let k = indices.length - 1; k >= 0; --k) corners[indices[k]!] = k;
  return corners;
}

/**
 * An open mesh, made by openMesh(). Lengths are in the mesh's units, angles in radians. All calls end when
 * their work is done: in a page, call them in a worker. A wrong argument throws TalwegError and changes
 * nothing.
 */
export class Mesh {
  private readonly corners: Int32Array;
  /** The number of curves that were smoothed last. */
  private smoothed = 0;

  /** @internal */
  constructor(private module: Module | null, private readonly gone: (module: Module) => void,
              readonly vertices: number, readonly faces: number, indices: ArrayLike<number>,
              /** The changes of a repair, a sentence each. */
              readonly changes: readonly string[]) {
    this.corners = cornersOf(vertices, indices);
  }

  /** The place of a vertex, an index from 0. */
  at(vertex: number): Place {
    const corner = this.corners[vertex] ?? -1;
    if (corner < 0) {
      throw new TalwegError(`There is no vertex ${String(vertex)} in a triangle: vertices are counted from 0 to `
        + `${this.vertices - 1}.`, 'usage');
    }
    return { face: Math.floor(corner / 3), barycentric: [0, 1, 2].map((k) => Number(k === corner % 3)) as Place['barycentric'] };
  }

  /** The curves as they are drawn: joined along the surface, not smoothed. */
  draw(curves: Drawn[]): Line[] { return this.ask('draw', [drawingOf(curves, {}, this.faces)]); }

  /** Smooth curves near the drawn ones. Each has its `deviation`, the distance of every point to the
      drawing, and a `report`. */
  smooth(curves: Drawn[], options: Options = {}): Smoothed {
    const made = this.ask<Smoothed>('smooth', [drawingOf(curves, options, this.faces), 'rests']);
    this.smoothed = made.curves.length;
    return made;
  }

  /** Curves at a distance > 0 along the surface from all curves of the last smooth(). */
  offset(distance: number, { side = 'both', caps = 'round' }: { side?: Side; caps?: Caps } = {}): Offset {
    if (!(Number.isFinite(distance) && distance > 0)) {
      throw new TalwegError(`The distance is ${String(distance)}: give a number above 0, in mesh units.`, 'usage');
    }
    return this.ask('offset', [{ curves: Array.from({ length: this.smoothed }, (_, c) => c), distance, side, caps }]);
  }

  /** The pieces of the mesh along the smoothed curves. Positions are in single precision; saveMesh() has all
      digits. */
  cut(curves: Drawn[], options: Options = {}): CutResult {
    return this.ask('cut', [drawingOf(curves, options, this.faces), false]);
  }

  /** The borders between regions, as strokes to smooth. `labels` has a whole number for each face. */
  labels(labels: ArrayLike<number>): Drawn[] {
    return this.ask<Curve[]>('labels', [true], labelBytes(labels)).map(drawnOf);
  }

  /** A file with the curves that smooth() made last; `format` is the ending of its name: "json", "vtp",
      "vtk", "obj", "ply", "mrk.json", "fcsv"; "drawn.json" has the drawing. */
  saveCurves(format: string): SavedFile { return this.ask('saveCurves', [endingOf(format), 'smooth']); }

  /** A file with the mesh, or with the pieces of the last cut(); `format`: "ply", "obj", "stl", "vtp", ... */
  saveMesh(format: string): SavedFile { return this.ask('saveMesh', [endingOf(format)]); }

  /** Gives the memory to the next mesh. A second call does nothing, and any other throws. A mesh that is not
      disposed of is collected like other objects. */
  dispose(): void {
    if (this.module) this.gone(this.module);
    this.module = null;
  }

  private ask<Result>(name: string, args: unknown[], bytes?: Uint8Array): Result {
    if (!this.module) throw new TalwegError('The mesh was disposed of: open it again.', 'usage');
    try {
      return this.module.call<Result>(name, args, bytes);
    } catch (error) {
      if (!(error instanceof EngineError)) this.module = null;  // its memory is in no known state
      throw talwegError(error);
    }
  }
}
