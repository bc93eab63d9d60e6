// The mesh as a lit solid; after a cut, its parts in colours.
import {
  Box3, BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, MeshStandardMaterial, Raycaster, Sphere,
} from 'three';
import type { CutResult } from '../engine/types';
import type { Shape } from '../pick/shape';
import { coarseFaces, coarser } from './coarse';
import { sideColour } from './colours';
import type { Stage } from './stage';

export class MeshView {
  private readonly plain = surface({ side: DoubleSide });
  private readonly coloured = surface({ side: DoubleSide, vertexColors: true, flatShading: true });
  private readonly body = new Mesh(new BufferGeometry(), this.plain);
  private readonly parts = new Mesh(new BufferGeometry(), this.coloured);

  private readonly coarse = new Mesh(new BufferGeometry(), this.plain);
  private shape: Shape | null = null;
  private cut: CutResult | null = null;

  constructor(private readonly stage: Stage) {
    stage.backdrop.scene.add(this.body, this.coarse, this.parts);
    this.parts.visible = false;
    this.body.visible = false;
    // Everything is usually in view, and a million faces need no second bounding box.
    this.body.frustumCulled = false;
    this.coarse.frustumCulled = false;
    this.coarse.visible = false;
    stage.onSlow = (took) => void this.makeCoarse(took);
    this.parts.frustumCulled = false;
    stage.onColours((colours) => this.plain.color.set(colours.mesh));  // the stage draws again by
                                                                       // itself
  }

  /** Shows another mesh; null: no mesh. */
  show(shape: Shape | null): void {
    this.body.geometry.dispose();
    this.coarse.geometry.dispose();
    this.body.geometry = new BufferGeometry();
    this.coarse.geometry = new BufferGeometry();
    this.shape = shape;
    this.stage.backdrop.hold({ whole: this.body, coarse: null, faces: 0 });
    this.body.visible = shape !== null;
    if (shape) {
      this.body.geometry.setAttribute('position', new BufferAttribute(shape.positions, 3));
      this.body.geometry.setAttribute('normal', new BufferAttribute(shape.normals, 3));
      this.body.geometry.setIndex(new BufferAttribute(shape.index, 1));
      const ball = new Box3().setFromArray(shape.positions).getBoundingSphere(new Sphere());
      this.stage.camera.hold(ball.center, ball.radius || 1);
    }
    this.showCut(null);
  }

  private async makeCoarse(took: number): Promise<void> {
    const { shape } = this;
    const faces = shape && coarseFaces(shape.index.length / 3, took);
    if (!shape || !faces || this.coarse.geometry.index) return;
    const index = await coarser(shape, faces);
    if (!index || this.shape !== shape) return;
    const { position, normal } = this.body.geometry.attributes;
    this.coarse.geometry.setAttribute('position', position);
    this.coarse.geometry.setAttribute('normal', normal);
    this.coarse.geometry.setIndex(new BufferAttribute(index, 1));
    this.stage.backdrop.hold({ whole: this.body, coarse: this.coarse, faces });
  }

  /** Shows the parts of a cut mesh in colours; null: the whole mesh. */
  showCut(cut: CutResult | null): void {
    this.parts.geometry.dispose();
    this.parts.geometry = cut ? partsGeometry(cut) : new BufferGeometry();
    this.parts.visible = cut !== null;
    this.cut = cut;
    this.body.visible = cut === null && this.body.geometry.hasAttribute('position');
    this.stage.backdrop.invalidate();
    this.stage.ask();
  }

  /** The part of a cut mesh that a ray meets first; null: none. O(faces), for clicks only. */
  partAt(ray: Raycaster): number | null {
    const hit = this.cut ? ray.intersectObject(this.parts, false)[0] : undefined;
    return hit?.faceIndex === undefined || hit.faceIndex === null ? null : (this.cut?.side[hit.faceIndex] ?? null);
  }
}

function surface(options: object): MeshStandardMaterial {
  // The depth offset keeps curves on the mesh from sinking into it.
  return new MeshStandardMaterial({
    roughness: 0.62, metalness: 0, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2,
    ...options,
  });
}

/** Each face has its own corners, in the colour of its part. */
function partsGeometry(cut: CutResult): BufferGeometry {
  const { triangles, positions, side } = cut;
  const places = new Float32Array(3 * triangles.length);
  const colours = new Uint8Array(3 * triangles.length);
  const palette = Array.from({ length: cut.parts }, (_, part) => {
    const c = new Color(sideColour(part));
    return [255 * c.r, 255 * c.g, 255 * c.b];
  });
  for (let corner = 0; corner < triangles.length; ++corner) {
    const v = 3 * triangles[corner];
    places.set(positions.subarray(v, v + 3), 3 * corner);
    colours.set(palette[side[Math.floor(corner / 3)]] ?? [200, 200, 200], 3 * corner);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setAttribute('color', new BufferAttribute(colours, 3, true));
  return geometry;
}
