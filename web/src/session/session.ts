// A session of the page with what answers it, a server or a worker: messages go to the parts of the page that show them.

import "../style.css";
import { againstProgram } from "../compare/compare-session";
import { measuring } from "../measure/tool";
import { type Vec3, axisBits, batchOf } from "../path/batch";
import { engagedOf } from "../path/engagement";
import { unknownTurns } from "../path/kinematics";
import { chordsText, toleranceText } from "../panels/chord-texts";
import { onKeys } from "../panels/keyboard";
import { layout } from "../panels/layout";
import { Elsewhere } from "../panels/other-file-view";
import { Problems } from "../panels/problems";
import { leftOutText, notNamedText, notVerified, showOutline, showTimes } from "../panels/program-panels";
import { readingsPanel } from "../panels/readings";
import { askWords, words } from "../panels/syntax-hints";
import { Editor } from "../panels/text-editor";
import { Timeline } from "../panels/timeline";
import type { PageHost } from "../page-host";
import { Link } from "../protocol/connection";
import { type Frame, f32, u8 } from "../protocol/frame";
import type { Report, Told } from "../protocol/messages";
import { turnedOfProgram } from "../stock/lathe-stock";
import { stockOfProgram } from "../stock/mill-stock";
import { drawAxes } from "../view/axis-cross";
import { type ColorBy, DARK, LIGHT, toolColor } from "../view/colors";
import { PathView } from "../view/path-view";
import { travelBox, whyNoTravel } from "../view/travel-box";
import { PlaybackController } from "./playback-controller";
import { type Refusal, ShownRun } from "./shown-run";
import { StatePanel } from "./state-panel";

/** How far the pointer may move between press and release for a click, pixels. */
const CLICK_PIXELS = 3;

