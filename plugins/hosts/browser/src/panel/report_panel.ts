// The numbers of the report, a table for each curve.
import type { CurveReport } from '../engine/types';
import { nameOf, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import { angleText, lengthText, numberText } from '../state/numbers';
import { unitOf } from '../state/units';
import { farthestText, farthestWhat } from '../state/verdict';
import { worded } from '../state/wording';
import { byId, element, fill } from '../elements';

export function bindReportPanel(store: Store): void {
  store.watch((now, before) => {
    if (changed(now, before, 'smoothed', 'drawing', 'mesh')) tell(now);
  });
}

function tell(state: State): void {
  const { smoothed, drawing } = state;
  byId('no-report').hidden = smoothed !== null;
  const unit = unitOf(state);
  fill('reports', (smoothed?.curves ?? []).map((curve, k) => {
    const name = drawing.curves[k] ? nameOf(drawing.curves[k]) : `Curve ${k + 1}`;
    return table(name, curve.report, unit);
  }));
  const reports = smoothed?.curves.map((curve) => curve.report) ?? [];
  const decisive = new Set(reports.flatMap((report) => report.decisive.map((one) => one.sentence)));
  const notes = new Set([...decisive, ...smoothed?.notes ?? [], ...reports.flatMap((report) => report.warnings)]);
  fill('notes', [...notes].map((note) => {
    const item = element('li', worded(note, state));
    if (decisive.has(note)) item.className = 'trouble';
    return item;
  }));
}

function table(name: string, report: CurveReport, unit: string): HTMLTableElement {
  const made = element('table');
  made.append(element('caption', name));
  const shorter = report.drawnLength > 0 ? ` (drawn ${numberText(report.drawnLength)})` : '';
  const rows = [
    ['length', lengthText(report.length, unit) + shorter],
    ['turns by', angleText(report.turning)],
    ['farthest apart', farthestText(report, unit)],
    ['which is', report.farthest === 0 ? '' : farthestWhat[report.farthestOf]],
    ['on average', report.meanDeviation === null ? '–' : lengthText(report.meanDeviation, unit)],
  ];
  if (report.termination !== 'converged') rows.push(['ended', report.termination]);
  for (const [what, value] of rows.filter(([, text]) => text !== '')) {
    const row = made.insertRow();
    const head = element('th', what);
    head.scope = 'row';
    row.append(head, element('td', value));
  }
  return made;
}
