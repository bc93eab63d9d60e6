// Everything that the page shows, as one value. Parts of it are replaced, never changed in place.
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

/** How a mesh was opened, to open it so again. */
export interface Opening {
  repaired: boolean;
  /** A repair welds within so many mesh units; null: as far as the mesh seems to ask for. */
  weld?: number | null;
  /** The UCUM code of the unit that a person has said; empty: what its file says. */
  unit?: string;
}

export interface OpenMesh extends Opening {
  /** Tells one opened mesh from the next. */
  id: number;
  name: string;
  /** The file as it came: for the session, and for an engine that had to be ended. */
  bytes: Uint8Array;
  info: MeshInfo;
}

/** What is under the mouse, or under the cursor of the keyboard. */
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
  /** Lengths, written beside the curves. */
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

/** The parts of the panel beside which sentences about trouble stand. */
export type Spot = 'mesh' | 'drawing' | 'settings' | 'offset' | 'cut' | 'files' | 'session';

export interface State {
  mesh: OpenMesh | null;
  /** Another mesh is being opened: the one that is shown is not to be drawn on. */
  opening: boolean;
  /** Drawings on other meshes, the newest first. */
  asides: Aside[];
  /** A file that has defects and waits for the person to say "repair". */
  refused: { name: string; bytes: Uint8Array; info: MeshInfo } | null;
  drawing: Drawing;
  undo: string | null;
  redo: string | null;
  /** The curves as they were drawn, on the mesh. */
  /** What `talweg info` tells of the mesh; null until somebody wants to know. */
  words: string | null;
  drawn: Line[];
  smoothed: Smoothed | null;
  /** The next leg, from the last point to the mouse; three numbers per point. */
  leg: Float64Array | null;
  combs: Comb[];
  /** What came of the drawing's offset; null while there is none. */
  offsets: Offset | null;
  cut: CutResult | null;
  /** Which part of the cut is kept alone; null: all are there. */
  kept: number | null;
  lids: boolean;
  chosen: Chosen | null;
  cursor: Place | null;
  under: Under;
  show: Show;
  busy: { what: string; since: number } | null;
  trouble: Partial<Record<Spot, string>>;
  /** What has just happened, for those who cannot see it. */
  told: string;
  onMachine: boolean;
  /** Another tab keeps its session on this machine, so this one does not. */
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

/** What a person calls the curve. */
export function nameOf(curve: Curve): string {
  return curve.name || `Curve ${curve.number}`;
}

export function wasClicked(exact: number): boolean {
  return exact >= 0;
}

/** Slack and largest deviation are for strokes only. */
export function hasStrokes(drawing: Drawing): boolean {
  return drawing.curves.some((curve) => curve.points.some((point) => !wasClicked(point.exact)));
}
