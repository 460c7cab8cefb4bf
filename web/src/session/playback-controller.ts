// The playback position, shown by timeline, clock, readout, tool, stock and text.

import type { layout } from "../panels/layout";
import type { TextEditor } from "../panels/text-editor";
import { ThrottledTask } from "../panels/throttled-task";
import type { Timeline } from "../panels/timeline";
import type { Vec3 } from "../path/batch";
import { type PlaybackState, type PlaybackTarget, rowsDoneAt, playbackStateOf } from "../path/playback-state";
import { toolDirection } from "../path/rotation";
import { machineAxesAt, stepRow } from "../path/setpoints";
import type { latheStock } from "../stock/lathe-stock";
import type { millStock } from "../stock/mill-stock";
import type { PathView } from "../view/path-view";
import type { PickedPoint } from "../view/picking";
import type { ShownRun } from "./shown-run";
import type { StatePanel } from "./state-panel";

/** Shortest time between two scrolls of the text during playback, ms: a scroll costs as much as drawing the stock. */
const TEXT_INTERVAL_MS = 100;
/** How long the time slider must rest before the text follows, ms. */
const TEXT_QUIET_MS = 150;

export interface PlaybackParts {
  run: ShownRun;
  ui: ReturnType<typeof layout>;
  view: PathView;
  timeline: Timeline;
  editor: TextEditor;
  millStock: ReturnType<typeof millStock>;
  latheStock: ReturnType<typeof latheStock>;
  statePanel: StatePanel;
}

export class PlaybackController {
  private target: PlaybackTarget = { to: "start" };
  state: PlaybackState;
  /** Key of the run and the row that are marked on the path. */
  private markedRowKey = "";
  /** Key of the run and the line that are marked in the text. */
  private markedLineKey = "";
  /** Key of the run, the tool and the number of rows for which the tool was drawn. */
  private drawnToolKey = "";
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

  /** Back to the start, for another program. */
  reset(): void {
    this.target = { to: "start" };
  }

  /** Keeps the line for a new run; rows and times belong to the old one. */
  restart(): void {
    if (this.target.to !== "start") this.target = { to: "line", line: this.parts.editor.line };
  }

  /** Forgets what is marked, so that the next position is marked in any case. */
  forgetMarks(): void {
    this.markedRowKey = this.markedLineKey = "";
  }

  /** Shows the same position again, after more of the run has become known. */
  refresh(): void {
    this.goTo(this.target);
  }

  /** Goes to the end of a line, on which the cursor was put. */
  goToLine(line: number): void {
    this.parts.timeline.pause();
    this.goTo({ to: "line", line });
  }

  /** Goes to a point of the path that was clicked. */
  goToPick({ row, fraction }: PickedPoint): void {
    this.parts.timeline.pause();
    this.forgetMarks();
    this.goTo({ to: "row", row, fraction, keepsPathInFull: true });
  }

  private step(direction: 1 | -1): void {
    const { run, timeline } = this.parts;
    if (!run.setpoints) return;
    timeline.pause();
    this.goTo({ to: "row", row: stepRow(run.path, this.state.row, direction), fraction: 0 });
  }

  private goToCursor(): void {
    const { run, timeline, editor } = this.parts;
    const rows = run.path.rowsOfLine(editor.line);
    if (!run.setpoints || !rows) return;
    timeline.pause();
    this.goTo({ to: "row", row: rows[0], fraction: 0 });
  }

  private goTo(target: PlaybackTarget, deferText = false): void {
    const { run, timeline, ui } = this.parts;
    this.target = target;
    this.state = playbackStateOf(target, run.path, run.setpoints);
    if (this.state.seconds !== undefined) timeline.showTime(this.state.seconds);
    // Before the first move is planned there is no position to show.
    if (run.setpoints || run.path.rows > 0) ui.readout(this.state, run.axisUnits);
    this.showTool();
    this.showProgress(target);
    this.showMarks(target, deferText);
  }

