// Cutting loads over time: their maximum in each interval of the timeline, and where a load is too high.

import { type Units, length, power } from "../panels/units";
import { type Frame, f32, u32, u8 } from "../protocol/frame";
import type { Setpoints } from "./setpoints";

export type EngagementMeasure = "radial" | "chip" | "power";

const MILLING_MEASURES: [EngagementMeasure, string][] = [["radial", "Radial depth"], ["chip", "Chip"], ["power", "Power"]];
const TURNING_MEASURES: [EngagementMeasure, string][] = [["radial", "Depth of cut"], ["chip", "Chip"], ["power", "Power"]];

/** What is wrong with a move: overload is a chip that is too thick or too much power for the spindle, rubbing a chip that is too thin. */
export type EngagementFault = "none" | "overload" | "rubs";

/** Cutting loads by row of the path; zero where nothing is cut or the load is not known. */
export class EngagementCurve {
  private values: Record<EngagementMeasure, Float32Array>;
  /** By row: 0 no fault, 1 rubs, 2 overload: the worst is the largest. */
  private faults: Uint8Array;
  readonly known: EngagementMeasure[];

  constructor(rows: Uint32Array, loads: Record<EngagementMeasure, Float32Array>, problems: Uint8Array, private isTurning = false) {
    const count = (rows.at(-1) ?? -1) + 1;
    const dense = (values: Float32Array) => {
      const byRow = new Float32Array(count);
      rows.forEach((row, index) => (byRow[row] = Math.max(0, values[index]!)));
      return byRow;
    };
    this.values = { radial: dense(loads.radial), chip: dense(loads.chip), power: dense(loads.power) };
    this.faults = new Uint8Array(count);
    rows.forEach((row, index) => (this.faults[row] = problems[index] === 2 ? 1 : problems[index] ? 2 : 0));
    this.known = MILLING_MEASURES.map(([measure]) => measure).filter((measure) => loads[measure].some((value) => value > 0));
  }

  /** The measures that are known, with their labels. */
  get labels(): [EngagementMeasure, string][] {
    return (this.isTurning ? TURNING_MEASURES : MILLING_MEASURES).filter(([measure]) => this.known.includes(measure));
  }

  /** The maximum of a measure and the worst fault in each of `count` equal intervals of the time. */
  bands(measure: EngagementMeasure | undefined, setpoints: Setpoints, count: number): { maxima: Float32Array; faults: EngagementFault[] } {
    const maxima = new Float32Array(count);
    const faults: EngagementFault[] = new Array(count).fill("none");
    const values = measure && this.values[measure];
    const last = setpoints.row.length - 1;
    for (let interval = 0; interval < count && last >= 0; interval++) {
      const indexAt = (fraction: number) => Math.min(last, Math.max(0, (fraction * setpoints.totalS) / setpoints.periodS));
      // Every row between the two setpoints: short moves have no setpoint of their own.
      const from = setpoints.row[Math.floor(indexAt(interval / count))]!;
      const to = Math.min(setpoints.row[Math.ceil(indexAt((interval + 1) / count))]!, this.faults.length - 1);
      let worst = 0;
      for (let row = from; row <= to; row++) {
        if (values && values[row]! > maxima[interval]!) maxima[interval] = values[row]!;
        if (this.faults[row]! > worst) worst = this.faults[row]!;
      }
      faults[interval] = (["none", "rubs", "overload"] as const)[worst]!;
    }
    return { maxima, faults };
  }
}

export function engagementOf(frame: Frame): EngagementCurve {
  const loads = { radial: f32(frame, "radial"), chip: f32(frame, "chip"), power: f32(frame, "power") };
  return new EngagementCurve(u32(frame, "row"), loads, u8(frame, "problem"), frame.header.turning === true);
}

/** A value with its unit. */
export function measureText(units: Units, measure: EngagementMeasure, value: number): string {
  return measure === "power" ? power(units, value) : length(units, value);
}