type StockDiagnostics = Pick<Report, "diagnostics" | "left_out" | "errors" | "warnings" | "notes">;

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
  private link: Link;
  private editor: Editor;
  private otherFile: Elsewhere;
  private problems: Problems;
  private readings: ReturnType<typeof readingsPanel>;
  private compare: ReturnType<typeof againstProgram>;
  private stock: ReturnType<typeof stockOfProgram>;
  private lathe: ReturnType<typeof turnedOfProgram>;
  private measure: ReturnType<typeof measuring>;
  private statePanel: StatePanel;
  private playback: PlaybackController;
  private colorBy: ColorBy = "tool";
  /** The first batch of a run replaces the path before; until it comes that path stays. */
  private isPathShown = false;

  /** Builds the page into `root`; `host` says how it reaches what answers it. */
  constructor(root: HTMLElement, private host: PageHost) {
    this.ui = layout(root);
    const { ui, run } = this;
    this.view = new PathView(ui.canvas, palette());
    this.timeline = new Timeline(ui.timeline);
    this.editor = this.makeEditor();
    this.otherFile = new Elsewhere(ui.code, () => this.editor.view.focus());
    this.link = new Link(host.dial, (message) => this.take(message), (frame) => this.takeFrame(frame), () => ui.tell("error", host.lost));
    const { view, editor, link, timeline } = this;
    this.problems = new Problems(ui.panels.problems, ({ place }) => {
      if (place?.own) this.goToLine(place.line, place.column);
    });
    this.readings = this.makeReadings();
    this.compare = againstProgram({
      panel: ui.panels.compare,
      legend: ui.paths,
      view,
      editor,
      elsewhere: this.otherFile,
      link,
      run,
      goTo: (line) => {
        editor.goTo(line);
        this.playback.goToLine(line);
      },
      another: host.another,
      tell: ui.comparison,
      open: () => ui.show("compare"),
    });
    const report = (diagnostics: StockDiagnostics) => this.addStockDiagnostics(diagnostics);
    this.lathe = turnedOfProgram({ view, link, run, report });
    this.stock = stockOfProgram({ view, link, run, report, tell: ui.tell });
    ui.stockSlot.append(this.stock.root, this.lathe.root);
    this.statePanel = new StatePanel(run, link, ui);
    const { stock, lathe, statePanel } = this;
    this.playback = new PlaybackController({ run, ui, view, timeline, editor, stock, lathe, statePanel });
    this.measure = measuring({ view, canvas: ui.canvas, button: ui.measure, run, tell: ui.measured });
    this.listen();
    host.furnish?.({ ui, editor, link, cursorAt: (line) => this.followCursor(line) });
    this.exposeForTests();
  }

  private makeEditor(): Editor {
    return new Editor(this.ui.code, {
      typed: (changes) => this.link.tell("edit", { changes }),
      cursor: (line, byUser) => {
        if (byUser) this.playback.goToLine(line);
        else this.host.follow?.(line);
      },
      save: () => void this.save(false),
      definition: (line, column) => void this.goToDefinition(line, column),
    }, words({
      tokens: async (from, to) => {
        const answer = await this.link.ask("tokens", { from, to });
        return answer.type === "tokens" ? answer : undefined;
      },
      meaning: async (line, column) => {
        this.editor.flush();
        const answer = await this.link.ask("hover", { line, column });
        return answer.type === "hover" ? (answer.hover ?? undefined) : undefined;
      },
    }));
  }

  private makeReadings() {
    const { ui, editor, link } = this;
    return readingsPanel(ui.readings, {
      read: (choice) => {
        editor.flush();
        ui.chooseMachine(choice);
        link.tell("machine", { name: choice.name, is_answer: true });
      },
      leave: () => ui.machine.focus(),
    });
  }

  /** What the controls of the page do. */
  private listen(): void {
    const { ui, view, editor, link, timeline, readings } = this;
    editor.onDirty = (dirty) => ui.setDirty(dirty);
    ui.save.addEventListener("click", () => void this.save(false));
    ui.machine.addEventListener("change", () => {
      editor.flush();
      const [chosen] = ui.machine.selectedOptions;
      readings.chosen(chosen?.value ? { name: chosen.value, title: chosen.text } : undefined);
      link.tell("machine", { name: ui.machine.value || null });
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
    ui.toolOn.addEventListener("change", () => this.playback.showTool());
    ui.onSection = (section) => view.setSection(section);
    ui.cursorLine = () => editor.line;
    this.listenToClicks();
    view.onDrawn = () => drawAxes(ui.axes, view.axes());
    onKeys({ timeline, view, measure: this.measure, walk: (direction) => this.compare.walk(direction) });
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
    if (!line.own) this.ui.tell("note", `This is line ${line.line} of a subprogram in another file.`);
    this.playback.goToPick(picked);
  }

  /** An editor around the page may move its cursor because of what is played: that is not a request to go there. */
  private followCursor(line: number): void {
    if (!this.timeline.isPlaying) this.playback.goToLine(line);
  }

  private take(message: Told): void {
    if (this.compare.take(message) || this.stock.take(message) || this.lathe.take(message)) return;
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
        else this.link.tell("reload");
        break;
      case "gone":
        ui.tell("warning", "The file was deleted on disk. Save writes it again.");
        break;
      case "error":
        ui.tell("error", message.help ? `${message.message}. ${message.help}.` : message.message);
        break;
      default:
        break;
    }
  }

  private offerReload(): void {
    this.ui.ask("The file has changed on disk.", [
      ["Load it and lose my changes", () => this.link.tell("reload")],
      ["Keep mine", () => {}],
    ]);
  }

  private open(message: Extract<Told, { type: "hello" }>): void {
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
    const answer = await this.link.ask("definition", { line, column });
    if (answer.type !== "definition") return;
    const { place } = answer;
    if (!place) return this.ui.tell("note", "This word has no definition in this file or its folder.");
    if (place.file !== undefined) return this.otherFile.show(place);
    this.goToLine(place.line, place.column);
  }

  private begin(message: Extract<Told, { type: "run" }>): void {
    const { run, ui } = this;
    run.begin(message.run, message.machine);
    this.view.setLathe(message.machine.turret ?? undefined);
    askWords(this.editor.view);
    ui.machineWhy(message.machine.title, message.why);
    this.readings.ran(run.programName, message.readings);
    this.isPathShown = false;
    this.playback.restart();
    ui.progress(0);
    this.timeline.setMessage("running…");
    this.compare.began();
  }

  private showPath(): void {
    if (this.isPathShown) return;
    this.isPathShown = true;
    this.view.begin(this.run.path);
    this.view.showDone(Infinity);
    this.playback.clearMarks();
    this.measure.set(false);
    this.timeline.clear();
    this.stock.began();
    this.lathe.began();
  }

  private takeFrame(frame: Frame): void {
    const { header } = frame;
    const { run, ui, view } = this;
    if (this.stock.takeFrame(frame)) return;
    // The tool is drawn with the half sections from now on.
    if (this.lathe.takeFrame(frame)) return this.playback.showTool();
    const isOfRun = header.run === run.number;
    switch (header.type) {
      case "engagement":
        if (isOfRun) this.timeline.setEngaged(engagedOf(frame));
        break;
      case "text":
        this.takeText(frame);
        break;
      case "path":
        if (isOfRun) this.takePath(frame);
        break;
      case "file":
        this.host.keep?.(String(header.name), u8(frame, "bytes"));
        break;
      case "contour":
        if (isOfRun) {
          const origin = header.origin as Vec3;
          view.addContour(run.kinematicsAt(origin).batch(batchOf(frame)), origin);
        }
        break;
      case "against_path":
        this.compare.takePath(frame);
        break;
      case "chords":
        view.setChords(f32(frame, "points"), header.origin as Vec3);
        ui.chordsTold(chordsText(run.axisUnits, header));
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
    if (header.binary) this.ui.tell("error", "The file holds binary data, not an NC program.");
    else if (header.mixed_endings) this.ui.tell("note", "The file has different line ends. Save makes them all the same.");
  }

  private takePath(frame: Frame): void {
    const { run } = this;
    this.showPath();
    const origin = frame.header.origin as Vec3;
    run.kinematics = run.kinematicsAt(origin);
    const batch = run.kinematics.batch(batchOf(frame));
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

  private finish(report: Report): void {
    const { run, ui, view } = this;
    const { path } = run;
    this.showPath();
    run.report = report;
    const notNamed = [...report.never_named, ...report.named_in_no_cut];
    path.notNamed = axisBits.reduce((bits, bit, axis) => bits | (notNamed.includes("XYZ"[axis]!) ? bit : 0), 0);
    ui.progress(1);
    void view.finish();
    const { zeros, machine: at } = report.places;
    view.setFixed(zeros.map((zero) => zero.at), travelBox(run.machine, at));
    this.showTravel();
    ui.offerPower(path.minPower < path.maxPower);
    this.showColors();
    const depths = path.bounds ? [path.bounds.low[2], path.bounds.high[2]] : [0, 0];
    ui.section.offer(path.tools, depths.map((z) => z! + path.origin[2]) as [number, number], { inch: report.inch });
    ui.empty(path.bounds ? "" : this.emptyText(report));
    ui.turns([notNamedText(report), leftOutText(report), unknownTurns(report.axes, run.machine?.rotary ?? [])].filter(Boolean).join(" "));
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

  /** All problems of the run, those of the stock among them. */
  private addStockDiagnostics({ diagnostics, left_out, errors, warnings, notes }: StockDiagnostics): void {
    if (!this.run.report) return;
    this.run.report = { ...this.run.report, diagnostics, left_out, errors, warnings, notes };
    this.editor.setProblems(diagnostics);
    this.showProblems();
  }

  /** Which colour is which tool, and that of the first for the whole path. */
  private showColors(): void {
    const { report, path, machine } = this.run;
    if (report) this.ui.legend(this.colorBy, path, report, machine, palette());
    this.compare.color(toolColor(palette(), 0));
  }

  private emptyText(report: Report): string {
    if (report.errors > 0) return "There is no path to show. The problems say why.";
    if (this.run.path.rows > 0) return "The program moves, but the position relative to the part is not known.";
    return "The program does not move any axis.";
  }

  /** Shows the box of the machine where it is switched on, or says why it cannot be shown. */
  private showTravel(): void {
    const { checked } = this.ui.travel;
    const { report, machine } = this.run;
    this.view.showTravel(checked);
    this.ui.travelWhy(checked && report && machine ? whyNoTravel(machine, report.places.machine) : "");
  }

  private showProblems(): void {
    const { report, refusal } = this.run;
    this.ui.counts(report, refusal !== undefined);
    this.problems.show(report, refusal);
  }

  /** The outline is read when its panel is open. */
  private async showOutline(): Promise<void> {
    if (this.ui.shown() !== "outline") return;
    const answer = await this.link.ask("outline");
    if (answer.type === "outline") showOutline(this.ui.panels.outline, answer.entries, (line) => this.goToLine(line));
  }

  private showTimes(): void {
    const { times, timesMessage, report, machine, path } = this.run;
    const color = (tool: number) => toolColor(palette(), path.cutterIndex(tool));
    showTimes(this.ui.panels.times, times, timesMessage, report, machine, color, (line) => this.goToLine(line));
  }

  private async save(force: boolean): Promise<void> {
    const { editor, ui, link } = this;
    editor.flush();
    const answer = await link.ask("save", { force });
    if (answer.type === "saved") {
      editor.setDirty(false);
      ui.tell("note", this.host.saved);
    } else if (answer.type === "conflict") {
      ui.ask("The file has changed on disk since it was read.", [
        ["Overwrite it with mine", () => void this.save(true)],
        ["Load it and lose my changes", () => link.tell("reload")],
        ["Cancel", () => {}],
      ]);
    } else this.take(answer);
  }

  private requestChords(): void {
    const { ui, run, view } = this;
    if (!ui.chordsOn.checked) {
      view.setChords(undefined, [0, 0, 0]);
      ui.chordsTold("");
      return;
    }
    const mm = (ui.ownChords() && run.report?.own_chords_mm) || ui.chordTolerance();
    ui.chordsTold(toleranceText(run.axisUnits, mm));
    this.link.tell("chords", { tolerance_mm: mm, balanced: ui.balanced.checked, as_control: ui.ownChords() });
  }

  /** What the browser's tests and the measurements look at. */
  private exposeForTests(): void {
    const { run, view, editor, timeline, compare, stock, lathe, playback } = this;
    Object.assign(window, {
      chordal: {
        view, editor, timeline, compare: compare.shown, stock, lathe,
        path: () => run.path,
        report: () => run.report,
        setpoints: () => run.setpoints,
        playback: () => playback.state,
      },
    });
  }
}
