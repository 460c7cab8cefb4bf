// The comparison with another program: its path, the result, and stepping through the differences.

import type { OtherFileView } from "../panels/other-file-view";
import type { TextEditor } from "../panels/text-editor";
import { countText } from "../panels/units";
import { type Bounds, type Vec3, batchOf } from "../path/batch";
import { Path } from "../path/path";
import type { Connection } from "../protocol/connection";
import type { Frame } from "../protocol/frame";
import type { BlockRange, ComparedProgram, ComparedWith, Comparison, Difference, HelloMessage, ServerMessage } from "../protocol/messages";
import type { ShownRun } from "../session/shown-run";
import type { PathView } from "../view/path-view";
import { comparePanel, pathLegend } from "./compare-panel";
import { boxAround, boxOf, boxUnion, differingLines, rowsOf, rowsOfLines, step } from "./difference-ranges";

/** The view of a difference without a distance shows at least this fraction of the path's size. */
const MIN_PATH_FRACTION = 1 / 50;
/** The size of a path without bounds, mm. */
const DEFAULT_SIZE_MM = 10;

/** What the comparison uses of the page. */
export interface CompareParts {
  panel: HTMLElement;
  legend: HTMLElement;
  view: PathView;
  editor: TextEditor;
  otherFile: OtherFileView;
  connection: Connection;
  /** The program that is shown. */
  run: ShownRun;
  goTo: (line: number) => void;
  /** The text that explains how to compare with another file. */
  anotherHint: string;
  /** Shows a line of text over the picture. */
  setMessage: (text: string) => void;
  /** Opens the pane of the comparison. */
  openPanel: () => void;
}

