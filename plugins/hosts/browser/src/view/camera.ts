// The camera. The view turns freely around a point.
import { PerspectiveCamera, Quaternion, Vector3 } from 'three';

export interface CameraState {
  target: [number, number, number];
  turn: [number, number, number, number];
  distance: number;
}

export class ViewCamera {
  readonly three = new PerspectiveCamera(30, 1, 0.01, 100);
  private readonly target = new Vector3();
  private readonly turned = new Quaternion();
  private distance = 1;
  private readonly middle = new Vector3();
  private radius = 1;
  width = 1;
  height = 1;

  resize(width: number, height: number): void {
    this.width = width;
    this.height = height;
    this.three.aspect = width / height;
    this.place();
  }

  /** Sets the bounding sphere of everything that is shown. */
  hold(middle: Vector3, radius: number): void {
    this.middle.copy(middle);
    this.radius = radius;
    this.place();
  }

  /** Shows everything, in the present direction. */
  fit(): void {
    const half = (this.three.fov / 2) * (Math.PI / 180);
    const narrow = Math.atan(Math.tan(half) * Math.min(1, this.three.aspect));
    this.target.copy(this.middle);
    this.distance = this.radius / Math.sin(narrow);
    this.place();
  }

  /** Looks from slightly above and to the side, so that a solid looks solid. */
  lookAslant(): void {
    this.turned.setFromAxisAngle(new Vector3(0, 1, 0), 0.5);
    this.turned.multiply(new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -0.35));
    this.fit();
  }

  /** Turns as if the front of the mesh was moved by so many pixels. */
  orbit(dx: number, dy: number): void {
    const angle = Math.PI / Math.min(this.width, this.height);
    const turn = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), -dx * angle);
    turn.multiply(new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), -dy * angle));
    this.turned.multiply(turn).normalize();
    this.place();
  }

  roll(angle: number): void {
    this.turned.multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 0, 1), angle)).normalize();
    this.place();
  }

  /** Moves the target by so many pixels. */
  pan(dx: number, dy: number): void {
    const step = this.perPixel(this.distance);
    const by = new Vector3(-dx * step, dy * step, 0).applyQuaternion(this.turned);
    this.target.add(by);
    this.place();
  }

  /** Zooms in (factor < 1) or out; the place under the pixel (x, y) stays there. */
  zoom(factor: number, x = this.width / 2, y = this.height / 2): void {
    const next = Math.min(Math.max(this.distance * factor, this.radius * 1e-4), this.radius * 100);
    const step = this.perPixel(this.distance) - this.perPixel(next);
    const by = new Vector3((x - this.width / 2) * step, (this.height / 2 - y) * step, 0);
    this.target.add(by.applyQuaternion(this.turned));
    this.distance = next;
    this.place();
  }

  /** Brings a place to the middle of the view, seen along `out`, which points away from the mesh. */
  lookAt(place: Vector3, out: Vector3): void {
    const now = new Vector3(0, 0, 1).applyQuaternion(this.turned);
    const turn = new Quaternion().setFromUnitVectors(now, out.clone().normalize());
    this.turned.premultiply(turn).normalize();
    this.target.copy(place);
    this.place();
  }

  /** The length of a pixel at this distance from the eye, mesh units. */
  perPixel(distance: number): number {
    return (2 * distance * Math.tan((this.three.fov / 2) * (Math.PI / 180))) / this.height;
  }

  state(): CameraState {
    return {
      target: this.target.toArray(),
      turn: this.turned.toArray() as CameraState['turn'],
      distance: this.distance,
    };
  }

  restore(state: CameraState): void {
    this.target.fromArray(state.target);
    this.turned.fromArray(state.turn).normalize();
    this.distance = state.distance;
    this.place();
  }

  private place(): void {
    const camera = this.three;
    camera.quaternion.copy(this.turned);
    camera.position.set(0, 0, this.distance).applyQuaternion(this.turned).add(this.target);
    // The planes are close to the shown objects, so that the depth buffer separates curves from the
    // mesh.
    const away = camera.position.distanceTo(this.middle);
    camera.near = Math.max(away - 1.05 * this.radius, this.distance * 0.02, this.radius * 1e-5);
    camera.far = Math.max(away + 1.05 * this.radius, 2 * camera.near);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }
}
