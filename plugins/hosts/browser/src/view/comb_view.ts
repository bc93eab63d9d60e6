// Combs: teeth across the curves, with lengths proportional to the curvature, and a line over their
// tips.
import { BufferAttribute, BufferGeometry, Group, Line, LineBasicMaterial, LineSegments } from 'three';
import type { Comb } from '../state/state';
import { dispose } from './fat_line';
import type { Stage } from './stage';

export class CombView {
  private readonly group = new Group();

  constructor(private readonly stage: Stage) {
    stage.scene.add(this.group);
  }

  show(combs: Comb[]): void {
    for (const child of [...this.group.children]) dispose(child);
    const color = this.stage.colours.comb;
    for (const comb of combs) {
      const teeth = new Float32Array(2 * comb.roots.length);
      for (let k = 0; k < comb.roots.length; k += 3) {
        teeth.set(comb.roots.subarray(k, k + 3), 2 * k);
        teeth.set(comb.tips.subarray(k, k + 3), 2 * k + 3);
      }
      const tips = new LineBasicMaterial({ color });
      const back = new LineBasicMaterial({ color, transparent: true, opacity: 0.55 });
      this.group.add(new LineSegments(through(teeth), back), new Line(through(new Float32Array(comb.tips)), tips));
    }
    for (const child of this.group.children) child.frustumCulled = false;
    this.stage.ask();
  }
}

function through(positions: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  return geometry;
}
