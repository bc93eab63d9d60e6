// The settings for all curves.
import type { Editor } from '../engine/editor';
import type { Ends, RidgeKind } from '../engine/types';
import { hasStrokes, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import type { DrawingWork } from '../actions/drawing_work';
import { numberText } from '../state/numbers';
import { boundChooses, whySlackIsIdle, whyTauIsIdle } from '../state/idle';
import { ridgesTold } from '../state/ridges';
import { unitOf } from '../state/units';
import { beyondBound, farthestText } from '../state/verdict';
import { byId, input, numberIn, setBox, setText } from '../elements';
import { factors, parts, type Scale, Slider, squares } from './slider';

export class SettingsPanel {
  private readonly tau: Slider;
  private readonly slack: Slider;
  private readonly most: Slider;
  private readonly ridges: Slider;
  private wasSeen = false;

  constructor(private readonly store: Store, private readonly drawing: DrawingWork) {
    this.tau = this.slider('tau', () => squares(10), (e, v) => e.setTau(v));
    this.slack = this.slider('slack', () => squares(this.size() / 20), (e, v) => e.setSlack(v));
    this.most = this.slider('most', () => this.mostScale(), (e, v) => e.setMaxDeviation(v));
    this.ridges = this.slider('ridges', () => parts, (e, v) => e.setRidges(v));
    this.bindSwitch('slack-on', (e, on) => e.setSlack(on ? this.edge() : null));
    this.bindSwitch('most-on', (e, on) => e.setMaxDeviation(on ? this.edge() : null));
    this.bindChoice('method', (e, value) => e.setPaper(value === 'paper'));
    this.bindChoice('ends', (e, value) => e.setEnds(value as Ends));
    this.bindChoice('ridge-kind', (e, value) => e.setRidgeKind(value as RidgeKind));
    const clicks = input('click-distance');
    clicks.addEventListener('change', () => this.orBack(drawing.edit((e) => e.setClickDistance(numberIn(clicks)))));
    store.watch((now, before) => {
      if (changed(now, before, 'drawing', 'mesh')) this.update(now);
      if (!changed(now, before, 'drawing', 'mesh', 'smoothed')) return;
      tellOfBound(now);
      setText('ridges-told', ridgesTold(now));
    });
  }

  private update({ drawing, mesh }: State): void {
    const { tau, slack, maxDeviation, paper, ends, clickDistance, ridges, ridgeKind } = drawing.settings;
    byId<HTMLSelectElement>('method').value = paper ? 'paper' : 'fair';
    byId<HTMLSelectElement>('ends').value = ends;
    byId<HTMLSelectElement>('ridge-kind').value = ridgeKind;
    input('ridge-kind').disabled = !mesh || ridges === 0;
    this.ridges.show(ridges, numberText(ridges), mesh !== null);
    setBox('click-distance', clickDistance === null ? '' : numberText(clickDistance));
    for (const id of ['method', 'ends', 'click-distance']) input(id).disabled = !mesh;
    byId('for-strokes').hidden = paper;
    const strokes = hasStrokes(drawing) || drawing.curves.length === 0;
    const chosen = boundChooses(drawing);
    this.tau.show(tau, numberText(tau), mesh !== null && !chosen);
    this.slack.show(slack, slack === null ? '' : numberText(slack), strokes && slack !== null && !chosen);
    this.most.show(maxDeviation, maxDeviation === null ? '' : numberText(maxDeviation), chosen);
    input('slack-on').checked = slack !== null;
    input('slack-on').disabled = !mesh || !strokes || chosen;
    input('most-on').checked = maxDeviation !== null;
    input('most-on').disabled = !mesh || !strokes;
    setText('tau-told', whyTauIsIdle(drawing));
    setText('slack-told', whySlackIsIdle(drawing));
    this.letTauBeSeen(drawing.curves.length > 0 && !drawing.unfinished);
  }

  /** In a small window τ is far below. After the first curve the panel scrolls to it, since users
     look for it next. */
  private letTauBeSeen(hasCurve: boolean): void {
    if (!hasCurve || this.wasSeen) return;
    this.wasSeen = true;
    input('tau').closest('.slider')?.scrollIntoView({ block: 'nearest' });
  }

  private slider(id: string, scale: () => Scale, set: (editor: Editor, value: number) => void): Slider {
    const { drawing } = this;
    return new Slider(input(id), input(`${id}-number`), scale, {
      begin: () => drawing.grip(),
      slide: (value) => drawing.edit((e) => set(e, value), '', 'slides'),
      end: () => drawing.release(),
      write: (value) => {
        this.orBack(drawing.edit((e) => set(e, value)));
      },
    });
  }

  private bindChoice(id: string, set: (editor: Editor, value: string) => void): void {
    const box = byId<HTMLSelectElement>(id);
    box.addEventListener('change', () => this.drawing.edit((e) => set(e, box.value)));
  }

  private bindSwitch(id: string, set: (editor: Editor, on: boolean) => void): void {
    input(id).addEventListener('change', () => {
      this.orBack(this.drawing.edit((e) => set(e, input(id).checked)));
    });
  }

  /** A refused value is replaced by the present one. */
  private orBack(taken: boolean): void {
    if (!taken) this.update(this.store.now);
  }

  private size(): number {
    return this.store.now.mesh?.info.size ?? 1;
  }

  private edge(): number {
    return Number((this.store.now.mesh?.info.meanEdge ?? 1).toPrecision(3));
  }

  private mostScale(): Scale {
    return factors(this.edge() / 5, this.size() / 10);
  }
}

/** A bound that could not be kept is reported beside its field. */
function tellOfBound(state: State): void {
  const unit = unitOf(state);
  const beyond = boundChooses(state.drawing) ? beyondBound(state) : [];
  setText('most-told', beyond.map(({ name, report }) => `${name}: no curve within the bound was found; `
    + `this one and the drawing lie ${farthestText(report, unit)} apart.`).join(' '));
}