export function compareSession(page: CompareParts) {
  const { view, editor, connection } = page;
  let compared: ComparedProgram | undefined;
  let path = new Path();
  let isPathShown = false;
  let comparison: Comparison | undefined;
  /** Index of the chosen difference; -1 where there is none. */
  let chosen = -1;

  const panel = comparePanel(page.panel, {
    choose: (other) => connection.send("compare_with", { other }),
    tolerance: (tolerance_mm) => connection.send("tolerance", { tolerance_mm }),
    show: choose,
    walk,
    farthest: showFarthest,
    read: (file, line) => void read(file, line),
  });
  const legend = pathLegend(page.legend, {
    own: (shown) => view.showOwn(shown),
    other: (shown) => view.showOther(shown),
    end: () => connection.send("compare_with", { other: "nothing" satisfies ComparedWith }),
  });
  const emptyMessage = `Choose what to compare the program with. ${page.anotherHint}`;
  panel.clear(emptyMessage, false);

  function begin(next: ComparedProgram): void {
    panel.chosen(next.other, next.own_text ? next.machine?.title : undefined);
    comparison = undefined;
    chosen = -1;
    compared = next.other === "nothing" ? undefined : next;
    path = new Path();
    isPathShown = false;
    if (!compared) return end(emptyMessage);
    showLegend();
    panel.waiting();
  }

  function end(message: string, isBad = false): void {
    compared = undefined;
    comparison = undefined;
    path = new Path();
    view.beginOther(path);
    legend.hide();
    panel.clear(message, isBad);
    editor.markLines("differs", []);
    page.setMessage("");
  }

  /** Replaces the other path by the new one, once; until its first batch comes the one before stays. */
  function startPath(): void {
    if (isPathShown) return;
    isPathShown = true;
    view.beginOther(path);
  }

  function showLegend(): void {
    if (!compared) return;
    const machines = [page.run.machine?.title ?? "", compared.machine?.title ?? ""];
    const fileName = (name: string) => name.split(/[\\/]/).pop()!;
    legend.show(`${fileName(page.run.programName)} on ${machines[0]}`, `${fileName(compared.name ?? "")} on ${machines[1]}`);
  }

  function show(result: Comparison): void {
    comparison = result;
    chosen = -1;
    panel.show(result, page.run.units);
    editor.markLines("differs", differingLines(result.differences, 0));
    const distant = result.differences.filter(({ distance_mm }) => distance_mm !== null);
    view.markDifferences({
      own: rowsOfLines(page.run.path, differingLines(distant, 0)),
      other: rowsOfLines(path, differingLines(distant, 1)),
      places: distant.flatMap(({ at_mm }) => (at_mm ? [at_mm[0]] : [])),
    });
    legend.showDifferenceKey(distant.length > 0);
    const total = result.differences.length + result.dropped;
    page.setMessage(total === 0 ? result.verdict.replace("-", " ") : `${countText(total, "difference")}: next N, previous P`);
  }

  /** The box of the rows of both sides, in the frame of the run. */
  function boxOfSides(sides: [BlockRange | null, BlockRange | null]): Bounds | undefined {
    const boxes = [page.run.path, path].map((sidePath, side) => {
      const blocks = sides[side];
      return blocks ? boxOf(sidePath, rowsOf(sidePath, blocks)) : undefined;
    });
    const { bounds } = page.run.path;
    const size = bounds ? Math.max(...bounds.high.map((high, axis) => high - bounds.low[axis]!)) : DEFAULT_SIZE_MM;
    return boxUnion(boxes, size * MIN_PATH_FRACTION);
  }

  /** Goes to the line of a difference, and zooms to it so that both paths can be distinguished. */
  function choose(index: number): void {
    const difference = comparison?.differences[index];
    if (!difference) return;
    chosen = index;
    panel.select(index);
    const [a, b] = difference.sides;
    if (a.blocks?.file === 0) page.goTo(a.blocks.from);
    zoomTo(difference.at_mm, [a.blocks, b.blocks]);
    const mark = (blocks: BlockRange | null, lacks: boolean, sidePath: Path) => (blocks && !lacks ? rowsOf(sidePath, blocks) : []);
    view.markBoth(mark(a.blocks, a.lacks, page.run.path), mark(b.blocks, b.lacks, path));
    // At this zoom the tool would cover the difference.
    view.placeTool(undefined);
  }

  function zoomTo(at: Difference["at_mm"], sides: [BlockRange | null, BlockRange | null]): void {
    const box = at ? boxAround(at) : boxOfSides(sides);
    if (box) view.zoomTo(box);
    const relative = (point: Vec3) => point.map((value, axis) => value - page.run.path.origin[axis]!) as Vec3;
    if (at) view.showMeasured(relative(at[0]), relative(at[1]));
    else view.showMeasured(undefined, undefined);
  }

  function showFarthest(): void {
    if (!comparison?.farthest) return;
    const [a, b] = comparison.farthest.places.map(({ file, line }) => ({ file, from: line, to: line }));
    if (a!.file === 0) page.goTo(a!.from);
    zoomTo(comparison.farthest.at_mm, [a!, b!]);
    view.placeTool(undefined);
  }

  function walk(by: 1 | -1): void {
    const next = step(chosen, by, comparison?.differences.length ?? 0);
    if (next < 0) return;
    page.openPanel();
    choose(next);
  }

  async function read(file: number, line: number): Promise<void> {
    const answer = await connection.query("other_text", { file, line });
    if (answer.type === "other_text") page.otherFile.show({ ...answer, column: 0 }, answer.first_line);
  }

  return {
    /** Sets the choice for a program that has just been opened, and ends the comparison of the one before. */
    offer(message: HelloMessage): void {
      if (compared) end(emptyMessage);
      panel.offer(message);
      panel.chosen("nothing");
      panel.tolerance(message.tolerance_mm);
    },
    /** Adds to the choice. */
    offerMore: panel.offer,
    walk,
    /** Takes a message about the comparison; false where it is about something else. */
    take(message: ServerMessage): boolean {
      switch (message.type) {
        case "compared_program":
          begin(message);
          return true;
        case "compared_program_refused":
          panel.chosen(message.other);
          end(message.help ? `${message.message}. ${message.help}.` : message.message, true);
          return true;
        case "compared_path_end":
          if (message.version !== compared?.version) return true;
          startPath();
          void view.finishOther();
          return true;
        case "comparison":
          if (message.run === page.run.number && message.version === compared?.version) show(message);
          return true;
        case "no_comparison":
          if (message.run === page.run.number) panel.clear(message.message, true);
          return true;
        default:
          return false;
      }
    },
    takePath(frame: Frame): void {
      const { header } = frame;
      if (header.version !== compared?.version) return;
      startPath();
      const origin = header.origin as Vec3;
      const batch = batchOf(frame);
      path.add(batch, origin);
      view.addOther(batch);
    },
    /** Shows the line of the other program whose path is at a position on the canvas, CSS pixels. */
    readAt(x: number, y: number): void {
      const picked = view.pickOther(x, y);
      const [batch, index] = (picked && path.find(picked.row)) ?? [];
      if (batch) void read(batch.file[index!]!, batch.line[index!]!);
    },
    /** The program runs again: shows that it is being compared again. */
    began(): void {
      if (!compared) return;
      showLegend();
      panel.waiting();
    },
    color: legend.color,
    /** For the browser's tests. */
    shown: () => ({ path, comparison, chosen }),
  };
}
