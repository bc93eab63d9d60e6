// Distances of the points of one line from another, through space: lower bounds of the distances
// along the surface.
import type { Line } from '../engine/types';

/** The distance of each point of `from`; empty if `to` has no points. */
export function distancesTo(from: Line, to: Line): Float64Array {
  const count = to.positions.length / 3;
  if (count === 0) return new Float64Array();
  return Float64Array.from({ length: from.positions.length / 3 }, (_, p) => {
    let least = Infinity;
    for (let k = 0; k < (to.closed ? count : Math.max(1, count - 1)); ++k) {
      least = Math.min(least, squareToSegment(from.positions, 3 * p, to.positions, 3 * k, 3 * ((k + 1) % count)));
    }
    return Math.sqrt(least);
  });
}

/** The square of the distance of the point at `p` to the segment from `a` to `b`. */
function squareToSegment(points: Float64Array, p: number, line: Float64Array, a: number, b: number): number {
  const ux = line[b] - line[a], uy = line[b + 1] - line[a + 1], uz = line[b + 2] - line[a + 2];
  const x = points[p] - line[a], y = points[p + 1] - line[a + 1], z = points[p + 2] - line[a + 2];
  const square = ux * ux + uy * uy + uz * uz;
  const t = square > 0 ? Math.min(1, Math.max(0, (x * ux + y * uy + z * uz) / square)) : 0;
  return (x - t * ux) ** 2 + (y - t * uy) ** 2 + (z - t * uz) ** 2;
}
