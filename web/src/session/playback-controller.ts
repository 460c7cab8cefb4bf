// Where the program is: line, clock, readout, tool, stock and text all show one position.

import type { layout } from "../panels/layout";
import type { TextEditor } from "../panels/text-editor";
import { ThrottledTask } from "../panels/throttled-task";
import type { Timeline } from "../panels/timeline";
import type { Vec3 } from "../path/batch";
import { type PlaybackState, type PlaybackTarget, doneOf, playbackStateOf } from "../path/playback-state";
import { toolDirection } from "../path/rotation";
import { stepRow } from "../path/setpoints";
import type { latheStock } from "../stock/lathe-stock";
import type { millStock } from "../stock/mill-stock";
import type { PathView } from "../view/path-view";
import type { PickedPoint } from "../view/picking";
import type { ShownRun } from "./shown-run";
import type { StatePanel } from "./state-panel";

/** Scrolling the text takes as long as drawing the stock. While the program plays it is done so often at most, ms. */
const TEXT_INTERVAL_MS = 100;
/** While the time is dragged, the text follows once the slider has not moved for so long, ms. */
const TEXT_QUIET_MS = 150;

export interface PlaybackParts {
  run: ShownRun;
  ui: ReturnType<typeof layout>;
  view: PathView;
  timeline: Timeline;
  editor: TextEditor;
  stock: ReturnType<typeof millStock>;
  lathe: ReturnType<typeof latheStock>;
  statePanel: StatePanel;
}

export class PlaybackController {
  private target: PlaybackTarget = { to: "start" };
  state: PlaybackState;
  /** The row that is marked, and the line that the text shows, each with the number of the run. */
  private markedRow = "";
  private markedLine = "";
  /** The tool whose shape is drawn. */
  private shapedTool = "";
  private textTask = new ThrottledTask(TEXT_INTERVAL_MS);

  constructor(private parts: PlaybackParts) {
    this.state = playbackStateOf(this.target, parts.run.path, undefined);
    const { timeline } = parts;
    timeline.onTime = (seconds) => {
      if (parts.run.setpoints) this.goTo({ to: "time", seconds }, true);
    };
    timeline.onStep = (direction) => this.step(direction);
    timeline.onToCursor = () => this.goToCursor();
  }

  /** Another program is opened. */
  reset(): void {
    this.target = { to: "start" };
  }

  /** The program runs again: rows and times are those of the run before, the line stays. */
  restart(): void {
    if (this.target.to !== "start") this.target = { to: "line", line: this.parts.editor.line };
  }

  /** What was marked is marked no more. */
  clearMarks(): void {
    this.markedRow = this.markedLine = "";
  }

  /** The same position again, after more of the run has become known. */
  refresh(): void {
    this.goTo(this.target);
  }

  /** The cursor was put on a line: the program is where that line is done. */
  goToLine(line: number): void {
    this.parts.timeline.pause();
    this.goTo({ to: "line", line });
  }

  /** A point of the path was clicked. */
  goToPick({ row, share }: PickedPoint): void {
    this.parts.timeline.pause();
    this.clearMarks();
    this.goTo({ to: "row", row, share, isInspection: true });
  }

  private step(direction: 1 | -1): void {
    const { run, timeline } = this.parts;
    if (!run.setpoints) return;
    timeline.pause();
    this.goTo({ to: "row", row: stepRow(run.path, this.state.row, direction), share: 0 });
  }

  private goToCursor(): void {
    const { run, timeline, editor } = this.parts;
    const rows = run.path.rowsOfLine(editor.line);
    if (!run.setpoints || !rows) return;
    timeline.pause();
    this.goTo({ to: "row", row: rows[0], share: 0 });
  }

  private goTo(target: PlaybackTarget, isTextLate = false): void {
    const { run, timeline, ui } = this.parts;
    this.target = target;
    this.state = playbackStateOf(target, run.path, run.setpoints);
    if (this.state.seconds !== undefined) timeline.put(this.state.seconds);
    // Before the first move is planned there is no position to show.
    if (run.setpoints || run.path.rows > 0) ui.readout(this.state, run.axisUnits);
    this.showTool();
    this.showDone(target);
    this.showText(target, isTextLate);
  }