  /** Draws the tool and the machine, or hides them where the position is unknown, and the tool where the tool is switched off, or the view of the lathe stock draws it. */
  showTool(): void {
    const { run, ui, view, latheStock } = this.parts;
    const { row, rotaryAngles } = this.state;
    const [batch, index] = run.path.find(row) ?? [];
    const number = batch ? batch.tool[index!]! : 0;
    this.updateToolShape(number);
    const up = toolDirection(run.machine?.tool_rotations ?? [], this.pointsAlongX(number) ? [1, 0, 0] : [0, 0, 1], rotaryAngles);
    const position = ui.toolOn.checked && run.path.bounds ? this.state.position : undefined;
    const isKnown = this.state.position !== undefined && this.state.seconds !== undefined;
    view.machine.place(isKnown && run.setpoints ? machineAxesAt(run.setpoints, this.state.seconds!) : undefined);
    view.placeTool(latheStock.placeTool(number, position) ? undefined : position, up);
  }

  /** Whether a tool points along X: a turning tool on a turret. Drills and taps point along Z. */
  private pointsAlongX(number: number): boolean {
    const { machine } = this.parts.run;
    const shape = machine?.tools.find((tool) => tool.number === number)?.shape;
    return Boolean(machine?.turret) && (!shape || shape === "insert" || shape === "groove");
  }

  private updateToolShape(number: number): void {
    const { run, view } = this.parts;
    const key = `${run.number} ${number} ${run.path.rows}`;
    if (key === this.drawnToolKey) return;
    this.drawnToolKey = key;
    view.setToolShape(run.machine?.tools.find((tool) => tool.number === number));
  }

  /** Draws the stock for the moment when `rowsDone` rows are done and the tool is at a position. */
  private cutStock(rowsDone: number, position: Vec3 | undefined): void {
    this.parts.millStock.goTo(rowsDone, position);
    this.parts.latheStock.goTo(rowsDone, position);
  }

  /** Draws the path and the stock up to the position. */
  private showProgress(target: PlaybackTarget): void {
    const { view, run } = this.parts;
    const rowsDone = rowsDoneAt(this.state);
    const { seconds, position } = this.state;
    const total = run.setpoints?.totalS ?? 0;
    switch (target.to) {
      // The whole path is drawn, and the stock stays as it is after the run.
      case "start":
        return view.showDone(Infinity);
      case "line":
        view.showDone(Infinity);
        return this.cutStock(rowsDone, undefined);
      default: {
        // At time 0 and at the end nothing is drawn pale.
        const isPartial = seconds !== undefined && seconds > 0 && seconds < total && !(target.to === "row" && target.keepsPathInFull);
        view.showDone(isPartial ? rowsDone : Infinity);
        if (seconds === undefined || seconds < total) this.cutStock(seconds === 0 ? 0 : rowsDone, position);
        else this.cutStock(Infinity, undefined);
      }
    }
  }

  /** Marks the row and the line of the position, and shows the modal state there. */
  private showMarks(target: PlaybackTarget, deferText: boolean): void {
    if (target.to === "row" || target.to === "time") return this.markRow(this.state.row, deferText);
    const { view, run, editor, statePanel } = this.parts;
    this.textTask.cancel();
    this.forgetMarks();
    const line = target.to === "line" ? target.line : editor.line;
    view.markRows(run.path.rowsOfLine(line));
    editor.markLines("now", target.to === "line" ? [line] : []);
    statePanel.show(target.to === "line" ? rowsDoneAt(this.state) : 0, line);
  }

  /** Marks a row and its line; with `deferText` the editor follows later. */
  private markRow(row: number, deferText: boolean): void {
    const { run, view, timeline } = this.parts;
    const line = run.path.lineOf(row);
    const key = `${run.number} ${row}`;
    if (!line || key === this.markedRowKey) return;
    this.markedRowKey = key;
    view.markRows([row, row]);
    const { number } = run;
    if (deferText) return this.textTask.schedule(() => number === run.number && this.markLine(row, line), timeline.isPlaying ? 0 : TEXT_QUIET_MS);
    this.textTask.cancel();
    this.markLine(row, line);
  }

  /** Marks a line in the text; `own` is false for a line of another file, which the editor does not show. */
  private markLine(row: number, { line, own }: { line: number; own: boolean }): void {
    const { run, editor, statePanel } = this.parts;
    const key = `${run.number} ${line}`;
    if (own && key !== this.markedLineKey) {
      this.markedLineKey = key;
      editor.markLines("now", [line]);
      editor.goTo(line);
    }
    statePanel.show(row + 1, own ? line : editor.line, own ? undefined : line);
  }
}
