// A session of the page with a server or a worker: its messages go to the parts of the page that show them.

import "../style.css";
import { compareSession } from "../compare/compare-session";
import { measureTool } from "../measure/tool";
import type { PageHost } from "../page-host";
import { chordsText, toleranceText } from "../panels/chord-texts";
import { listenToKeys } from "../panels/keyboard";
import { layout } from "../panels/layout";
import { OtherFileView } from "../panels/other-file-view";
import { ProblemPanel } from "../panels/problems";
import { leftOutText, notNamedText, notVerified, showOutline, showTimes } from "../panels/program-panels";
import { readingsPanel } from "../panels/readings";
import { refreshTokens, syntaxHints } from "../panels/syntax-hints";
import { TextEditor } from "../panels/text-editor";
import { Timeline } from "../panels/timeline";
import { type Vec3, AXIS_BITS, batchOf } from "../path/batch";
import { engagementOf } from "../path/engagement";
import { unknownRotaryHint } from "../path/rotation";
import { Connection } from "../protocol/connection";
import { type Frame, f32, u8 } from "../protocol/frame";
import type { RunReport, ServerMessage } from "../protocol/messages";
import { latheStock } from "../stock/lathe-stock";
import { millStock } from "../stock/mill-stock";
import { drawAxes } from "../view/axis-cross";
import { type ColorBy, DARK, LIGHT, toolColor } from "../view/colors";
import { PathView } from "../view/path-view";
import { travelBox, whyNoTravel } from "../view/travel-box";
import { PlaybackController } from "./playback-controller";
import { type Refusal, ShownRun } from "./shown-run";
import { StatePanel } from "./state-panel";

/** How far the pointer may move between press and release of a click, pixels. */
const CLICK_PIXELS = 3;

type StockDiagnostics = Pick<RunReport, "diagnostics" | "left_out" | "errors" | "warnings" | "notes">;

const isDark = () =>
  document.documentElement.dataset.theme
    ? document.documentElement.dataset.theme === "dark"
    : matchMedia("(prefers-color-scheme: dark)").matches;
const palette = () => (isDark() ? DARK : LIGHT);

export class Session {
  private run = new ShownRun();
  private ui: ReturnType<typeof layout>;
  private view: PathView;
  private timeline: Timeline;
  private connection: Connection;
  private editor: TextEditor;
  private otherFile: OtherFileView;
  private problems: ProblemPanel;
  private readings: ReturnType<typeof readingsPanel>;
  private compare: ReturnType<typeof compareSession>;
  private millStock: ReturnType<typeof millStock>;
  private latheStock: ReturnType<typeof latheStock>;
  private measure: ReturnType<typeof measureTool>;
  private statePanel: StatePanel;
  private playback: PlaybackController;
  private colorBy: ColorBy = "tool";
  /** Whether the path is that of the present run; the one before stays until the first batch comes. */
  private isPathShown = false;

  /** Builds the page into `root`; `host` connects it to its server or worker. */
  constructor(root: HTMLElement, private host: PageHost) {
    this.ui = layout(root);
    const { ui, run } = this;
    this.view = new PathView(ui.canvas, palette());
    this.timeline = new Timeline(ui.timeline);
    this.editor = this.makeEditor();
    this.otherFile = new OtherFileView(ui.code, () => this.editor.view.focus());
    this.connection = new Connection(host.dial, (message) => this.take(message), (frame) => this.takeFrame(frame), () => ui.notify("error", host.lostMessage));
    const { view, editor, connection, timeline } = this;
    this.problems = new ProblemPanel(ui.panels.problems, ({ place }) => {
      if (place?.own) this.goToLine(place.line, place.column);
    });
    this.readings = this.makeReadings();
    this.compare = compareSession({
      panel: ui.panels.compare,
      legend: ui.paths,
      view,
      editor,
      otherFile: this.otherFile,
      connection,
      run,
      goTo: (line) => {
        editor.goTo(line);
        this.playback.goToLine(line);
      },
      anotherHint: host.anotherHint,
      setMessage: ui.comparison,
      openPanel: () => ui.show("compare"),
    });
    const report = (diagnostics: StockDiagnostics) => this.addStockDiagnostics(diagnostics);
    this.latheStock = latheStock({ view, connection, run, report });
    this.millStock = millStock({ view, connection, run, report, notify: ui.notify });
    ui.stockSlot.append(this.millStock.root, this.latheStock.root);
    this.statePanel = new StatePanel(run, connection, ui);
    this.playback = new PlaybackController({
      run, ui, view, timeline, editor, millStock: this.millStock, latheStock: this.latheStock, statePanel: this.statePanel,
    });
    this.measure = measureTool({ view, canvas: ui.canvas, button: ui.measure, run, setMessage: ui.measured });
    this.listen();
    host.addControls?.({ ui, editor, connection, cursorAt: (line) => this.followCursor(line) });
    this.exposeForTests();
  }

