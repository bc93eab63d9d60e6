// The stage has the canvas, the light and the camera, and draws only after a change.
import {
  Color, DirectionalLight, Group, HemisphereLight, Raycaster, Scene, SRGBColorSpace, Vector2, Vector3, WebGLRenderer,
} from 'three';
import type { Vec3 } from '../engine/types';
import { Backdrop } from './backdrop';
import { ViewCamera } from './camera';
import { coloursFor, type Colours } from './colours';

export class Stage {
  readonly camera = new ViewCamera();
  readonly backdrop = new Backdrop(() => this.ask(), (took) => this.onSlow(took));
  /** Called with the drawing time, ms, if it is so long that a coarser mesh is wanted while the
     view turns. */
  onSlow: (took: number) => void = () => {};
  /** Objects on the mesh. */
  readonly scene = new Scene();
  /** Objects that turn with the camera: the light comes over the left shoulder. */
  private readonly lights = new Group();
  private readonly renderer: WebGLRenderer;
  private readonly dark = matchMedia('(prefers-color-scheme: dark)');
  private asked = false;
  private afterwards: (() => void)[] = [];
  private recoloured: ((colours: Colours) => void)[] = [];

  /** Throws Error if the browser has no WebGL 2. */
  constructor(private readonly box: HTMLElement, canvas: HTMLCanvasElement) {
    if (!hasWebGL2()) {
      throw new Error('this browser has no WebGL 2, or has it switched off, so meshes cannot be drawn. Turn on "hardware '
        + 'acceleration" in its settings, or take another browser.');
    }
    this.renderer = new WebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = SRGBColorSpace;
    const sun = new DirectionalLight(0xffffff, 2.1);
    sun.position.set(-0.5, 0.7, 1);
    const fill = new DirectionalLight(0xdfe8ff, 0.5);
    fill.position.set(0.9, -0.2, 0.4);
    this.lights.add(sun, sun.target, fill, fill.target, new HemisphereLight(0xffffff, 0x6b6f7a, 1.0));
    this.backdrop.scene.add(this.lights);
    this.renderer.autoClear = false;
    new ResizeObserver(() => this.resize()).observe(box);
    this.dark.addEventListener('change', () => this.recolour());
    canvas.addEventListener('webglcontextrestored', () => {
      this.backdrop.invalidate();
      this.ask();
    });
    this.resize();
    this.recolour();
  }

  get colours(): Colours {
    return coloursFor(this.dark.matches);
  }

  /** Requests a new picture for the next frame. */
  ask(): void {
    if (this.asked) return;
    this.asked = true;
    requestAnimationFrame(() => this.draw());
  }

  /** Adds a task after every picture: marks over the canvas follow the view. */
  afterEach(task: () => void): void {
    this.afterwards.push(task);
  }

  /** Calls the task now, and when the page becomes dark or light. */
  onColours(task: (colours: Colours) => void): void {
    this.recoloured.push(task);
    task(this.colours);
  }

  /** The place of a position on the canvas, in its pixels; null behind the eye. */
  onScreen(position: Vec3): { x: number; y: number; distance: number } | null {
    const p = new Vector3(...position);
    const distance = p.distanceTo(this.camera.three.position);
    p.project(this.camera.three);
    if (!(p.z < 1)) return null;
    return { x: ((p.x + 1) / 2) * this.camera.width, y: ((1 - p.y) / 2) * this.camera.height, distance };
  }

  /** Whether a position is on the canvas, and not at its rim. */
  isInView(position: Vec3): boolean {
    const p = this.onScreen(position);
    const rim = 20;
    return p !== null && Math.abs(2 * p.x - this.camera.width) < this.camera.width - 2 * rim
      && Math.abs(2 * p.y - this.camera.height) < this.camera.height - 2 * rim;
  }

  /** The ray from the eye through a pixel. */
  rayAt(x: number, y: number): Raycaster {
    const caster = new Raycaster();
    const pixel = new Vector2((2 * x) / this.camera.width - 1, 1 - (2 * y) / this.camera.height);
    caster.setFromCamera(pixel, this.camera.three);
    return caster;
  }

  /** The view as a PNG picture. */
  picture(): Promise<Blob> {
    this.draw();
    return new Promise((resolve, reject) => {
      this.renderer.domElement.toBlob((blob) => {
        if (blob) resolve(blob);
        else reject(new Error('The browser could not make a picture of the view.'));
      }, 'image/png');
    });
  }

  private draw(): void {
    this.asked = false;
    this.lights.quaternion.copy(this.camera.three.quaternion);
    this.renderer.clear();
    this.backdrop.draw(this.renderer, this.camera.three);
    this.renderer.render(this.scene, this.camera.three);
    for (const task of this.afterwards) task();
  }

  private resize(): void {
    const width = Math.max(1, this.box.clientWidth), height = Math.max(1, this.box.clientHeight);
    // A higher ratio is not visible, and slow on phones.
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    this.ask();
  }

  private recolour(): void {
    this.backdrop.scene.background = new Color(this.colours.background);
    this.backdrop.invalidate();
    for (const task of this.recoloured) task(this.colours);
    this.ask();
  }
}

function hasWebGL2(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}
