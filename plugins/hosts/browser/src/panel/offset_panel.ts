// The offset of the curves: its distance, curves and side, and its result.
import type { Caps, OffsetSettings, Side } from '../engine/types';
import type { OffsetWork } from '../actions/offset_work';
import { nameOf, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import { lengthText, numberText } from '../state/numbers';
import { unitOf } from '../state/units';
import { byId, element, enable, fill, input } from '../elements';
import { factors, Slider } from './slider';

const sides: Record<string, string> = { left: 'left', right: 'right', both: 'around the ends' };

export class OffsetPanel {
  private readonly distance: Slider;

  constructor(private readonly store: Store, private readonly work: OffsetWork) {
    input('offset-on').addEventListener('change', () => this.turn(input('offset-on').checked));
    const onChoice = (id: string, parts: (value: string) => Partial<OffsetSettings>) => {
      const box = byId<HTMLSelectElement>(id);
      box.addEventListener('change', () => this.set(parts(box.value)));
    };
    onChoice('offset-of', (of) => ({ of: of === '' ? null : Number(of) }));
    onChoice('offset-side', (side) => ({ side: side as Side }));
    onChoice('offset-caps', (caps) => ({ caps: caps as Caps }));
    this.distance = new Slider(input('offset'), input('offset-number'),
      () => factors(this.edge() / 2, (store.now.mesh?.info.size ?? 1) / 2),
      {
        begin: () => work.grip(),
        slide: (distance) => void work.set({ distance }),
        end: () => work.release(),
        write: (distance) => this.set({ distance }),
      });
    store.watch((now, before) => {
      if (changed(now, before, 'offsets', 'drawing', 'smoothed', 'mesh')) this.update(now);
    });
  }

  private turn(on: boolean): void {
    const { distance } = this.store.now.drawing.offset;
    this.set({ on, distance: distance > 0 ? distance : Number((5 * this.edge()).toPrecision(2)) });
  }

  /** A refused value is replaced by the present one. */
  private set(parts: Partial<OffsetSettings>): void {
    if (!this.work.set(parts)) this.update(this.store.now);
  }

  private edge(): number {
    return this.store.now.mesh?.info.meanEdge ?? 1;
  }

  private update(state: State): void {
    const { offsets, smoothed, drawing } = state, { offset } = drawing;
    input('offset-on').checked = offset.on;
    input('offset-on').disabled = !smoothed && !offset.on;
    byId('offset-settings').hidden = !offset.on;
    this.distance.show(offset.distance, offset.on ? numberText(offset.distance) : '', offset.on);
    const all = Object.assign(element('option', 'all curves'), { value: '' });
    fill('offset-of', [all, ...drawing.curves.map((curve) =>
      Object.assign(element('option', nameOf(curve)), { value: String(curve.number) }))]);
    byId<HTMLSelectElement>('offset-of').value = offset.of === null ? '' : String(offset.of);
    byId<HTMLSelectElement>('offset-side').value = offset.side;
    byId<HTMLSelectElement>('offset-caps').value = offset.caps;
    byId<HTMLSelectElement>('offset-caps').disabled = offset.side !== 'both';
    enable('save-offset', offsets !== null);
    const unit = unitOf(state);
    fill('offset-list', [
      ...(offsets?.curves ?? []).map(({ closed, report }, k) =>
        element('li', `${closed ? 'a loop' : 'open'}, ${sides[offsets?.sides[k] ?? '']}: ${lengthText(report.length, unit)}`)),
      ...(offsets?.notes ?? []).map((note) => element('li', note)),
    ]);
  }
}
