// The stock of a lathe on the page: its half section at any moment, the tool in it, and the result of the simulation.

import { arcIndex } from "../path/arcs";
import type { Vec3 } from "../path/batch";
import type { Connection } from "../protocol/connection";
import type { Frame } from "../protocol/frame";
import type { ServerMessage, TurnedReport } from "../protocol/messages";
import type { ShownRun } from "../session/shown-run";
import type { PathView } from "../view/path-view";
import { type SectionPoint, HalfSections } from "./half-sections";
import { latheControls } from "./lathe-controls";

export interface LatheStockParts {
  view: PathView;
  connection: Connection;
  run: ShownRun;
  /** Takes all problems of the run, including those of the stock. */
  report: (message: TurnedReport) => void;
}

/** Steps along an arc that is being cut. */
const ARC_STEPS = 24;

export function latheStock(parts: LatheStockParts) {
  const { view } = parts;
  let sections: HalfSections | undefined;
  let rowsDone = Infinity;
  /** Of the tool, relative to the origin of the path; undefined where it is not known. */
  let position: Vec3 | undefined;
  const controls = latheControls((what, shown) => {
    view.lathe.shown[what] = shown;
    view.lathe.changed();
  });

  /** Z and radius of a position relative to the origin of the path. */
  const sectionPoint = (at: Vec3): SectionPoint => {
    const { origin } = parts.run.path;
    return [at[2] + origin[2], at[0] + origin[0]];
  };

  /** Positions of the tool on the row that it is cutting, from its start to now. */
  function cuttingPositions(): SectionPoint[] {
    const row = sections?.rowInProgress(rowsDone);
    const path = parts.run.path;
    const found = row === undefined ? undefined : path.find(row);
    if (!found || row === undefined || !position) return [];
    const steps = arcIndex(...found) < 0 ? 1 : ARC_STEPS;
    const points = Array.from({ length: steps }, (_, step) => path.pointOn(row, ((rowsDone - row) * step) / steps)!);
    return [...points, position].map(sectionPoint);
  }

  function show(): void {
    if (!sections) return;
    view.lathe.goTo({ number: sections.numberAt(rowsDone), done: rowsDone, cutting: cuttingPositions() });
  }

  return {
    root: controls.root,
    sections: () => sections,
    /** A new run begins. */
    began(): void {
      sections = undefined;
      rowsDone = Infinity;
      position = undefined;
      view.setHalfSections(undefined, () => 0);
      controls.none();
    },
    /** Goes to the moment when `rows` rows of the path are done and the tool is at a position relative to the origin of the path. */
    goTo(rows: number, at: Vec3 | undefined): void {
      [rowsDone, position] = [rows, at];
      show();
    },
    /** Puts a tool at a position relative to the origin of the path, or hides it; returns whether the half section draws it. */
    placeTool(tool: number, at: Vec3 | undefined): boolean {
      return sections !== undefined && view.lathe.placeTool(tool, at && sectionPoint(at));
    },
    take(message: ServerMessage): boolean {
      if (message.type !== "turned_report") return false;
      if (message.run !== parts.run.number) return true;
      parts.report(message);
      controls.report(message, parts.run.axisUnits);
      view.lathe.mark(message.problems);
      return true;
    },
    takeFrame(frame: Frame): boolean {
      if (frame.header.type !== "turned") return false;
      if (frame.header.run !== parts.run.number) return true;
      sections = new HalfSections(frame);
      const path = parts.run.path;
      view.setHalfSections(sections, (tool) => path.cutterIndex(tool));
      controls.begin(sections);
      show();
      return true;
    },
  };
}
