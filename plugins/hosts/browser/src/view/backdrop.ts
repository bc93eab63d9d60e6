// A picture of the mesh with its depth, which is kept, so that a change of curves does not draw a
// million faces again.
import {
  DepthTexture, HalfFloatType, Mesh, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial, UnsignedIntType,
  Vector2, WebGLRenderTarget, type Object3D, type PerspectiveCamera, type WebGLRenderer,
} from 'three';
import { Pace } from './pace';

const vertexShader = `
  varying vec2 at;
  void main() {
    at = uv;
    gl_Position = vec4(position.xy * 2.0, 0.0, 1.0);
  }`;

const fragmentShader = `
  uniform sampler2D colours;
  uniform sampler2D depths;
  uniform float away;
  varying vec2 at;
  void main() {
    gl_FragColor = vec4(texture2D(colours, at).rgb, 1.0);
    gl_FragDepth = min(1.0, texture2D(depths, at).r + away);
    #include <colorspace_fragment>
  }`;


/** A mesh, and a coarser one for the time while the view turns. */
export interface Turned {
  whole: Object3D | null;
  coarse: Object3D | null;
  /** Faces of the coarser mesh. */
  faces: number;
}

export class Backdrop {
  /** The mesh and its lights. */
  readonly scene = new Scene();
  private readonly kept = new WebGLRenderTarget(1, 1, {
    type: HalfFloatType, samples: 4, depthTexture: new DepthTexture(1, 1, UnsignedIntType),
  });
  private readonly sheet = new Mesh(new PlaneGeometry(1, 1), new ShaderMaterial({
    vertexShader, fragmentShader, depthWrite: true,
    uniforms: {
      colours: { value: this.kept.texture }, depths: { value: this.kept.depthTexture }, away: { value: 0 },
    },
  }));
  private readonly flat = new OrthographicCamera();
  private seenFrom = '';
  private isCoarse = false;
  private mesh: Turned = { whole: null, coarse: null, faces: 0 };
  private readonly pace: Pace;

  /** `ask` requests a picture; `wanted` requests a coarser mesh, since the whole mesh takes `took`
     ms. */
  constructor(ask: () => void, private readonly wanted: (took: number) => void) {
    this.sheet.frustumCulled = false;
    const again = () => {
      this.invalidate();
      ask();
    };
    this.pace = new Pace(ask, again, (took) => this.wanted(took));
  }

  /** The mesh has changed: the next picture draws it again. */
  invalidate(): void {
    this.seenFrom = '';
  }

  /** Takes another mesh, whose drawing time is unknown. */
  hold(mesh: Turned): void {
    if (mesh.whole !== this.mesh.whole || mesh.coarse === null) this.pace.reset();
    this.mesh = mesh;
    if (mesh.coarse) mesh.coarse.visible = false;
    this.invalidate();
  }

  /** Draws the mesh, or its kept picture if the view has not changed. Clears the canvas before. */
  draw(renderer: WebGLRenderer, camera: PerspectiveCamera): void {
    const size = renderer.getDrawingBufferSize(new Vector2());
    const from = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements, size.x, size.y].join();
    const moved = this.seenFrom !== '' && from !== this.seenFrom;
    if (moved) this.pace.moved();
    const coarse = this.canBeCoarse() && this.pace.moves;
    if (from !== this.seenFrom || (this.isCoarse && !coarse)) {
      this.seenFrom = from;
      if (this.kept.width !== size.x || this.kept.height !== size.y) this.kept.setSize(size.x, size.y);
      this.drawMesh(renderer, camera, coarse);
    }
    renderer.render(this.sheet, this.flat);
  }

  private canBeCoarse(): boolean {
    const { whole, coarse } = this.mesh;
    return this.pace.isSlow && coarse !== null && whole?.visible === true;
  }

  private drawMesh(renderer: WebGLRenderer, camera: PerspectiveCamera, isCoarse: boolean): void {
    const { whole, coarse, faces } = this.mesh;
    const shown = whole?.visible;
    if (isCoarse && whole && coarse) [whole.visible, coarse.visible] = [false, true];
    renderer.setRenderTarget(this.kept);
    renderer.clear();
    renderer.render(this.scene, camera);
    renderer.setRenderTarget(null);
    if (isCoarse && whole && coarse) [whole.visible, coarse.visible] = [true, false];
    // Curves lie on the whole mesh: the coarser mesh is moved back by about an edge, so that it
    // does not hide them.
    this.sheet.material.uniforms.away.value = isCoarse ? 2.4 / Math.sqrt(faces) : 0;
    this.isCoarse = isCoarse;
    renderer.domElement.dataset.mesh = isCoarse ? 'coarse' : 'whole';  // read by tests
    if (!isCoarse && shown) this.pace.measure(renderer.getContext() as WebGL2RenderingContext);
  }
}
