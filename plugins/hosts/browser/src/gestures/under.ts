// Finds the object under a pixel: a point of the drawing, a curve, or the mesh.
import type { Vec3 } from '../engine/types';
import type { Picker } from '../pick/picker';
import type { Place, State, Under } from '../state/state';
import { wasClicked } from '../state/state';
import type { Stage } from '../view/stage';
import { at, positionOf } from '../view/vectors';

interface Near {
  distance: number;
  position: Vec3;
}

export class Finder {
  constructor(private readonly stage: Stage, private readonly picker: () => Picker | null) {}

  /** The mesh under a pixel. */
  place(x: number, y: number): Place | null {
    return this.picker()?.first(this.stage.rayAt(x, y).ray) ?? null;
  }

  /** Points are grabbed within `reach` pixels, curves within half of it. */
  under(x: number, y: number, reach: number, state: State): Under {
    const point = this.pointNear(x, y, reach, state);
    if (point) return point;
    const line = state.drawing.unfinished ? null : this.lineNear(x, y, reach / 2, state);
    if (line) return line;
    const place = this.place(x, y);
    return place ? { kind: 'mesh', place } : { kind: 'nothing' };
  }

  /** The place on the canvas of the first point of the unfinished curve. */
  firstPoint(state: State): { x: number; y: number } | null {
    const first = state.drawing.unfinished ? state.drawing.curves.at(-1)?.points[0] : undefined;
    return first && state.mesh ? this.stage.onScreen(positionOf(state.mesh.info, first)) : null;
  }

  private isHidden(position: Vec3): boolean {
    return this.picker()?.isHidden(position, this.stage.camera.three.position) ?? true;
  }

  private pointNear(x: number, y: number, reach: number, state: State): Under | null {
    const mesh = state.mesh?.info;
    if (!mesh) return null;
    const found: (Near & { curve: number; point: number })[] = [];
    state.drawing.curves.forEach((curve, c) => curve.points.forEach((point, k) => {
      const isChosen = state.chosen?.curve === c && state.chosen.point === k;
      // Points of a stroke lie close together. They are grabbed only by a click close to one; other
      // clicks add a point to the curve.
      const most = wasClicked(point.exact) || point.pinned || isChosen ? reach : reach / 4;
      const position = positionOf(mesh, point);
      const screen = this.stage.onScreen(position);
      const distance = screen ? Math.hypot(screen.x - x, screen.y - y) : Infinity;
      if (distance <= most) found.push({ distance, position, curve: c, point: k });
    }));
    const best = nearest(found, (position) => this.isHidden(position));
    if (!best) return null;
    const { face, barycentric } = state.drawing.curves[best.curve].points[best.point];
    const place = { face, barycentric, position: best.position };
    return { kind: 'point', curve: best.curve, point: best.point, place };
  }

  private lineNear(x: number, y: number, reach: number, state: State): Under | null {
    const lines = state.smoothed?.curves ?? state.drawn;
    const found: (Near & { curve: number; segment: number; pixel: [number, number] })[] = [];
    lines.forEach((line, curve) => {
      const count = line.positions.length / 3;
      let before = this.stage.onScreen(at(line.positions, 0));
      for (let k = 0; k < (line.closed ? count : count - 1); ++k) {
        const next = this.stage.onScreen(at(line.positions, (k + 1) % count));
        if (before && next) {
          const { distance, t } = toSegment(x, y, before, next);
          const pixel: [number, number] = [before.x + t * (next.x - before.x), before.y + t * (next.y - before.y)];
          const position = at(line.positions, t < 0.5 ? k : (k + 1) % count);
          if (distance <= reach) found.push({ distance, position, curve, segment: k, pixel });
        }
        before = next;
      }
    });
    const best = nearest(found, (position) => this.isHidden(position));
    // A place on the curve, not under the mouse, so that the new point does not move the curve.
    const place = best ? (this.place(...best.pixel) ?? this.place(x, y)) : null;
    return best && place ? { kind: 'line', curve: best.curve, segment: best.segment, place } : null;
  }
}

/** The nearest visible one. */
function nearest<T extends Near>(found: T[], hidden: (position: Vec3) => boolean): T | null {
  found.sort((a, b) => a.distance - b.distance);
  return found.slice(0, 12).find((one) => !hidden(one.position)) ?? null;
}

function toSegment(x: number, y: number, a: { x: number; y: number }, b: { x: number; y: number }) {
  const dx = b.x - a.x, dy = b.y - a.y;
  const squared = dx * dx + dy * dy;
  const t = squared > 0 ? Math.min(1, Math.max(0, ((x - a.x) * dx + (y - a.y) * dy) / squared)) : 0;
  return { distance: Math.hypot(a.x + t * dx - x, a.y + t * dy - y), t };
}
