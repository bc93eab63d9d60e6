// Sentences about trouble stand beside what they are about. What happened is told to screen readers,
// and work that takes long can be ended.
import type { Spot } from '../state/state';
import { changed, type Store } from '../state/store';
import { byId, setText } from '../elements';

const spots: Spot[] = ['mesh', 'drawing', 'settings', 'cut', 'files', 'session'];
/** Work that is shorter is not worth a message. */
const patience = 500;

export function bindTrouble(store: Store): void {
  let timer = 0;
  store.watch((now, before) => {
    if (changed(now, before, 'trouble')) {
      for (const spot of spots) setText(`trouble-${spot}`, now.trouble[spot] ?? '');
    }
    if (changed(now, before, 'told')) setText('told', now.told);
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
