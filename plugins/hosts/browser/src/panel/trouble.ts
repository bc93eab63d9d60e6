// Shows sentences about errors beside the part of the panel that they are about, and the newest one
// on the mesh. Screen readers get events, and long work gets a button that ends it.
import type { Spot, State } from '../state/state';
import { changed, type Store } from '../state/store';
import { worded } from '../state/wording';
import { byId, setText } from '../elements';

const spots: Spot[] = ['mesh', 'drawing', 'settings', 'offset', 'cut', 'files', 'session'];
/** Milliseconds; shorter work gets no message. */
const patience = 500;

export function bindTrouble(store: Store): void {
  let timer = 0;
  store.watch((now, before) => {
    if (changed(now, before, 'trouble')) {
      for (const spot of spots) setText(`trouble-${spot}`, now.trouble[spot] ?? '');
      setText('alarm', alarmOf(now, before));
    }
    if (changed(now, before, 'told')) setText('told', worded(now.told, now));
    if (!changed(now, before, 'busy')) return;
    clearTimeout(timer);
    byId('main').setAttribute('aria-busy', String(now.busy !== null));
    if (!now.busy) {
      byId('busy').hidden = true;
      return;
    }
    setText('busy-what', `${now.busy.what} …`);
    timer = window.setTimeout(() => (byId('busy').hidden = false), patience);
  });
}

/** The sentence for the mesh: the newest one, or the shown one while it lasts. */
function alarmOf({ trouble }: State, before: State): string {
  const newest = spots.find((spot) => trouble[spot] !== undefined && trouble[spot] !== before.trouble[spot]);
  if (newest) return trouble[newest] ?? '';
  const told = byId('alarm').textContent;
  return spots.some((spot) => trouble[spot] === told) ? told : '';
}
