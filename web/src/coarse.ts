// Fewer lines while the view turns: as many as this machine draws fast enough.

import { Group } from "three";
import { type Lines, decimated } from "./lines";
import type { Batch } from "./path";
import { type StrokeMaterials, Strokes } from "./strokes";

/** Lines of each level, about. */
const LEVELS = [60_000, 15_000, 4_000];
/** A frame that takes longer asks for fewer lines, ms. */
const SLOW = 42;
/** Frames that are faster, many in a row, allow for more, ms. */
const FAST = 14;
const IN_A_ROW = 20;

export class Coarse {
  readonly object = new Group();
  private levels: Group[] = [];
  private level = 0;
  private before = 0;
  private fast = 0;
  private strokes: Strokes[] = [];

  constructor() {
    this.object.visible = false;
  }

  get isReady(): boolean {
    return this.levels.length > 0;
  }

  clear(): void {
    this.strokes.forEach((strokes) => strokes.remove());
    this.levels.forEach((level) => level.removeFromParent());
    this.strokes = [];
    this.levels = [];
  }

  build(batches: Batch[], rows: number, colors: (batch: Batch, lines: Lines) => Uint8Array, materials: StrokeMaterials): void {
    this.clear();
    for (const most of LEVELS) {
      const level = new Group();
      for (const batch of batches) {
        const lines = decimated(batch, Math.ceil(rows / most));
        if (lines.count === 0) continue;
        const strokes = new Strokes(lines.points, colors(batch, lines), materials, false);
        this.strokes.push(strokes);
        level.add(strokes.object);
      }
      this.levels.push(level);
      this.object.add(level);
    }
    this.choose(Math.min(this.level, LEVELS.length - 1));
  }

  private choose(level: number): void {
    this.level = level;
    this.fast = 0;
    this.levels.forEach((group, index) => (group.visible = index === level));
  }

  show(shown: boolean): void {
    if (shown && !this.object.visible) this.before = 0;
    this.object.visible = shown;
  }

  /** A frame is drawn at a time, ms: the gap to the one before says whether the level is right. */
  frame(now: number): void {
    if (!this.object.visible) return;
    const gap = now - this.before;
    const first = this.before === 0;
    this.before = now;
    // Whoever rests with the button down makes no frames: that says nothing.
    if (first || gap > 1000) return;
    if (gap > SLOW && this.level < this.levels.length - 1) this.choose(this.level + 1);
    this.fast = gap < FAST ? this.fast + 1 : 0;
    if (this.fast > IN_A_ROW && this.level > 0) this.choose(this.level - 1);
  }
}
