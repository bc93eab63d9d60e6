// The mesh as it is seen, kept as a picture with its depth: while only curves change, a million faces
// need not be drawn again.
import {
  DepthTexture, HalfFloatType, Mesh, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial, UnsignedIntType,
  Vector2, WebGLRenderTarget, type PerspectiveCamera, type WebGLRenderer,
} from 'three';

const vertexShader = `
  varying vec2 at;
  void main() {
    at = uv;
    gl_Position = vec4(position.xy * 2.0, 0.0, 1.0);
  }`;

const fragmentShader = `
  uniform sampler2D colours;
  uniform sampler2D depths;
  varying vec2 at;
  void main() {
    gl_FragColor = vec4(texture2D(colours, at).rgb, 1.0);
    gl_FragDepth = texture2D(depths, at).r;
    #include <colorspace_fragment>
  }`;

export class Backdrop {
  /** The mesh and its light. */
  readonly scene = new Scene();
  private readonly kept = new WebGLRenderTarget(1, 1, {
    type: HalfFloatType, samples: 4, depthTexture: new DepthTexture(1, 1, UnsignedIntType),
  });
  private readonly sheet = new Mesh(new PlaneGeometry(1, 1), new ShaderMaterial({
    vertexShader, fragmentShader, depthWrite: true,
    uniforms: { colours: { value: this.kept.texture }, depths: { value: this.kept.depthTexture } },
  }));
  private readonly flat = new OrthographicCamera();
  private seenFrom = '';

  constructor() {
    this.sheet.frustumCulled = false;
  }

  /** The mesh has changed. */
  invalidate(): void {
    this.seenFrom = '';
  }

  /** Draws the mesh, anew only if it is seen from another place. Clears what was there. */
  draw(renderer: WebGLRenderer, camera: PerspectiveCamera): void {
    const size = renderer.getDrawingBufferSize(new Vector2());
    const from = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements, size.x, size.y].join();
    if (from !== this.seenFrom) {
      this.seenFrom = from;
      if (this.kept.width !== size.x || this.kept.height !== size.y) this.kept.setSize(size.x, size.y);
      renderer.setRenderTarget(this.kept);
      renderer.clear();
      renderer.render(this.scene, camera);
      renderer.setRenderTarget(null);
    }
    renderer.render(this.sheet, this.flat);
  }
}
