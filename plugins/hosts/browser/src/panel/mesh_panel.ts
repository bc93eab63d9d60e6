// What the panel tells of the mesh, and the repair that it offers.
import type { OpenMesh, State } from '../state/state';
import { changed, type Store } from '../state/store';
import { countText, lengthText } from '../state/numbers';
import { unitName, unitOf, units } from '../state/units';
import { byId, element, fill, setBox, setText } from '../elements';
import { worded } from '../state/wording';
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

/** The unit that the file tells, if it does, and those that can be chosen. */
function tellUnit({ info, unit }: OpenMesh): void {
  const first = Object.assign(element('option', info.unit ? `${unitName(info.unit)}, as its file says` : 'not known'), { value: '' });
  const others = [...new Set([...units, ...(unit ? [unit] : [])])];
  fill('mesh-unit', [first, ...others.map((code) => Object.assign(element('option', unitName(code)), { value: code }))]);
  byId<HTMLSelectElement>('mesh-unit').value = unit ?? '';
}

function tell(state: State): void {
  const { mesh } = state, unit = unitOf(state);
  byId('mesh-told').hidden = mesh === null;
  hideStart(mesh !== null);
  document.title = mesh ? `${mesh.name} – Talweg` : pageTitle;
  for (const words of document.querySelectorAll('.unit')) words.textContent = `in ${unit || 'units of the mesh'}`;
  if (!mesh) return;
  const { info } = mesh, { faces, vertices } = info.repaired ?? info;
  setText('mesh-name', mesh.repaired ? `${mesh.name} (repaired)` : mesh.name);
  fill('mesh-facts', [
    ['faces', countText(faces)],
    ['vertices', countText(vertices)],
    ['size', lengthText(info.size, unit)],
    ['edge', lengthText(info.meanEdge, unit)],
  ].flatMap(([name, value]) => [element('dt', name), element('dd', value)]));
  tellUnit(mesh);
  tellRepair(state, mesh, unit);
}

function tellRepair(state: State, { info, weld }: OpenMesh, unit: string): void {
  const words = repairWords(info, unit);
  byId('repair').hidden = !words;
  byId('repair').querySelector('button')!.textContent = info.repaired ? 'Repair again' : 'Repair';
  setBox('weld', weld === undefined || weld === null ? '' : String(weld));
  setText('repair-why', words?.why ?? '');
  fill('repair-list', (words?.items ?? []).map((sentence) => element('li', worded(sentence, state))));
}
