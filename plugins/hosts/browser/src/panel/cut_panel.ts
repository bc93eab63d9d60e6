// Cutting, the parts, and borders of labels.
import type { State } from '../state/state';
import { changed, type Store } from '../state/store';
import { sideColour } from '../view/colours';
import type { CutWork } from '../actions/cut_work';
import { countText } from '../state/numbers';
import { type Acts, byId, chooseFile, element, enable, fill, input } from '../elements';

export class CutPanel {
  constructor(store: Store, private readonly cutting: CutWork) {
    input('lids').addEventListener('change', () => void cutting.setLids(input('lids').checked));
    store.watch((now, before) => {
      if (changed(now, before, 'cut', 'kept', 'smoothed', 'offsets', 'drawing', 'mesh')) this.update(now);
    });
  }

  acts(): Acts {
    const { cutting } = this;
    return {
      cut: () => cutting.cut(),
      'cut-offset': () => cutting.cut(true),
      'all-parts': () => cutting.again(),
      uncut: () => cutting.uncut(),
      borders: () => cutting.borders(null),
      'choose-labels': () => chooseFile('.labels,.txt,.csv', (file) => void this.readLabels(file)),
    };
  }

  async readLabels(file: File): Promise<void> {
    await this.cutting.borders(await file.text());
  }

  private update({ cut, kept, smoothed, offsets, drawing, mesh }: State): void {
    const usable = mesh !== null && mesh.info.defects === null;
    enable('cut', smoothed !== null && !drawing.unfinished && cut === null);
    enable('cut-offset', offsets !== null && !drawing.unfinished && cut === null);
    enable('borders', usable && !drawing.unfinished);
    enable('choose-labels', usable && !drawing.unfinished);
    enable('save-mesh', cut !== null);
    enable('save-parts', cut !== null);
    byId('parts').hidden = cut === null;
    for (const button of document.querySelectorAll<HTMLElement>('[data-act="all-parts"]')) {
      button.hidden = kept === null;
    }
    if (!cut) return;
    const faces = new Array<number>(cut.parts).fill(0);
    for (const part of cut.side) ++faces[part];
    fill('part-list', faces.flatMap((count, part) => (count > 0 ? [this.item(part, count, kept === part)] : [])));
  }

  private item(part: number, faces: number, isKept: boolean): HTMLLIElement {
    const item = element('li');
    const button = element('button');
    button.type = 'button';
    button.setAttribute('aria-pressed', String(isKept));
    const swatch = element('i');
    swatch.className = 'swatch';
    swatch.style.background = sideColour(part);
    button.append(swatch, ` Part ${part + 1} `, element('small', `${countText(faces)} faces`));
    button.addEventListener('click', () => void this.cutting.keep(part));
    item.append(button);
    return item;
  }
}
