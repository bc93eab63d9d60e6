// Curves and options as they are given, checked, and as the engine takes them.
import type { Drawing, Point, Settings, Vec3 } from '../engine/types.js';
import { TalwegError } from './talweg_error.js';

/** A place on the mesh. */
export interface Place {
  /** The index of a triangle, from 0. */
  face: number;
  /** Each >= 0 with the sum 1, in the order of the triangle's corners. */
  barycentric: Vec3;
  /** The smoothed curve passes through the place, also in a stroke. */
  pinned?: boolean;
}

/** A curve as it is drawn: through its places, and back to the first place if it is closed. */
export interface Drawn {
  points: Place[];
  /** The last place is joined to the first, which is not repeated. */
  closed: boolean;
  /** The places are of a hand's stroke or follow edges, and are smoothed; otherwise they are clicks, which
      the curve passes through. */
  painted?: boolean;
}

/** Settings that are left out are those of the page and the driver. */
export type Options = Partial<Settings>;

const clicked = 0, painted = -2;  // TALWEG_MARK_PAINTED of talweg_way_points.h

const defaults: Settings = {
  tau: 1, slack: null, maxDeviation: null, paper: false, ends: 'auto', clickDistance: null, ridges: 0, ridgeKind: 'both',
};

const isNumber = (value: unknown): value is number => typeof value === 'number' && Number.isFinite(value);
const oneOf = (...words: unknown[]) => (value: unknown) => words.includes(value);

/** The values of each option, in words and as a test. */
const allowed: Record<keyof Settings, [string, (value: unknown) => boolean]> = {
  tau: ['a number of 0 or more', (x) => isNumber(x) && x >= 0],
  slack: ['null or a number of 0 or more', (x) => x === null || (isNumber(x) && x >= 0)],
  maxDeviation: ['null or a number above 0', (x) => x === null || (isNumber(x) && x > 0)],
  paper: ['true or false', oneOf(true, false)],
  ends: ['"auto", "closed" or "open"', oneOf('auto', 'closed', 'open')],
  clickDistance: ['null or a number of 0 or more', (x) => x === null || (isNumber(x) && x >= 0)],
  ridges: ['a number from 0 to 1', (x) => isNumber(x) && x >= 0 && x <= 1],
  ridgeKind: ['"both", "convex" or "concave"', oneOf('both', 'convex', 'concave')],
};

function settingsOf(options: Options | null): Settings {
  if (typeof options !== 'object') {
    throw new TalwegError(`The options are ${String(options)}: give an object such as { tau: 2 }.`, 'usage');
  }
  options ??= {};
  for (const [name, value] of Object.entries(options)) {
    const [words, holds] = allowed[name as keyof Settings] ?? [];
    if (!holds) {
      throw new TalwegError(`There is no option ${name}: the options are ${Object.keys(allowed).join(', ')}.`, 'usage');
    }
    if (value !== undefined && !holds(value)) {
      throw new TalwegError(`The option ${name} is ${String(value)}: give ${words}.`, 'usage');
    }
  }
  const given = Object.entries(options).filter(([, value]) => value !== undefined);
  return { ...defaults, ...Object.fromEntries(given) };
}

/** Coordinates rounded to single precision may be this far outside of their triangle. */
const rounding = 1e-3;

function pointOf(place: Place, where: string, faces: number, exact: number): Point {
  const { face, barycentric, pinned = false } = place ?? {};
  if (!(Number.isInteger(face) && face >= 0 && face < faces)) {
    throw new TalwegError(`${where} is on face ${String(face)}: faces are counted from 0 to ${faces - 1}.`, 'curve');
  }
  const three = Array.from(barycentric ?? []);
  const inside = three.length === 3 && three.every((b) => isNumber(b) && b >= -rounding)
    && Math.abs(three[0]! + three[1]! + three[2]! - 1) <= rounding;
  if (inside) return { face, barycentric: three as Vec3, pinned, exact };
  throw new TalwegError(`${where} has the barycentric coordinates [${three.map(String).join(', ')}]: `
    + 'give three numbers of 0 or more with the sum 1.', 'curve');
}

/** The engine's drawing. Throws TalwegError for curves that are not on the mesh, and for other options. */
export function drawingOf(curves: Drawn[], options: Options, faces: number): Pick<Drawing, 'unfinished' | 'settings'> {
  if (!Array.isArray(curves)) throw new TalwegError('The curves are not an array: give a list of curves.', 'usage');
  const checked = curves.map((curve, c) => {
    if (!Array.isArray(curve?.points)) {
      throw new TalwegError(`Curve ${c} has no list of points: give { points, closed }.`, 'usage');
    }
    if (curve.points.length < 2) {
      throw new TalwegError(`Curve ${c} has ${curve.points.length === 1 ? 'only one point' : 'no points'}: give two at least.`, 'curve');
    }
    const exact = curve.painted ? painted : clicked;
    return {
      points: curve.points.map((place, k) => pointOf(place, `Point ${k} of curve ${c}`, faces, exact)),
      closed: Boolean(curve.closed),
    };
  });
  return { curves: checked, unfinished: false, settings: settingsOf(options) } as object as
    Pick<Drawing, 'unfinished' | 'settings'>;
}

/** The engine's curve as it is given. */
export function drawnOf({ points, closed }: { points: Point[]; closed: boolean }): Drawn {
  const places = points.map(({ face, barycentric, pinned }) => ({ face, barycentric, ...(pinned && { pinned }) }));
  return { points: places, closed, painted: points.some(({ exact }) => exact < 0) };
}