  private makeEditor(): TextEditor {
    return new TextEditor(this.ui.code, {
      typed: (changes) => this.connection.send("edit", { changes }),
      cursor: (line, byUser) => {
        if (byUser) this.playback.goToLine(line);
        else this.host.followLine?.(line);
      },
      save: () => void this.save(false),
      definition: (line, column) => void this.goToDefinition(line, column),
    }, syntaxHints({
      tokens: async (from, to) => {
        const answer = await this.connection.query("tokens", { from, to });
        return answer.type === "tokens" ? answer : undefined;
      },
      meaning: async (line, column) => {
        this.editor.flush();
        const answer = await this.connection.query("hover", { line, column });
        return answer.type === "hover" ? (answer.hover ?? undefined) : undefined;
      },
    }));
  }

  private makeReadings() {
    const { ui, editor, connection } = this;
    return readingsPanel(ui.readings, {
      read: (choice) => {
        editor.flush();
        ui.chooseMachine(choice);
        connection.send("machine", { name: choice.name, is_answer: true });
      },
      leave: () => ui.machine.focus(),
    });
  }

  /** Connects the controls of the page. */
  private listen(): void {
    const { ui, view, editor, connection, timeline, readings } = this;
    editor.onDirty = (dirty) => ui.setDirty(dirty);
    ui.save.addEventListener("click", () => void this.save(false));
    ui.machine.addEventListener("change", () => {
      editor.flush();
      const [chosen] = ui.machine.selectedOptions;
      readings.machineChosen(chosen?.value ? { name: chosen.value, title: chosen.text } : undefined);
      connection.send("machine", { name: ui.machine.value || null });
    });
    ui.onView = (name) => view.setView(name);
    ui.onFit = () => view.fit();
    ui.onColor = (by) => {
      this.colorBy = by;
      view.setColorBy(by);
      this.showColors();
    };
    ui.onTheme = () => {
      view.setPalette(palette());
      this.showColors();
      timeline.draw();
      this.showTimes();
    };
    ui.onPanel = () => {
      this.statePanel.refresh();
      void this.showOutline();
    };
    ui.onChords = () => this.requestChords();
    ui.rapids.addEventListener("change", () => view.showRapids(ui.rapids.checked));
    ui.travel.addEventListener("change", () => this.showTravel());
    ui.machineOn.addEventListener("change", () => this.showTravel());
    ui.toolOn.addEventListener("change", () => this.playback.showTool());
    ui.onSection = (section) => view.setSection(section);
    ui.cursorLine = () => editor.line;
    this.listenToClicks();
    view.onDrawn = () => drawAxes(ui.axes, view.axes());
    listenToKeys({ timeline, view, measure: this.measure, walk: (direction) => this.compare.walk(direction) });
    window.addEventListener("beforeunload", (event) => {
      if (editor.dirty) event.preventDefault();
    });
  }

