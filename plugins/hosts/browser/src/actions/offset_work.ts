// Curves at a distance from the smoothed curves, updated when the hand rests.
import type { OffsetSettings, State } from '../state/state';
import type { Desk } from './desk';

export class OffsetWork {
  constructor(private readonly desk: Desk) {
    desk.store.watch((now, before) => {
      if (now.smoothed !== before.smoothed || now.offset !== before.offset) void this.make(now);
    });
  }

  set(parts: Partial<OffsetSettings>): void {
    const { store } = this.desk;
    store.set({ offset: { ...store.now.offset, ...parts } });
  }

  private async make({ offset, smoothed, drawing }: State): Promise<void> {
    const { store, engine } = this.desk;
    const curves = drawing.curves.flatMap(({ number }, k) =>
      smoothed?.curves[k] && (offset.of === null || offset.of === number) ? [k] : []);
    if (!offset.on || !smoothed?.final || curves.length === 0) {
      if (store.now.offsets) store.set({ offsets: null });
      store.trouble('offset', null);
      return;
    }
    const { distance, side, caps } = offset;
    const work = engine.offset({ curves, distance, side, caps });
    const offsets = await this.desk.wait('offset', 'Finding the offset', work);
    if (store.now.smoothed !== smoothed || store.now.offset !== offset) return;
    store.set({ offsets: offsets ?? null });
  }
}