  /** Draws the tool at the position; not where the position is not known. */
  showTool(): void {
    const { run, ui, view, lathe } = this.parts;
    const { row, at, turn } = this.state;
    const found = run.path.find(row);
    const number = found ? found[0].tool[found[1]]! : 0;
    this.shapeTool(number);
    const up = toolDirection(run.machine?.tool_rotations ?? [], this.isAcross(number) ? [1, 0, 0] : [0, 0, 1], turn);
    const position = ui.toolOn.checked && run.path.bounds ? at : undefined;
    view.placeTool(lathe.place(number, position) ? undefined : position, up);
  }

  /** Tools of a lathe that do not cut on the axis come from the side of the turret. */
  private isAcross(number: number): boolean {
    const { machine } = this.parts.run;
    const shape = machine?.tools.find((tool) => tool.number === number)?.shape;
    return Boolean(machine?.turret) && (!shape || shape === "insert" || shape === "groove");
  }

  private shapeTool(number: number): void {
    const { run, view } = this.parts;
    const key = `${run.number} ${number} ${run.path.rows}`;
    if (key === this.shapedTool) return;
    this.shapedTool = key;
    view.shapeTool(run.machine?.tools.find((tool) => tool.number === number));
  }

  /** The stock as it is when so much of the path is done and the tool is at a position. */
  private cutStock(done: number, at: Vec3 | undefined): void {
    this.parts.stock.goTo(done, at);
    this.parts.lathe.goTo(done, at);
  }

  /** Shows what of the path and of the stock is done. */
  private showDone(target: PlaybackTarget): void {
    const { view, run } = this.parts;
    const done = doneOf(this.state);
    const { seconds, at } = this.state;
    const total = run.setpoints?.totalS ?? 0;
    switch (target.to) {
      // At first the stock is shown as it is at the end.
      case "start":
        return view.showDone(Infinity);
      case "line":
        view.showDone(Infinity);
        return this.cutStock(done, undefined);
      default: {
        // At both ends all of the path has one state: it is drawn in full.
        const isWithin = seconds !== undefined && seconds > 0 && seconds < total && !(target.to === "row" && target.isInspection);
        view.showDone(isWithin ? done : Infinity);
        if (seconds === undefined || seconds < total) this.cutStock(seconds === 0 ? 0 : done, at);
        else this.cutStock(Infinity, undefined);
      }
    }
  }

  /** Marks the path and the line at the position, and shows what is active there. */
  private showText(target: PlaybackTarget, isTextLate: boolean): void {
    if (target.to === "row" || target.to === "time") return this.showRow(this.state.row, isTextLate);
    const { view, run, editor, statePanel } = this.parts;
    this.textTask.cancel();
    this.clearMarks();
    const line = target.to === "line" ? target.line : editor.line;
    view.markRows(run.path.rowsOfLine(line));
    editor.markLines("now", target.to === "line" ? [line] : []);
    statePanel.show(target.to === "line" ? doneOf(this.state) : 0, line);
  }

  /** Marks a row and its line; the text at once, or soon after the picture. */
  private showRow(row: number, isTextLate: boolean): void {
    const { run, view, timeline } = this.parts;
    const line = run.path.lineOf(row);
    const key = `${run.number} ${row}`;
    if (!line || key === this.markedRow) return;
    this.markedRow = key;
    view.markRows([row, row]);
    const { number } = run;
    if (isTextLate) return this.textTask.schedule(() => number === run.number && this.showLine(row, line), timeline.isPlaying ? 0 : TEXT_QUIET_MS);
    this.textTask.cancel();
    this.showLine(row, line);
  }

  private showLine(row: number, { line, own }: { line: number; own: boolean }): void {
    const { run, editor, statePanel } = this.parts;
    const key = `${run.number} ${line}`;
    if (own && key !== this.markedLine) {
      this.markedLine = key;
      editor.markLines("now", [line]);
      editor.goTo(line);
    }
    statePanel.show(row + 1, own ? line : editor.line, own ? undefined : line);
  }
}
