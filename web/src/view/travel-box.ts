// The box that a machine can reach, or why it is not known.

import type { Bounds, Vec3 } from "../path/batch";
import type { MachineInfo } from "../protocol/messages";

/** For X, Y and Z: the position of the zero of the run on the machine, mm; null where it is not known. */
type RunZero = (number | null)[] | null;

/** The box that the machine can reach, in the frame of the run, mm; undefined where travel or zero of an axis are not known. */
export function travelBox(machine: MachineInfo | undefined, zero: RunZero): Bounds | undefined {
  if (!zero || !machine) return undefined;
  const ends = [0, 1, 2].map((axis) => {
    const travel = machine.travel[axis];
    const offset = zero[axis];
    return travel && offset !== null && offset !== undefined ? [travel[0] - offset, travel[1] - offset] : undefined;
  });
  if (ends.some((end) => !end)) return undefined;
  return { low: ends.map((end) => end![0]) as Vec3, high: ends.map((end) => end![1]) as Vec3 };
}

/** Why there is no such box; empty where there is one. */
export function whyNoTravel(machine: MachineInfo, zero: RunZero): string {
  if (travelBox(machine, zero)) return "";
  const missing = (valueOf: (axis: number) => unknown) => ["X", "Y", "Z"].filter((_, axis) => valueOf(axis) === null || valueOf(axis) === undefined);
  const limits = missing((axis) => machine.travel[axis]);
  const offsets = missing((axis) => zero?.[axis]);
  return limits.length > 0
    ? `Travel is not shown: the machine file gives no travel of ${limits.join(", ")}.`
    : `Travel is not shown: the offsets of ${offsets.join(", ")} are not known. Give work offsets and tool lengths in the machine file, or with \`--set\`.`;
}
