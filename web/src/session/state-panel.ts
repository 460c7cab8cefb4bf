// The panel of the modal state at the playback position.

import type { layout } from "../panels/layout";
import { showState } from "../panels/program-panels";
import { kindOf } from "../path/batch";
import { playbackStateOf } from "../path/playback-state";
import type { Connection } from "../protocol/connection";
import type { ShownRun } from "./shown-run";

interface StateQuery {
  /** Rows of the path. */
  done: number;
  line: number;
  /** Where the position is in a subprogram of another file, the line there. */
  subprogramLine: number | undefined;
}

export class StatePanel {
  /** One query at a time; of those that come meanwhile only the last is sent. */
  private isWaiting = false;
  private next: StateQuery | undefined;
  private current: StateQuery = { done: 0, line: 1, subprogramLine: undefined };

  constructor(
    private run: ShownRun,
    private connection: Connection,
    private ui: ReturnType<typeof layout>,
  ) {}

  /** Stops waiting: no answer about the program before will come. */
  reset(): void {
    this.isWaiting = false;
  }

  /** Shows the modal state after `done` rows, at once or when the panel is opened. */
  show(done: number, line: number, subprogramLine?: number): void {
    this.current = { done, line, subprogramLine };
    this.refresh();
  }

  refresh(): void {
    if (this.run.report && this.ui.shown() === "state") void this.query(this.current);
  }

  private async query(query: StateQuery): Promise<void> {
    if (this.isWaiting) {
      this.next = query;
      return;
    }
    this.isWaiting = true;
    const answer = await this.connection.query("state", { done: query.done, line: query.line });
    this.isWaiting = false;
    const { next } = this;
    this.next = undefined;
    if (next) return this.refresh();
    if (answer.type !== "state") return;
    const { path, machine } = this.run;
    const { done, line, subprogramLine } = query;
    const last = done > 0 ? path.find(done - 1) : undefined;
    const end = last && playbackStateOf({ to: "row", row: done - 1, fraction: 1 }, path, undefined);
    const moves = subprogramLine !== undefined || path.rowsOfLine(line) !== undefined;
    const kind = last && moves ? kindOf(last[0].kind[last[1]]!) : undefined;
    showState(this.ui.panels.state, answer.state ?? undefined, end, { line, kind, inSubprogram: subprogramLine }, machine);
  }
}
