// Stores the session during work, and restores it.
import { changed, type Store } from '../state/store';
import { type Desk, sentenceOf } from '../actions/desk';
import { download } from '../actions/files_work';
import { byId, input, setText } from '../elements';
import type { Asides } from './asides';
import type { Current } from './current';
import {
  askedKey, asidesOnThisMachine, forgetAll, isKeptOnMachine, keep, keepOnMachine, kept, keptAsides, keptOnThisMachine,
} from './keep';
import { becomeKeeper, isKeeper, stopKeeping } from './keeper';
import { sessionOf, sessionText } from './session';

/** Milliseconds between the last edit and the storage of the drawing. When the page is left, the
   drawing is stored at once. */
const pause = 400;

export class SessionWork {
  private timer = 0;
  private forgotten = false;

  constructor(private readonly desk: Desk, private readonly store: Store, private readonly current: Current,
              private readonly asides: Asides) {
    input('on-machine').addEventListener('change', () => void this.setOnMachine(input('on-machine').checked));
    store.set({ onMachine: isKeptOnMachine() });
    store.watch((now, before) => {
      if (changed(now, before, 'onMachine', 'otherTab')) {
        input('on-machine').checked = now.onMachine;
        input('on-machine').disabled = now.otherTab;
        byId('other-tab').hidden = !now.otherTab;
      }
      if (now === before) return;
      if (changed(now, before, 'drawing', 'mesh', 'show') && now.mesh) this.soon();
      // Packing a mesh takes time, so it begins before the page may be left.
      if (now.mesh && now.mesh.bytes !== before.mesh?.bytes) setTimeout(() => void this.keepNow());
    });
    addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.keepNow();
    });
    addEventListener('storage', (event) => {
      if (event.key === null || event.key === askedKey) void this.follow();
    });
  }

  /** Restores the stored session; returns whether there was one. */
  async bringBack(): Promise<boolean> {
    await this.follow();
    const all = await this.desk.wait('session', 'Looking for drawings that were put aside', keptAsides());
    const session = await this.desk.wait('session', 'Bringing back the session', kept());
    // A page that was left while another mesh was being opened has stored the same drawing twice.
    this.asides.add((all ?? []).filter(({ drawing }) => drawing !== session?.drawing));
    if (!session?.mesh) return false;
    if (session.mesh.bytes.length > 0) {
      const opened = await this.current.open(session);
      this.asides.standBehind();
      return opened;
    }
    this.asides.add([session]);  // the drawing waits for its mesh
    return false;
  }

  async openFile(file: File): Promise<void> {
    const session = await this.desk.wait('files', `Reading ${file.name}`,
      file.text().then((text) => sessionOf(file.name, text)));
    if (session) await this.current.open(session);
  }

  async saveFile(): Promise<void> {
    const session = this.current.session();
    if (!session) return;
    const text = await this.desk.wait('files', 'Writing the session', sessionText(session));
    if (!text) return;
    const name = this.store.now.mesh?.name.replace(/(\.[^.]+)?(\.gz)?$/i, '') ?? 'session';
    download(`${name}.talweg`, new Blob([text], { type: 'application/json' }));
  }

  async forget(): Promise<void> {
    this.forgotten = true;
    clearTimeout(this.timer);
    try {
      await forgetAll();
      location.reload();
    } catch (error) {
      this.forgotten = false;
      this.store.trouble('session', sentenceOf(error));
    }
  }

  private async setOnMachine(on: boolean): Promise<void> {
    try {
      await keepOnMachine(on);
    } catch (error) {
      this.store.trouble('session', sentenceOf(error));
    }
    await this.follow();
    await this.keepNow();
  }

  /** Applies the user's last choice, in this tab or another. */
  private async follow(): Promise<void> {
    const onMachine = isKeptOnMachine();
    if (!onMachine) stopKeeping();
    const mine = !onMachine || (await becomeKeeper(() => void this.takeOver()));
    this.store.set({ onMachine, otherTab: !mine });
  }

  /** The tab that stored its session on this machine was closed: its session is put aside here. */
  private async takeOver(): Promise<void> {
    this.store.set({ otherTab: false });
    try {
      const own = this.desk.editor.state();
      const left = await keptOnThisMachine();
      const all = [...(left ? [left] : []), ...(await asidesOnThisMachine())];
      this.asides.add(all.filter(({ drawing }) => drawing !== own));
    } catch (error) {
      this.store.trouble('session', sentenceOf(error));
    }
    await this.keepNow();
  }

  private soon(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.keepNow(), pause);
  }

  private async keepNow(): Promise<void> {
    const session = this.current.session();
    if (!session || this.forgotten) return;
    try {
      const whole = await keep(session);
      const where = this.store.now.onMachine && isKeeper() ? 'on this device' : 'until this tab is closed';
      setText('kept-told', whole ? `The session is kept ${where}.`
        : `The drawing is kept ${where}; the mesh is too large and would have to be opened again.`);
      byId('kept-told').hidden = false;
      this.store.trouble('session', null);
    } catch (error) {
      this.store.trouble('session', sentenceOf(error));
    }
  }
}
