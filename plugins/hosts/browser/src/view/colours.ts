// The colours of the view, for a light and a dark page. They differ in brightness, too, for
// colour-blind users.
import { Color } from 'three';

export interface Colours {
  background: string;
  mesh: string;
  inside: string;
  drawn: string;
  result: string;
  offset: string;
  leg: string;
  point: string;
  pin: string;
  first: string;
  chosen: string;
  rim: string;
  comb: string;
}

const light: Colours = {
  background: '#eef1f4',
  mesh: '#d9cfbf',
  inside: '#a58f86',
  drawn: '#b3261e',
  result: '#0b4fc4',
  offset: '#00695c',
  leg: '#c75b12',
  point: '#ffffff',
  pin: '#d81b60',
  first: '#1e88e5',
  chosen: '#ffc400',
  rim: '#1b1f24',
  comb: '#5b2a86',
};

const dark: Colours = {
  ...light,
  background: '#15181c',
  mesh: '#a89f92',
  inside: '#6d5c56',
  drawn: '#ff6f61',
  result: '#2f7bff',
  offset: '#35e0c0',
  leg: '#ffa14a',
  comb: '#c79bf2',
};

export function coloursFor(isDark: boolean): Colours {
  return isDark ? dark : light;
}

// The colours of Okabe and Ito, which colour-blind people can distinguish, in a light tint.
const sides = ['#e69f00', '#56b4e9', '#009e73', '#f0e442', '#d55e00', '#cc79a7', '#8aa0ff', '#b0b7bd'];

export function sideColour(part: number): string {
  return sides[part % sides.length];
}

// Viridis, and a scale from blue over grey to red, at equal steps.
const growing = ['#440154', '#414487', '#2a788e', '#22a884', '#7ad151', '#fde725'].map(colour);
const twoWays = ['#2166ac', '#67a9cf', '#d8dcdf', '#ef8a62', '#b2182b'].map(colour);

function colour(text: string): Color {
  return new Color(text);
}

function between(scale: Color[], t: number): Color {
  const x = Math.min(Math.max(t, 0), 1) * (scale.length - 1);
  const k = Math.min(Math.floor(x), scale.length - 2);
  return scale[k].clone().lerp(scale[k + 1], x - k);
}

/** For a value from 0 to 1. */
export function growingColour(t: number): Color {
  return between(growing, t);
}

/** For a value from -1 to 1. */
export function twoWayColour(t: number): Color {
  return between(twoWays, (t + 1) / 2);
}

export function gradient(kind: 'growing' | 'twoWay'): string {
  const scale = kind === 'growing' ? growing : twoWays;
  return `linear-gradient(to right, ${scale.map((c) => `#${c.getHexString()}`).join(', ')})`;
}