  private listenToClicks(): void {
    const { canvas } = this.ui;
    let pressed: [number, number] | undefined;
    canvas.addEventListener("pointerdown", (event) => (pressed = [event.offsetX, event.offsetY]));
    canvas.addEventListener("pointerup", ({ offsetX, offsetY }) => {
      if (!pressed || Math.hypot(offsetX - pressed[0], offsetY - pressed[1]) > CLICK_PIXELS) return;
      this.click(offsetX, offsetY);
    });
  }

  private click(x: number, y: number): void {
    const picked = this.view.pick(x, y);
    const line = picked && this.run.path.lineOf(picked.row);
    if (!picked || !line) {
      if (!this.measure.isOn) this.compare.readAt(x, y);
      return;
    }
    if (this.measure.isOn) return this.measure.click(picked);
    if (!line.own) this.ui.notify("note", `This is line ${line.line} of a subprogram in another file.`);
    this.playback.goToPick(picked);
  }

  /** Goes to the line of the cursor of an editor around the page, unless the program plays: then the cursor follows it. */
  private followCursor(line: number): void {
    if (!this.timeline.isPlaying) this.playback.goToLine(line);
  }

  private take(message: ServerMessage): void {
    if (this.compare.take(message) || this.millStock.take(message) || this.latheStock.take(message)) return;
    const { ui, run, editor } = this;
    switch (message.type) {
      case "hello":
        this.open(message);
        break;
      case "machines":
        ui.offerMachines(message.machines);
        this.compare.offerMore(message);
        break;
      case "run":
        this.begin(message);
        break;
      case "refused":
        if (message.run >= run.number) this.refuse(message.run, message);
        break;
      case "report":
        if (message.run === run.number) this.finish(message);
        break;
      case "times":
        if (message.run !== run.number) break;
        run.times = message;
        this.showTimes();
        break;
      case "no_times":
        if (message.run !== run.number) break;
        run.timesMessage = message.message;
        this.timeline.setMessage("no times");
        this.showTimes();
        break;
      case "changed":
        if (editor.dirty) this.offerReload();
        else this.connection.send("reload");
        break;
      case "gone":
        ui.notify("warning", "The file was deleted on disk. Save writes it again.");
        break;
      case "error":
        ui.notify("error", message.help ? `${message.message}. ${message.help}.` : message.message);
        break;
      default:
        break;
    }
  }

  private offerReload(): void {
    this.ui.prompt("The file has changed on disk.", [
      ["Load it and lose my changes", () => this.connection.send("reload")],
      ["Keep mine", () => {}],
    ]);
  }

  private open(message: Extract<ServerMessage, { type: "hello" }>): void {
    const { ui } = this;
    document.title = `${message.name.split(/[\\/]/).pop()} – Chordal`;
    ui.setName(message.name);
    ui.save.hidden = !message.writable;
    ui.setMachines(message.machines);
    this.run.open(message.name);
    this.playback.reset();
    this.statePanel.reset();
    this.compare.offer(message);
    this.readings.opened();
  }

  /** Goes to a line of the program, with the focus. */
  private goToLine(line: number, column = 0): void {
    this.editor.goTo(line, column, true);
    this.playback.goToLine(line);
  }

  private async goToDefinition(line: number, column: number): Promise<void> {
    const answer = await this.connection.query("definition", { line, column });
    if (answer.type !== "definition") return;
    const { place } = answer;
    if (!place) return this.ui.notify("note", "This word has no definition in this file or its folder.");
    if (place.file !== undefined) return this.otherFile.show(place);
    this.goToLine(place.line, place.column);
  }

  private begin(message: Extract<ServerMessage, { type: "run" }>): void {
    const { run, ui } = this;
    run.begin(message.run, message.machine);
    this.view.setLathe(message.machine.turret ?? undefined);
    refreshTokens(this.editor.view);
    ui.machineWhy(message.machine.title, message.why);
    this.readings.programRun(run.programName, message.readings);
    this.isPathShown = false;
    this.playback.restart();
    ui.progress(0);
    this.timeline.setMessage("running…");
    this.compare.began();
  }

