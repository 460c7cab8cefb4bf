// The stock of a lathe on the page: its half section at any moment, the tool in it, and what was found.

import type { Frame } from "../protocol/frame";
import type { Link } from "../protocol/connection";
import type { Told, TurnedReport } from "../protocol/messages";
import { arcIndex } from "../path/arcs";
import type { Vec3 } from "../path/batch";
import type { PathView } from "../view/path-view";
import { Sections, type Spot } from "./half-sections";
import { turnedControls } from "./lathe-controls";
import type { ShownRun } from "../session/shown-run";

export interface TurnedOf {
  view: PathView;
  link: Link;
  run: ShownRun;
  /** All problems, those of the stock among them. */
  report: (told: TurnedReport) => void;
}

/** Pieces in which the tool goes along an arc that is being cut. */
const ARC_STEPS = 24;

export function turnedOfProgram(of: TurnedOf) {
  const { view } = of;
  let sections: Sections | undefined;
  let done = Infinity;
  let at: Vec3 | undefined;
  const controls = turnedControls((what, shown) => {
    view.turned.shown[what] = shown;
    view.turned.changed();
  });

  const spot = (place: Vec3): Spot => {
    const { origin } = of.run.path;
    return [place[2] + origin[2], place[0] + origin[0]];
  };

  /** Where the tool was on the move that it is cutting. */
  function cutting(): Spot[] {
    const row = sections?.underWay(done);
    const path = of.run.path;
    const found = row === undefined ? undefined : path.find(row);
    if (!found || row === undefined || !at) return [];
    const steps = arcIndex(...found) < 0 ? 1 : ARC_STEPS;
    const places = Array.from({ length: steps }, (_, step) => path.pointOn(row, ((done - row) * step) / steps)!);
    return [...places, at].map(spot);
  }

  function show(): void {
    if (!sections) return;
    view.turned.stand({ number: sections.numberAt(done), done, cutting: cutting() });
  }

  return {
    root: controls.root,
    sections: () => sections,
    /** A new run begins. */
    began(): void {
      sections = undefined;
      done = Infinity;
      at = undefined;
      view.setTurned(undefined, () => 0);
      controls.none();
    },
    /** To a moment: so much of the path is done, and the tool stands at a place, relative to the origin of the path. */
    goTo(rows: number, place: Vec3 | undefined): void {
      [done, at] = [rows, place];
      show();
    },
    /** The tool at a place, relative to the origin of the path; whether it is drawn here. */
    place(tool: number, place: Vec3 | undefined): boolean {
      return sections !== undefined && view.turned.place(tool, place && spot(place));
    },
    take(told: Told): boolean {
      if (told.type !== "turned_report") return false;
      if (told.run !== of.run.number) return true;
      of.report(told);
      controls.report(told, of.run.axisUnits);
      view.turned.mark(told.problems);
      return true;
    },
    takeFrame(frame: Frame): boolean {
      if (frame.header.type !== "turned") return false;
      if (frame.header.run !== of.run.number) return true;
      sections = new Sections(frame);
      const path = of.run.path;
      view.setTurned(sections, (tool) => path.cutterIndex(tool));
      controls.begin(sections);
      show();
      return true;
    },
  };
}
