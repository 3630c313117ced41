/**
 * How much is drawn while the picture moves: as much as the measured time of a frame allows. First the finer
 * pixels of dense screens go, then rows, whose order is random so that the first of them are a fair sample.
 */
const wanted = 30;
/** So few rows cost nothing beside the picture itself. */
const few = 5000;

export class Detail {
  /** part of the rows */
  part = 1;
  fine = true;
  private least_: number;

  constructor(rows: number) {
    this.least_ = Math.min(1, few / Math.max(1, rows));
  }

  /** The whole took so long: what can be hoped of the first moving frame. */
  wholeTook(time: number): void {
    if (time > 4 * wanted) this.fine = false;
    if (time > 1.4 * wanted) this.part = Math.max(this.least_, Math.min(this.part, wanted / time));
  }

  /** The last moving frame took so long, in milliseconds, until the graphics card had drawn it. */
  took(time: number): void {
    if (time > 1.4 * wanted) {
      // So slow that finer pixels alone cannot help.
      if (time > 4 * wanted) this.part = Math.max(this.least_, this.part * Math.max(0.05, wanted / time));
      else if (!this.fine) this.part = Math.max(this.least_, (this.part * wanted) / time);
      this.fine = false;
    } else if (time < 0.6 * wanted) {
      this.part = Math.min(1, this.part * 1.15);
    }
  }
}

/** When the graphics card has done what it was given. */
export class Fence {
  private sync_: WebGLSync | null = null;
  private from_ = 0;

  constructor(private gl_: WebGL2RenderingContext) {}

  put(): void {
    this.drop();
    this.sync_ = this.gl_.fenceSync(this.gl_.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl_.flush();
    this.from_ = performance.now();
  }

  /** Milliseconds since it was put, once it is passed; null: there is none, or it is not passed yet. */
  passed(): number | null {
    if (!this.sync_ || this.gl_.getSyncParameter(this.sync_, this.gl_.SYNC_STATUS) !== this.gl_.SIGNALED)
      return null;
    this.drop();
    return performance.now() - this.from_;
  }

  get isWaiting(): boolean {
    return this.sync_ !== null;
  }

  drop(): void {
    if (this.sync_) this.gl_.deleteSync(this.sync_);
    this.sync_ = null;
  }
}
