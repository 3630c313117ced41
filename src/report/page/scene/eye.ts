/** The eye: parallel sight or perspective on the same spot, views by name, and turning by hand. */
import { MOUSE, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Model } from './model';

export type Toward = 'x' | '-x' | 'y' | '-y' | 'z' | '-z' | 'slanted' | 'home';

const opening = 30;
/** Distance of the eye in parallel sight: beyond everything that is drawn, in lengths of the diagonal. */
const away = 10;

/** The direction in which the model is thinnest, where it is a slab, a sheet or a row; else none. */
function thinAxis(model: Model): 0 | 1 | 2 | null {
  const extent = model.extent;
  const order = ([2, 1, 0] as const).slice().sort((a, b) => extent[a] - extent[b]);
  const [thin, middle] = [order[0] as 0 | 1 | 2, order[1] as 0 | 1 | 2];
  if (extent[thin] < 0.3 * extent[middle]) return thin;
  return Math.max(...extent) > 0 && extent[middle] === 0 ? 2 : null;
}

export class Eye {
  readonly controls: OrbitControls;
  private parallel_ = new OrthographicCamera();
  private perspective_ = new PerspectiveCamera(opening);
  private aspect_ = 1;
  private thin_: 0 | 1 | 2 | null;
  private model_: Model;

  constructor(model: Model, canvas: HTMLCanvasElement) {
    this.model_ = model;
    this.thin_ = thinAxis(model);
    const up = this.thin_ === 2 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
    for (const camera of [this.parallel_, this.perspective_]) camera.up.copy(up);
    this.controls = new OrbitControls(this.parallel_, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN };
    this.controls.listenToKeyEvents(canvas);
    this.look('home');
  }

  get camera(): OrthographicCamera | PerspectiveCamera {
    return this.controls.object as OrthographicCamera | PerspectiveCamera;
  }

  get isParallel(): boolean {
    return this.camera === this.parallel_;
  }

  private direction_(toward: Toward): Vector3 {
    const y_up = this.thin_ === 2;
    if (toward === 'slanted') return y_up ? new Vector3(0.6, 0.5, 1) : new Vector3(0.65, -1, 0.6);
    if (toward === 'home') {
      if (this.thin_ === null) return this.direction_('slanted');
      const exact = this.model_.extent[this.thin_] === 0;
      if (this.thin_ === 2) return exact ? new Vector3(0, 0, 1) : new Vector3(0.3, 0.3, 1);
      if (this.thin_ === 1) return exact ? new Vector3(0, -1, 0) : new Vector3(0.3, -1, 0.3);
      return exact ? new Vector3(1, 0, 0) : new Vector3(1, -0.3, 0.3);
    }
    const axis = 'xyz'.indexOf(toward.slice(-1));
    return new Vector3().setComponent(axis, toward.startsWith('-') ? -1 : 1);
  }

  /** Looks at the whole model from there. */
  look(toward: Toward): void {
    const direction = this.direction_(toward).normalize();
    const up = this.camera.up;
    // Straight down or up: OrbitControls wants a hint of where the top of the picture is.
    if (Math.abs(direction.dot(up)) > 0.9999) {
      const back = up.z === 1 ? new Vector3(0, -1, 0) : new Vector3(0, 0, Math.sign(direction.y));
      direction.addScaledVector(back, 1e-5).normalize();
    }
    this.fit_(direction);
  }

  flip(): void {
    const from = this.camera.position.clone().sub(this.controls.target);
    const up = this.camera.up;
    const height = from.dot(up) / from.length();
    if (Math.abs(height) > 0.999) this.look(((height > 0 ? '-' : '') + (up.z === 1 ? 'z' : 'y')) as Toward);
    else this.place_(from.negate());
  }

  private place_(from: Vector3): void {
    this.camera.position.copy(this.controls.target).add(from);
    this.controls.update();
  }

  private fit_(direction: Vector3): void {
    const camera = this.camera;
    this.controls.target.set(0, 0, 0);
    camera.position.copy(direction).multiplyScalar(away);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    let [wide, high] = [1e-6, 1e-6];
    const { low, high: top } = this.model_;
    for (let corner = 0; corner < 8; ++corner) {
      const at = new Vector3(...([0, 1, 2] as const).map((c) => (corner & (1 << c) ? top[c] : low[c])));
      at.applyMatrix4(camera.matrixWorldInverse);
      wide = Math.max(wide, Math.abs(at.x));
      high = Math.max(high, Math.abs(at.y));
    }
    // Room for legends below and for what is moved; half a height in parallel sight is 0.5.
    const half = 1.15 * Math.max(high, wide / this.aspect_);
    if (this.isParallel) this.parallel_.zoom = 0.5 / half;
    else camera.position.copy(direction).multiplyScalar(half / Math.tan((opening * Math.PI) / 360) + 0.3);
    camera.updateProjectionMatrix();
    this.controls.update();
  }

  set perspective(wanted: boolean) {
    if (wanted !== this.isParallel) return;
    const from = this.camera.position.clone().sub(this.controls.target);
    const tangent = Math.tan((opening * Math.PI) / 360);
    if (wanted) {
      from.setLength(0.5 / this.parallel_.zoom / tangent);
      this.controls.object = this.perspective_;
    } else {
      this.parallel_.zoom = 0.5 / (from.length() * tangent);
      from.setLength(away);
      this.controls.object = this.parallel_;
    }
    this.place_(from);
    this.camera.updateProjectionMatrix();
  }

  resize(aspect: number): void {
    this.aspect_ = aspect;
    this.parallel_.left = -0.5 * aspect;
    this.parallel_.right = 0.5 * aspect;
    this.parallel_.top = 0.5;
    this.parallel_.bottom = -0.5;
    this.perspective_.aspect = aspect;
    this.parallel_.updateProjectionMatrix();
    this.perspective_.updateProjectionMatrix();
  }

  /** Sets the near and far planes close around a ball of that radius about the model's middle. */
  enclose(radius: number): void {
    const camera = this.camera;
    const away_now = camera.position.length();
    camera.near = Math.max(away_now - radius, this.isParallel ? 0.01 : radius * 2e-3);
    camera.far = away_now + radius;
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  /** Pixels a length of one takes, in parallel sight. */
  scale(height: number): number {
    return this.parallel_.zoom * height;
  }
}
