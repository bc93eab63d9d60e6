// The line below the mesh that says what a click would do now, and the buttons that go with it.
import { nameOf, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import { byId, enable, setText } from '../elements';

export function bindHint(store: Store): void {
  store.watch((now, before) => {
    if (changed(now, before, 'drawing', 'under', 'chosen', 'mesh', 'cut', 'kept', 'undo', 'redo')) update(now);
  });
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

function hintOf(state: State): string {
  const { mesh, drawing, under, chosen, cut, kept } = state;
  if (!mesh) return '';
  if (mesh.info.defects) return mesh.info.defects;
  if (cut) return kept === null ? 'Click the part that you want to keep.' : 'This part is kept. Save it, or go back.';
  if (drawing.unfinished) return drawingHint(state);
  if (under.kind === 'point') return 'Drag the point. Double click pins it, Shift and click removes it.';
  if (under.kind === 'line') return 'Click for a new point on the curve, or pull it.';
  if (chosen && chosen.point !== null && drawing.curves[chosen.curve]) {
    return `Point ${chosen.point + 1} of ${nameOf(drawing.curves[chosen.curve])}.`;
  }
  if (drawing.curves.length > 0) return 'Click or paint another curve, drag points, or move τ.';
  return 'Click points on the mesh, or keep the button pressed and paint.';
}

function drawingHint({ drawing, under }: State): string {
  const current = drawing.curves.length - 1, points = drawing.curves[current].points.length;
  const isHere = under.kind === 'point' && under.curve === current;
  if (isHere && under.point === 0 && points > 2) return 'Click to close the curve.';
  if (isHere && under.point === points - 1 && points > 1) return 'Click to finish the curve.';
  if (points < 2) return 'Click the next point, or paint on.';
  if (points < 3) return 'Click on, or paint. Finish with Enter.';
  return 'Click on, or paint. Finish with Enter, close by clicking the first point.';
}
