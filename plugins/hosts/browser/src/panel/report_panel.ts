// The numbers of the report, a table for each curve.
import type { CurveReport } from '../engine/types';
import { nameOf, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import { angleText, lengthText, numberText } from '../state/numbers';
import { byId, element, fill } from '../elements';

export function bindReportPanel(store: Store): void {
  store.watch((now, before) => {
    if (changed(now, before, 'smoothed', 'drawing')) tell(now);
  });
}

function tell({ smoothed, drawing, mesh }: State): void {
  byId('no-report').hidden = smoothed !== null;
  const unit = mesh?.info.unit ?? '';
  fill('reports', (smoothed?.curves ?? []).map((curve, k) => {
    const name = drawing.curves[k] ? nameOf(drawing.curves[k]) : `Curve ${k + 1}`;
    return table(name, curve.report, unit);
  }));
  const notes = smoothed
    ? [...smoothed.notes, ...smoothed.curves.flatMap((curve) => curve.report.warnings)] : [];
  fill('notes', [...new Set(notes)].map((note) => element('li', note)));
}

function table(name: string, report: CurveReport, unit: string): HTMLTableElement {
  const made = element('table');
  made.append(element('caption', name));
  const shorter = report.drawnLength > 0 ? ` (drawn ${numberText(report.drawnLength)})` : '';
  const rows = [
    ['length', lengthText(report.length, unit) + shorter],
    ['turns by', angleText(report.turning)],
    ['farthest from the drawing', lengthText(report.maxDeviation, unit)],
    ['on average', lengthText(report.meanDeviation, unit)],
  ];
  if (report.termination !== 'converged') rows.push(['ended', report.termination]);
  for (const [what, value] of rows) {
    const row = made.insertRow();
    const head = element('th', what);
    head.scope = 'row';
    row.append(head, element('td', value));
  }
  return made;
}
