// Sentences of the library in the page's words. The library numbers curves from 0 and knows no unit.
import { nameOf, type State } from './state';
import { unitOf } from './units';

/** The sentence with the names of curves and the unit of the mesh, where they are known. */
export function worded(sentence: string, state: State): string {
  const unit = unitOf(state);
  const named = sentence.replace(/\bcurve (\d+)\b/gi, (words: string, number: string) => {
    const curve = state.drawing.curves[Number(number)];
    return curve ? nameOf(curve) : words;
  });
  return unit ? named.replace(/\bmesh units?\b/g, unit) : named;
}
