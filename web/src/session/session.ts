// The page: puts the parts together.

import "../style.css";
import { type ColorBy, DARK, LIGHT, toolColor } from "../view/colors";
import { againstProgram } from "../compare/compare-session";
import { chordsText, toleranceText } from "../panels/chord-texts";
import { Editor } from "../panels/text-editor";
import { Elsewhere } from "../panels/other-file-view";
import { type Frame, f32, u32, u8 } from "../protocol/frame";
import { Later } from "../panels/throttled-task";
import { onKeys } from "../panels/keyboard";
import { layout } from "../panels/layout";
import { measuring } from "../measure/tool";
import { drawAxes } from "../view/axis-cross";
import { Link } from "../protocol/connection";
import type { MachineInfo, Report, Times, Told } from "../protocol/messages";
import { leftOutText, notNamedText, notVerified, showOutline, showState, showTimes } from "../panels/program-panels";
import { type Vec3, axisBits, batchOf, kindOf } from "../path/batch";
import { Path } from "../path/path";
import { Problems } from "../panels/problems";
import { readingsPanel } from "../panels/readings";
import { Kinematics, unknownTurns } from "../path/kinematics";
import { type Setpoints, stepRow } from "../path/setpoints";
import type { ViewName } from "../view/camera";
import { PathView } from "../view/path-view";
import { shell } from "../page-host";
import { engagedOf } from "../path/engagement";
import { type Asked, type PlaybackState, doneOf, playbackStateOf } from "../path/playback-state";
import { stockOfProgram } from "../stock/mill-stock";
import { Timeline } from "../panels/timeline";
import { travelBox, whyNoTravel } from "../view/travel-box";
import { turnedOfProgram } from "../stock/lathe-stock";
import { askWords, words } from "../panels/syntax-hints";
import type { Units } from "../panels/units";

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
/** Where the program is, as it was asked for and as it is shown. */
let asked: Asked = { to: "start" };
let playback: PlaybackState = playbackStateOf(asked, path, undefined);

const isDark = () =>
  document.documentElement.dataset.theme
    ? document.documentElement.dataset.theme === "dark"
    : matchMedia("(prefers-color-scheme: dark)").matches;
const palette = () => (isDark() ? DARK : LIGHT);

