// Decisive warnings about the smoothed curves. The page shows them beside the curve, on the mesh
// and in the line below it, besides the report.
import type { CurveReport, Decisive } from '../engine/types';
import { lengthText, numberText } from './numbers';
import { nameOf, type State } from './state';

export interface Verdict {
  /** The curve's index in the drawing, from 0. */
  curve: number;
  name: string;
  report: CurveReport;
  decisive: Decisive[];
}

/** Verdicts of all curves with decisive warnings, except an unfinished curve. */
export function verdicts({ smoothed, drawing }: State): Verdict[] {
  const current = drawing.unfinished ? drawing.curves.length - 1 : -1;
  return (smoothed?.curves ?? []).flatMap(({ report }, curve) => {
    const drawn = drawing.curves[curve];
    if (!drawn || curve === current || report.decisive.length === 0) return [];
    return [{ curve, name: nameOf(drawn), report, decisive: report.decisive }];
  });
}

/** The first verdict: of the chosen curve, if it has one. */
export function firstVerdict(state: State): Verdict | null {
  const all = verdicts(state);
  return all.find(({ curve }) => curve === state.chosen?.curve) ?? all[0] ?? null;
}

/** The distance between result and drawing. The text is a bound if the distance was measured
   through space or not to the end. */
export function farthestText({ farthest, farthestAtMost }: CurveReport, unit: string): string {
  if (farthest === null) return '–';
  if (farthestAtMost === null) return `≥ ${lengthText(farthest, unit)}`;
  if (farthest < 1e-6 * farthestAtMost) return `≤ ${lengthText(farthestAtMost, unit)}`;
  if (farthestAtMost > farthest) return `${numberText(farthest)} to ${lengthText(farthestAtMost, unit)}`;
  return lengthText(farthest, unit);
}

/** Words for the owner of the farthest place. */
export const farthestWhat: Record<CurveReport['farthestOf'], string> = {
  none: '',
  result: 'the curve from the drawing',
  drawing: 'the drawing from the curve',
  point: 'a point that the curve misses',
};

/** The names of curves that exceed the largest deviation. */
export function beyondBound({ smoothed, drawing }: State): { name: string; report: CurveReport }[] {
  return (smoothed?.curves ?? []).flatMap(({ report }, k) => {
    const curve = drawing.curves[k];
    return curve && report.termination === 'deviation' ? [{ name: nameOf(curve), report }] : [];
  });
}
