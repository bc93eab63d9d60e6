// The view shows the state.
import { Vector3 } from 'three';
import type { Vec3 } from '../engine/types';
import type { Picker } from '../pick/picker';
import type { Prepared } from '../pick/preparer';
import { changed, type Store } from '../state/store';
import type { State } from '../state/state';
import { CombView } from './comb_view';
import { CurveView, drawnDistances, rangeOf } from './curve_view';
import { MeshView } from './mesh_view';
import { lengthLabels } from './length_labels';
import { type Mark, Overlay } from './overlay';
import { PointsView } from './points_view';
import type { Stage } from './stage';
import { unitOf } from '../state/units';
import { farthestText, verdicts } from '../state/verdict';

export class View {
  private readonly mesh: MeshView;
  private readonly curves: CurveView;
  private readonly points: PointsView;
  private readonly combs: CombView;
  private readonly overlay: Overlay;
  private picker: Picker | null = null;

  constructor(private readonly stage: Stage, box: HTMLElement, store: Store) {
    this.mesh = new MeshView(stage);
    this.curves = new CurveView(stage);
    this.points = new PointsView(stage);
    this.combs = new CombView(stage);
    this.overlay = new Overlay(stage, box, (place) => !this.picker?.isHidden(place, stage.camera.three.position));
    store.watch((now, before) => this.update(now, before));
    stage.onColours(() => this.update(store.now, store.now));
  }

  showMesh({ shape, picker }: Prepared): void {
    this.picker = picker;
    this.mesh.show(shape);
    this.stage.ask();
  }

  /** The part of the cut mesh under a pixel. */
  partAt(x: number, y: number): number | null {
    return this.mesh.partAt(this.stage.rayAt(x, y));
  }

  /** Turns to a place on the mesh, as seen from outside. */
  goTo(place: Vec3): void {
    this.stage.camera.lookAt(new Vector3(...place), this.picker?.normalNear(place) ?? new Vector3(0, 0, 1));
    this.stage.ask();
  }

  private showCurves(now: State, whole: boolean): void {
    const { show, smoothed, drawn, chosen } = now;
    const distances = drawnDistances(now), range = rangeOf(smoothed?.curves ?? [], show.colour, distances);
    this.curves.showDrawn(show.drawing && whole ? drawn : [], distances, range);
    this.curves.showResult(smoothed?.curves ?? [], show.colour, range, chosen);
  }

  private update(now: State, before: State): void {
    const { show } = now;
    const whole = now.cut === null;
    if (changed(now, before, 'cut')) this.mesh.showCut(now.cut);
    if (changed(now, before, 'drawn', 'smoothed', 'show', 'cut', 'chosen')) this.showCurves(now, whole);
    if (changed(now, before, 'drawing', 'mesh', 'chosen', 'show', 'cut')) {
      const mesh = whole && now.mesh ? now.mesh.info : null;
      this.points.show(now.drawing, mesh, now.chosen);
    }
    if (changed(now, before, 'leg')) this.curves.showLeg(now.leg);
    if (changed(now, before, 'combs', 'show')) this.combs.show(show.comb ? now.combs : []);
    if (changed(now, before, 'cursor')) {
      this.overlay.mark('cursor', now.cursor ? [{ places: [now.cursor.position], text: '' }] : []);
    }
    if (changed(now, before, 'smoothed', 'offsets', 'show', 'mesh', 'drawing')) {
      this.overlay.mark('length', lengthLabels(now));
    }
    if (changed(now, before, 'offsets')) this.curves.showOffsets(now.offsets?.curves ?? []);
    if (changed(now, before, 'smoothed', 'show', 'mesh')) this.overlay.mark('worst', worstPlaces(now));
    if (changed(now, before, 'smoothed', 'drawing', 'cut', 'mesh')) {
      this.overlay.mark('alarm', whole ? alarmPlaces(now) : []);
    }
  }
}

/** The farthest place between each curve and its drawing. */
function worstPlaces(state: State) {
  if (!state.show.worst || !state.smoothed) return [];
  return state.smoothed.curves.flatMap(({ report }) => report.worst
    ? [{ places: [report.worst], text: farthestText(report, unitOf(state)) }] : []);
}

/** The places of decisive warnings, one mark for several warnings at a place. */
function alarmPlaces(state: State) {
  const unit = unitOf(state);
  const marks = new Map<string, Mark>();
  for (const { report, decisive } of verdicts(state)) {
    for (const { at } of decisive) {
      if (!at) continue;
      const isFarthest = report.worst?.every((x, k) => x === at[k]);
      marks.set(at.join(), { places: [at], text: isFarthest ? farthestText(report, unit) : '' });
    }
  }
  return [...marks.values()];
}
