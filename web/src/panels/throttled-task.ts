// A task that may run after the picture is drawn, and not for each picture: scrolling the text while the program plays.

/** While newer tasks keep coming, the newest runs after so long at the latest, ms. */
const MAX_DELAY_MS = 600;

export class ThrottledTask {
  private next: (() => void) | undefined;
  private isWaiting = false;
  private requestedAt = 0;
  private dueAt = 0;
  private doneAt = -Infinity;

  /** Tasks run at most once in `everyMs`. */
  constructor(private everyMs: number) {}

  /** Runs the task after the next frame, or once no newer one has come for `quietMs`. It replaces one that waits. */
  schedule(what: () => void, quietMs = 0): void {
    const now = performance.now();
    if (!this.next) this.requestedAt = now;
    this.next = what;
    this.dueAt = Math.max(this.doneAt + this.everyMs, Math.min(now + quietMs, this.requestedAt + MAX_DELAY_MS));
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
