// A line on the mesh with a width in pixels.
import { Color, type Object3D } from 'three';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';

export interface LineLook {
  colour: string;
  width: number;
  dashed?: boolean;
  /** 1: opaque. */
  opacity?: number;
  /** Whether it is drawn through the mesh. */
  through?: boolean;
  /** A colour for each point instead. */
  colours?: Color[];
}

export function fatLine(positions: ArrayLike<number>, closed: boolean, look: LineLook): Line2 {
  const points = Array.from(positions);
  if (closed) points.push(points[0], points[1], points[2]);
  const geometry = new LineGeometry();
  geometry.setPositions(points);
  const material = new LineMaterial({
    color: look.colours ? 0xffffff : new Color(look.colour), linewidth: look.width,
    vertexColors: !!look.colours, transparent: (look.opacity ?? 1) < 1, opacity: look.opacity ?? 1,
    depthTest: !look.through, depthWrite: !look.through,
    polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -4,
  });
  if (look.colours) {
    const colours = closed ? [...look.colours, look.colours[0]] : look.colours;
    geometry.setColors(colours.flatMap((c) => [c.r, c.g, c.b]));
  }
  const line = new Line2(geometry, material);
  line.frustumCulled = false;
  if (look.dashed) {
    line.computeLineDistances();
    material.dashed = true;
  }
  return line;
}

/** Sets the lengths of dashes, given in pixels, in the mesh's unit. */
export function setDashes(line: Line2, perPixel: number): void {
  line.material.dashSize = 7 * perPixel;
  line.material.gapSize = 5 * perPixel;
}

export function dispose(object: Object3D): void {
  object.traverse((part) => {
    const { geometry, material } = part as Partial<Line2>;
    geometry?.dispose();
    material?.dispose();
  });
  object.removeFromParent();
}