  /** Replaces the path of the run before by that of the present one, once. */
  private showPath(): void {
    if (this.isPathShown) return;
    this.isPathShown = true;
    this.view.begin(this.run.path);
    this.view.showDone(Infinity);
    this.playback.forgetMarks();
    this.measure.set(false);
    this.timeline.clear();
    this.millStock.began();
    this.latheStock.began();
  }

  private takeFrame(frame: Frame): void {
    const { header } = frame;
    const { run, ui, view } = this;
    if (this.millStock.takeFrame(frame)) return;
    // The tool is drawn with the half sections from now on.
    if (this.latheStock.takeFrame(frame)) return this.playback.showTool();
    const isOfRun = header.run === run.number;
    switch (header.type) {
      case "engagement":
        if (isOfRun) this.timeline.setEngagement(engagementOf(frame));
        break;
      case "text":
        this.takeText(frame);
        break;
      case "path":
        if (isOfRun) this.takePath(frame);
        break;
      case "file":
        this.host.keepFile?.(String(header.name), u8(frame, "bytes"));
        break;
      case "contour":
        if (isOfRun) view.addContour(batchOf(frame), header.origin as Vec3);
        break;
      case "compared_path":
        this.compare.takePath(frame);
        break;
      case "chords":
        view.setChords(f32(frame, "points"), header.origin as Vec3);
        ui.setChordText(chordsText(run.axisUnits, header));
        break;
      case "setpoints":
        if (!isOfRun) break;
        this.timeline.set(run.takeSetpoints(frame), run.units);
        this.playback.refresh();
        break;
      default:
        break;
    }
  }

  private takeText(frame: Frame): void {
    const { header } = frame;
    this.editor.addText(new TextDecoder().decode(u8(frame, "text")), header.first === true, header.last === true);
    if (!header.first) return;
    if (header.binary) this.ui.notify("error", "The file holds binary data, not an NC program.");
    else if (header.mixed_endings) this.ui.notify("note", "The file has different line ends. Save makes them all the same.");
  }

  private takePath(frame: Frame): void {
    const { run } = this;
    this.showPath();
    const origin = frame.header.origin as Vec3;
    const batch = batchOf(frame);
    run.path.add(batch, origin);
    this.view.add(batch);
    this.ui.progress(Number(frame.header.progress));
  }

  private refuse(number: number, refusal: Refusal): void {
    this.run.number = number;
    this.run.refusal = refusal;
    this.ui.progress(1);
    this.showPath();
    this.ui.unverified("");
    this.showProblems();
    this.ui.show("problems");
  }

  private finish(report: RunReport): void {
    const { run, ui, view } = this;
    const { path } = run;
    this.showPath();
    run.report = report;
    const notNamed = [...report.never_named, ...report.named_in_no_cut];
    path.notNamed = AXIS_BITS.reduce((bits, bit, axis) => bits | (notNamed.includes("XYZ"[axis]!) ? bit : 0), 0);
    ui.progress(1);
    void view.finish();
    const { zeros, machine: at } = report.places;
    view.setFixed(zeros.map((zero) => zero.at), travelBox(run.machine, at));
    view.machine.set(report.bodies, view.origin);
    ui.offerMachine(report.bodies !== null);
    this.showTravel();
    ui.offerPower(path.minPower < path.maxPower);
    this.showColors();
    const heights = path.bounds ? [path.bounds.low[2], path.bounds.high[2]] : [0, 0];
    ui.section.offer(path.tools, heights.map((z) => z! + path.origin[2]) as [number, number], { inch: report.inch });
    ui.empty(path.bounds ? "" : this.emptyText(report));
    ui.setAxisHint([notNamedText(report), leftOutText(report), unknownRotaryHint(report.axes, run.machine?.rotary ?? [])].filter(Boolean).join(" "));
    ui.unverified(notVerified(report));
    this.editor.setProblems(report.diagnostics);
    this.showProblems();
    this.showTimes();
    void this.showOutline();
    if (run.setpoints) this.timeline.set(run.setpoints, run.units);
    this.playback.refresh();
    ui.offerOwnChords(report.own_chords_mm !== null);
    if (ui.chordsOn.checked) this.requestChords();
  }

