// Settings without an effect on the present drawing, and why.
import type { Curve, Drawing } from '../engine/types';
import { hasStrokes, wasClicked } from './state';

/** Whether the largest deviation chooses τ and slack. */
export function boundChooses(drawing: Drawing): boolean {
  const { maxDeviation, paper } = drawing.settings;
  return maxDeviation !== null && !paper && (hasStrokes(drawing) || drawing.curves.length === 0);
}

/** Whether the curve is a straight line between two clicks, for every τ. */
function isStraight({ points, closed }: Curve): boolean {
  return !closed && points.length === 2 && points.every((point) => wasClicked(point.exact));
}

/** Why τ has no effect; empty if it has one. */
export function whyTauIsIdle(drawing: Drawing): string {
  const { curves, settings } = drawing;
  if (boundChooses(drawing)) return '“At most this far” chooses τ.';
  if (settings.paper || drawing.unfinished || curves.length === 0) return '';
  if (curves.every(isStraight)) return 'No effect yet: two clicks are joined straight.';
  if (curves.every((curve) => curve.tau !== null)) return 'No effect: every curve has its own τ.';
  return '';
}

/** Why slack and largest deviation have no effect; empty if they have one. */
export function whySlackIsIdle(drawing: Drawing): string {
  if (drawing.curves.length > 0 && !hasStrokes(drawing)) {
    return 'Slack and largest deviation have no effect: they are for painted strokes, and clicked points are meant '
      + 'exactly.';
  }
  return boundChooses(drawing) ? '“At most this far” chooses the slack, unless it is set.' : '';
}

/** Why a curve's own τ and tolerance have no effect; empty if they have one. */
export function whyOwnIsIdle(drawing: Drawing): string {
  if (drawing.settings.paper) return 'The paper\'s method has one τ for all, and no tolerance.';
  return boundChooses(drawing) ? '“At most this far” chooses τ for all curves.' : '';
}
