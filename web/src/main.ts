// The page: puts the parts together.

import "./style.css";
import { type ColorBy, DARK, LIGHT, toolColor } from "./colors";
import { againstProgram } from "./against";
import { Editor } from "./editor";
import { Elsewhere } from "./elsewhere";
import { type Frame, f32, u32, u8 } from "./frame";
import { layout } from "./layout";
import { drawAxes } from "./axes";
import { Link, type MachineInfo, type Report, type Times, type Told } from "./link";
import { notVerified, showOutline, showState, showTimes } from "./panels";
import { type Bounds, Path, type Vec3, batchOf, kindOf } from "./path";
import { Problems } from "./problems";
import { Kinematics, unknownTurns } from "./turn";
import { type Setpoints, momentAt, stepRow, timeOfRow } from "./playback";
import type { ViewName } from "./eye";
import { PathView } from "./scene";
import { Timeline } from "./timeline";
import { askWords, words } from "./words";
import { count, counted, length } from "./units";

const ui = layout(document.querySelector<HTMLElement>("#app")!);

let path = new Path();
let kinematics = new Kinematics([], [0, 0, 0]);
let run = 0;
let machine: MachineInfo | undefined;
let report: Report | undefined;
let refused: { message: string; help?: string | null } | undefined;
let times: Times | undefined;
let timesMessage: string | undefined;
let setpoints: Setpoints | undefined;
let programName = "";
let row = 0;

const isDark = () =>
  document.documentElement.dataset.theme
    ? document.documentElement.dataset.theme === "dark"
    : matchMedia("(prefers-color-scheme: dark)").matches;
const palette = () => (isDark() ? DARK : LIGHT);

const view = new PathView(ui.canvas, palette());
const timeline = new Timeline(ui.timeline);
const editor = new Editor(ui.code, {
  typed: (changes) => link.tell("edit", { changes }),
  cursor: (line, byUser) => byUser && cursorAt(line),
  save: () => void save(false),
  definition: (line, column) => void goToDefinition(line, column),
}, words({
  tokens: async (from, to) => {
    const told = await link.ask("tokens", { from, to });
    return told.type === "tokens" ? told : undefined;
  },
  meaning: async (line, column) => {
    editor.flush();
    const told = await link.ask("hover", { line, column });
    return told.type === "hover" ? (told.hover ?? undefined) : undefined;
  },
}));
const elsewhere = new Elsewhere(ui.code, () => editor.view.focus());
const link = new Link(take, takeFrame, () => {
  ui.tell("error", "Chordal has ended, or the connection was lost. Start chordal view again; the text typed since the last save is still here to copy.");
});

const problems = new Problems(ui.panels.problems, ({ place }) => {
  if (!place?.own) return;
  editor.goTo(place.line, place.column, true);
  cursorAt(place.line);
});

const against = againstProgram({
  panel: ui.panels.compare,
  legend: ui.paths,
  view,
  editor,
  elsewhere,
  link,
  path: () => path,
  run: () => run,
  machine: () => machine,
  units: () => ({ inch: report?.inch ?? false }),
  name: () => programName,
  goTo: (line) => {
    editor.goTo(line);
    cursorAt(line);
  },
  tell: ui.comparison,
  open: () => ui.show("compare"),
});

function take(told: Told): void {
  if (against.take(told)) return;
  switch (told.type) {
    case "hello":
      document.title = `${told.name.split(/[\\/]/).pop()} – Chordal`;
      ui.setName(told.name);
      ui.save.hidden = !told.writable;
      ui.setMachines(told.machines);
      programName = told.name;
      against.offer(told);
      break;
    case "run":
      begin(told);
      break;
    case "refused":
      if (told.run >= run) refuse(told);
      break;
    case "report":
      if (told.run === run) finish(told);
      break;
    case "times":
      if (told.run !== run) break;
      times = told;
      tellTimes();
      break;
    case "no_times":
      if (told.run !== run) break;
      timesMessage = told.message;
      timeline.setMessage("no times");
      tellTimes();
      break;
    case "changed":
      if (editor.dirty) {
        ui.ask("The file changed on disk.", [
          ["Load it, drop my changes", () => link.tell("reload")],
          ["Keep mine", () => {}],
        ]);
      } else link.tell("reload");
      break;
    case "gone":
      ui.tell("warning", "The file was deleted on disk; saving writes it again.");
      break;
    case "error":
      ui.tell("error", told.help ? `${told.message}. ${told.help}.` : told.message);
      break;
    default:
      break;
  }
}

