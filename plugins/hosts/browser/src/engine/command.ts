// The driver's command line for the page's work.
import type { Drawing, OffsetWish } from './types';

/** The mesh's file, and the driver's options for it; empty for none. */
export interface MeshWords {
  name: string;
  repair: string;
  unit: string;
}

/** The word quoted for a shell, if needed. */
function quoted(word: string): string {
  return /^[\w./+=,-]+$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`;
}

/** The option for the page's repair; tolerance 0: only vertices at the same place are welded. */
export function repairOption(tolerance: number): string {
  return tolerance > 0 ? `--repair=weld=${tolerance},drop,orient,split` : '--repair';
}

function settingsWords({ settings }: Drawing): string[] {
  const { tau, slack, maxDeviation, paper, ends, clickDistance, ridges, ridgeKind } = settings;
  return [
    ...(paper ? ['--potential', 'paper', '--tau', String(tau)]
      : maxDeviation !== null ? ['--max-deviation', String(maxDeviation)] : ['--tau', String(tau)]),
    ...(slack !== null && !paper ? ['--slack', String(slack)] : []),
    ...(ends !== 'auto' ? ['--ends', ends] : []),
    '--border', 'snap',
    ...(clickDistance !== null ? ['--click-distance', String(clickDistance)] : []),
    ...(ridges > 0 ? ['--ridges', String(ridges)] : []),
    ...(ridges > 0 && ridgeKind !== 'both' ? ['--ridge-kind', ridgeKind] : []),
  ];
}

/** Smooths the drawing, saved as drawn.json, on the mesh, and offsets the result. Empty without a
   mesh. */
export function commandOf({ name, repair, unit }: MeshWords, drawing: Drawing | null,
                          offset: Omit<OffsetWish, 'curves'> | null): string {
  if (!name) return '';
  const mesh = name.replace(/\.gz$/i, '');
  const stem = mesh.replace(/\.[^.]*$/, '');
  const ofMesh = [...(repair ? [repair] : []), ...(unit ? ['--mesh-units', unit === '[in_i]' ? 'in' : unit] : [])];
  const smooth = ['talweg', 'smooth', mesh, '--curve', `${stem}-drawn.json`, ...(drawing ? settingsWords(drawing) : []),
    ...ofMesh, '-o', `${stem}-smooth.vtp`, '--report', `${stem}-report.json`];
  const lines = [smooth];
  if (offset) {
    lines.push(['talweg', 'offset', mesh, '--curve', `${stem}-smooth.vtp`, '--distance', String(offset.distance),
      '--side', offset.side, '--caps', offset.caps, '--ends', 'open', ...ofMesh, '-o', `${stem}-offset.vtp`]);
  }
  return lines.map((words) => words.map(quoted).join(' ')).join('\n');
}
