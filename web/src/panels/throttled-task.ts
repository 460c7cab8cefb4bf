// A task that runs after a frame is drawn, and not after each frame: scrolling the text during playback.

/** While newer tasks keep coming, the newest of them runs after this time at the latest, ms. */
const MAX_DELAY_MS = 600;

export class ThrottledTask {
  private next: (() => void) | undefined;
  private isWaiting = false;
  private requestedAt = 0;
  private dueAt = 0;
  private doneAt = -Infinity;

  /** Tasks run at intervals of at least `intervalMs`. */
  constructor(private intervalMs: number) {}

  /** Runs a task after the next frame, or once no newer one has come for `quietMs`. It replaces the one that waits. */
  schedule(task: () => void, quietMs = 0): void {
    const now = performance.now();
    if (!this.next) this.requestedAt = now;
    this.next = task;
    this.dueAt = Math.max(this.doneAt + this.intervalMs, Math.min(now + quietMs, this.requestedAt + MAX_DELAY_MS));
    if (!this.isWaiting) this.wait();
  }

  /** Drops the task that waits. */
  cancel(): void {
    this.next = undefined;
  }

  private wait(): void {
    this.isWaiting = true;
    const rest = this.dueAt - performance.now();
    if (rest > 0) setTimeout(() => this.wait(), rest);
    else requestAnimationFrame(() => setTimeout(() => this.run()));
  }

  private run(): void {
    const { next } = this;
    this.next = undefined;
    this.isWaiting = false;
    this.doneAt = performance.now();
    next?.();
  }
}