function goTo(line: number): void {
  editor.goTo(line, 0, true);
  cursorAt(line);
}

async function goToDefinition(line: number, column: number): Promise<void> {
  const told = await link.ask("definition", { line, column });
  if (told.type !== "definition") return;
  if (!told.place) return ui.tell("note", "No definition of this word in this file or in its folder.");
  if (told.place.file !== undefined) return elsewhere.show(told.place);
  editor.goTo(told.place.line, told.place.column, true);
  cursorAt(told.place.line);
}

function begin(told: Extract<Told, { type: "run" }>): void {
  run = told.run;
  machine = told.machine;
  askWords(editor.view);
  ui.machineWhy(told.machine.title, told.why);
  path = new Path();
  started = false;
  report = undefined;
  refused = undefined;
  times = undefined;
  timesMessage = undefined;
  setpoints = undefined;
  ui.progress(0);
  timeline.setMessage("running…");
  against.began();
}

/** The first batch of a run takes the place of the path before: until then that stays. */
let started = false;
function startPath(): void {
  if (started) return;
  started = true;
  view.begin(path);
  timeline.clear();
}

function takeFrame(frame: Frame): void {
  const { header } = frame;
  switch (header.type) {
    case "text":
      editor.addText(new TextDecoder().decode(u8(frame, "text")), header.first === true, header.last === true);
      if (!header.first) break;
      if (header.binary) ui.tell("error", "The file holds binary data, not an NC program.");
      else if (header.mixed_endings) ui.tell("note", "The file has different line endings; saving makes them all the same.");
      break;
    case "path": {
      if (header.run !== run) break;
      startPath();
      const origin = header.origin as Vec3;
      kinematics = new Kinematics(machine?.rotary ?? [], origin);
      const batch = kinematics.batch(batchOf(frame));
      path.add(batch, origin);
      view.add(batch);
      ui.progress(Number(header.progress));
      break;
    }
    case "contour":
      if (header.run === run) {
        const origin = header.origin as Vec3;
        const own = new Kinematics(machine?.rotary ?? [], origin);
        view.addContour(own.batch(batchOf(frame)), origin);
      }
      break;
    case "against_path":
      against.takePath(frame);
      break;
    case "chords":
      view.setChords(f32(frame, "points"), header.origin as Vec3);
      ui.chordsTold(
        `${counted(Number(header.chords), "chord")} on ${counted(Number(header.curves), "curve")}` +
          (Number(header.left_out) > 0 ? `, ${count(Number(header.left_out))} not drawn` : ""),
      );
      break;
    case "setpoints": {
      if (header.run !== run) break;
      const turns = "turns" in frame.columns ? f32(frame, "turns") : undefined;
      const places = f32(frame, "places");
      setpoints = {
        places: turns ? kinematics.places(places, turns) : places,
        programmed: turns && places,
        turns,
        speed: f32(frame, "speed"),
        row: u32(frame, "row"),
        periodS: Number(header.period_s),
        totalS: Number(header.total_s),
      };
      timeline.set(setpoints, { inch: report?.inch ?? false });
      break;
    }
    default:
      break;
  }
}

function refuse(told: { run: number; message: string; help?: string | null }): void {
  run = told.run;
  refused = told;
  ui.progress(1);
  startPath();
  ui.unverified("");
  tellProblems();
  ui.show("problems");
}

