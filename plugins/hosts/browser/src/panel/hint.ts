// The line below the mesh with the effect of a click, and its buttons.
import { nameOf, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import { firstVerdict, verdicts } from '../state/verdict';
import { worded } from '../state/wording';
import { byId, enable, setText } from '../elements';

export function bindHint(store: Store): void {
  store.watch((now, before) => {
    if (changed(now, before, 'drawing', 'under', 'chosen', 'mesh', 'cut', 'kept', 'undo', 'redo')) update(now);
    if (changed(now, before, 'drawing', 'chosen', 'cut', 'smoothed', 'mesh')) warn(now);
  });
}

/** The first decisive warning as a sentence. */
function warn(state: State): void {
  const first = state.cut ? null : firstVerdict(state);
  byId('alert').hidden = first === null;
  const all = verdicts(state), more = all.reduce((sum, { decisive }) => sum + decisive.length, 0) - 1;
  const whose = state.drawing.curves.length > 1 ? `${first?.name}: ` : '';
  const others = more > 0 ? ` (and ${more} more: see “Curves”)` : '';
  setText('alert-text', first ? whose + worded(first.decisive[0].sentence, state) + others : '');
  const button = document.querySelector<HTMLElement>('[data-act="go-alert"]');
  if (button) button.hidden = !first?.decisive.some((one) => one.at);
}

function update(state: State): void {
  const { drawing, chosen, cut } = state;
  setText('hint', hintOf(state));
  byId('drawing-buttons').hidden = !drawing.unfinished || cut !== null;
  const point = chosen && chosen.point !== null ? drawing.curves[chosen.curve]?.points[chosen.point] : undefined;
  byId('point-buttons').hidden = !point || drawing.unfinished || cut !== null;
  byId('cut-buttons').hidden = cut === null;
  const current = drawing.unfinished ? (drawing.curves.at(-1)?.points.length ?? 0) : 0;
  enable('finish', current > 1);
  enable('close', current > 2);
  const pin = document.querySelector<HTMLElement>('[data-act="pin"]');
  pin?.setAttribute('aria-pressed', String(point?.pinned ?? false));
  nameStep('undo', 'Undo', state.undo);
  nameStep('redo', 'Redo', state.redo);
  byId('view').dataset.under = state.under.kind;
}

function nameStep(act: string, verb: string, name: string | null): void {
  enable(act, name !== null);
  const button = document.querySelector<HTMLElement>(`[data-act="${act}"]`);
  if (button) button.title = name ? `${verb}: ${name}` : '';
}

const mouse = {
  keep: 'Click the part that you want to keep.',
  point: 'Drag the point. Double click pins it, Shift and click removes it.',
  line: 'Click for a new point on the curve, or pull it.',
  another: 'Click or paint another curve, drag points, or move τ.',
  begin: 'Click points on the mesh, or keep the button pressed and paint. The right button turns it.',
  close: 'Click to close the curve.',
  finish: 'Click to finish the curve.',
  second: 'Click the next point, or paint on.',
  third: 'Click more points, or paint. Finish with Enter.',
  more: 'Click more points, or paint. Finish with Enter, close by clicking the first point.',
};
const fingers: typeof mouse = {
  keep: 'Tap the part that you want to keep.',
  point: 'Drag the point, or pin or remove it.',
  line: 'Tap for a new point on the curve, or pull it.',
  another: 'Draw another curve, drag points, or move τ below.',
  begin: 'Tap points on the mesh, or draw with one finger. Two fingers turn it.',
  close: 'Tap to close the curve.',
  finish: 'Tap to finish the curve.',
  second: 'Tap the next point, or draw on.',
  third: 'Tap more points, or draw. Then finish.',
  more: 'Tap more points, or draw. Then finish, or tap the first point to close.',
};
const coarse = matchMedia('(pointer: coarse)');

function hintOf(state: State): string {
  const { mesh, drawing, under, chosen, cut, kept } = state;
  const words = coarse.matches ? fingers : mouse;
  if (!mesh) return '';
  if (mesh.info.defects) return mesh.info.defects + (mesh.info.repair.length > 0 ? ' “Repair” mends it.' : '');
  if (cut) return kept === null ? words.keep : 'This part is kept. Save it, or go back.';
  if (drawing.unfinished) return drawingHint(state, words);
  if (under.kind === 'point') return words.point;
  if (under.kind === 'line') return words.line;
  if (chosen && chosen.point !== null && drawing.curves[chosen.curve]) {
    return `Point ${chosen.point + 1} of ${nameOf(drawing.curves[chosen.curve])}.`;
  }
  if (drawing.curves.length > 0) return words.another;
  return mesh.info.weld && !mesh.info.repaired ? 'Parts of this mesh meet without sharing vertices. “Repair” welds them.'
    : words.begin;
}

function drawingHint({ drawing, under }: State, words: typeof mouse): string {
  const current = drawing.curves.length - 1, points = drawing.curves[current].points.length;
  const isHere = under.kind === 'point' && under.curve === current;
  if (isHere && under.point === 0 && points > 2) return words.close;
  if (isHere && under.point === points - 1 && points > 1) return words.finish;
  if (points < 2) return words.second;
  return points < 3 ? words.third : words.more;
}
