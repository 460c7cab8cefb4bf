// The program held against another one: the path beside, the answer, and the way through the differences.

import { around, boxOf, linesOf, rowsOf, rowsOfLines, step, union } from "./difference-ranges";
import { comparePanel, pathLegend } from "./compare-panel";
import type { Editor } from "../panels/text-editor";
import type { Elsewhere } from "../panels/other-file-view";
import type { Frame } from "../protocol/frame";
import type { Link } from "../protocol/connection";
import type { Against, Blocks, Comparison, Difference, Hello, Other, Told } from "../protocol/messages";
import { type Bounds, type Vec3, batchOf } from "../path/batch";
import { Path } from "../path/path";
import type { PathView } from "../view/path-view";
import { Kinematics } from "../path/kinematics";
import type { ShownRun } from "../session/shown-run";
import { counted } from "../panels/units";

/** What is shown of a place without a distance is at least this share of the path. */
const LEAST_SHARE = 1 / 50;

/** The page around. */
export interface Page {
  panel: HTMLElement;
  legend: HTMLElement;
  view: PathView;
  editor: Editor;
  elsewhere: Elsewhere;
  link: Link;
  /** The program that is shown. */
  run: ShownRun;
  goTo: (line: number) => void;
  /** How to compare with a program of another file. */
  another: string;
  /** A line for the picture. */
  tell: (text: string) => void;
  /** The pane is to be seen. */
  open: () => void;
}

