// Cutting loads over time: the maximum of each part of it, and where it is too much.

import { type Units, length, power } from "../panels/units";
import { type Frame, f32, u32, u8 } from "../protocol/frame";
import type { Setpoints } from "./setpoints";

export type EngagementMeasure = "radial" | "chip" | "power";

const MILLING_MEASURES: [EngagementMeasure, string][] = [["radial", "Radial depth"], ["chip", "Chip"], ["power", "Power"]];
const TURNING_MEASURES: [EngagementMeasure, string][] = [["radial", "Depth of cut"], ["chip", "Chip"], ["power", "Power"]];

/** What is wrong with a move: a chip too thick or a spindle without the power, or a tool that rubs. */
export type EngagementFault = "none" | "overload" | "rubs";

/** By row of the path; zero where nothing is cut or the load is not known. */
export class EngagementCurve {
  private values: Record<EngagementMeasure, Float32Array>;
  private faults: Uint8Array;
  readonly known: EngagementMeasure[];

  constructor(rows: Uint32Array, by: Record<EngagementMeasure, Float32Array>, problems: Uint8Array, private isTurning = false) {
    const count = (rows.at(-1) ?? -1) + 1;
    const dense = (values: Float32Array) => {
      const made = new Float32Array(count);
      rows.forEach((row, at) => (made[row] = Math.max(0, values[at]!)));
      return made;
    };
    this.values = { radial: dense(by.radial), chip: dense(by.chip), power: dense(by.power) };
    this.faults = new Uint8Array(count);
    rows.forEach((row, at) => (this.faults[row] = problems[at] === 2 ? 1 : problems[at] ? 2 : 0));
    this.known = MILLING_MEASURES.map(([measure]) => measure).filter((measure) => by[measure].some((value) => value > 0));
  }

  /** The measures that are known, with their names. */
  get named(): [EngagementMeasure, string][] {
    return (this.isTurning ? TURNING_MEASURES : MILLING_MEASURES).filter(([measure]) => this.known.includes(measure));
  }

  /** The maximum of a measure in each of `parts` equal parts of the time, and what is wrong there. */
  bands(measure: EngagementMeasure | undefined, points: Setpoints, parts: number): { most: Float32Array; faults: EngagementFault[] } {
    const most = new Float32Array(parts);
    const faults: EngagementFault[] = new Array(parts).fill("none");
    const values = measure && this.values[measure];
    const last = points.row.length - 1;
    for (let part = 0; part < parts && last >= 0; part++) {
      const at = (share: number) => Math.min(last, Math.max(0, (share * points.totalS) / points.periodS));
      // Short moves have no setpoint of their own.
      const from = points.row[Math.floor(at(part / parts))]!;
      const to = Math.min(points.row[Math.ceil(at((part + 1) / parts))]!, this.faults.length - 1);
      let worst = 0;
      for (let row = from; row <= to; row++) {
        if (values && values[row]! > most[part]!) most[part] = values[row]!;
        if (this.faults[row]! > worst) worst = this.faults[row]!;
      }
      faults[part] = (["none", "rubs", "overload"] as const)[worst]!;
    }
    return { most, faults };
  }
}

export function engagementOf(frame: Frame): EngagementCurve {
  const by = { radial: f32(frame, "radial"), chip: f32(frame, "chip"), power: f32(frame, "power") };
  return new EngagementCurve(u32(frame, "row"), by, u8(frame, "problem"), frame.header.turning === true);
}

/** A value with its unit. */
export function measureText(units: Units, measure: EngagementMeasure, value: number): string {
  return measure === "power" ? power(units, value) : length(units, value);
}
