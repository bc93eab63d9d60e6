// The list of curves, and what can be done to the chosen one.
import type { Curve } from '../engine/types';
import { nameOf, type State } from '../state/state';
import { changed, type Store } from '../state/store';
import type { DrawingWork } from '../actions/drawing_work';
import { numberText } from '../state/numbers';
import { whyOwnIsIdle } from '../state/idle';
import { verdicts } from '../state/verdict';
import { worded } from '../state/wording';
import { type Acts, byId, element, enable, input, numberIn, setBox, setText } from '../elements';

export class CurvePanel {
  constructor(private readonly store: Store, private readonly drawing: DrawingWork) {
    store.watch((now, before) => {
      if (changed(now, before, 'drawing', 'chosen')) this.update(now);
      if (changed(now, before, 'drawing', 'chosen', 'smoothed', 'mesh')) showBadges(now);
    });
    this.bindForm();
  }

  acts(): Acts {
    const { drawing } = this;
    return {
      'continue-curve': () => this.withCurve((k) => drawing.edit((e) => e.continueCurve(k), 'Draw on at its end.')),
      'reverse-curve': () => this.withCurve((k) => drawing.edit((e) => e.reverseCurve(k), 'Reversed the curve.')),
      'remove-curve': () => this.withCurve((k) => drawing.edit((e) => e.removeCurve(k), 'Removed the curve.')),
      clear: () => drawing.edit((e) => e.clear(), 'Removed all curves.'),
    };
  }

  private bindForm(): void {
    const on = (id: string, act: (box: HTMLInputElement, curve: number) => void) =>
      input(id).addEventListener('change', () => this.withCurve((k) => act(input(id), k)));
    const { drawing } = this;
    on('curve-name', (box, k) => drawing.edit((e) => e.renameCurve(k, box.value.trim()), 'Renamed the curve.'));
    on('curve-closed', (box, k) => this.orBack(drawing.edit((e) => e.setClosed(k, box.checked))));
    on('curve-pinned', (box, k) => this.orBack(drawing.edit((e) => e.pinCurve(k, box.checked))));
    on('curve-tau', (box, k) => this.orBack(drawing.edit((e) => e.setCurveTau(k, numberIn(box)))));
    on('curve-tolerance', (box, k) => this.orBack(drawing.edit((e) => e.setCurveTolerance(k, numberIn(box)))));
    byId<HTMLFormElement>('curve-form').addEventListener('submit', (event) => event.preventDefault());
  }

  /** What was refused is shown as it is. */
  private orBack(taken: boolean): void {
    if (!taken) this.update(this.store.now);
  }

  private withCurve(act: (curve: number) => void): void {
    const { chosen } = this.store.now;
    if (chosen) act(chosen.curve);
  }

  private update({ drawing, chosen }: State): void {
    byId('no-curves').hidden = drawing.curves.length > 0;
    const list = byId('curve-list');
    const hadFocus = [...list.children].findIndex((item) => item.contains(document.activeElement));
    list.replaceChildren(...drawing.curves.map((curve, k) => this.item(curve, k, chosen?.curve === k,
      drawing.unfinished && k === drawing.curves.length - 1)));
    if (hadFocus >= 0) list.children[hadFocus]?.querySelector('button')?.focus();
    for (const button of document.querySelectorAll<HTMLElement>('[data-act="clear"]')) {
      button.hidden = drawing.curves.length < 2;
    }
    const curve = chosen ? drawing.curves[chosen.curve] : undefined;
    byId('curve-form').hidden = !curve;
    if (curve) this.fillForm(curve, drawing.unfinished);
    const idle = whyOwnIsIdle(drawing);
    setText('own-told', idle);
    input('curve-tau').disabled = idle !== '';
    input('curve-tolerance').disabled = drawing.settings.paper;
  }

  private item(curve: Curve, index: number, isChosen: boolean, isCurrent: boolean): HTMLLIElement {
    const item = element('li');
    const button = element('button');
    button.type = 'button';
    button.setAttribute('aria-pressed', String(isChosen));
    const what = isCurrent ? 'being drawn' : curve.closed ? 'closed' : 'open';
    button.append(element('span', nameOf(curve)), ' ', element('small', `${what}, ${pointsText(curve.points.length)}`));
    button.addEventListener('click', () =>
      this.drawing.choose(isChosen ? null : { curve: index, point: null }));
    item.append(button);
    return item;
  }

  private fillForm(curve: Curve, unfinished: boolean): void {
    setBox('curve-name', curve.name);
    input('curve-name').placeholder = nameOf({ ...curve, name: '' });
    input('curve-closed').checked = curve.closed;
    input('curve-pinned').checked = curve.points.every((point) => point.pinned);
    setBox('curve-tau', curve.tau === null ? '' : numberText(curve.tau));
    setBox('curve-tolerance', curve.tolerance === null ? '' : numberText(curve.tolerance));
    input('curve-closed').disabled = unfinished;
    enable('continue-curve', !unfinished && !curve.closed);
    enable('reverse-curve', !unfinished);
  }
}

function pointsText(count: number): string {
  return count === 1 ? '1 point' : `${count} points`;
}

/** What decides whether a curve can be used stands below its name. */
function showBadges(state: State): void {
  const rows = [...byId('curve-list').children];
  for (const row of rows) row.querySelector('.badge')?.remove();
  for (const { curve, decisive } of verdicts(state)) {
    const badge = element('p', decisive.map((one) => worded(one.sentence, state)).join(' '));
    badge.className = 'badge';
    badge.title = badge.textContent ?? '';
    rows[curve]?.append(badge);
  }
}
