// Lets the user choose one of several files that came together.
import { byId, element, setText } from '../elements';

/** null: none was chosen. */
export function chooseOne(question: string, names: string[]): Promise<number | null> {
  const dialog = byId<HTMLDialogElement>('choice');
  setText('choice-title', question);
  return new Promise((resolve) => {
    const items = names.map((name, k) => {
      const item = element('li'), button = element('button', name);
      button.type = 'button';
      button.addEventListener('click', () => dialog.close(String(k)));
      item.append(button);
      return item;
    });
    byId('choice-list').replaceChildren(...items);
    dialog.returnValue = '';
    dialog.addEventListener('close', () => {
      resolve(dialog.returnValue === '' ? null : Number(dialog.returnValue));
    }, { once: true });
    dialog.showModal();
  });
}
