// Adapts what a frame draws to the speed of the machine, so that frames follow each other fast enough.

/** What a frame of a turning view is drawn with. */
export interface FrameQuality {
  /** Number of the coarse level; -1 is the path itself. */
  level: number;
  /** Samples of each pixel. */
  samples: 0 | 4;
  /** Pixels drawn to pixels shown, of each side. */
  scale: number;
}

/** From the best picture to the cheapest. */
export const QUALITIES: FrameQuality[] = [
  { level: -1, samples: 4, scale: 1 },
  { level: 0, samples: 4, scale: 1 },
  { level: 0, samples: 0, scale: 1 },
  { level: 1, samples: 0, scale: 1 },
  { level: 2, samples: 0, scale: 1 },
  { level: 3, samples: 0, scale: 1 },
  { level: 3, samples: 0, scale: 0.5 },
];

/** A slower frame lowers the quality, ms: 25 a second. */
const SLOW_MS = 40;
/** Many faster frames in a row raise the quality, ms. */
const FAST_MS = 20;
const FAST_FRAMES_IN_A_ROW = 20;
/** While the pointer does not move there are no frames: a longer gap is no slow frame. */
const MAX_GAP_MS = 1000;

export class FramePace {
  private step: number;
  private before = 0;
  private slow = 0;
  private fast = 0;
  /** Fast frames before a higher quality is tried; doubled each time that it was too slow. */
  private fastFramesNeeded = FAST_FRAMES_IN_A_ROW;
  private tried = false;

  /** Begins with what a machine of this kind can probably draw. */
  constructor(isSoftware: boolean) {
    this.step = isSoftware ? 4 : 1;
  }

  get quality(): FrameQuality {
    return QUALITIES[this.step]!;
  }

  /** The view begins to turn. */
  begin(): void {
    this.before = 0;
    this.slow = this.fast = 0;
  }

  /** A frame begins at a time, ms: the gap to the one before says what that one took. */
  frame(now: number): void {
    const gap = now - this.before;
    const isFirst = this.before === 0;
    this.before = now;
    if (isFirst || gap > MAX_GAP_MS) return;
    this.slow = gap > SLOW_MS ? this.slow + 1 : 0;
    this.fast = gap < FAST_MS ? this.fast + 1 : 0;
    // One slow frame may have another cause.
    if (this.slow >= 2 && this.step < QUALITIES.length - 1) {
      if (this.tried) this.fastFramesNeeded = Math.min(1280, 2 * this.fastFramesNeeded);
      this.choose(this.step + 1);
      this.tried = false;
    } else if (this.fast > this.fastFramesNeeded && this.step > 0) {
      this.choose(this.step - 1);
      this.tried = true;
    }
  }

  private choose(step: number): void {
    this.step = step;
    this.slow = this.fast = 0;
  }
}

/** How many lines are drawn in one go, so that the page stays responsive. */
export class DrawSlices {
  lines: number;

  constructor(isSoftware: boolean) {
    this.lines = isSoftware ? 8_000 : 250_000;
  }

  /** Reports how long a number of lines took, ms. */
  took(lines: number, ms: number): void {
    // The time of few lines is mostly that of the surroundings.
    if (lines < this.lines / 2) return;
    if (ms < 16) this.lines = Math.min(16_000_000, this.lines * 2);
    else if (ms > 40) this.lines = Math.max(2_000, this.lines / 2);
  }
}
