// The command line that does what the page does.
import type { Drawing, MeshInfo } from './types';

/** For a shell, where that is needed. */
function quoted(word: string): string {
  return /^[\w./+=,-]+$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`;
}

/** What repairs a mesh as the page does. */
export function repairOption({ weld }: MeshInfo): string {
  return weld && weld.tolerance > 0 ? `--repair=weld=${weld.tolerance},drop,orient,split` : '--repair';
}

/** Smooths the drawing, saved as drawn.json, on the mesh. Empty without a mesh. */
export function commandOf(name: string, repair: string, drawing: Drawing | null): string {
  if (!name) return '';
  const mesh = name.replace(/\.gz$/i, '');
  const stem = mesh.replace(/\.[^.]*$/, '');
  const words = ['talweg', 'smooth', mesh, '--curve', `${stem}-drawn.json`];
  if (drawing) {
    const { tau, slack, maxDeviation, paper, ends, clickDistance } = drawing.settings;
    if (paper) words.push('--potential', 'paper', '--tau', String(tau));
    else if (maxDeviation !== null) words.push('--max-deviation', String(maxDeviation));
    else words.push('--tau', String(tau));
    if (slack !== null && !paper) words.push('--slack', String(slack));
    if (ends !== 'auto') words.push('--ends', ends);
    words.push('--border', 'snap');
    if (clickDistance !== null) words.push('--click-distance', String(clickDistance));
  }
  if (repair) words.push(repair);
  words.push('-o', `${stem}-smooth.vtp`, '--report', `${stem}-report.json`);
  return words.map(quoted).join(' ');
}
