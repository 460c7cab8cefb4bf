// The stock of a lathe on the page: its half section at any moment, the tool in it, and what was found.

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
  /** All problems, those of the stock among them. */
  report: (message: TurnedReport) => void;
}

/** Pieces in which the tool goes along an arc that is being cut. */
const ARC_STEPS = 24;

export function latheStock(parts: LatheStockParts) {
  const { view } = parts;
  let sections: HalfSections | undefined;
  let done = Infinity;
  let at: Vec3 | undefined;
  const controls = latheControls((what, shown) => {
    view.lathe.shown[what] = shown;
    view.lathe.changed();
  });

  const spot = (place: Vec3): SectionPoint => {
    const { origin } = parts.run.path;
    return [place[2] + origin[2], place[0] + origin[0]];
  };

  /** Where the tool was on the move that it is cutting. */
  function cutting(): SectionPoint[] {
    const row = sections?.rowInProgress(done);
    const path = parts.run.path;
    const found = row === undefined ? undefined : path.find(row);
    if (!found || row === undefined || !at) return [];
    const steps = arcIndex(...found) < 0 ? 1 : ARC_STEPS;
    const places = Array.from({ length: steps }, (_, step) => path.pointOn(row, ((done - row) * step) / steps)!);
    return [...places, at].map(spot);
  }

  function show(): void {
    if (!sections) return;
    view.lathe.goTo({ number: sections.numberAt(done), done, cutting: cutting() });
  }

  return {
    root: controls.root,
    sections: () => sections,
    /** A new run begins. */
    began(): void {
      sections = undefined;
      done = Infinity;
      at = undefined;
      view.setHalfSections(undefined, () => 0);
      controls.none();
    },
    /** To a moment: so much of the path is done, and the tool is at a position, relative to the origin of the path. */
    goTo(rows: number, place: Vec3 | undefined): void {
      [done, at] = [rows, place];
      show();
    },
    /** The tool at a position, relative to the origin of the path; whether it is drawn here. */
    place(tool: number, place: Vec3 | undefined): boolean {
      return sections !== undefined && view.lathe.place(tool, place && spot(place));
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
