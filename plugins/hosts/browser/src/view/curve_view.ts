// The curves on the mesh: drawn and smoothed curves, colours along them, and the next leg.
import { Color, Group } from 'three';
import type { Line2 } from 'three/examples/jsm/lines/Line2.js';
import type { Line } from '../engine/types';
import type { Chosen, Colouring, State } from '../state/state';
import { growingColour, twoWayColour } from './colours';
import { distancesTo } from './distances';
import { dispose, fatLine, setDashes } from './fat_line';
import type { Stage } from './stage';

/** The values at the two ends of a colour scale. */
export interface Range {
  from: number;
  to: number;
}

/**
 * The distances of the drawing's points from the curves, if they are coloured by deviation: parts
 * of the drawing that were cut off have no curve that could show the distance.
 */
export function drawnDistances({ drawn, smoothed, show }: State): Float64Array[] {
  if (show.colour !== 'deviation' || !smoothed) return [];
  return drawn.map((line, k) => (smoothed.curves[k] ? distancesTo(line, smoothed.curves[k]) : new Float64Array()));
}

/** The largest turning or deviation over all curves; null if none was measured. */
export function rangeOf(curves: Line[], colour: Colouring, more: Float64Array[] = []): Range | null {
  if (colour === 'plain') return null;
  const values = [...curves.map((curve) => curve[colour]), ...more].flatMap((some) => Array.from(some))
    .filter(Number.isFinite);
  if (values.length === 0) return null;
  if (colour === 'deviation') return { from: 0, to: values.reduce((a, b) => Math.max(a, b)) };
  // The scale ends at the 95th percentile: otherwise a few sharp corners would leave all else grey.
  const sizes = values.map(Math.abs).sort((a, b) => a - b);
  const most = sizes[Math.floor(0.95 * (sizes.length - 1))] || sizes[sizes.length - 1];
  return { from: -most, to: most };
}

export class CurveView {
  private readonly drawnGroup = new Group();
  private readonly resultGroup = new Group();
  private readonly offsetGroup = new Group();
  private legLine: Line2 | null = null;

  constructor(private readonly stage: Stage) {
    stage.scene.add(this.drawnGroup, this.resultGroup, this.offsetGroup);
  }

  /** `distances`: for each curve at its points, coloured in this range. */
  showDrawn(curves: Line[], distances: Float64Array[], range: Range | null): void {
    empty(this.drawnGroup);
    curves.forEach((curve, k) => {
      if (curve.positions.length < 6) return;
      const colours = range && distances[k]?.length > 0 ? coloursAlong(distances[k], range) : undefined;
      const look = { colour: this.stage.colours.drawn, width: colours ? 3 : 2, colours };
      this.drawnGroup.add(fatLine(curve.positions, curve.closed, look));
    });
    this.stage.ask();
  }

  showResult(curves: Line[], colour: Colouring, range: Range | null, chosen: Chosen | null): void {
    empty(this.resultGroup);
    curves.forEach((curve, index) => {
      if (curve.positions.length < 6) return;
      const width = chosen?.curve === index ? 5.5 : 4;
      const plain = { colour: this.stage.colours.result, width };
      // The far side is drawn faintly, so that loops are recognizable.
      const behind = fatLine(curve.positions, curve.closed,
        { ...plain, width: 2, opacity: 0.16, through: true });
      behind.renderOrder = 2;
      const colours = range && colour !== 'plain' && curve[colour].length > 0
        ? coloursAlong(curve[colour], range) : undefined;
      this.resultGroup.add(behind, fatLine(curve.positions, curve.closed, { ...plain, colours }));
    });
    this.stage.ask();
  }

  showOffsets(curves: Line[]): void {
    empty(this.offsetGroup);
    const look = { colour: this.stage.colours.offset, width: 3 };
    for (const { positions, closed } of curves) {
      if (positions.length >= 6) this.offsetGroup.add(fatLine(positions, closed, look));
    }
    this.stage.ask();
  }

  showLeg(positions: Float64Array | null): void {
    if (this.legLine) dispose(this.legLine);
    this.legLine = null;
    if (positions && positions.length >= 6) {
      const look = { colour: this.stage.colours.leg, width: 2.5, dashed: true };
      this.legLine = fatLine(positions, false, look);
      setDashes(this.legLine, this.stage.camera.perPixel(this.stage.camera.state().distance));
      this.stage.scene.add(this.legLine);
    }
    this.stage.ask();
  }
}

function empty(group: Group): void {
  for (const child of [...group.children]) dispose(child);
}

function coloursAlong(values: Float64Array, range: Range): Color[] {
  const span = range.to - range.from || 1;
  return Array.from(values, (value) => {
    const t = (value - range.from) / span;
    return range.from < 0 ? twoWayColour(2 * t - 1) : growingColour(t);
  });
}
