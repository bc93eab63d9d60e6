// Labels with the lengths of curves. Each stands beside a visible place of its curve, and stays
// there while the place is visible.
import type { Vec3 } from '../engine/types';
import { nameOf, type State } from '../state/state';
import { lengthText } from '../state/numbers';
import { unitOf } from '../state/units';
import type { Mark } from './overlay';
import { at } from './vectors';

/** Number of places of a curve that are tried. */
const tries = 12;

/** Labels of the smoothed curves, with names if there are several, and of their offset. */
export function lengthLabels(state: State): Mark[] {
  const { smoothed, offsets, drawing, show } = state;
  if (!show.lengths) return [];
  const unit = unitOf(state), several = drawing.curves.length > 1;
  const name = (k: number) => (several && drawing.curves[k] ? `${nameOf(drawing.curves[k])}: ` : '');
  return [
    ...(smoothed?.curves ?? []).map(({ positions, report }, k) =>
      ({ ...spread(positions), text: name(k) + lengthText(report.length, unit) })),
    ...(offsets?.curves ?? []).map(({ positions, report }) =>
      ({ ...spread(positions), text: `Offset: ${lengthText(report.length, unit)}` })),
  ].filter(({ places }) => places.length > 0);
}

/** Points along a curve, from its middle outwards, each with the next point. */
function spread(positions: Float64Array): { places: Vec3[]; ahead: Vec3[] } {
  const legs = positions.length / 3 - 1;
  const found = Array.from({ length: tries }, (_, k) => {
    const share = 0.5 + (k % 2 === 0 ? k : -k - 1) / (2 * tries);
    return Math.max(0, Math.min(legs - 1, Math.floor(share * legs)));
  });
  const points = legs < 1 ? [] : [...new Set(found)];
  return { places: points.map((p) => at(positions, p)), ahead: points.map((p) => at(positions, p + 1)) };
}
