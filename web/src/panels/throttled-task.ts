// Work that can wait until the picture is there, and that need not be done for each picture.

/** However long newer work keeps coming, some of it is done after so long, ms. */
const LONGEST_MS = 600;

export class ThrottledTask {
  private next: (() => void) | undefined;
  private isWaiting = false;
  private requestedAt = 0;
  private dueAt = 0;
  private doneAt = -Infinity;

  /** Done at most once in so many ms. */
  constructor(private everyMs: number) {}

  /** Does this after the next frame, or after so many ms in which nothing newer comes. */
  schedule(what: () => void, quietMs = 0): void {
    const now = performance.now();
    if (!this.next) this.requestedAt = now;
    this.next = what;
    this.dueAt = Math.max(this.doneAt + this.everyMs, Math.min(now + quietMs, this.requestedAt + LONGEST_MS));
    if (!this.isWaiting) this.wait();
  }

  /** What waits is not done. */
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
