// What a repair would do, and what it did, in words.
import type { MeshInfo, Weld } from '../engine/types';
import { countText, lengthText } from '../state/numbers';

/** Sentences of the library about a repair that is done, as what is to come. */
export function planned(sentence: string): string {
  return sentence.replace(/^Repair: /, '')
    .replace(/ (?:was|were) /, ' would be ')
    .replace(/ (?:has|have) no area any more/, ' would have no area any more')
    .replace(/, (\d+) were added/, ', $1 would be added')
    .replace(/ stay apart/, ' would stay apart');
}

export function weldWords(weld: Weld, unit: string): string {
  const { tolerance, vertices, parts, partsNow, borders, bordersNow } = weld;
  const where = tolerance > 0 ? `within ${lengthText(tolerance, unit)} of others` : 'at the place of others';
  const change = (now: number, then: number, one: string, several: string) =>
    `${countText(now)} ${now === 1 ? one : several} would become ${countText(then)}`;
  const changes = [
    ...(parts === partsNow ? [] : [change(partsNow, parts, 'part', 'parts')]),
    ...(borders === bordersNow ? [] : [change(bordersNow, borders, 'border', 'borders')]),
  ];
  return `${countText(vertices)} vertices ${where} would be welded: ${changes.join(', ')}.`;
}

/** The headline of what a repair is or was about, and its items; null: there is nothing to tell. */
export function repairWords(info: MeshInfo, unit: string): { why: string; items: string[] } | null {
  const { repaired, defects, repair, weld } = info;
  if (repaired) {
    return {
      why: `Repaired: ${countText(repaired.faces)} faces and ${countText(repaired.vertices)} vertices.`,
      items: repaired.changes.map((sentence) => sentence.replace(/^Repair: /, '')),
    };
  }
  if (defects !== null) {
    return { why: repair.length > 0 ? `${defects} Repair would do this:` : defects, items: repair.map(planned) };
  }
  return weld && {
    why: 'Parts of the mesh only lie beside each other, and no curve gets from one to the next. Repair would do this:',
    items: [weldWords(weld, unit)],
  };
}
