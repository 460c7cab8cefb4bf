import { describe, expect, it } from "vitest";
import { DrawSlices, FramePace, QUALITIES } from "./frame-budget";

function frames(pace: FramePace, gap: number, count: number): void {
  pace.begin();
  for (let at = 1; at <= count; at++) pace.frame(1 + at * gap);
}

const step = (pace: FramePace) => QUALITIES.indexOf(pace.quality);

describe("the pace of a turning view", () => {
  it("draws less while frames are slow, down to the least", () => {
    const pace = new FramePace(false);
    const before = step(pace);
    frames(pace, 100, 4);
    expect(step(pace)).toBe(before + 1);
    frames(pace, 100, 100);
    expect(step(pace)).toBe(QUALITIES.length - 1);
  });

  it("draws more after many fast frames, and is in less of a hurry where that was too much", () => {
    const pace = new FramePace(true);
    const before = step(pace);
    frames(pace, 16, 23);
    expect(step(pace)).toBe(before - 1);
    frames(pace, 60, 4);
    expect(step(pace)).toBe(before);
    frames(pace, 16, 23);
    expect(step(pace)).toBe(before);
    frames(pace, 16, 50);
    expect(step(pace)).toBe(before - 1);
  });

  it("takes no rest for a slow frame, nor one slow frame for many", () => {
    const pace = new FramePace(false);
    const before = step(pace);
    frames(pace, 1500, 10);
    pace.begin();
    for (const at of [16, 32, 132, 148, 164, 264, 280]) pace.frame(at);
    expect(step(pace)).toBe(before);
  });
});

describe("slices of a long path", () => {
  it("grow and shrink with what they take", () => {
    const slices = new DrawSlices(true);
    const first = slices.lines;
    slices.took(first, 5);
    expect(slices.lines).toBe(2 * first);
    slices.took(2 * first, 30);
    expect(slices.lines).toBe(2 * first);
    slices.took(2 * first, 90);
    expect(slices.lines).toBe(first);
    slices.took(10, 1);
    expect(slices.lines).toBe(first);
  });
});
