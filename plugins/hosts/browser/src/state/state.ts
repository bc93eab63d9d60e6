// The state of the page, as one value. Its parts are replaced, never changed in place.
import type {
  Curve, CutResult, Drawing, Line, MeshInfo, Offset, OffsetSettings, Smoothed, Vec3,
} from '../engine/types';
import type { Aside } from '../session/asides';

/** A place on the mesh. */
export interface Place {
  face: number;
  barycentric: Vec3;
  position: Vec3;
}

/** The options with which a mesh was opened. */
export interface Opening {
  repaired: boolean;
  /** The tolerance of a repair's welding, mesh units; null: chosen from the mesh. */
  weld?: number | null;
  /** The UCUM code of the unit that the user has chosen; empty: the unit of the mesh's file. */
  unit?: string;
}

export interface OpenMesh extends Opening {
  /** Unique among opened meshes. */
  id: number;
  name: string;
  /** The file's bytes, for the session and for a new engine. */
  bytes: Uint8Array;
  info: MeshInfo;
}

/** The object under the mouse, or under the keyboard's cursor. */
export type Under =
  | { kind: 'nothing' }
  | { kind: 'mesh'; place: Place }
  | { kind: 'point'; curve: number; point: number; place: Place }
  | { kind: 'line'; curve: number; segment: number; place: Place };

export type Colouring = 'plain' | 'turning' | 'deviation';

export interface Show {
  drawing: boolean;
  comb: boolean;
  worst: boolean;
  colour: Colouring;
  /** Whether lengths are written beside the curves. */
  lengths: boolean;
}

export interface Chosen {
  curve: number;
  /** null: the whole curve. */
  point: number | null;
}

/** Comb teeth of one curve: three numbers per root and tip. */
export interface Comb {
  roots: Float64Array;
  tips: Float64Array;
}

/** The parts of the panel that sentences about errors stand beside. */
export type Spot = 'mesh' | 'drawing' | 'settings' | 'offset' | 'cut' | 'files' | 'session';

export interface State {
  mesh: OpenMesh | null;
  /** Another mesh is being opened: nothing can be drawn on the shown one. */
  opening: boolean;
  /** Drawings on other meshes, the newest first. */
  asides: Aside[];
  /** A file with defects, which waits for the user's command to repair it. */
  refused: { name: string; bytes: Uint8Array; info: MeshInfo } | null;
  drawing: Drawing;
  undo: string | null;
  redo: string | null;
  /** Sizes and defects of the mesh as a text (mesh_words.hpp); null until requested. */
  words: string | null;
  /** The drawn curves on the mesh. */
  drawn: Line[];
  smoothed: Smoothed | null;
  /** The next leg, from the last point to the mouse; three numbers per point. */
  leg: Float64Array | null;
  combs: Comb[];
  /** The result of the drawing's offset; null without one. */
  offsets: Offset | null;
  cut: CutResult | null;
  /** The part of the cut that is kept alone; null: all parts are shown. */
  kept: number | null;
  lids: boolean;
  chosen: Chosen | null;
  cursor: Place | null;
  under: Under;
  show: Show;
  busy: { what: string; since: number } | null;
  trouble: Partial<Record<Spot, string>>;
  /** The last event, for screen readers. */
  told: string;
  onMachine: boolean;
  /** Another tab stores its session on this machine, so this tab does not. */
  otherTab: boolean;
}

/** The distance is chosen for the mesh. */
const noOffset: OffsetSettings = { on: false, of: null, distance: 0, side: 'both', caps: 'round' };

export const emptyDrawing: Drawing = {
  curves: [],
  unfinished: false,
  settings: {
    tau: 1, slack: null, maxDeviation: null, paper: false, ends: 'auto', clickDistance: null, ridges: 0,
    ridgeKind: 'both',
  },
  offset: noOffset,
};

export const firstState: State = {
  mesh: null,
  opening: false,
  asides: [],
  refused: null,
  drawing: emptyDrawing,
  undo: null,
  redo: null,
  words: null,
  drawn: [],
  smoothed: null,
  leg: null,
  combs: [],
  offsets: null,
  cut: null,
  kept: null,
  lids: false,
  chosen: null,
  cursor: null,
  under: { kind: 'nothing' },
  show: { drawing: true, comb: false, worst: false, colour: 'plain', lengths: true },
  busy: null,
  trouble: {},
  told: '',
  onMachine: false,
  otherTab: false,
};

/** The user's name for the curve, or "Curve" with its number. */
export function nameOf(curve: Curve): string {
  return curve.name || `Curve ${curve.number}`;
}

export function wasClicked(exact: number): boolean {
  return exact >= 0;
}

/** Whether the drawing has strokes; slack and largest deviation have an effect only on strokes. */
export function hasStrokes(drawing: Drawing): boolean {
  return drawing.curves.some((curve) => curve.points.some((point) => !wasClicked(point.exact)));
}
