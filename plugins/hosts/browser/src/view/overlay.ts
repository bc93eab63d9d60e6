// What lies over the canvas at places of the mesh: the keyboard's cursor, and where curves deviate
// most. These are elements of the page, sharp at every size.
import type { Vec3 } from '../engine/types';
import type { Stage } from './stage';

export class Overlay {
  private places = new Map<HTMLElement, Vec3>();

  constructor(private readonly stage: Stage, private readonly box: HTMLElement) {
    stage.afterEach(() => this.follow());
  }

  /** A mark of a class, with a text beside it; null takes it away. */
  mark(name: string, marks: { place: Vec3; text: string }[]): void {
    for (const element of [...this.places.keys()].filter((e) => e.classList.contains(name))) {
      this.places.delete(element);
      element.remove();
    }
    for (const { place, text } of marks) {
      const element = document.createElement('div');
      element.className = `mark ${name}`;
      element.append(document.createElement('i'));
      if (text) {
        const label = document.createElement('span');
        label.textContent = text;
        element.append(label);
      }
      this.box.append(element);
      this.places.set(element, place);
    }
    this.stage.ask();
  }

  private follow(): void {
    for (const [element, place] of this.places) {
      const at = this.stage.onScreen(place);
      element.hidden = at === null;
      if (at) element.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
    }
  }
}
