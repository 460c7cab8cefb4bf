// Colours of the path, for a light and a dark page.

import type { Lines } from "./lines";
import type { Batch } from "./path";

export type ColorBy = "tool" | "speed";

export interface Palette {
  background: string;
  rapid: string;
  contour: string;
  /** The path of the other program. */
  other: string;
  /** Where the two are apart. */
  apart: string;
  chord: string;
  travel: string;
  mark: string;
  measure: string;
  toolShape: string;
  tools: string[];
  /** From slow to fast. */
  speeds: string[];
}

export const LIGHT: Palette = {
  background: "#f6f8fa",
  rapid: "#8a5a00",
  contour: "#3a7d34",
  other: "#111a22",
  apart: "#a34fe0",
  chord: "#c2185b",
  travel: "#7b8794",
  mark: "#d9480f",
  measure: "#6a1bb0",
  toolShape: "#5b6672",
  tools: ["#0b61a4", "#1b7a3d", "#8e3ba8", "#b3470f", "#00757a", "#a3195b", "#5f6b00", "#4b4fc4"],
  speeds: ["#3b4cc0", "#1b7a9c", "#1b7a3d", "#a86400", "#b40426"],
};

export const DARK: Palette = {
  background: "#10171d",
  rapid: "#e8b04b",
  contour: "#86d67f",
  other: "#ffffff",
  apart: "#b57bf0",
  chord: "#ff7ab0",
  travel: "#6d7a86",
  mark: "#ffd166",
  measure: "#e3b3ff",
  toolShape: "#c8d2dc",
  tools: ["#4fb3ff", "#5fd38a", "#d49bf0", "#ff9e64", "#4fd6d8", "#ff8fb8", "#d4d663", "#a3a8ff"],
  speeds: ["#7b9cff", "#4fc3e8", "#5fd38a", "#f0c05a", "#ff6b6b"],
};

type Rgb = [number, number, number];

const known = new Map<string, Rgb>();

export function rgb(color: string): Rgb {
  let found = known.get(color);
  if (!found) {
    const value = Number.parseInt(color.slice(1), 16);
    found = [(value >> 16) & 255, (value >> 8) & 255, value & 255];
    known.set(color, found);
  }
  return found;
}

/** The colour of a tool, by its number. */
export function toolColor(palette: Palette, tool: number): string {
  const { tools } = palette;
  return tools[(Math.max(1, tool) - 1) % tools.length]!;
}

/** The colour of a feed between the slowest and the fastest of the program. */
export function speedColor(palette: Palette, feed: number, [slow, fast]: [number, number]): Rgb {
  const { speeds } = palette;
  const share = fast > slow ? Math.min(1, Math.max(0, (feed - slow) / (fast - slow))) : 0.5;
  const at = share * (speeds.length - 1);
  const index = Math.min(speeds.length - 2, Math.floor(at));
  const [a, b] = [rgb(speeds[index]!), rgb(speeds[index + 1]!)];
  return [0, 1, 2].map((c) => Math.round(a[c]! + (b[c]! - a[c]!) * (at - index))) as Rgb;
}

/** Steps of the colours from slow to fast: as many as can be told apart. */
const SPEED_STEPS = 255;

/** The colours of both ends of each line, by the tool or the feed of its row. */
export function colorsOf(palette: Palette, by: ColorBy, { tool, feed }: Batch, lines: Lines, range: [number, number]): Uint8Array {
  const [slow, fast] = range;
  const steps: Rgb[] = [];
  for (let step = 0; step <= SPEED_STEPS && by === "speed"; step++) steps.push(speedColor(palette, step, [0, SPEED_STEPS]));
  const ofFeed = (value: number) => {
    const share = fast > slow ? Math.min(1, Math.max(0, (value - slow) / (fast - slow))) : 0.5;
    return steps[Math.round(share * SPEED_STEPS)]!;
  };
  const colors = new Uint8Array(6 * lines.count);
  let last = -1;
  let color: Rgb = [0, 0, 0];
  for (let at = 0; at < lines.count; at++) {
    const row = lines.rows ? lines.rows[at]! : at;
    if (row !== last) color = by === "tool" ? rgb(toolColor(palette, tool[row]!)) : ofFeed(feed[row]!);
    last = row;
    for (let part = 0; part < 3; part++) colors[6 * at + part] = colors[6 * at + 3 + part] = color[part]!;
  }
  return colors;
}
