// The effect of ridges on a drawing, in words.
import type { RidgeReport } from '../engine/types';
import { lengthText } from './numbers';
import { nameOf, type State } from './state';
import { unitOf } from './units';

/** Less than a percent is told as none. */
const seen = 0.005;

function percent(part: number): string {
  return `${Math.round(100 * part)} %`;
}

export function ridgeText({ moved, farthest, already, clicks, farthestClick, band }: RidgeReport, unit: string): string {
  if (moved === 0 && already < seen) return `none that is strong enough within ${lengthText(band, unit)} of the drawing`;
  if (moved === 0) return `${percent(already)} of the drawing lies on them already; nothing had to be moved`;
  return [
    `${percent(moved)} of the drawing moved onto them, by up to ${lengthText(farthest, unit)}`,
    ...(already < seen ? [] : [`${percent(already)} lay there already`]),
    ...(clicks === 0 ? [] : [`${clicks} ${clicks === 1 ? 'click' : 'clicks'} moved, by up to ${lengthText(farthestClick, unit)}`]),
  ].join('; ');
}

/** The sentences for all curves; empty if ridges attract no curve. */
export function ridgesTold(state: State): string {
  const { smoothed, drawing } = state, { curves } = drawing;
  if (drawing.settings.ridges === 0) return '';
  return (smoothed?.curves ?? []).flatMap(({ report }, k) => {
    if (!report.ridges || !curves[k]) return [];
    const text = ridgeText(report.ridges, unitOf(state));
    return [`${curves.length > 1 ? nameOf(curves[k]) : 'Ridges'}: ${text}.`];
  }).join(' ');
}
