/** The drawing: three's renderer, the meshes, when to draw, and what lies under a pixel. */
import {
  DataTexture,
  LinearSRGBColorSpace,
  Scene as Space,
  UnsignedByteType,
  Vector3,
  Vector4,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { Bonds } from './bonds';
import { Detail, Fence } from './detail';
import { Eye } from './eye';
import { sharedUniforms, type Shared } from './gpu';
import type { Axis, Model } from './model';
import { Particles } from './particles';
import { drawFirst } from './quads';
import { PickKind } from './shaders';
import type { Kind } from './values';

export interface Picked {
  kind: Kind;
  row: number;
}

/** Around the pointer, in pixels of the page; a thin bond is hit with a finger too. */
const reach = 4;
/** After the last movement everything is drawn again, in milliseconds. */
const calm = 180;
/** A frame that takes no longer than this, in milliseconds, is drawn again with more pixels. */
const quick = 60;

export class Stage {
  readonly eye: Eye;
  readonly particles: Particles;
  readonly bonds: Bonds;
  readonly shared: Shared;
  readonly space = new Space();
  /** called after each frame */
  drawn: () => void = () => {};
  /** called when all that was asked for is drawn, or no longer so */
  still: (isStill: boolean) => void = () => {};
  /** how far symbols and moved particles may reach from the middle */
  reach = 1;
  /** shown while moving: part of the rows */
  part = 1;
  private renderer_: WebGLRenderer;
  private target_ = new WebGLRenderTarget(2 * reach + 1, 2 * reach + 1, { type: UnsignedByteType });
  private detail_: Detail;
  private fence_: Fence;
  private wanted_ = false;
  private last_: 'moving' | 'calm' | 'fine' = 'calm';
  private asked_ = 0;
  private resting_ = 0;
  private moving_ = false;
  private width_ = 1;
  private height_ = 1;

  constructor(
    model: Model,
    readonly canvas: HTMLCanvasElement,
  ) {
    this.renderer_ = new WebGLRenderer({ canvas, alpha: true, antialias: false });
    this.renderer_.outputColorSpace = LinearSRGBColorSpace;
    this.renderer_.setClearColor(0x000000, 0);
    this.fence_ = new Fence(this.renderer_.getContext() as WebGL2RenderingContext);
    this.shared = sharedUniforms(model.place);
    this.particles = new Particles(this.shared, model.drawn);
    this.bonds = new Bonds(this.shared, model);
    this.space.add(this.particles.mesh, this.bonds.mesh);
    this.detail_ = new Detail(model.drawn + model.bonds);
    this.eye = new Eye(model, canvas);
    this.eye.controls.addEventListener('change', () => this.move());
    canvas.addEventListener('webglcontextlost', () => this.fence_.drop());
    canvas.addEventListener('webglcontextrestored', () => this.ask());
  }

  resize(width: number, height: number): void {
    if (width === this.width_ && height === this.height_) return;
    this.width_ = Math.max(1, width);
    this.height_ = Math.max(1, height);
    this.eye.resize(this.width_ / this.height_);
  }

  get width(): number {
    return this.width_;
  }

  get height(): number {
    return this.height_;
  }

  /** Draws all of it soon. */
  ask(): void {
    this.wanted_ = true;
    this.still(false);
    this.await_();
  }

  private await_(): void {
    if (!this.asked_) this.asked_ = requestAnimationFrame(() => this.frame_());
  }

  /** Draws soon what can be drawn quickly, and all of it when nothing moves any more. */
  move(): void {
    this.moving_ = true;
    clearTimeout(this.resting_);
    this.resting_ = window.setTimeout(() => {
      this.moving_ = false;
      this.ask();
    }, calm);
    this.ask();
  }

  /** No frame begins before the last one is done: else they pile up, and the picture runs behind the hand. */
  private frame_(): void {
    this.asked_ = 0;
    const took = this.fence_.passed();
    if (this.fence_.isWaiting) return this.await_();
    if (took !== null) this.judge_(took);
    if (!this.wanted_) {
      if (!this.asked_ && !this.moving_) this.still(true);
      return;
    }
    this.wanted_ = false;
    this.last_ = this.moving_ ? 'moving' : 'calm';
    this.part = this.moving_ ? this.detail_.part : 1;
    const dense = Math.min(window.devicePixelRatio || 1, 2);
    this.draw_(this.moving_ && !this.detail_.fine ? 1 : dense);
    this.fence_.put();
    this.drawn();
    this.await_();
  }

  private judge_(took: number): void {
    if (this.last_ === 'moving') this.detail_.took(took);
    if (this.last_ === 'calm') this.detail_.wholeTook(took);
    if (this.last_ !== 'calm' || this.wanted_ || took > quick) return;
    // At rest a screen of ordinary pixels gets four samples each where that takes no time to speak of.
    this.last_ = 'fine';
    if ((window.devicePixelRatio || 1) >= 2) return;
    this.draw_(2);
    this.fence_.put();
    this.await_();
  }

  private draw_(ratio: number): void {
    if (this.renderer_.getPixelRatio() !== ratio || !this.isSized_(ratio)) {
      this.renderer_.setPixelRatio(ratio);
      this.renderer_.setSize(this.width_, this.height_, false);
    }
    this.rows_(this.part);
    this.eye.enclose(this.reach);
    this.renderer_.setRenderTarget(null);
    this.renderer_.render(this.space, this.eye.camera);
  }

  private isSized_(ratio: number): boolean {
    return (
      this.canvas.width === Math.floor(this.width_ * ratio) &&
      this.canvas.height === Math.floor(this.height_ * ratio)
    );
  }

  private rows_(part: number): void {
    for (const body of [this.particles, this.bonds])
      drawFirst(body.mesh.geometry, Math.ceil(body.count * part));
  }

  /** All of it now, at so many pixels per pixel of the page. */
  now(ratio: number): HTMLCanvasElement {
    this.part = 1;
    this.draw_(ratio);
    return this.canvas;
  }

  /** What is nearest to that spot of the picture, in pixels of the page. */
  under(x: number, y: number): Picked | null {
    const camera = this.eye.camera;
    const side = 2 * reach + 1;
    camera.setViewOffset(this.width_, this.height_, Math.round(x) - reach, Math.round(y) - reach, side, side);
    this.rows_(1);
    this.shared.picking.value = true;
    this.renderer_.setRenderTarget(this.target_);
    this.renderer_.render(this.space, camera);
    const found = new Uint8Array(side * side * 4);
    this.renderer_.readRenderTargetPixels(this.target_, 0, 0, side, side, found);
    this.renderer_.setRenderTarget(null);
    this.shared.picking.value = false;
    camera.clearViewOffset();
    let best: Picked | null = null;
    let nearest = Infinity;
    for (let i = 0; i < side * side; ++i) {
      const kind = found[i * 4 + 3];
      const far = Math.hypot((i % side) - reach, Math.floor(i / side) - reach);
      if (!kind || far >= nearest) continue;
      nearest = far;
      const row =
        (found[i * 4] as number) + 256 * (found[i * 4 + 1] as number) + 65536 * (found[i * 4 + 2] as number);
      best = { kind: kind === PickKind.particle ? 'particle' : 'bond', row };
    }
    return best;
  }

  mark(picked: Picked | null): void {
    this.particles.look.picked.value = picked?.kind === 'particle' ? picked.row : -1;
    this.bonds.look.picked.value = picked?.kind === 'bond' ? picked.row : -1;
    this.ask();
  }

  /** Displacements in lengths of the diagonal times whatever `warp` divides by; null: none are known. */
  setMoves(moves: Float32Array | null): void {
    const texture = this.shared.moves.value as DataTexture;
    const texels = texture.image.data as Float32Array;
    texels.fill(0);
    if (moves)
      for (let row = 0; row * 3 < moves.length; ++row)
        texels.set(moves.subarray(row * 3, row * 3 + 3), row * 4);
    texture.needsUpdate = true;
  }

  setCut(axis: Axis | null, at: number, flipped: boolean): void {
    const cut = new Vector4(0, 0, 0, 1);
    if (axis !== null) {
      const sign = flipped ? -1 : 1;
      cut.setComponent(axis, sign);
      cut.w = sign * at;
    }
    this.shared.cut.value.copy(cut);
  }

  /** Where a spot of the model is in the picture, in pixels of the page. */
  onPage(at: Vector3): [number, number] {
    const seen = at.clone().project(this.eye.camera);
    return [((seen.x + 1) / 2) * this.width_, ((1 - seen.y) / 2) * this.height_];
  }
}