  /** Replaces the problems of the run by those that include the stock. */
  private addStockDiagnostics({ diagnostics, left_out, errors, warnings, notes }: StockDiagnostics): void {
    if (!this.run.report) return;
    this.run.report = { ...this.run.report, diagnostics, left_out, errors, warnings, notes };
    this.editor.setProblems(diagnostics);
    this.showProblems();
  }

  /** Shows the legend of the colours, and sets the colour of the own path in the comparison. */
  private showColors(): void {
    const { report, path, machine } = this.run;
    if (report) this.ui.legend(this.colorBy, path, report, machine, palette());
    this.compare.color(toolColor(palette(), 0));
  }

  private emptyText(report: RunReport): string {
    if (report.errors > 0) return "There is no path to show. The problems say why.";
    if (this.run.path.rows > 0) return "The program moves, but the position relative to the part is not known.";
    return "The program does not move any axis.";
  }

  /** Shows the travel box and the bodies of the machine where they are switched on, or why they cannot be shown. */
  private showTravel(): void {
    const { checked } = this.ui.travel;
    const { report, machine } = this.run;
    this.view.showTravel(checked);
    this.view.machine.show(this.ui.machineOn.checked);
    const whyNoBodies = this.ui.machineOn.checked ? (report?.bodies?.left_out ?? []).map((reason) => `Not shown of the machine: ${reason}.`) : [];
    const whyNoBox = checked && report && machine ? whyNoTravel(machine, report.places.machine) : "";
    this.ui.setTravelHint([whyNoBox, ...whyNoBodies].filter(Boolean).join(" "));
  }

  private showProblems(): void {
    const { report, refusal } = this.run;
    this.ui.counts(report, refusal !== undefined);
    this.problems.show(report, refusal);
  }

  /** Shows the outline where its panel is open. */
  private async showOutline(): Promise<void> {
    if (this.ui.shown() !== "outline") return;
    const answer = await this.connection.query("outline");
    if (answer.type === "outline") showOutline(this.ui.panels.outline, answer.entries, (line) => this.goToLine(line));
  }

  private showTimes(): void {
    const { times, timesMessage, report, machine, path } = this.run;
    const color = (tool: number) => toolColor(palette(), path.cutterIndex(tool));
    showTimes(this.ui.panels.times, times, timesMessage, report, machine, color, (line) => this.goToLine(line));
  }

  private async save(force: boolean): Promise<void> {
    const { editor, ui, connection } = this;
    editor.flush();
    const answer = await connection.query("save", { force });
    if (answer.type === "saved") {
      editor.setDirty(false);
      ui.notify("note", this.host.savedMessage);
    } else if (answer.type === "conflict") {
      ui.prompt("The file has changed on disk since it was read.", [
        ["Overwrite it with mine", () => void this.save(true)],
        ["Load it and lose my changes", () => connection.send("reload")],
        ["Cancel", () => {}],
      ]);
    } else this.take(answer);
  }

  private requestChords(): void {
    const { ui, run, view } = this;
    if (!ui.chordsOn.checked) {
      view.setChords(undefined, [0, 0, 0]);
      ui.setChordText("");
      return;
    }
    const mm = (ui.ownChords() && run.report?.own_chords_mm) || ui.chordTolerance();
    ui.setChordText(toleranceText(run.axisUnits, mm));
    this.connection.send("chords", { tolerance_mm: mm, balanced: ui.balanced.checked, as_control: ui.ownChords() });
  }

  /** For the tests and the measurements in the browser. */
  private exposeForTests(): void {
    const { run, view, editor, timeline, compare, playback } = this;
    Object.assign(window, {
      chordal: {
        view, editor, timeline, compare: compare.shown, stock: this.millStock, lathe: this.latheStock,
        path: () => run.path,
        report: () => run.report,
        setpoints: () => run.setpoints,
        playback: () => playback.state,
      },
    });
  }
}
