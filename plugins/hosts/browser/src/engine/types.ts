// Values that the view and the engine exchange. Lengths in mesh units, angles in radians.

export type Vec3 = [number, number, number];

/** A point of a drawing, as `talweg::editing::Point`. */
export interface Point {
  face: number;
  /** Each >= 0, sum 1, in the order of the face's corners. */
  barycentric: Vec3;
  /** The smoothed curve passes through it. */
  pinned: boolean;
  /** 0 or more at a clicked point: its tolerance, mesh units. Below 0: a mark of
     talweg_way_points.h. */
  exact: number;
}

export interface Curve {
  points: Point[];
  /** The last point is joined to the first, which is not repeated. */
  closed: boolean;
  /** null: the value of the settings. */
  tau: number | null;
  /** The largest distance between result and drawing, mesh units; null: the tolerance of each
     point. */
  tolerance: number | null;
  /** The user's name for the curve; empty: the curve has only its number. */
  name: string;
  /** The curve's number, unique in the drawing; the editor numbers curves from 1. */
  number: number;
}

/** The ends of curves that are not closed: 'auto' closes painted strokes that return to their
   start, 'closed' closes all curves, 'open' none. */
export type Ends = 'auto' | 'closed' | 'open';

/** 'convex' ridges, 'concave' valleys, or both. */
export type RidgeKind = 'both' | 'convex' | 'concave';

export interface Settings {
  tau: number;
  /** null: the method's default. */
  slack: number | null;
  /** A bound that chooses tau and slack, mesh units; null: tau and slack are used as set. */
  maxDeviation: number | null;
  /** The paper's potential, without slack and largest deviation. */
  paper: boolean;
  ends: Ends;
  /** Successive clicks at most this far apart count as one, mesh units; null: the method's
     default. */
  clickDistance: number | null;
  /** The strength by which ridges attract the drawing, 0 to 1. */
  ridges: number;
  ridgeKind: RidgeKind;
}

/** The offset of the smoothed curves. */
export interface OffsetSettings {
  on: boolean;
  /** The number of a curve of the drawing; null: all curves. */
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

/** An opened mesh. The arrays are for display; picked faces are indices of `triangles`. */
export interface MeshInfo {
  vertices: number;
  faces: number;
  positions: Float32Array;
  triangles: Uint32Array;
  /** Diagonal of the bounding box. */
  size: number;
  meanEdge: number;
  /** The UCUM code of the mesh's unit; empty if the file has none. */
  unit: string;
  /** The changes that a repair would make, a sentence each, in the past tense; empty: none. */
  repair: string[];
  /** The effect of welding, for a usable mesh with parts that only touch. */
  weld: Weld | null;
  /** The changes of a repair; null: the mesh is not repaired. Picked faces are still indices of
     `triangles`. */
  repaired: Repaired | null;
  /** Why curves cannot be drawn on the mesh; null if they can. */
  defects: string | null;
}

/** A warning by which a result may be of no use. */
export interface Decisive {
  sentence: string;
  /** Its place, if it has one. */
  at: Vec3 | null;
}

export interface Weld {
  /** Mesh units; 0: only vertices at the same place are welded. */
  tolerance: number;
  /** The number of vertices that would be welded onto others. */
  vertices: number;
  /** Parts and boundary loops after welding, and at present. */
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

/** The effect of ridges on a drawing. */
export interface RidgeReport {
  /** The part of its length that was moved onto ridges, 0 to 1, and by how much. */
  moved: number;
  farthest: number;
  /** The part that lay on ridges as it was drawn. */
  already: number;
  clicks: number;
  farthestClick: number;
  /** The largest distance from the drawing at which ridges were searched, mesh units. */
  band: number;
}

export interface CurveReport {
  length: number;
  drawnLength: number;
  /** A lower bound of the largest distance between result and drawing, either way, and of missed
   * points. null: not measured, or one cannot be reached from the other. */
  farthest: number | null;
  /** Its upper bound; null: not known. */
  farthestAtMost: number | null;
  /** The owner of the farthest place; 'point': a way-point that the curve misses. */
  farthestOf: 'none' | 'result' | 'drawing' | 'point';
  /** The larger mean of both directions. */
  meanDeviation: number | null;
  /** Total geodesic curvature. */
  turning: number;
  termination: string;
  warnings: string[];
  decisive: Decisive[];
  /** null: ridges did not attract the drawing. */
  ridges: RidgeReport | null;
  /** The farthest place. */
  worst: Vec3 | null;
}

/** A curve on the mesh. */
export interface Line {
  /** Three numbers per point. */
  positions: Float64Array;
  faces: Int32Array;
  /** Three numbers per point, in the faces `faces`. */
  barycentric: Float64Array;
  closed: boolean;
  /** Geodesic curvature at every point; empty if not measured. */
  turning: Float64Array;
  /** Distance to the drawing at every point; empty if not measured. */
  deviation: Float64Array;
  report: CurveReport;
}

export interface Smoothed {
  curves: Line[];
  notes: string[];
  /** Smoothed with the hand at rest: everything is measured. */
  final: boolean;
  milliseconds: number;
  /** JSON, as the driver's report. */
  report: string;
}

export type Side = 'both' | 'left' | 'right';
/** Round the ends of an open curve, or stop at them. */
export type Caps = 'round' | 'none';

export interface OffsetWish {
  /** Indices of the last smoothing's curves, from 0. */
  curves: number[];
  /** Along the surface, mesh units. */
  distance: number;
  side: Side;
  caps: Caps;
}

export interface Offset {
  curves: Line[];
  /** For each curve, from the report: "left", "right", or "both" around ends. */
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
