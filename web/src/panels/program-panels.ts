// The panels of outline, modal state and times.

import type { PlaybackState } from "../path/playback-state";
import type { MachineInfo, ModalState, OutlineEntry, RunReport, RunTimes } from "../protocol/messages";
import { codeSpans } from "./code-spans";
import { element } from "./dom";
import { type Units, angles, count, countText, duration, length, positionText, speed } from "./units";

/** From where on the path or its time is not verified; empty where all of it is. */
export function notVerified(report: Pick<RunReport, "not_verified_from">): string {
  const from = report.not_verified_from;
  if (!from) return "";
  const line = from.own ? `line ${from.line}` : `line ${from.line} of ${from.file}`;
  return `Not verified from ${line} on: the ${from.path_known ? "time" : "path"} after it is not known.`;
}

/** Which axes the program does not name, so that they are drawn at zero; empty where there are none. */
export function notNamedText(report: Pick<RunReport, "never_named" | "named_in_no_cut">): string {
  const sentence = (axes: string[], why: string) => {
    const zeros = axes.map((axis) => `${axis}0`).join(" ");
    return axes.length === 0 ? "" : `${axes.join(" and ")} ${axes.length === 1 ? "is" : "are"} ${why}; drawn at ${zeros}.`;
  };
  return [sentence(report.never_named, "never named"), sentence(report.named_in_no_cut, "not known in any cut")].filter(Boolean).join(" ");
}

/** Which moves are not drawn because of their work offset; empty where there are none. */
export function leftOutText(report: Pick<RunReport, "moves_left_out">): string {
  return report.moves_left_out.map((text) => `${text[0]!.toUpperCase()}${text.slice(1)}.`).join(" ");
}

/** Entries of the outline that are shown at most. */
const MAX_ENTRIES = 2_000;
const MAX_LONGEST_BLOCKS = 5;

/** Shows programs with their tools and operations; a click goes to the line. */
export function showOutline(root: HTMLElement, entries: OutlineEntry[] | undefined, goToLine: (line: number) => void): void {
  root.replaceChildren();
  if (!entries || entries.length === 0) {
    root.append(element("p", "clean", entries ? "Nothing to list: the program has no tools and no operations." : "Reading…"));
    return;
  }
  let left = MAX_ENTRIES;
  const listOf = (children: OutlineEntry[]): HTMLUListElement => {
    const list = element("ul", "outline");
    for (const entry of children) {
      if (left-- <= 0) break;
      const item = element("li");
      const button = element("button", `entry ${entry.kind}`);
      button.type = "button";
      button.append(element("span", "", entry.name), element("span", "where", `line ${count(entry.line)}`));
      if (entry.detail) button.append(element("span", "help", entry.detail));
      button.addEventListener("click", () => goToLine(entry.line));
      item.append(button);
      if (entry.children.length > 0) item.append(listOf(entry.children));
      list.append(item);
    }
    return list;
  };
  root.append(listOf(entries));
}

function addRow(table: HTMLTableElement, name: string, value: string): void {
  const line = table.insertRow();
  const head = document.createElement("th");
  head.scope = "row";
  head.textContent = name;
  line.append(head);
  line.insertCell().textContent = value;
}

/** By kind of a row of the path (batch.ts). */
const MOTIONS = ["rapid", "straight", "arc", "spiral", "spline"];

/** Shows the modal state and the position after a block; without a state the run does not reach the line. */
export function showState(
  root: HTMLElement,
  modal: ModalState | undefined,
  position: Pick<PlaybackState, "coordinates" | "rotaryAngles"> | undefined,
  block: { line: number; kind: number | undefined; inSubprogram?: number | undefined } | undefined,
  machine?: Pick<MachineInfo, "factors" | "has">,
): void {
  root.replaceChildren();
  if (!modal) {
    root.append(element("p", "clean", "The run does not reach this line."));
    return;
  }
  const units: Units = { inch: modal.inch, ...(machine && { factors: machine.factors, has: machine.has }) };
  const table = element("table");
  if (block) addRow(table, "After line", block.inSubprogram === undefined ? count(block.line) : `${count(block.inSubprogram)} of a subprogram in another file`);
  if (modal.codes) addRow(table, "Codes", modal.codes.join(" "));
  if (position) {
    const shifted = position.coordinates.map((value, axis) => (value === undefined ? undefined : value - modal.shift[axis]!));
    addRow(table, "Position", `${positionText(units, shifted)}${angles(position.rotaryAngles)}`);
  }
  if (block?.kind !== undefined) addRow(table, "Motion", MOTIONS[block.kind] ?? "");
  addRow(table, "Units, plane", `${modal.inch ? "inch" : "millimetre"}, ${modal.plane}`);
  addRow(table, "Feed", feedText(modal, units));
  const spindle = modal.spindle === "off" ? "off" : `${modal.spindle}, ${count(modal.rpm)} rpm`;
  addRow(table, "Spindle", spindle);
  addRow(table, "Tool", modal.selected === null ? `T${modal.tool}` : `T${modal.tool}, next T${modal.selected}`);
  addRow(table, "Work offset", modal.work ?? "–");
  addRow(table, "Length offset", offsetText(modal.length, units));
  addRow(table, "Compensation", modal.side === "off" ? "off" : `${modal.side}, ${offsetText(modal.cutter, units)}`);
  addRow(table, "Path mode", modal.path_mode ?? "as at power-on");
  addRow(table, "Coolant", modal.coolant.join(", ") || "off");
  if (!modal.overrides.feed || !modal.overrides.rapid) addRow(table, "Overrides", "held at 100 %");
  root.append(table);
}