function finish(told: Report): void {
  startPath();
  report = told;
  ui.progress(1);
  void view.finish();
  const { zeros, machine: at } = told.places;
  view.setFixed(zeros.map((zero) => zero.at), travelBox(at));
  view.showTravel(ui.travel.checked);
  tellColors();
  const depths = path.bounds ? [path.bounds.low[2], path.bounds.high[2]] : [0, 0];
  ui.section.offer(path.tools, depths.map((z) => z! + path.origin[2]) as [number, number], { inch: told.inch });
  ui.empty(path.bounds ? "" : emptyText(told));
  ui.turns(unknownTurns(told.axes, machine?.rotary ?? []));
  ui.unverified(notVerified(told));
  editor.setProblems(told.diagnostics);
  tellProblems();
  tellTimes();
  void tellOutline();
  if (setpoints) timeline.set(setpoints, { inch: told.inch });
  cursorAt(editor.line);
  if (ui.chordsOn.checked) askChords();
}

/** Which colour is which tool, and that of the first for the whole path. */
function tellColors(): void {
  if (report) ui.legend(report, path, (tool) => toolColor(palette(), tool));
  against.color(toolColor(palette(), path.tools[0] ?? 0));
}

function emptyText(told: Report): string {
  if (told.errors > 0) return "There is no path to show. The problems say why.";
  if (path.rows > 0) return "The program moves, but the position relative to the part is not known.";
  return "The program does not move any axis.";
}

/** The box that the machine reaches, in the frame of the run, where the offsets are known. */
function travelBox(at: (number | null)[] | null): Bounds | undefined {
  if (!at || !machine) return undefined;
  const ends = [0, 1, 2].map((axis) => {
    const travel = machine!.travel[axis];
    const offset = at[axis];
    return travel && offset !== null && offset !== undefined ? [travel[0] - offset, travel[1] - offset] : undefined;
  });
  if (ends.some((end) => !end)) return undefined;
  return { low: ends.map((end) => end![0]) as Vec3, high: ends.map((end) => end![1]) as Vec3 };
}

function tellProblems(): void {
  ui.counts(report, refused !== undefined);
  problems.show(report, refused);
}

/** The outline, where it is looked at. */
async function tellOutline(): Promise<void> {
  if (ui.shown() !== "outline") return;
  const told = await link.ask("outline");
  if (told.type === "outline") showOutline(ui.panels.outline, told.entries, goTo);
}

function tellTimes(): void {
  showTimes(ui.panels.times, times, timesMessage, report, machine, (tool) => toolColor(palette(), tool), goTo);
}

/** The cursor is on a line: its path is marked, and what is in force after it is told. */
function cursorAt(line: number): void {
  const rows = path.rowsOfLine(line);
  view.markRows(rows);
  const done = rows ? rows[1] + 1 : path.doneAfterLine(line);
  if (!timeline.isPlaying) showTool(done > 0 ? done - 1 : 0, 1);
  void tellState(done, line);
}

/** One question at a time: of those that come meanwhile only the last is asked. */
let stateAsked = false;
let stateNext: [number, number] | undefined;
async function tellState(done: number, line: number): Promise<void> {
  if (!report || ui.shown() !== "state") return;
  if (stateAsked) {
    stateNext = [done, line];
    return;
  }
  stateAsked = true;
  const told = await link.ask("state", { done, line });
  stateAsked = false;
  if (stateNext) {
    const next = stateNext;
    stateNext = undefined;
    return tellState(...next);
  }
  if (told.type !== "state") return;
  const found = done > 0 ? path.find(done - 1) : undefined;
  const end = done > 0 ? path.programmedEnd(done - 1) : undefined;
  const place = end && (end.map((value, axis) => value + path.origin[axis]!) as Vec3);
  const at = place && { place, turn: path.turnOn(done - 1, 1) };
  const kind = found && path.rowsOfLine(line) ? kindOf(found[0].kind[found[1]]!) : undefined;
  showState(ui.panels.state, told.state ?? undefined, at, { line, kind });
}

