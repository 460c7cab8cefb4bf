// Where the program is: one state, from which line, clock, readout, tool and stock are shown.

import { type Vec3, axisBits } from "./batch";
import type { Path } from "./path";
import { type Setpoints, momentAt, timeAfterRow, timeOfRow, timeOnRow } from "./setpoints";

/** The position that was requested. */
export type PlaybackTarget =
  /** The beginning. */
  | { to: "start" }
  /** The end of what a line does. */
  | { to: "line"; line: number }
  /** A share of a row is done; `isInspection`: a point of the path was clicked, and all of the path stays drawn in full. */
  | { to: "row"; row: number; share: number; isInspection?: boolean }
  | { to: "time"; seconds: number };

/** X, Y and Z, mm; none where one is not known. */
export type Coordinates = [number | undefined, number | undefined, number | undefined];

export interface PlaybackState {
  /** The row of the path that the tool is on, and how much of it is done. */
  row: number;
  share: number;
  /** Where the tool is on the part, relative to the origin of the path; none where that is not known. */
  at: Vec3 | undefined;
  /** The programmed position, in the frame of the run. */
  coordinates: Coordinates;
  /** A, B and C, rad. */
  turn: Vec3;
  /** mm/min; none while the motion is planned. */
  speed: number | undefined;
  /** From the start; none while the motion is planned. */
  seconds: number | undefined;
}

/** A position closer to an end of its row counts as that end, mm. */
const AT_END_MM = 1e-3;
/** Within this share of the ends of a closed row, the time decides whether the tool is at its start or its end. */
const CLOSED_END_SHARE = 0.02;

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
      return onRow(path, setpoints, target.row, target.share);
    case "time":
      return setpoints ? atTime(path, setpoints, target.seconds) : onRow(path, setpoints, 0, 0, 0);
  }
}

/** How many rows are done, with the share of the last one. */
export function doneOf({ row, share }: PlaybackState): number {
  return row + share;
}

function onRow(path: Path, setpoints: Setpoints | undefined, row: number, share: number, from?: number): PlaybackState {
  const seconds = setpoints && (from ?? timeOnRow(setpoints, row, share));
  const moment = setpoints && seconds !== undefined ? momentAt(setpoints, seconds) : undefined;
  const [own, programmed] = [path.pointOn(row, share), path.programmedOn(row, share)];
  const planned = moment && relative(moment.programmed, path);
  // Its ends are those of the program, to the digit. Within a row, and at a corner that is rounded, the motion says
  // where the tool is.
  const isEnd = share <= 0 || share >= 1;
  const isReached = !planned || !programmed || (isEnd && distance(planned, programmed) <= stepAt(setpoints!, seconds!));
  if (isReached) return { row, share, ...known(path, row, share, own, programmed), turn: path.turnOn(row, share), speed: moment?.speed, seconds };
  return { row, share, ...known(path, row, share, relative(moment!.at, path), planned), turn: moment!.turn, speed: moment!.speed, seconds };
}

/** How far the tool moves between the setpoints around a time, mm: the time of a position is known no better. */
function stepAt(setpoints: Setpoints, seconds: number): number {
  const { periodS } = setpoints;
  const [before, after] = [seconds - periodS, seconds + periodS].map((at) => momentAt(setpoints, at)!.programmed);
  return AT_END_MM + distance(before!, after!);
}

function atTime(path: Path, setpoints: Setpoints, seconds: number): PlaybackState {
  const moment = momentAt(setpoints, seconds);
  if (!moment) return onRow(path, undefined, 0, 0);
  const { row, turn, speed } = moment;
  const own = relative(moment.at, path);
  const share = shareAt(path, setpoints, row, own, seconds);
  return { row, share, ...known(path, row, share, own, relative(moment.programmed, path)), turn, speed, seconds };
}

/** The share of a row that is done when the tool is at a position at a time. */
function shareAt(path: Path, setpoints: Setpoints, row: number, at: Vec3, seconds: number): number {
  const far = (share: number) => {
    const point = path.pointOn(row, share);
    return point ? distance(point, at) : Infinity;
  };
  const isAtStart = far(0) < AT_END_MM;
  const isAtEnd = far(1) < AT_END_MM;
  if (isAtStart !== isAtEnd) return isAtEnd ? 1 : 0;
  const share = path.shareOf(row, at);
  const isClosed = isAtStart || (far(0) < Infinity && closes(path, row));
  if (!isClosed || (share > CLOSED_END_SHARE && share < 1 - CLOSED_END_SHARE)) return share;
  // A whole circle, or a move of rotary axes alone: start and end are one place.
  const [from, to] = [timeOfRow(setpoints, row), timeAfterRow(setpoints, row)];
  const passed = to > from ? Math.min(1, Math.max(0, (seconds - from) / (to - from))) : 1;
  if (isAtStart) return passed;
  return passed > 0.5 ? Math.max(share, 1 - share) : Math.min(share, 1 - share);
}

function closes(path: Path, row: number): boolean {
  return distance(path.pointOn(row, 0)!, path.pointOn(row, 1)!) < AT_END_MM;
}

/** Where the tool is drawn, and its coordinates, as far as both are known. */
function known(path: Path, row: number, share: number, at: Vec3 | undefined, programmed: Vec3 | undefined): Pick<PlaybackState, "at" | "coordinates"> {
  const axes = path.knownOn(row, share);
  const coordinates = axisBits.map((bit, axis) =>
    programmed && axes & bit ? programmed[axis]! + path.origin[axis]! : undefined) as Coordinates;
  return { at: path.isPlace(row, share) ? at : undefined, coordinates };
}

function relative(place: Vec3, path: Path): Vec3 {
  return place.map((value, axis) => value - path.origin[axis]!) as Vec3;
}

function distance(one: Vec3, other: Vec3): number {
  return Math.hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}
