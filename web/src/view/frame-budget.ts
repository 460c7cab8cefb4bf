// Adapts the detail of a frame to the speed of the computer, for a sufficient frame rate.

/** How a frame is drawn while the view turns. */
export interface FrameQuality {
  /** Level of detail; -1 is the path itself. */
  level: number;
  /** Samples of each pixel. */
  samples: 0 | 4;
  /** Drawn pixels per shown pixel, along each side. */
  scale: number;
}

/** From the best to the cheapest. */
export const QUALITIES: FrameQuality[] = [
  { level: -1, samples: 4, scale: 1 },
  { level: 0, samples: 4, scale: 1 },
  { level: 0, samples: 0, scale: 1 },
  { level: 1, samples: 0, scale: 1 },
  { level: 2, samples: 0, scale: 1 },
  { level: 3, samples: 0, scale: 1 },
  { level: 3, samples: 0, scale: 0.5 },
];

/** Slower frames lower the quality, ms: 25 frames per second. */
const SLOW_MS = 40;
/** Many faster frames in a row raise the quality, ms: 50 frames per second. */
const FAST_MS = 20;
const FAST_FRAMES_IN_A_ROW = 20;
const MAX_FAST_FRAMES_IN_A_ROW = 1280;
/** A longer gap is no slow frame: while the pointer rests there are no frames. */
const MAX_GAP_MS = 1000;

export class FramePace {
  /** Index in `QUALITIES`. */
  private step: number;
  /** When the last frame began, ms; 0 before the first one. */
  private lastFrameMs = 0;
  private slowFrames = 0;
  private fastFrames = 0;
  /** Fast frames in a row before a higher quality is tried; doubled each time that it turns out to be too slow. */
  private fastFramesNeeded = FAST_FRAMES_IN_A_ROW;
  /** The last change was to a higher quality. */
  private wasRaised = false;

  /** Begins with the quality that is probably right with or without a graphics card. */
  constructor(isSoftware: boolean) {
    this.step = isSoftware ? 4 : 1;
  }

  get quality(): FrameQuality {
    return QUALITIES[this.step]!;
  }

  /** The view begins to turn. */
  begin(): void {
    this.lastFrameMs = 0;
    this.slowFrames = this.fastFrames = 0;
  }

  /** A frame begins at `now`, ms: the time since the one before is what that one took. */
  frame(now: number): void {
    const gap = now - this.lastFrameMs;
    const isFirst = this.lastFrameMs === 0;
    this.lastFrameMs = now;
    if (isFirst || gap > MAX_GAP_MS) return;
    this.slowFrames = gap > SLOW_MS ? this.slowFrames + 1 : 0;
    this.fastFrames = gap < FAST_MS ? this.fastFrames + 1 : 0;
    // One slow frame may have another cause.
    if (this.slowFrames >= 2 && this.step < QUALITIES.length - 1) {
      if (this.wasRaised) this.fastFramesNeeded = Math.min(MAX_FAST_FRAMES_IN_A_ROW, 2 * this.fastFramesNeeded);
      this.choose(this.step + 1);
      this.wasRaised = false;
    } else if (this.fastFrames > this.fastFramesNeeded && this.step > 0) {
      this.choose(this.step - 1);
      this.wasRaised = true;
    }
  }

  private choose(step: number): void {
    this.step = step;
    this.slowFrames = this.fastFrames = 0;
  }
}

/** How many lines are drawn in one slice, so that the page stays responsive: a slice is to take 16 to 40 ms. */
export class DrawSlices {
  lines: number;

  constructor(isSoftware: boolean) {
    this.lines = isSoftware ? 8_000 : 250_000;
  }

  /** Reports how long a number of lines took, ms. */
  took(lines: number, ms: number): void {
    // The time of a small slice is mostly overhead.
    if (lines < this.lines / 2) return;
    if (ms < 16) this.lines = Math.min(16_000_000, this.lines * 2);
    else if (ms > 40) this.lines = Math.max(2_000, this.lines / 2);
  }
}
