// The page's elements, found by their ids, and its buttons, found by their commands.

/** Throws Error for an id that the page does not have. */
export function byId<T extends HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (!element) throw new Error(`The page has no element ${id}.`);
  return element as T;
}

export function input(id: string): HTMLInputElement {
  return byId<HTMLInputElement>(id);
}

/** Sets the text of a box, unless the user is writing in it. */
export function setBox(id: string, text: string): void {
  if (document.activeElement !== input(id)) input(id).value = text;
}

/** null: the box is empty. */
export function numberIn(box: HTMLInputElement): number | null {
  return box.value.trim() === '' ? null : box.valueAsNumber;
}

/** The commands of the page's buttons, by the name in their `data-act`. */
export type Acts = Record<string, () => unknown>;

export function bindActs(acts: Acts): void {
  document.addEventListener('click', (event) => {
    const button = (event.target as Element).closest<HTMLElement>('[data-act]');
    const act = button?.dataset.act;
    if (act) acts[act]?.();
  });
}

export function enable(act: string, enabled: boolean): void {
  for (const button of document.querySelectorAll<HTMLButtonElement>(`[data-act="${act}"]`)) {
    button.disabled = !enabled;
  }
}

export function setText(id: string, text: string): void {
  const element = byId(id);
  if (element.textContent !== text) element.textContent = text;
}

/** Replaces the elements of a list. */
export function fill(id: string, elements: Node[]): void {
  byId(id).replaceChildren(...elements);
}

export function element<K extends keyof HTMLElementTagNameMap>(name: K, text = ''): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  made.textContent = text;
  return made;
}

/** The box of the newest choice: without this reference a browser may drop the box before the user
   has chosen. */
let choosing: HTMLInputElement | null = null;

/** Lets the user choose a file. */
export function chooseFile(accept: string, chosen: (file: File) => void): void {
  const box = document.createElement('input');
  choosing = box;
  box.type = 'file';
  box.accept = accept;
  box.addEventListener('change', () => {
    if (choosing === box) choosing = null;
    if (box.files?.[0]) chosen(box.files[0]);
  });
  box.click();
}
