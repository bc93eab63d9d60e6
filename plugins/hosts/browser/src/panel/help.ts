// The list of keys in the help, made from the keys themselves.
import type { Key } from '../gestures/keys';
import { byId, element } from '../elements';

export function bindHelp(keys: Key[]): () => void {
  const dialog = byId<HTMLDialogElement>('help');
  const body = dialog.querySelector('#help-keys tbody');
  for (const key of keys) {
    const row = element('tr');
    const head = element('th', key.shown);
    head.scope = 'row';
    row.append(head, element('td', key.what));
    body?.append(row);
  }
  return () => dialog.showModal();
}
