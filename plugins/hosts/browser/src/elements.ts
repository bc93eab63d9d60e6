// The page's elements, found by their ids, and its buttons, found by what they do.

/** Throws Error for an id that the page does not have. */
export function byId<T extends HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (!element) throw new Error(`The page has no element ${id}.`);
  return element as T;
}

export function input(id: string): HTMLInputElement {
  return byId<HTMLInputElement>(id);
}

/** Leaves a box alone that a person is writing into. */
export function setBox(id: string, text: string): void {
  if (document.activeElement !== input(id)) input(id).value = text;
}

/** null: the box is empty. */
export function numberIn(box: HTMLInputElement): number | null {
  return box.value.trim() === '' ? null : box.valueAsNumber;
}

/** What the page's buttons do, by the name in their `data-act`. */
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

/** Makes the elements of a list anew. */
export function fill(id: string, elements: Node[]): void {
  byId(id).replaceChildren(...elements);
}

export function element<K extends keyof HTMLElementTagNameMap>(name: K, text = ''): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  made.textContent = text;
  return made;
}

/** The box of the newest choice: without it a browser may forget it before the person has chosen. */
let choosing: HTMLInputElement | null = null;

/** Lets the person choose a file. */
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