const view = new PathView(ui.canvas, palette());
const timeline = new Timeline(ui.timeline);
const editor = new Editor(ui.code, {
  typed: (changes) => link.tell("edit", { changes }),
  cursor: (line, byUser) => {
    if (byUser) putCursor(line);
    else shell().follow?.(line);
  },
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
const link = new Link(shell().dial, take, takeFrame, () => ui.tell("error", shell().lost));

const problems = new Problems(ui.panels.problems, ({ place }) => {
  if (!place?.own) return;
  editor.goTo(place.line, place.column, true);
  putCursor(place.line);
});

const readings = readingsPanel(ui.readings, {
  read: (choice) => {
    editor.flush();
    ui.chooseMachine(choice);
    link.tell("machine", { name: choice.name, is_answer: true });
  },
  leave: () => ui.machine.focus(),
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
    putCursor(line);
  },
  another: shell().another,
  tell: ui.comparison,
  open: () => ui.show("compare"),
});

/** Units of what is said of a place. */
const units = (): Units => ({ inch: report?.inch ?? false, ...(machine && { factors: machine.factors, has: machine.has }) });

/** With the problems of the stock. */
const withStock = (told: Pick<Report, "diagnostics" | "left_out" | "errors" | "warnings" | "notes">) => {
  if (!report) return;
  const { diagnostics, left_out, errors, warnings, notes } = told;
  report = { ...report, diagnostics, left_out, errors, warnings, notes };
  editor.setProblems(diagnostics);
  tellProblems();
};

const turned = turnedOfProgram({ view, link, path: () => path, run: () => run, units, report: withStock });
const stock = stockOfProgram({
  view,
  link,
  path: () => path,
  run: () => run,
  machine: () => machine,
  units: () => ({ inch: report?.inch ?? false }),
  report: withStock,
  tell: ui.tell,
});
ui.stockSlot.append(stock.root, turned.root);

function take(told: Told): void {
  if (against.take(told) || stock.take(told) || turned.take(told)) return;
  switch (told.type) {
    case "hello":
      document.title = `${told.name.split(/[\\/]/).pop()} – Chordal`;
      ui.setName(told.name);
      ui.save.hidden = !told.writable;
      ui.setMachines(told.machines);
      programName = told.name;
      // Runs of another program are counted anew.
      run = 0;
      asked = { to: "start" };
      stateAsked = false;
      against.offer(told);
      readings.opened();
      break;
    case "machines":
      ui.offerMachines(told.machines);
      against.offerMore(told);
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
        ui.ask("The file has changed on disk.", [
          ["Load it and lose my changes", () => link.tell("reload")],
          ["Keep mine", () => {}],
        ]);
      } else link.tell("reload");
      break;
    case "gone":
      ui.tell("warning", "The file was deleted on disk. Save writes it again.");
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
  putCursor(line);
}

async function goToDefinition(line: number, column: number): Promise<void> {
  const told = await link.ask("definition", { line, column });
  if (told.type !== "definition") return;
  if (!told.place) return ui.tell("note", "This word has no definition in this file or its folder.");
  if (told.place.file !== undefined) return elsewhere.show(told.place);
  editor.goTo(told.place.line, told.place.column, true);
  putCursor(told.place.line);
}

function begin(told: Extract<Told, { type: "run" }>): void {
  run = told.run;
  machine = told.machine;
  view.setLathe(told.machine.turret ?? undefined);
  askWords(editor.view);
  ui.machineWhy(told.machine.title, told.why);
  readings.ran(programName, told.readings);
  path = new Path();
  started = false;
  report = undefined;
  refused = undefined;
  times = undefined;
  timesMessage = undefined;
  setpoints = undefined;
  // Rows and times are of the run before; the line stays.
  if (asked.to !== "start") asked = { to: "line", line: editor.line };
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
  view.showDone(Infinity);
  shown = shownLine = "";
  measure.set(false);
  timeline.clear();
  stock.began();
  turned.began();
}

function takeFrame(frame: Frame): void {
  const { header } = frame;
  if (stock.takeFrame(frame)) return;
  // A tool that stands already is drawn among the sections from now on.
  if (turned.takeFrame(frame)) return showTool();
  if (header.type === "engagement") {
    if (header.run === run) timeline.setEngaged(engagedOf(frame));
    return;
  }
  switch (header.type) {
    case "text":
      editor.addText(new TextDecoder().decode(u8(frame, "text")), header.first === true, header.last === true);
      if (!header.first) break;
      if (header.binary) ui.tell("error", "The file holds binary data, not an NC program.");
      else if (header.mixed_endings) ui.tell("note", "The file has different line ends. Save makes them all the same.");
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
    case "file":
      shell().keep?.(String(header.name), u8(frame, "bytes"));
      break;
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
      ui.chordsTold(chordsText(units(), header));
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
      go(asked);
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
  const notNamed = [...told.never_named, ...told.named_in_no_cut];
  path.notNamed = axisBits.reduce((bits, bit, axis) => bits | (notNamed.includes("XYZ"[axis]!) ? bit : 0), 0);
  ui.progress(1);
  void view.finish();
  const { zeros, machine: at } = told.places;
  view.setFixed(zeros.map((zero) => zero.at), travelBox(machine, at));
  tellTravel();
  ui.offerPower(path.minPower < path.maxPower);
  tellColors();
  const depths = path.bounds ? [path.bounds.low[2], path.bounds.high[2]] : [0, 0];
  ui.section.offer(path.tools, depths.map((z) => z! + path.origin[2]) as [number, number], { inch: told.inch });
  ui.empty(path.bounds ? "" : emptyText(told));
  ui.turns([notNamedText(told), leftOutText(told), unknownTurns(told.axes, machine?.rotary ?? [])].filter(Boolean).join(" "));
  ui.unverified(notVerified(told));
  editor.setProblems(told.diagnostics);
  tellProblems();
  tellTimes();
  void tellOutline();
  if (setpoints) timeline.set(setpoints, { inch: told.inch });
  go(asked);
  ui.offerOwnChords(told.own_chords_mm !== null);
  if (ui.chordsOn.checked) askChords();
}

/** Which colour is which tool, and that of the first for the whole path. */
function tellColors(): void {
  if (report) ui.legend(colorBy, path, report, machine, palette());
  against.color(toolColor(palette(), 0));
}

function emptyText(told: Report): string {
  if (told.errors > 0) return "There is no path to show. The problems say why.";
  if (path.rows > 0) return "The program moves, but the position relative to the part is not known.";
  return "The program does not move any axis.";
}

/** Shows the box of the machine where somebody wants it, or says why it cannot be shown. */
function tellTravel(): void {
  const { checked } = ui.travel;
  view.showTravel(checked);
  ui.travelWhy(checked && report && machine ? whyNoTravel(machine, report.places.machine) : "");
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
  showTimes(ui.panels.times, times, timesMessage, report, machine, (tool) => toolColor(palette(), path.cutterIndex(tool)), goTo);
}

/** Somebody has put the cursor on a line: the program stands where that line is done. */
function putCursor(line: number): void {
  timeline.pause();
  go({ to: "line", line });
}

/** One question at a time: of those that come meanwhile only the last is asked. */
let stateAsked = false;
let stateNext: [number, number, number?] | undefined;
/** What it is about, whether the panel is looked at or not. */
let stateOf: [number, number, number?] = [0, 1];
async function tellState(done: number, line: number, inSubprogram?: number): Promise<void> {
  stateOf = [done, line, inSubprogram];
  if (!report || ui.shown() !== "state") return;
  if (stateAsked) {
    stateNext = [done, line, inSubprogram];
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
  const end = found && playbackStateOf({ to: "row", row: done - 1, share: 1 }, path, undefined);
  const at = end && { place: end.coordinates, turn: end.turn };
  const moves = inSubprogram !== undefined || path.rowsOfLine(line) !== undefined;
  const kind = found && moves ? kindOf(found[0].kind[found[1]]!) : undefined;
  showState(ui.panels.state, told.state ?? undefined, at, { line, kind, inSubprogram }, machine);
}

/** Draws the tool where the program is; not where that is not known. */
function showTool(): void {
  const { row, at, turn } = playback;
  const found = path.find(row);
  const number = found ? found[0].tool[found[1]]! : 0;
  shapeTool(number);
  const up = kinematics.direction(standsAcross(number) ? [1, 0, 0] : [0, 0, 1], turn);
  const own = ui.toolOn.checked && path.bounds ? at : undefined;
  view.placeTool(turned.place(number, own) ? undefined : own, up);
}

/** Tools of a lathe that do not cut on the axis come from the side of the turret. */
function standsAcross(number: number): boolean {
  const shape = machine?.tools.find((tool) => tool.number === number)?.shape;
  return Boolean(machine?.turret) && (!shape || shape === "insert" || shape === "groove");
}

let shaped = "";
function shapeTool(number: number): void {
  const key = `${run} ${number} ${path.rows}`;
  if (key === shaped) return;
  shaped = key;
  view.shapeTool(machine?.tools.find((own) => own.number === number));
}

/** The stock as it is when so much of the path is done and the tool stands at a place. */
function goToMoment(done: number, at: Vec3 | undefined): void {
  stock.goTo(done, at);
  turned.goTo(done, at);
}

/** Goes to where the program is when something is done: line, clock, readout, tool and stock show the same. */
function go(next: Asked, isTextLate = false): void {
  asked = next;
  playback = playbackStateOf(next, path, setpoints);
  if (playback.seconds !== undefined) timeline.put(playback.seconds);
  // Before the first move is planned there is nothing to say.
  if (setpoints || path.rows > 0) ui.readout(playback, units());
  showTool();
  showDone(next);
  showWhere(next, isTextLate);
}

/** What of the path and of the stock is done. */
function showDone(next: Asked): void {
  const done = doneOf(playback);
  const { seconds, at } = playback;
  const total = setpoints?.totalS ?? 0;
  switch (next.to) {
    // At first the stock is shown as it is at the end.
    case "start":
      return view.showDone(Infinity);
    case "line":
      view.showDone(Infinity);
      return goToMoment(done, undefined);
    default: {
      // At both ends there is nothing to tell apart.
      const isWithin = seconds !== undefined && seconds > 0 && seconds < total && !(next.to === "row" && next.looks);
      view.showDone(isWithin ? done : Infinity);
      if (seconds === undefined || seconds < total) goToMoment(seconds === 0 ? 0 : done, at);
      else goToMoment(Infinity, undefined);
    }
  }
}

/** Marks the path and the line where the program is, and shows what is active there. */
function showWhere(next: Asked, isTextLate: boolean): void {
  if (next.to === "row" || next.to === "time") return showRow(playback.row, isTextLate);
  textLater.cancel();
  shown = shownLine = "";
  const line = next.to === "line" ? next.line : editor.line;
  view.markRows(path.rowsOfLine(line));
  editor.markLines("now", next.to === "line" ? [line] : []);
  void tellState(next.to === "line" ? doneOf(playback) : 0, line);
}

let shown = "";
let shownLine = "";
timeline.onTime = (seconds) => {
  if (setpoints) go({ to: "time", seconds }, true);
};

/** To scroll the text takes as long as to draw the stock: so often while it plays, and while time is dragged once it rests so long. */
const TEXT_EVERY_MS = 100;
const TEXT_QUIET_MS = 150;
const textLater = new Later(TEXT_EVERY_MS);

/** Marks a row and its line, and shows what is active there; the text at once or soon after the picture. */
function showRow(at: number, isTextLate = false): void {
  const line = path.lineOf(at);
  const key = `${run} ${at}`;
  if (!line || key === shown) return;
  shown = key;
  view.markRows([at, at]);
  const of = run;
  if (isTextLate) return textLater.do(() => of === run && showLine(at, line), timeline.isPlaying ? 0 : TEXT_QUIET_MS);
  textLater.cancel();
  showLine(at, line);
}

function showLine(at: number, line: { line: number; own: boolean }): void {
  if (line.own && `${run} ${line.line}` !== shownLine) {
    shownLine = `${run} ${line.line}`;
    editor.markLines("now", [line.line]);
    editor.goTo(line.line);
  }
  void tellState(at + 1, line.own ? line.line : editor.line, line.own ? undefined : line.line);
}
timeline.onStep = (direction) => {
  if (!setpoints) return;
  timeline.pause();
  go({ to: "row", row: stepRow(path, playback.row, direction), share: 0 });
};
timeline.onToCursor = () => {
  const rows = path.rowsOfLine(editor.line);
  if (!setpoints || !rows) return;
  timeline.pause();
  go({ to: "row", row: rows[0], share: 0 });
};

async function save(force: boolean): Promise<void> {
  editor.flush();
  const told = await link.ask("save", { force });
  if (told.type === "saved") {
    editor.setDirty(false);
    ui.tell("note", shell().saved);
  } else if (told.type === "conflict") {
    ui.ask("The file has changed on disk since it was read.", [
      ["Overwrite it with mine", () => void save(true)],
      ["Load it and lose my changes", () => link.tell("reload")],
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
  const mm = (ui.ownChords() && report?.own_chords_mm) || ui.chordTolerance();
  ui.chordsTold(toleranceText(units(), mm));
  link.tell("chords", { tolerance_mm: mm, balanced: ui.balanced.checked, as_control: ui.ownChords() });
}

editor.onDirty = (dirty) => ui.setDirty(dirty);
ui.save.addEventListener("click", () => void save(false));
ui.machine.addEventListener("change", () => {
  editor.flush();
  const [chosen] = ui.machine.selectedOptions;
  readings.chosen(chosen?.value ? { name: chosen.value, title: chosen.text } : undefined);
  link.tell("machine", { name: ui.machine.value || null });
});
ui.onView = (name: ViewName) => view.setView(name);
ui.onFit = () => view.fit();
let colorBy: ColorBy = "tool";
ui.onColor = (by: ColorBy) => {
  colorBy = by;
  view.setColorBy(by);
  tellColors();
};
ui.onTheme = () => {
  view.setPalette(palette());
  tellColors();
  timeline.draw();
  tellTimes();
};
ui.onPanel = () => {
  void tellState(...stateOf);
  void tellOutline();
};
ui.onChords = askChords;
ui.rapids.addEventListener("change", () => view.showRapids(ui.rapids.checked));
ui.travel.addEventListener("change", tellTravel);
ui.toolOn.addEventListener("change", showTool);

const measure = measuring({
  view,
  canvas: ui.canvas,
  button: ui.measure,
  path: () => path,
  units,
  tell: ui.measured,
});
ui.onSection = (section) => view.setSection(section);
ui.cursorLine = () => editor.line;

let pressed: [number, number] | undefined;
ui.canvas.addEventListener("pointerdown", (event) => (pressed = [event.offsetX, event.offsetY]));
ui.canvas.addEventListener("pointerup", (event) => {
  if (!pressed || Math.hypot(event.offsetX - pressed[0], event.offsetY - pressed[1]) > 3) return;
  const picked = view.pick(event.offsetX, event.offsetY);
  const line = picked && path.lineOf(picked.row);
  if (!picked || !line) {
    if (!measure.isOn) against.readAt(event.offsetX, event.offsetY);
    return;
  }
  if (measure.isOn) return measure.click(picked);
  if (!line.own) ui.tell("note", `This is line ${line.line} of a subprogram in another file.`);
  timeline.pause();
  shown = shownLine = "";
  go({ to: "row", row: picked.row, share: picked.share, looks: true });
});

view.onDrawn = () => drawAxes(ui.axes, view.axes());

onKeys({ timeline, view, measure, walk: (direction) => against.walk(direction) });
window.addEventListener("beforeunload", (event) => {
  if (editor.dirty) event.preventDefault();
});

/** What an editor around the page says of its cursor may follow from what is played. */
const cursorAt = (line: number) => {
  if (!timeline.isPlaying) putCursor(line);
};
shell().furnish?.({ ui, editor, link, cursorAt });

// For the browser's tests and for measurements.
Object.assign(window, { chordal: { view, editor, timeline, against: against.shown, stock, turned, path: () => path, report: () => report, setpoints: () => setpoints, playback: () => playback } });
