// The list of drawings on other meshes, each with a button that brings it back.
import type { Aside } from '../session/asides';
import { changed, type Store } from '../state/store';
import { byId, element, fill } from '../elements';

export function bindAsidePanel(store: Store, bringBack: (id: number) => Promise<void>): void {
  store.watch((now, before) => {
    if (!changed(now, before, 'asides')) return;
    byId('asides').hidden = now.asides.length === 0;
    fill('asides', now.asides.map((aside) => item(aside, bringBack)));
  });
}

function item(aside: Aside, bringBack: (id: number) => Promise<void>): HTMLLIElement {
  const made = element('li');
  const { mesh } = aside.session;
  const name = mesh?.name ?? '', curves = aside.curves === 1 ? '1 curve' : `${aside.curves} curves`;
  if (!mesh || mesh.bytes.length === 0) {
    made.append(`The drawing on ${name} (${curves}) waits for its mesh, which is too large to be kept here: `
      + `open ${name} again to go on with it.`);
    return made;
  }
  const button = element('button', 'Bring it back');
  button.type = 'button';
  button.setAttribute('aria-label', `Bring it back: the drawing on ${name}`);
  button.addEventListener('click', () => {
    // The button disappears, and the focus with it.
    void bringBack(aside.id).then(() => byId('view').focus({ preventScroll: true }));
  });
  made.append(`The drawing on ${name} (${curves}) was put aside. `, button);
  return made;
}
