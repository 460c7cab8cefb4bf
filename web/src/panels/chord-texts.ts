// Texts about the chords of arcs.

import type { Frame } from "../protocol/frame";
import { type Units, count, countText, length } from "./units";

/** How many chords there are at a tolerance, and how far they are from the arcs. */
export function chordsText(units: Units, header: Frame["header"]): string {
  const { chords, curves, left_out, error_mm, tolerance_mm } = header;
  if (Number(curves) === 0) return "No arcs in this program";
  const error = typeof error_mm === "number"
    ? `chord error ${length(units, error_mm, true, 2)}`
    : `chord error at most ${length(units, Number(tolerance_mm), true, 2)}`;
  const hidden = Number(left_out) > 0 ? `, ${count(Number(left_out))} not drawn` : "";
  return `${toleranceText(units, Number(tolerance_mm))}: ${countText(Number(chords), "chord")} on ${countText(Number(curves), "curve")}, ${error}${hidden}`;
}

export function toleranceText(units: Units, mm: number): string {
  return `Tolerance ${length(units, mm, true, 2)}`;
}
