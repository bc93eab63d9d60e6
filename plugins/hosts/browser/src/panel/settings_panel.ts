// τ, slack and largest deviation, for all curves.
import type { Editor } from '../engine/editor';
import { hasStrokes, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import type { DrawingWork } from '../actions/drawing_work';
import { numberText } from '../state/numbers';
import { byId, input } from '../elements';
import { factors, type Scale, Slider, squares } from './slider';

export class SettingsPanel {
  private readonly tau: Slider;
  private readonly slack: Slider;
  private readonly most: Slider;

  constructor(private readonly store: Store, private readonly drawing: DrawingWork) {
    this.tau = this.slider('tau', () => squares(10), (e, v) => e.setTau(v));
    this.slack = this.slider('slack', () => squares(this.size() / 20), (e, v) => e.setSlack(v));
    this.most = this.slider('most', () => this.mostScale(), (e, v) => e.setMaxDeviation(v));
    this.bindSwitch('slack-on', (e, on) => e.setSlack(on ? this.edge() : null));
    this.bindSwitch('most-on', (e, on) => e.setMaxDeviation(on ? this.edge() : null));
    store.watch((now, before) => {
      if (changed(now, before, 'drawing', 'mesh')) this.update(now);
    });
  }

  private update({ drawing, mesh }: State): void {
    const { tau, slack, maxDeviation } = drawing.settings;
    const strokes = hasStrokes(drawing) || drawing.curves.length === 0;
    const chosen = strokes && maxDeviation !== null;  // τ and slack are chosen by the bound
    this.tau.show(tau, numberText(tau), mesh !== null && !chosen);
    this.slack.show(slack, slack === null ? '' : numberText(slack), strokes && slack !== null && !chosen);
    this.most.show(maxDeviation, maxDeviation === null ? '' : numberText(maxDeviation), chosen);
    input('slack-on').checked = slack !== null;
    input('slack-on').disabled = !mesh || !strokes || chosen;
    input('most-on').checked = maxDeviation !== null;
    input('most-on').disabled = !mesh || !strokes;
    byId('only-clicks').hidden = strokes;
  }

  private slider(id: string, scale: () => Scale, set: (editor: Editor, value: number) => void): Slider {
    const { drawing } = this;
    return new Slider(input(id), input(`${id}-number`), scale, {
      begin: () => drawing.grip(),
      slide: (value) => drawing.edit((e) => set(e, value), '', 'slides'),
      end: () => drawing.release(),
      write: (value) => {
        if (!drawing.edit((e) => set(e, value))) this.update(this.store.now);
      },
    });
  }

  private bindSwitch(id: string, set: (editor: Editor, on: boolean) => void): void {
    input(id).addEventListener('change', () => {
      if (!this.drawing.edit((e) => set(e, input(id).checked))) this.update(this.store.now);
    });
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