/** The tool stands at a share of a row. */
function showTool(at: number, share: number, place?: Vec3, turn?: Vec3): void {
  row = at;
  const found = path.find(at);
  const number = found ? found[0].tool[found[1]]! : 0;
  shapeTool(number);
  const up = kinematics.direction([0, 0, 1], turn ?? path.turnOn(at, share));
  view.placeTool(ui.toolOn.checked && path.bounds ? (place ?? path.pointOn(at, share)) : undefined, up);
}

let shaped = "";
function shapeTool(number: number): void {
  const key = `${run} ${number} ${path.rows}`;
  if (key === shaped) return;
  shaped = key;
  const tool = machine?.tools.find((own) => own.number === number);
  view.shapeTool(tool?.diameter_mm ?? null, tool?.length_mm ?? null, tool?.corner_radius_mm ?? null);
}

let shownLine = 0;
/** The row that was asked for, where a setpoint of it may be none. */
let askedRow: number | undefined;
timeline.onTime = (seconds, playing) => {
  const moment = setpoints && momentAt(setpoints, seconds);
  if (!moment) return;
  const at = moment.at.map((value, axis) => value - path.origin[axis]!) as Vec3;
  const shownRow = askedRow ?? moment.row;
  showTool(shownRow, 0, at, moment.turn);
  const units = { inch: report?.inch ?? false };
  ui.readout(moment.programmed, moment.turn, moment.speed, units);
  const line = path.lineOf(shownRow);
  if (!line?.own || line.line === shownLine) return;
  shownLine = line.line;
  view.markRows([shownRow, shownRow]);
  editor.markLines("now", [line.line]);
  editor.goTo(line.line);
  if (!playing) void tellState(shownRow + 1, line.line);
};
timeline.onStep = (direction) => {
  if (!setpoints) return;
  timeline.pause();
  seekRow(stepRow(path, row, direction));
};
timeline.onToCursor = () => {
  const rows = path.rowsOfLine(editor.line);
  if (!setpoints || !rows) return;
  timeline.pause();
  seekRow(rows[0]);
};

/** To when a row begins. */
function seekRow(to: number): void {
  if (!setpoints) return;
  askedRow = to;
  timeline.seek(timeOfRow(setpoints, to));
  askedRow = undefined;
}

async function save(force: boolean): Promise<void> {
  editor.flush();
  const told = await link.ask("save", { force });
  if (told.type === "saved") {
    editor.setDirty(false);
    ui.tell("note", "Saved.");
  } else if (told.type === "conflict") {
    ui.ask("The file changed on disk since it was read.", [
      ["Overwrite it with mine", () => void save(true)],
      ["Load it, drop my changes", () => link.tell("reload")],
      ["Cancel", () => {}],
    ]);
  } else take(told);
}

function askChords(): void {
  if (!ui.chordsOn.checked) {
    view.setChords(undefined, [0, 0, 0]);
    ui.chordsTold("");
    return;
  }
  const mm = ui.chordTolerance();
  ui.chordsTold(length({ inch: report?.inch ?? false }, mm));
  link.tell("chords", { tolerance_mm: mm, balanced: ui.balanced.checked });
}

editor.onDirty = (dirty) => ui.setDirty(dirty);
ui.save.addEventListener("click", () => void save(false));
ui.machine.addEventListener("change", () => {
  editor.flush();
  link.tell("machine", { name: ui.machine.value || null });
});
ui.onView = (name: ViewName) => view.setView(name);
ui.onFit = () => view.fit();
ui.onColor = (by: ColorBy) => {
  view.setColorBy(by);
  ui.colorBy(by, path, report, palette().speeds);
};
ui.onTheme = () => {
  view.setPalette(palette());
  tellColors();
  ui.colorBy(undefined, path, report, palette().speeds);
  timeline.draw();
  tellTimes();
};
ui.onPanel = () => {
  cursorAt(editor.line);
  void tellOutline();
};
ui.onChords = askChords;
ui.rapids.addEventListener("change", () => view.showRapids(ui.rapids.checked));
ui.travel.addEventListener("change", () => view.showTravel(ui.travel.checked));
ui.toolOn.addEventListener("change", () => showTool(row, 1));

