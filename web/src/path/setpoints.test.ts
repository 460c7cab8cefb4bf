import { describe, expect, it } from "vitest";
import { KNOWN_BIT } from "./batch";
import { Path } from "./path";
import { momentAt, speedBands, stepRow, timeOfRow } from "./setpoints";

const points = {
  positions: new Float32Array([0, 0, 0, 1, 0, 0, 4, 0, 0, 4, 0, 0]),
  speed: new Float32Array([0, 60, 120, 0]),
  row: new Uint32Array([0, 0, 4, 4]),
  periodS: 0.5,
  totalS: 1.5,
};

describe("playback", () => {
  it("is where the planner says, between setpoints too", () => {
    expect(momentAt(points, 0.25)).toEqual({ position: [0.5, 0, 0], programmed: [0.5, 0, 0], rotaryAngles: [0, 0, 0], speed: 30, row: 0 });
    expect(momentAt(points, 99)).toEqual({ position: [4, 0, 0], programmed: [4, 0, 0], rotaryAngles: [0, 0, 0], speed: 0, row: 4 });
    expect(momentAt({ ...points, row: new Uint32Array(), positions: new Float32Array() }, 1)).toBeUndefined();
  });

  it("knows when a row begins", () => {
    expect(timeOfRow(points, 0)).toBe(0);
    expect(timeOfRow(points, 4)).toBe(1);
    // Two of the four rows that begin between two setpoints have begun at half of it.
    expect(timeOfRow(points, 2)).toBe(0.75);
    expect(timeOfRow(points, 9)).toBe(1.5);
  });

  it("keeps the peaks of the speed", () => {
    const [low, high] = speedBands(points, 2);
    expect([...high]).toEqual([120, 120]);
    expect([...low]).toEqual([0, 0]);
  });

  it("steps by block", () => {
    const path = new Path();
    const lines = [1, 2, 2, 2, 5];
    path.add({
      first: 0,
      rows: 5,
      points: new Float32Array(30),
      kind: new Uint8Array(5).fill(1 | KNOWN_BIT),
      tool: new Uint32Array(5),
      line: new Uint32Array(lines),
      file: new Uint8Array(5),
      feed: new Float32Array(5),
      arcRows: new Uint32Array(),
      arcs: new Float32Array(),
    }, [0, 0, 0]);
    expect(stepRow(path, 0, 1)).toBe(1);
    expect(stepRow(path, 1, 1)).toBe(4);
    expect(stepRow(path, 4, 1)).toBe(4);
    expect(stepRow(path, 4, -1)).toBe(1);
    expect(stepRow(path, 2, -1)).toBe(0);
    expect(stepRow(path, 0, -1)).toBe(0);
  });
});
