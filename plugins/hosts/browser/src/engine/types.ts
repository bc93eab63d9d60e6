// What the view and the engine hand to each other. Lengths in mesh units, angles in radians.

export type Vec3 = [number, number, number];

/** A point of a drawing, as `talweg::editing::Point`. */
export interface Point {
  face: number;
  /** Each >= 0, sum 1, in the order of the face's corners. */
  barycentric: Vec3;
  /** The smoothed curve passes through it. */
  pinned: boolean;
  /** 0 or more at a point that was clicked: its tolerance. Below 0: a mark of talweg_way_points.h. */
  exact: number;
}

export interface Curve {
  points: Point[];
  /** Joined from the last point back to the first, which is not repeated. */
  closed: boolean;
  /** null: the settings'. */
  tau: number | null;
  /** How far the result may pass from what was drawn; null: that of each point. */
  tolerance: number | null;
  /** For people; empty: the curve has only its number. */
  name: string;
  /** Tells the curves of a drawing apart; the editor gives it, from 1. */
  number: number;
}

/** What becomes of curves that are not closed: a painted stroke that comes back is a loop, all are, none. */
export type Ends = 'auto' | 'closed' | 'open';

/** Ridges, which stand out; valleys; both. */
export type RidgeKind = 'both' | 'convex' | 'concave';

export interface Settings {
  tau: number;
  /** null: the method's default. */
  slack: number | null;
  /** Chooses tau and slack; null: they are as they are set. */
  maxDeviation: number | null;
  /** The paper's own potential: without slack and largest deviation. */
  paper: boolean;
  ends: Ends;
  /** Successive clicks at most so far apart are one; null: the method's default. */
  clickDistance: number | null;
  /** 0 to 1: how strongly ridges attract the drawing. */
  ridges: number;
  ridgeKind: RidgeKind;
}

/** Curves at a distance from the smoothed ones. */
export interface OffsetSettings {
  on: boolean;
  /** The number of a curve of the drawing; null: all of them. */
  of: number | null;
  /** Along the surface, mesh units; above 0 while it is on. */
  distance: number;
  side: Side;
  caps: Caps;
}

export interface Drawing {
  curves: Curve[];
  /** The last curve is still being drawn. */
  unfinished: boolean;
  settings: Settings;
  offset: OffsetSettings;
}

/** An opened mesh. The arrays are for showing it; picked faces are those of `triangles`. */
export interface MeshInfo {
  vertices: number;
  faces: number;
  positions: Float32Array;
  triangles: Uint32Array;
  /** Diagonal of the bounding box. */
  size: number;
  meanEdge: number;
  /** The UCUM code of the mesh's unit, empty where the file does not tell it. */
  unit: string;
  /** What a repair would do, a sentence each, told as if it was done; empty if there is nothing to do. */
  repair: string[];
  /** What welding would give, where parts of a mesh that can be used only lie beside each other. */
  weld: Weld | null;
  /** What a repair did; null: the mesh is as it came. Picked faces are those of `triangles` still. */
  repaired: Repaired | null;
  /** Why the mesh cannot be drawn on as it is; null if it can. */
  defects: string | null;
}

/** A warning by which a result may be of no use. */
export interface Decisive {
  sentence: string;
  /** The place that it is about. */
  at: Vec3 | null;
}

export interface Weld {
  /** Mesh units; 0: vertices at one place become one. */
  tolerance: number;
  /** So many would be welded onto others. */
  vertices: number;
  /** Parts and boundary loops afterwards, and as they are. */
  parts: number;
  partsNow: number;
  borders: number;
  bordersNow: number;
}

export interface Repaired {
  vertices: number;
  faces: number;
  /** A sentence each. */
  changes: string[];
}

/** What ridges did to a drawing. */
export interface RidgeReport {
  /** The part of its length that was moved onto ridges, 0 to 1, and by how much. */
  moved: number;
  farthest: number;
  /** The part that lay on ridges as it was drawn. */
  already: number;
  clicks: number;
  farthestClick: number;
  /** How far from the drawing ridges were looked for. */
  band: number;
}

export interface CurveReport {
  length: number;
  drawnLength: number;
  /** How far result and drawing lie apart, in the direction in which that is more, or how far off a missed point
   * is: at least. null: not measured, or one cannot be reached from the other. */
  farthest: number | null;
  /** null: no more is known than that it is at least as far. */
  farthestAtMost: number | null;
  /** Which lies that far from the other; 'point': one that the curve was to pass. */
  farthestOf: 'none' | 'result' | 'drawing' | 'point';
  /** The larger of both directions. */
  meanDeviation: number | null;
  /** Total geodesic curvature. */
  turning: number;
  termination: string;
  warnings: string[];
  decisive: Decisive[];
  /** null: ridges were not to attract the drawing. */
  ridges: RidgeReport | null;
  /** Where the farthest is. */
  worst: Vec3 | null;
}

/** A curve as it lies on the mesh. */
export interface Line {
  /** Three numbers per point. */
  positions: Float64Array;
  faces: Int32Array;
  /** Three numbers per point, for `faces`. */
  barycentric: Float64Array;
  closed: boolean;
  /** Geodesic curvature at every point; empty where it was not measured. */
  turning: Float64Array;
  /** Distance to what was drawn at every point; empty where it was not measured. */
  deviation: Float64Array;
  report: CurveReport;
}

export interface Smoothed {
  curves: Line[];
  notes: string[];
  /** Of a hand at rest: everything is measured. */
  final: boolean;
  milliseconds: number;
  /** JSON, as the driver's. */
  report: string;
}

export type Side = 'both' | 'left' | 'right';
/** Around the ends of an open curve, or cut off there. */
export type Caps = 'round' | 'none';

export interface OffsetWish {
  /** Of the last smoothing, from 0. */
  curves: number[];
  /** Along the surface, mesh units. */
  distance: number;
  side: Side;
  caps: Caps;
}

export interface Offset {
  curves: Line[];
  /** Of each, as the report has it: "left", "right", or "both" around the ends. */
  sides: string[];
  notes: string[];
}

export interface CutResult {
  positions: Float32Array;
  triangles: Uint32Array;
  /** The part of every face, from 0. */
  side: Int32Array;
  parts: number;
  notes: string[];
}

export interface SavedFile {
  name: string;
  bytes: Uint8Array;
}
