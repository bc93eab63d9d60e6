// The keyboard's cursor: a place on the mesh that arrow keys move in the view.
import type { Place, Under } from '../state/state';
import type { Store } from '../state/store';
import type { Stage } from '../view/stage';
import { positionOf } from '../view/vectors';
import type { Touch } from './pointers';
import type { Finder } from './under';

export class Cursor {
  constructor(private readonly store: Store, private readonly stage: Stage, private readonly finder: Finder) {}

  /** Its place on the canvas; the cursor appears in the middle of the view. */
  touch(): Touch | null {
    const place = this.place();
    const at = place ? this.stage.onScreen(place.position) : null;
    return at ? { x: at.x, y: at.y, reach: 11, shift: false, time: 0 } : null;
  }

  /** Moves it by so many pixels; it stays at the outline of the mesh. */
  move(dx: number, dy: number): Place | null {
    const at = this.touch();
    const to = at ? this.finder.place(at.x + dx, at.y + dy) : null;
    if (to) this.put(to);
    return to;
  }

  put(place: Place): void {
    this.store.set({ cursor: place });
    this.store.set({ under: this.under() });
  }

  hide(): void {
    if (this.store.now.cursor) this.store.set({ cursor: null });
  }

  under(): Under {
    const at = this.touch();
    return at ? this.finder.under(at.x, at.y, at.reach, this.store.now) : { kind: 'nothing' };
  }

  /** Goes to the next point of the drawing, over all curves; -1: to the one before. */
  nextPoint(step: 1 | -1): void {
    const { drawing, chosen, mesh } = this.store.now;
    if (!mesh) return;
    const all = drawing.curves.flatMap((curve, c) => curve.points.map((point, k) => ({ point, c, k })));
    if (all.length === 0) return;
    const now = all.findIndex(({ c, k }) => chosen?.curve === c && chosen.point === k);
    const start = now < 0 && step < 0 ? 0 : now;
    const next = all[(start + step + all.length) % all.length];
    const { face, barycentric } = next.point;
    this.store.set({ chosen: { curve: next.c, point: next.k } });
    this.put({ face, barycentric, position: positionOf(mesh.info, next.point) });
  }

  private place(): Place | null {
    const { cursor } = this.store.now;
    if (cursor) return cursor;
    const { width, height } = this.stage.camera;
    // The middle of a view of a ring is empty: the nearest place on a grid around the middle is
    // used.
    for (let ring = 0; ring < 12; ++ring) {
      for (let k = 0; k < 8; ++k) {
        const far = (ring / 24) * Math.min(width, height);
        const x = width / 2 + far * Math.cos((k * Math.PI) / 4), y = height / 2 + far * Math.sin((k * Math.PI) / 4);
        const found = this.finder.place(x, y);
        if (found) {
          this.put(found);
          return found;
        }
      }
    }
    return null;
  }
}
