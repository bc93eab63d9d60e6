// Words for the changes of a repair, planned or done.
import type { MeshInfo, Weld } from '../engine/types';
import { countText, lengthText } from '../state/numbers';

/** The library's sentence about a change in the past tense, as a sentence about a planned change. */
export function planned(sentence: string): string {
  return sentence.replace(/^Repair: /, '')
    .replace(/ (?:was|were) /, ' would be ')
    .replace(/ (?:has|have) no area any more/, ' would have no area any more')
    .replace(/, ([\d,]+) (?:was|were) added/, ', $1 would be added')
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

/** The headline of a repair, planned or done, and its items; null: there is none. */
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
    why: 'Parts of the mesh meet without sharing vertices, so no curve gets from one to the next. Repair would do this:',
    items: [weldWords(weld, unit)],
  };
}
