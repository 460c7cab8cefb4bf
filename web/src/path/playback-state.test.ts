import { describe, expect, it } from "vitest";
import { KNOWN_BIT } from "./batch";
import { Path } from "./path";
import { rowsDoneAt, playbackStateOf } from "./playback-state";
import { type Setpoints, timeAfterRow, timeOfRow, timeOnRow } from "./setpoints";

/** From nowhere to X10 Z5 on line 1, along X on line 2 with a wait after it, along Z on line 4; Y is never named. */
function program(): [Path, Setpoints] {
  const path = new Path();
  path.add({
    first: 0,
    rows: 3,
    points: new Float32Array([-10, 0, -5, 0, 0, 0, 0, 0, 0, 20, 0, 0, 20, 0, 0, 20, 0, 10]),
    kind: Uint8Array.of(0, 1 | KNOWN_BIT, 1 | KNOWN_BIT),
    known: Uint8Array.of(0b101_000, 0b101_101, 0b101_101),
    tool: new Uint32Array(3).fill(1),
    line: Uint32Array.of(1, 2, 4),
    file: new Uint8Array(3),
    feed: new Float32Array(3).fill(600),
    arcRows: new Uint32Array(),
    arcs: new Float32Array(),
  }, [10, 0, 5]);
  path.notNamed = 0b010;
  const positions = [[0, 0, 0], [10, 0, 5], [20, 0, 5], [30, 0, 5], [30, 0, 5], [30, 0, 5], [30, 0, 15]].flat();
  return [path, {
    positions: new Float32Array(positions),
    speed: Float32Array.of(0, 600, 600, 0, 0, 0, 0),
    row: Uint32Array.of(0, 1, 1, 1, 1, 2, 2),
    periodS: 1,
    totalS: 6,
  }];
}

describe("the one state of the page", () => {
  const [path, setpoints] = program();

  it("has no place before the first known one", () => {
    for (const target of [{ to: "start" } as const, { to: "time", seconds: 0 } as const, { to: "time", seconds: 0.5 } as const]) {
      const state = playbackStateOf(target, path, setpoints);
      expect(state.position).toBeUndefined();
      expect(state.coordinates).toEqual([undefined, undefined, undefined]);
    }
  });

  it("knows the axes that are named, and draws the one that never is at zero", () => {
    expect(playbackStateOf({ to: "line", line: 1 }, path, setpoints)).toMatchObject({ position: [0, 0, 0], coordinates: [10, undefined, 5], seconds: 1 });
    expect(playbackStateOf({ to: "time", seconds: 2 }, path, setpoints)).toMatchObject({ position: [10, 0, 0], coordinates: [20, undefined, 5], row: 1 });
  });

  it("goes to when a line is done, not to when the next begins", () => {
    const state = playbackStateOf({ to: "line", line: 2 }, path, setpoints);
    expect(state).toMatchObject({ row: 1, fraction: 1, coordinates: [30, undefined, 5], seconds: 3, speed: 0 });
    expect(rowsDoneAt(state)).toBe(2);
    // Line 3 waits, and makes no path.
    expect(playbackStateOf({ to: "line", line: 3 }, path, setpoints)).toEqual(state);
    expect(playbackStateOf({ to: "line", line: 4 }, path, setpoints)).toMatchObject({ coordinates: [30, undefined, 15], seconds: 6 });
  });

  it("shows one time for a place within a row", () => {
    const state = playbackStateOf({ to: "row", row: 1, fraction: 0.25, keepsPathInFull: true }, path, setpoints);
    expect(state.seconds).toBeCloseTo(1.5, 9);
    expect(state.coordinates[0]).toBeCloseTo(15, 9);
    const again = playbackStateOf({ to: "time", seconds: state.seconds! }, path, setpoints);
    expect(again.row).toBe(1);
    expect(again.position).toEqual(state.position);
    expect(again.fraction).toBeCloseTo(0.25, 4);
  });

  it("has a place and no time while the motion is planned", () => {
    expect(playbackStateOf({ to: "line", line: 2 }, path, undefined)).toMatchObject({ position: [20, 0, 0], seconds: undefined, speed: undefined });
  });
});

it("a row is done before the wait after it", () => {
  const [, setpoints] = program();
  expect([0, 1, 2].map((row) => timeOfRow(setpoints, row))).toEqual([0, 1, 5]);
  expect([0, 1, 2].map((row) => timeAfterRow(setpoints, row))).toEqual([1, 3, 6]);
  expect([0, 0.25, 0.5, 1].map((fraction) => timeOnRow(setpoints, 1, fraction))).toEqual([1, 1.5, 2, 3]);
});
