// The direction of the tool relative to the part where rotary axes turn one of them. Positions come from the server relative to the part.

import type { AxisMotion, RotaryAxis, ToolRotation } from "../protocol/messages";
import type { Vec3 } from "./batch";

/** The direction of a tool relative to the part, from its direction on the machine and A, B and C, rad. */
export function toolDirection(rotations: readonly ToolRotation[], direction: Vec3, angles: ArrayLike<number>): Vec3 {
  return rotations.reduce((turned, { axis, about }) => rotated(turned, about, angles[axis]!), direction);
}

/** Rotated about a unit vector by the right-hand rule: Rodrigues' formula. */
function rotated(v: Vec3, k: Vec3, angle: number): Vec3 {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = (k[0] * v[0] + k[1] * v[1] + k[2] * v[2]) * (1 - c);
  return [
    v[0] * c + (k[1] * v[2] - k[2] * v[1]) * s + k[0] * along,
    v[1] * c + (k[2] * v[0] - k[0] * v[2]) * s + k[1] * along,
    v[2] * c + (k[0] * v[1] - k[1] * v[0]) * s + k[2] * along,
  ];
}

/** The pose of a body that axes move, at their positions, mm and rad: sixteen numbers, column by column. */
export function bodyPose(motions: readonly AxisMotion[], positions: ArrayLike<number>): number[] {
  const place = (point: Vec3) => motions.reduce((at, motion) => moved(at, motion, positions[motion.axis]!), point);
  const zero = place([0, 0, 0]);
  const columns = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as Vec3[]).map((unit) => [...difference(place(unit), zero), 0]);
  return [...columns.flat(), ...zero, 1];
}

/** A point after the motion of an axis that is at a position. */
function moved(point: Vec3, motion: AxisMotion, position: number): Vec3 {
  if ("along" in motion) return sum(point, motion.along.map((part) => part * position) as Vec3);
  return sum(rotated(difference(point, motion.through), motion.about, position), motion.through);
}

function sum(one: Vec3, other: Vec3): Vec3 {
  return [one[0] + other[0], one[1] + other[1], one[2] + other[2]];
}

function difference(one: Vec3, other: Vec3): Vec3 {
  return [one[0] - other[0], one[1] - other[1], one[2] - other[2]];
}

/** The hint about rotary axes that the program moves and the machine file does not describe; empty where there are none. */
export function unknownRotaryHint(axes: { letter: string; range: [number, number] }[], rotary: RotaryAxis[]): string {
  const unknown = rotary.filter(({ letter, turns }) => {
    const moved = axes.find((axis) => axis.letter === letter);
    return turns === null && moved && (moved.range[0] !== 0 || moved.range[1] !== 0);
  });
  if (unknown.length === 0) return "";
  const names = unknown.map(({ letter }) => letter).join(", ");
  return `What ${names} turns is not known: the path is drawn without rotation. Give \`rotary.${unknown[0]!.letter}.turns\` in the machine file.`;
}
