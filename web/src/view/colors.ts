// Colours of the path, for a light and a dark page.

import type { Batch } from "../path/batch";
import type { LineArrays } from "../path/lines";
import { DARK_SHEET, LIGHT_SHEET } from "./palette";

export type ColorBy = "tool" | "speed" | "depth" | "power";

export interface Palette {
  background: string;
  rapid: string;
  contour: string;
  /** The path of the other program. */
  other: string;
  /** Where the two paths differ. */
  difference: string;
  chord: string;
  travel: string;
  /** A highlighted line and its outline: colours of no tool. */
  mark: string;
  markEdge: string;
  measure: string;
  toolShape: string;
  /** Stock that is not cut yet. */
  stock: string;
  fixture: string;
  /** Bodies of the machine, which are translucent. */
  machine: string;
  /** The section where the stock is cut open. */
  inside: string;
  /** Deviation from the target, from far below to far above; the middle is within the tolerance. */
  deviation: string[];
  /** In the order of the tools' first cuts. */
  tools: string[];
  /** From slow to fast, or from low to high. */
  ramp: string[];
  /** The colour with the highest contrast to the background. */
  text: string;
}

export const LIGHT: Palette = {
  ...LIGHT_SHEET,
  background: LIGHT_SHEET.sheet,
  contour: "#3a7d34",
  other: "#111a22",
  difference: "#a34fe0",
  chord: "#c2185b",
  travel: "#7b8794",
  mark: "#ffd400",
  markEdge: "#1d2227",
  measure: "#6a1bb0",
  toolShape: "#5b6672",
  stock: "#c9ced4",
  fixture: "#8aa0b4",
  machine: "#8aa0b4",
  inside: "#e9c46a",
  deviation: ["#b00020", "#ef6a5a", "#b9c2b4", "#5aa2e0", "#0b4fa8"],
};

export const DARK: Palette = {
  ...DARK_SHEET,
  background: DARK_SHEET.sheet,
  contour: "#86d67f",
  other: "#ffffff",
  difference: "#b57bf0",
  chord: "#ff7ab0",
  travel: "#6d7a86",
  mark: "#fff04d",
  markEdge: "#000000",
  measure: "#e3b3ff",
  toolShape: "#c8d2dc",
  stock: "#8f989f",
  fixture: "#4d6478",
  machine: "#b4c8dc",
  inside: "#b8923a",
  deviation: ["#ff4d5e", "#f08a7a", "#7d8a80", "#6fb0ea", "#3a86ff"],
};

type Rgb = [number, number, number];

const parsedColors = new Map<string, Rgb>();

/** The components, 0 to 255, of a colour such as `#1d2227`. */
export function rgb(color: string): Rgb {
  let parsed = parsedColors.get(color);
  if (!parsed) {
    const value = Number.parseInt(color.slice(1), 16);
    parsed = [(value >> 16) & 255, (value >> 8) & 255, value & 255];
    parsedColors.set(color, parsed);
  }
  return parsed;
}

/** When there are more tools than colours, every second round of colours is mixed with this fraction of the text colour. */
const SECOND_ROUND_TEXT_FRACTION = 0.5;

/** The colour of a tool, by its index in the order of the tools' first cuts. */
export function toolColor({ tools, text }: Palette, index: number): string {
  const color = tools[Math.max(0, index) % tools.length]!;
  const isFirstRound = Math.floor(Math.max(0, index) / tools.length) % 2 === 0;
  return isFirstRound ? color : hex(mixed(rgb(color), rgb(text), SECOND_ROUND_TEXT_FRACTION));
}

function mixed(a: Rgb, b: Rgb, fraction: number): Rgb {
  return [0, 1, 2].map((part) => Math.round(a[part]! + (b[part]! - a[part]!) * fraction)) as Rgb;
}

function hex(color: Rgb): string {
  return `#${color.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
}

/** The colour of a value in a range; values beyond it have the colour of its end. */
export function rampColor({ ramp }: Palette, value: number, range: ValueRange): Rgb {
  const scaled = fractionOf(value, range) * (ramp.length - 1);
  const index = Math.min(ramp.length - 2, Math.floor(scaled));
  return mixed(rgb(ramp[index]!), rgb(ramp[index + 1]!), scaled - index);
}

export type ValueRange = [number, number];

/** Where a value is in a range, 0 to 1; the middle where the range is empty. */
function fractionOf(value: number, [low, high]: ValueRange): number {
  return high > low ? Math.min(1, Math.max(0, (value - low) / (high - low))) : 0.5;
}

/** Steps of the ramp: as many as eight bits can distinguish. */
const RAMP_STEPS = 255;

/** What the colours of a path depend on. */
export interface ColorScale {
  by: ColorBy;
  /** Tools in the order of their first cuts. */
  tools: number[];
  /** Slowest and fastest cut, mm/min. */
  feeds: ValueRange;
  /** Lowest and highest Z of a cut, relative to the origin, mm. */
  depths: ValueRange;
  /** From 0, a laser that is off, to the highest S of a cut. */
  powers: ValueRange;
}

/** The colours of both ends of each segment, by the tool, the feed or the power of its row, or by the Z of the end: six bytes each. */
export function colorsOf(palette: Palette, { by, tools, feeds, depths, powers }: ColorScale, { tool, feed, power }: Batch, lines: LineArrays): Uint8Array {
  const steps: Rgb[] = [];
  for (let step = 0; step <= RAMP_STEPS && by !== "tool"; step++) steps.push(rampColor(palette, step, [0, RAMP_STEPS]));
  const onRamp = (value: number, range: ValueRange) => steps[Math.round(fractionOf(value, range) * RAMP_STEPS)]!;
  const ofRow = (row: number) => (by === "power" ? onRamp(power?.[row] ?? 0, powers) : onRamp(feed[row]!, feeds));
  const ofTool = new Map(tools.map((number, index) => [number, rgb(toolColor(palette, index))]));
  const first = rgb(toolColor(palette, 0));
  const colors = new Uint8Array(6 * lines.count);
  const { points } = lines;
  let last = -1;
  let color: Rgb = [0, 0, 0];
  for (let line = 0; line < lines.count; line++) {
    const row = lines.rows ? lines.rows[line]! : line;
    if (row !== last && by !== "depth") color = by === "tool" ? (ofTool.get(tool[row]!) ?? first) : ofRow(row);
    last = row;
    for (let end = 0; end < 2; end++) {
      if (by === "depth") color = onRamp(points[6 * line + 3 * end + 2]!, depths);
      for (let part = 0; part < 3; part++) colors[6 * line + 3 * end + part] = color[part]!;
    }
  }
  return colors;
}
