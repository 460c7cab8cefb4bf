// The playback position as one state, from which line, clock, readout, tool and stock are shown.

import { type Vec3, AXIS_BITS } from "./batch";
import type { Path } from "./path";
import { type Setpoints, momentAt, timeAfterRow, timeOfRow, timeOnRow } from "./setpoints";

/** The position that was requested. */
export type PlaybackTarget =
  | { to: "start" }
  /** The end of the last row of a line. */
  | { to: "line"; line: number }
  /** A fraction of a row, 0 to 1; with `keepsPathInFull` no part of the path is drawn pale: a point of it was clicked. */
  | { to: "row"; row: number; fraction: number; keepsPathInFull?: boolean }
  | { to: "time"; seconds: number };

/** X, Y and Z, mm; undefined where one is not known. */
export type Coordinates = [number | undefined, number | undefined, number | undefined];

export interface PlaybackState {
  /** The row of the path that the tool is on. */
  row: number;
  /** How much of the row is done, 0 to 1. */
  fraction: number;
  /** Position of the tool on the part, relative to the origin of the path, mm; undefined where it is not known. */
  position: Vec3 | undefined;
  /** The programmed position, in the frame of the run. */
  coordinates: Coordinates;
  /** A, B and C, rad. */
  rotaryAngles: Vec3;
  /** mm/min; undefined until the motion is planned. */
  speed: number | undefined;
  /** From the start; undefined until the motion is planned. */
  seconds: number | undefined;
}

/** A position this close to an end of its row counts as that end, mm. */
const END_TOLERANCE_MM = 1e-3;
/** This close to the ends of a closed row, as a fraction of it, the time decides whether the tool is at its start or its end. */
const CLOSED_END_FRACTION = 0.02;

/** The state at a requested position. */
export function playbackStateOf(target: PlaybackTarget, path: Path, setpoints: Setpoints | undefined): PlaybackState {
  switch (target.to) {
    case "start":
      return onRow(path, setpoints, 0, 0, 0);
    case "line": {
      const done = path.doneAfterLine(target.line);
      return done === 0 ? onRow(path, setpoints, 0, 0, 0) : onRow(path, setpoints, done - 1, 1);
    }
    case "row":
      return onRow(path, setpoints, target.row, target.fraction);
    case "time":
      return setpoints ? atTime(path, setpoints, target.seconds) : onRow(path, setpoints, 0, 0, 0);
  }
}

/** How many rows are done, with the fraction of the present one. */
export function rowsDoneAt({ row, fraction }: PlaybackState): number {
  return row + fraction;
}

function onRow(path: Path, setpoints: Setpoints | undefined, row: number, fraction: number, from?: number): PlaybackState {
  const seconds = setpoints && (from ?? timeOnRow(setpoints, row, fraction));
  const moment = setpoints && seconds !== undefined ? momentAt(setpoints, seconds) : undefined;
  const [drawn, programmed] = [path.pointOn(row, fraction), path.programmedOn(row, fraction)];
  const planned = moment && relative(moment.programmed, path);
  // The ends of a row are exactly those of the program. Within a row, and at a corner that the control rounds, the planned
  // motion gives the position.
  const isEnd = fraction <= 0 || fraction >= 1;
  const isReached = !planned || !programmed || (isEnd && distance(planned, programmed) <= toleranceAt(setpoints!, seconds!));
  if (isReached) return { row, fraction, ...knownPosition(path, row, fraction, drawn, programmed), rotaryAngles: path.rotaryAnglesOn(row, fraction), speed: moment?.speed, seconds };
  return { row, fraction, ...knownPosition(path, row, fraction, relative(moment!.position, path), planned), rotaryAngles: moment!.rotaryAngles, speed: moment!.speed, seconds };
}

/** How far the tool moves between the setpoints around a time, mm: times and positions agree to no more than that. */
function toleranceAt(setpoints: Setpoints, seconds: number): number {
  const { periodS } = setpoints;
  const [before, after] = [seconds - periodS, seconds + periodS].map((time) => momentAt(setpoints, time)!.programmed);
  return END_TOLERANCE_MM + distance(before!, after!);
}

function atTime(path: Path, setpoints: Setpoints, seconds: number): PlaybackState {
  const moment = momentAt(setpoints, seconds);
  if (!moment) return onRow(path, undefined, 0, 0);
  const { row, rotaryAngles, speed } = moment;
  const drawn = relative(moment.position, path);
  const fraction = fractionAt(path, setpoints, row, drawn, seconds);
  return { row, fraction, ...knownPosition(path, row, fraction, drawn, relative(moment.programmed, path)), rotaryAngles, speed, seconds };
}

/** The fraction of a row that is done when the tool is at a position at a time. */
function fractionAt(path: Path, setpoints: Setpoints, row: number, position: Vec3, seconds: number): number {
  const distanceAt = (fraction: number) => {
    const point = path.pointOn(row, fraction);
    return point ? distance(point, position) : Infinity;
  };
  const isAtStart = distanceAt(0) < END_TOLERANCE_MM;
  const isAtEnd = distanceAt(1) < END_TOLERANCE_MM;
  if (isAtStart !== isAtEnd) return isAtEnd ? 1 : 0;
  const fraction = path.fractionOf(row, position);
  const isClosed = isAtStart || (distanceAt(0) < Infinity && isClosedRow(path, row));
  if (!isClosed || (fraction > CLOSED_END_FRACTION && fraction < 1 - CLOSED_END_FRACTION)) return fraction;
  // A full circle, or a move of rotary axes alone: start and end are the same position.
  const [from, to] = [timeOfRow(setpoints, row), timeAfterRow(setpoints, row)];
  const passed = to > from ? Math.min(1, Math.max(0, (seconds - from) / (to - from))) : 1;
  if (isAtStart) return passed;
  return passed > 0.5 ? Math.max(fraction, 1 - fraction) : Math.min(fraction, 1 - fraction);
}

function isClosedRow(path: Path, row: number): boolean {
  return distance(path.pointOn(row, 0)!, path.pointOn(row, 1)!) < END_TOLERANCE_MM;
}

/** Where the tool is drawn, and its coordinates, as far as they are known. */
function knownPosition(path: Path, row: number, fraction: number, drawn: Vec3 | undefined, programmed: Vec3 | undefined): Pick<PlaybackState, "position" | "coordinates"> {
  const axes = path.knownOn(row, fraction);
  const coordinates = AXIS_BITS.map((bit, axis) =>
    programmed && axes & bit ? programmed[axis]! + path.origin[axis]! : undefined) as Coordinates;
  return { position: path.isDrawable(row, fraction) ? drawn : undefined, coordinates };
}

/** Relative to the origin of the path. */
function relative(position: Vec3, path: Path): Vec3 {
  return position.map((value, axis) => value - path.origin[axis]!) as Vec3;
}

function distance(one: Vec3, other: Vec3): number {
  return Math.hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}