let measuring = false;
let measuredFrom: Vec3 | undefined;
function setMeasuring(on: boolean): void {
  measuring = on;
  measuredFrom = undefined;
  ui.measure.setAttribute("aria-pressed", String(on));
  view.showMeasured(undefined, undefined);
  ui.measured(on ? "Click two points of the path" : "");
}

/** The first of two places, or the second: then the distance is told. */
function measure(at: Vec3): void {
  if (!measuredFrom) {
    measuredFrom = at;
    view.showMeasured(at, undefined);
    ui.measured("Click the second point");
    return;
  }
  const units = { inch: report?.inch ?? false };
  const by = at.map((value, axis) => value - measuredFrom![axis]!);
  const parts = ["X", "Y", "Z"].map((name, axis) => `${name} ${length(units, by[axis]!, false)}`);
  view.showMeasured(measuredFrom, at);
  ui.measured(`${length(units, Math.hypot(...by))}   (${parts.join("  ")})`);
  measuredFrom = undefined;
}
ui.measure.addEventListener("click", () => setMeasuring(!measuring));
ui.onSection = (section) => view.setSection(section);
ui.cursorLine = () => editor.line;

let pressed: [number, number] | undefined;
ui.canvas.addEventListener("pointerdown", (event) => (pressed = [event.offsetX, event.offsetY]));
ui.canvas.addEventListener("pointerup", (event) => {
  if (!pressed || Math.hypot(event.offsetX - pressed[0], event.offsetY - pressed[1]) > 3) return;
  const picked = view.pick(event.offsetX, event.offsetY);
  const line = picked && path.lineOf(picked.row);
  if (!picked || !line) {
    if (!measuring) against.readAt(event.offsetX, event.offsetY);
    return;
  }
  if (measuring) {
    measure(picked.at);
    return;
  }
  if (line.own) editor.goTo(line.line);
  else ui.tell("note", `That is line ${line.line} of a subprogram in another file.`);
  view.markRows([picked.row, picked.row]);
  showTool(picked.row, picked.share);
  void tellState(picked.row + 1, line.line);
  if (setpoints) timeline.seek(timeOfRow(setpoints, picked.row + picked.share));
});

view.onDrawn = () => drawAxes(ui.axes, view.axes());

document.addEventListener("keydown", (event) => {
  const target = event.target as HTMLElement;
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "F9") {
    event.preventDefault();
    return against.walk(event.shiftKey ? -1 : 1);
  }
  if (target.closest(".cm-editor, input:not([type=range]):not([type=checkbox]), select, textarea")) return;
  if (event.key === " " && target.closest("button, summary, input")) return;
  const act: Record<string, () => void> = {
    " ": () => timeline.toggle(),
    ",": () => timeline.onStep(-1),
    ".": () => timeline.onStep(1),
    r: () => timeline.onToCursor(),
    "[": () => timeline.faster(-1),
    "]": () => timeline.faster(1),
    "1": () => view.setView("top"),
    "2": () => view.setView("front"),
    "3": () => view.setView("right"),
    "4": () => view.setView("iso"),
    f: () => view.fit(),
    m: () => setMeasuring(!measuring),
    n: () => against.walk(1),
    p: () => against.walk(-1),
    escape: () => setMeasuring(false),
  };
  const chosen = act[event.key.toLowerCase()];
  if (!chosen) return;
  event.preventDefault();
  chosen();
});

window.addEventListener("beforeunload", (event) => {
  if (editor.dirty) event.preventDefault();
});

// For the browser's tests and for measurements.
Object.assign(window, { chordal: { view, editor, timeline, against: against.shown, path: () => path, report: () => report, setpoints: () => setpoints } });
