// The switches for the display of curves, and the legend of the colours.
import { type Colouring, type Show, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import { gradient } from '../view/colours';
import { drawnDistances, rangeOf } from '../view/curve_view';
import type { Live } from '../actions/live';
import { lengthText, numberText } from '../state/numbers';
import { unitOf } from '../state/units';
import { byId, enable, input, setText } from '../elements';

export function bindShowPanel(store: Store, live: Live): void {
  const set = (parts: Partial<Show>) => store.set({ show: { ...store.now.show, ...parts } });
  const colour = byId<HTMLSelectElement>('colour');
  colour.addEventListener('change', () => set({ colour: colour.value as Colouring }));
  input('show-drawing').addEventListener('change', () => set({ drawing: input('show-drawing').checked }));
  input('show-worst').addEventListener('change', () => set({ worst: input('show-worst').checked }));
  input('show-lengths').addEventListener('change', () => set({ lengths: input('show-lengths').checked }));
  input('show-comb').addEventListener('change', () => {
    set({ comb: input('show-comb').checked });
    void live.combs();
  });
  store.watch((now, before) => {
    if (changed(now, before, 'show', 'smoothed', 'drawn', 'mesh')) update(now);
  });
}

function update(state: State): void {
  const { show, smoothed } = state;
  byId<HTMLSelectElement>('colour').value = show.colour;
  input('show-drawing').checked = show.drawing;
  input('show-comb').checked = show.comb;
  input('show-worst').checked = show.worst;
  input('show-lengths').checked = show.lengths;
  enable('go-worst', !!smoothed?.curves.some((curve) => curve.report.worst));
  const range = rangeOf(smoothed?.curves ?? [], show.colour, drawnDistances(state));
  byId('legend').hidden = range === null;
  if (!range) return;
  const unit = unitOf(state);
  const turning = show.colour === 'turning';
  setText('legend-title', turning ? `turns right – left, in 1/${unit || 'unit'}` : 'distance of curve and drawing');
  const text = (value: number) => (turning ? numberText(value) : lengthText(value, unit));
  setText('legend-from', text(range.from));
  setText('legend-to', text(range.to));
  byId('legend-bar').style.background = gradient(range.from < 0 ? 'twoWay' : 'growing');
}

/** The curve and the place of the largest deviation; null if none was measured. */
export function worstOf(state: State) {
  const all = state.smoothed?.curves.map(({ report }) => report).filter((report) => report.worst) ?? [];
  all.sort((a, b) => (b.farthest ?? 0) - (a.farthest ?? 0));
  return all[0]?.worst ?? null;
}