export function againstProgram(page: Page) {
  const { view, editor, link } = page;
  let against: Against | undefined;
  let path = new Path();
  let hasBegun = false;
  let found: Comparison | undefined;
  let chosen = -1;

  const panel = comparePanel(page.panel, {
    choose: (other) => link.tell("against", { other }),
    tolerance: (tolerance_mm) => link.tell("tolerance", { tolerance_mm }),
    show: choose,
    walk,
    farthest: showFarthest,
    read: (file, line) => void read(file, line),
  });
  const legend = pathLegend(page.legend, {
    own: (shown) => view.showOwn(shown),
    other: (shown) => view.showOther(shown),
    end: () => link.tell("against", { other: "nothing" satisfies Other }),
  });
  const nothing = `Choose what to compare the program with. ${page.another}`;
  panel.clear(nothing, false);

  function begin(told: Against): void {
    panel.chosen(told.other, told.own_text ? told.machine?.title : undefined);
    found = undefined;
    chosen = -1;
    against = told.other === "nothing" ? undefined : told;
    path = new Path();
    hasBegun = false;
    if (!against) return end(nothing);
    tellPaths();
    panel.waiting();
  }

  function end(message: string, isBad = false): void {
    against = undefined;
    found = undefined;
    path = new Path();
    view.beginOther(path);
    legend.hide();
    panel.clear(message, isBad);
    editor.markLines("differs", []);
    page.tell("");
  }

  /** The first batch takes the place of the path before: until then that stays. */
  function startPath(): void {
    if (hasBegun) return;
    hasBegun = true;
    view.beginOther(path);
  }

  function tellPaths(): void {
    if (!against) return;
    const machines = [page.run.machine?.title ?? "", against.machine?.title ?? ""];
    const short = (name: string) => name.split(/[\\/]/).pop()!;
    legend.show(`${short(page.run.programName)} on ${machines[0]}`, `${short(against.name ?? "")} on ${machines[1]}`);
  }

  function show(told: Comparison): void {
    found = told;
    chosen = -1;
    panel.show(told, page.run.units);
    editor.markLines("differs", linesOf(told.differences, 0));
    const apart = told.differences.filter(({ distance_mm }) => distance_mm !== null);
    view.markApart({
      own: rowsOfLines(page.run.path, linesOf(apart, 0)),
      other: rowsOfLines(path, linesOf(apart, 1)),
      places: apart.flatMap(({ at_mm }) => (at_mm ? [at_mm[0]] : [])),
    });
    legend.apart(apart.length > 0);
    const total = told.differences.length + told.dropped;
    page.tell(total === 0 ? told.verdict.replace("-", " ") : `${counted(total, "difference")}: next N, previous P`);
  }

  function boxOfSides(sides: [Blocks | null, Blocks | null]): Bounds | undefined {
    const boxes = [page.run.path, path].map((own, side) => {
      const blocks = sides[side];
      return blocks ? boxOf(own, rowsOf(own, blocks)) : undefined;
    });
    const { bounds } = page.run.path;
    const size = bounds ? Math.max(...bounds.high.map((high, axis) => high - bounds.low[axis]!)) : 10;
    return union(boxes, size * LEAST_SHARE);
  }

  /** Goes to a difference: its line, both paths there, large enough to be seen apart. */
  function choose(index: number): void {
    const difference = found?.differences[index];
    if (!difference) return;
    chosen = index;
    panel.select(index);
    const [a, b] = difference.sides;
    if (a.blocks?.file === 0) page.goTo(a.blocks.from);
    place(difference.at_mm, [a.blocks, b.blocks]);
    const mark = (blocks: Blocks | null, lacks: boolean, own: Path) => (blocks && !lacks ? rowsOf(own, blocks) : []);
    view.markBoth(mark(a.blocks, a.lacks, page.run.path), mark(b.blocks, b.lacks, path));
    // So near the tool would cover what is to be seen.
    view.placeTool(undefined);
  }

  function place(at: Difference["at_mm"], sides: [Blocks | null, Blocks | null]): void {
    const box = at ? around(at) : boxOfSides(sides);
    if (box) view.zoomTo(box);
    const relative = (point: Vec3) => point.map((value, axis) => value - page.run.path.origin[axis]!) as Vec3;
    if (at) view.showMeasured(relative(at[0]), relative(at[1]));
    else view.showMeasured(undefined, undefined);
  }

  function showFarthest(): void {
    if (!found?.farthest) return;
    const [a, b] = found.farthest.places.map(({ file, line }) => ({ file, from: line, to: line }));
    if (a!.file === 0) page.goTo(a!.from);
    place(found.farthest.at_mm, [a!, b!]);
    view.placeTool(undefined);
  }

  function walk(by: 1 | -1): void {
    const next = step(chosen, by, found?.differences.length ?? 0);
    if (next < 0) return;
    page.open();
    choose(next);
  }

  async function read(file: number, line: number): Promise<void> {
    const told = await link.ask("other_text", { file, line });
    if (told.type === "other_text") page.elsewhere.show({ ...told, column: 0 }, told.first_line);
  }

  return {
    /** What there is to choose from, for a program that was opened now. */
    offer(told: Hello): void {
      if (against) end(nothing);
      panel.offer(told);
      panel.chosen("nothing");
      panel.tolerance(told.tolerance_mm);
    },
    /** There is more to choose from. */
    offerMore: panel.offer,
    walk,
    /** Takes what is about the other program; false where it is about something else. */
    take(told: Told): boolean {
      switch (told.type) {
        case "against":
          begin(told);
          return true;
        case "against_refused":
          panel.chosen(told.other);
          end(told.help ? `${told.message}. ${told.help}.` : told.message, true);
          return true;
        case "against_end":
          if (told.version !== against?.version) return true;
          startPath();
          void view.finishOther();
          return true;
        case "comparison":
          if (told.run === page.run.number && told.version === against?.version) show(told);
          return true;
        case "no_comparison":
          if (told.run === page.run.number) panel.clear(told.message, true);
          return true;
        default:
          return false;
      }
    },
    takePath(frame: Frame): void {
      const { header } = frame;
      if (header.version !== against?.version) return;
      startPath();
      const origin = header.origin as Vec3;
      const batch = new Kinematics(against?.machine?.rotary ?? [], origin).batch(batchOf(frame));
      path.add(batch, origin);
      view.addOther(batch);
    },
    /** The line of the other program whose path is at a place of the canvas is to be read. */
    readAt(x: number, y: number): void {
      const picked = view.pickOther(x, y);
      const found = picked && path.find(picked.row);
      if (found) void read(found[0].file[found[1]]!, found[0].line[found[1]]!);
    },
    /** The program runs anew: what was found is of the text before. */
    began(): void {
      if (!against) return;
      tellPaths();
      panel.waiting();
    },
    color: legend.color,
    /** For the browser's tests. */
    shown: () => ({ path, found, chosen }),
  };
}
