// What the panel tells of the mesh, and the repair that it offers.
import type { State } from '../state/state';
import { changed, type Store } from '../state/store';
import { countText, lengthText } from '../state/numbers';
import { byId, element, fill, setText } from '../elements';
import { repairWords } from './repair_words';

export function bindMeshPanel(store: Store): void {
  store.watch((now, before) => {
    if (changed(now, before, 'mesh')) tell(now);
    if (changed(now, before, 'words')) setText('mesh-text', now.words ?? '');
  });
}

const pageTitle = document.title;

/** A hand on its keys goes on with the mesh. */
function hideStart(hidden: boolean): void {
  const start = byId('start');
  const hadFocus = start.contains(document.activeElement);
  start.hidden = hidden;
  if (hidden && hadFocus) byId('view').focus({ preventScroll: true });
}

function tell({ mesh }: State): void {
  byId('mesh-told').hidden = mesh === null;
  hideStart(mesh !== null);
  document.title = mesh ? `${mesh.name} – Talweg` : pageTitle;
  for (const unit of document.querySelectorAll('.unit')) {
    unit.textContent = `in ${mesh?.info.unit || 'units of the mesh'}`;
  }
  if (!mesh) return;
  const { info } = mesh;
  setText('mesh-name', mesh.repaired ? `${mesh.name} (repaired)` : mesh.name);
  fill('mesh-facts', [
    ['faces', countText(info.faces)],
    ['vertices', countText(info.vertices)],
    ['size', lengthText(info.size, info.unit)],
    ['edge', lengthText(info.meanEdge, info.unit)],
  ].flatMap(([name, value]) => [element('dt', name), element('dd', value)]));
  const words = repairWords(info);
  byId('repair').hidden = !words;
  byId('repair').querySelector('button')!.hidden = info.repaired !== null;
  setText('repair-why', words?.why ?? '');
  fill('repair-list', (words?.items ?? []).map((sentence) => element('li', sentence)));
}