function feedText(modal: ModalState, units: Units): string {
  if (modal.feed === null) return "none yet";
  if (modal.feed_mode === "inverse_time") return `1/T ${modal.feed.toFixed(3)} per min`;
  if (modal.feed_mode === "per_revolution") return `${length(units, modal.feed)} per revolution`;
  return speed(units, modal.feed);
}

function offsetText(offset: { number: number | null; mm: number | null } | null, units: Units): string {
  if (!offset) return "off";
  const name = offset.number === null ? "" : `number ${offset.number}`;
  const value = offset.mm === null ? "not in the tool table" : length(units, offset.mm);
  return name ? `${name} (${value})` : value;
}

export function showTimes(
  root: HTMLElement,
  times: RunTimes | undefined,
  message: string | undefined,
  report: RunReport | undefined,
  machine: MachineInfo | undefined,
  color: (tool: number) => string,
  goToLine: (line: number) => void,
): void {
  root.replaceChildren();
  if (message) root.append(codeSpans(message, "refused", "p"));
  if (!times) {
    if (!message) root.append(element("p", "clean", "Planning…"));
    return;
  }
  const units = { inch: report?.inch ?? false };
  const table = element("table", "times");
  const head = table.createTHead().insertRow();
  for (const name of ["Tool", "Cutting", "Rapid", "Other", "Total"]) {
    const cell = document.createElement("th");
    cell.scope = "col";
    cell.textContent = name;
    head.append(cell);
  }
  const body = table.createTBody();
  for (const tool of times.tools) {
    const line = body.insertRow();
    const name = line.insertCell();
    const swatch = element("span", "swatch");
    swatch.style.background = color(tool.number);
    const known = machine?.tools.find(({ number }) => number === tool.number);
    const details = [known?.kind, known?.diameter_mm ? `Ø${length(units, known.diameter_mm)}` : null];
    name.append(swatch, `T${tool.number} ${details.filter(Boolean).join(" ")}`);
    const { cutting_s, rapid_s, other_s, total_s } = tool.times;
    for (const value of [cutting_s, rapid_s, other_s, total_s]) line.insertCell().textContent = duration(value);
  }
  const all = table.createTFoot().insertRow();
  all.insertCell().textContent = "All";
  const { cutting_s, rapid_s, other_s, total_s } = times.all;
  for (const value of [cutting_s, rapid_s, other_s, total_s]) all.insertCell().textContent = duration(value);
  root.append(table);
  if (report) {
    root.append(element("p", "", `Length of cuts ${length(units, report.cut_length_mm)}, of rapids ${length(units, report.rapid_length_mm)}.`));
  }
  if (times.cuts_without_feed > 0) {
    root.append(element("p", "more", `${countText(times.cuts_without_feed, "cut")} without a feed: not in the time.`));
  }
  if (times.short_blocks) root.append(codeSpans(`Corners: ${times.short_blocks}.`, "more", "p"));
  if (times.assumed > 0) {
    root.append(element("p", "more", "Typical limits were used where the machine file gives none."));
  }
  if (times.longest.length > 0) {
    root.append(element("h3", "", "Longest blocks"));
    const list = element("ol", "longest");
    for (const block of times.longest.slice(0, MAX_LONGEST_BLOCKS)) {
      const item = element("li");
      const runs = block.runs > 1 ? ` in ${countText(block.runs, "run")}` : "";
      const button = element("button", "link", `line ${count(block.line)}: ${duration(block.time_s)}${runs}, ${block.reason}`);
      button.type = "button";
      button.addEventListener("click", () => goToLine(block.line));
      item.append(button);
      list.append(item);
    }
    root.append(list);
  }
}
