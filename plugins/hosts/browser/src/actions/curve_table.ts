// The smoothed curves as a table for spreadsheets: a row for each point.
import type { Line } from '../engine/types';

/** The titles of the columns, with the unit if it is known. */
function head(unit: string): string[] {
  const of = (what: string, power = '') => (unit ? `${what} [${power}${unit}]` : what);
  return ['curve', of('length'), of('x'), of('y'), of('z'), of('turning', '1/'), of('deviation')];
}

/**
 * CSV. `length` is the arc length from the curve's beginning; `turning` the geodesic curvature (1 /
 * mesh unit, positive to the left); `deviation` the distance to the drawing. Values that were not
 * measured are empty.
 */
export function curveTable(lines: Line[], names: string[], unit: string): string {
  const rows = lines.flatMap((line, k) => rowsOf(line, names[k]));
  return [head(unit), ...rows].map((row) => row.map(cell).join(',')).join('\r\n') + '\r\n';
}

function rowsOf({ positions, turning, deviation }: Line, name: string): (string | number | undefined)[][] {
  let length = 0;
  return Array.from({ length: positions.length / 3 }, (_, p) => {
    const [x, y, z] = positions.subarray(3 * p, 3 * p + 3);
    if (p > 0) length += Math.hypot(x - positions[3 * p - 3], y - positions[3 * p - 2], z - positions[3 * p - 1]);
    return [name, length, x, y, z, turning[p], deviation[p]];
  });
}

function cell(value: string | number | undefined): string {
  if (typeof value === 'string') return /[",\r\n]/.test(value) ? `"${value.replace(/"/g, '""')}"` : value;
  return value === undefined || !Number.isFinite(value) ? '' : String(value);
}
