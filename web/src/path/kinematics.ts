// Rotary axes: where on the part the tool is, and its direction there. The program's positions are
// those before the part turns; the picture shows the part without motion.

import type { RotaryAxis } from "../protocol/messages";
import { arcIndex, arcPoint } from "./arcs";
import type { Batch, Vec3 } from "./batch";

/** A move that turns is drawn in pieces of this angle, rad. */
const STEP_RAD = Math.PI / 90;
/** Pieces of one move at most. */
const MAX_PIECES = 2_000;

/** What the rotary axes of a machine do to the path. */
export class Kinematics {
  private known: boolean;

  constructor(
    private axes: RotaryAxis[],
    private origin: Vec3,
  ) {
    this.known = axes.some((axis) => axis.turns !== null);
  }

  get isKnown(): boolean {
    return this.known;
  }

  /** A point, relative to the origin, as it is on the part. */
  place(at: Vec3, turn: ArrayLike<number>, from = 0): Vec3 {
    let placed = at;
    this.axes.forEach((axis, index) => {
      const angle = turn[from + index]!;
      if (axis.turns !== "table" || angle === 0) return;
      const center = axis.center_mm.map((mm, i) => mm - this.origin[i]!) as Vec3;
      const arm = placed.map((value, i) => value - center[i]!) as Vec3;
      placed = rotated(arm, index, signed(axis, angle)).map((value, i) => value + center[i]!) as Vec3;
    });
    return placed;
  }

  /** A direction of the tool, or of a move, on the part. */
  direction(vector: Vec3, turn: ArrayLike<number>, from = 0, of: "tool" | "move" = "tool"): Vec3 {
    let pointed = vector;
    for (const kind of of === "tool" ? (["head", "table"] as const) : (["table"] as const)) {
      this.axes.forEach((axis, index) => {
        const angle = turn[from + index]!;
        if (axis.turns === kind && angle !== 0) pointed = rotated(pointed, index, signed(axis, angle));
      });
    }
    return pointed;
  }

  /** A batch as it is on the part; one without rotary moves is returned unchanged. */
  batch(batch: Batch): Batch {
    const { turns } = batch;
    if (!turns || !this.known) return batch;
    const points = batch.points.slice();
    const arcs = batch.arcs.slice();
    const curves = new Map<number, Float32Array>();
    for (let row = 0; row < batch.rows; row++) {
      const from = 6 * row;
      const to = from + 3;
      const steps = this.steps(turns, row);
      const arc = arcIndex(batch, row);
      const spline = batch.curves?.get(row);
      if (spline) curves.set(row, this.spline(spline, turns, row));
      else if (steps > 1) curves.set(row, this.curve(batch, row, arc, steps));
      else if (arc >= 0) this.turnArc(arcs, arc, turns, from);
      points.set(this.place(pointOf(batch.points, from), turns, from), from);
      points.set(this.place(pointOf(batch.points, to), turns, to), to);
    }
    return { ...batch, points, programmed: batch.points, arcs, curves };
  }

  /** In how many pieces a row is drawn: one where no axis turns that carries the part. */
  private steps(turns: Float32Array, row: number): number {
    let most = 0;
    this.axes.forEach((axis, index) => {
      if (axis.turns !== "table") return;
      most = Math.max(most, Math.abs(turns[6 * row + 3 + index]! - turns[6 * row + index]!));
    });
    return Math.max(1, Math.min(MAX_PIECES, Math.ceil(most / STEP_RAD)));
  }

  /** The points of a spline, each as it is on the part. */
  private spline(points: Float32Array, turns: Float32Array, row: number): Float32Array {
    const curve = new Float32Array(points.length);
    for (let at = 0; at < points.length; at += 3) {
      const share = at / (points.length - 3);
      const turn = [0, 1, 2].map((axis) => {
        const from = turns[6 * row + axis]!;
        return from + (turns[6 * row + 3 + axis]! - from) * share;
      });
      curve.set(this.place(pointOf(points, at), turn), at);
    }
    return curve;
  }

  private curve(batch: Batch, row: number, arc: number, steps: number): Float32Array {
    const turns = batch.turns!;
    // An arc on a turning part is curved twice: by itself and by the rotation.
    const pieces = arc >= 0 ? Math.max(steps, 64) : steps;
    const curve = new Float32Array(3 * (pieces + 1));
    for (let step = 0; step <= pieces; step++) {
      const share = step / pieces;
      const mix = (from: number, to: number) => from + (to - from) * share;
      const p = batch.points;
      const at = (axis: number) => mix(p[6 * row + axis]!, p[6 * row + 3 + axis]!);
      const place: Vec3 = arc >= 0 && step > 0 && step < pieces ? arcPoint(batch.arcs, arc, share) : [at(0), at(1), at(2)];
      const turn = [0, 1, 2].map((axis) => mix(turns[6 * row + axis]!, turns[6 * row + 3 + axis]!));
      curve.set(this.place(place, turn), 3 * step);
    }
    return curve;
  }

  private turnArc(arcs: Float32Array, arc: number, turns: Float32Array, from: number): void {
    const at = 13 * arc;
    arcs.set(this.place(pointOf(arcs, at), turns, from), at);
    arcs.set(this.direction(pointOf(arcs, at + 3), turns, from, "move"), at + 3);
    arcs.set(this.direction(pointOf(arcs, at + 6), turns, from, "move"), at + 6);
  }

  /** Setpoints as they are on the part. */
  places(places: Float32Array, turns: Float32Array): Float32Array {
    const turnedPlaces = new Float32Array(places.length);
    for (let at = 0; at < places.length; at += 3) {
      const own = pointOf(places, at).map((value, axis) => value - this.origin[axis]!) as Vec3;
      const place = this.place(own, turns, at);
      turnedPlaces.set(place.map((value, axis) => value + this.origin[axis]!), at);
    }
    return turnedPlaces;
  }
}

/** The point at a share of a curve of points at even distances. */
export function curvePoint(curve: Float32Array, share: number): Vec3 {
  const last = curve.length / 3 - 1;
  const exact = Math.min(last, Math.max(0, share * last));
  const index = Math.min(last - 1, Math.floor(exact));
  const part = exact - index;
  const mix = (axis: number) => {
    const from = curve[3 * index + axis]!;
    return from + (curve[3 * index + 3 + axis]! - from) * part;
  };
  return [mix(0), mix(1), mix(2)];
}

/** The hint about rotary axes that the program moves and the machine file does not describe. */
export function unknownTurns(axes: { letter: string; range: [number, number] }[], rotary: RotaryAxis[]): string {
  const unknown = rotary.filter((own) => {
    const moved = axes.find((axis) => axis.letter === own.letter);
    return own.turns === null && moved && (moved.range[0] !== 0 || moved.range[1] !== 0);
  });
  if (unknown.length === 0) return "";
  const names = unknown.map((own) => own.letter).join(", ");
  return `What ${names} turns is not known: the path is drawn without rotation. Give \`rotary.${unknown[0]!.letter}.turns\` in the machine file.`;
}

function signed(axis: RotaryAxis, angle: number): number {
  return axis.reversed ? -angle : angle;
}

function pointOf(points: ArrayLike<number>, at: number): Vec3 {
  return [points[at]!, points[at + 1]!, points[at + 2]!];
}

/** Rotated about X, Y or Z by the right-hand rule. */
export function rotated(at: Vec3, about: number, angle: number): Vec3 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [u, v] = [(about + 1) % 3, (about + 2) % 3];
  const result: Vec3 = [...at];
  result[u] = at[u]! * c - at[v]! * s;
  result[v] = at[u]! * s + at[v]! * c;
  return result;
}
