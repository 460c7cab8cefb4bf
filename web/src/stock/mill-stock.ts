// The stock of a milling program on the page: its messages, its state at any moment, and how it is shown.

import { type Vec3, KNOWN_BIT, RAPID, kindOf } from "../path/batch";
import type { Connection } from "../protocol/connection";
import { type Frame, f32, u32 } from "../protocol/frame";
import type { ServerMessage, StockReport } from "../protocol/messages";
import type { ShownRun } from "../session/shown-run";
import type { PathView } from "../view/path-view";
import { Gaps } from "./gaps";
import { millControls } from "./mill-controls";
import { COLOR_SLOTS } from "./stock-shader";
import { type StockBefore, StockTimeline } from "./stock-timeline";
import { floorOf } from "./tool-floor";

export interface MillStockParts {
  view: PathView;
  connection: Connection;
  run: ShownRun;
  /** Takes all problems of the run, including those of the stock. */
  report: (report: StockReport) => void;
  notify: (kind: "warning", text: string) => void;
}

/** A moment of the run: how many rows are done, and where the tool is, relative to the origin of the path. */
interface Moment {
  rows: number;
  position: Vec3 | undefined;
}

const PROGRAM_END: Moment = { rows: Infinity, position: undefined };
/** Colour slots of tools; slot 0 is the stock. */
const TOOL_SLOTS = COLOR_SLOTS - 1;

export function millStock(parts: MillStockParts) {
  const { view } = parts;
  let timeline: StockTimeline | undefined;
  let gaps = new Gaps();
  let moment = PROGRAM_END;
  let progress = 1;
  const controls = millControls({
    show: (shown) => view.stock.show(shown),
    showFixtures: (shown) => view.stock.showFixtures(shown),
    color: (by) => view.stock.setColor(by),
    cut: (cut) => view.stock.setCut(cut),
    columns: (columns) => parts.connection.send("stock", { columns }),
  });

  /** The colour slot of the tool of a row. */
  function slotOf(row: number): number {
    const found = parts.run.path.find(row);
    return found ? 1 + (parts.run.path.cutterIndex(found[0].tool[found[1]]!) % TOOL_SLOTS) : 1;
  }

  function begin(frame: Frame): void {
    const { header } = frame;
    const stock: StockBefore = {
      low: header.low as Vec3,
      high: header.high as Vec3,
      pitch: Number(header.resolution_mm),
      columns: header.cells as [number, number],
      heights: f32(frame, "heights"),
      target: "target" in frame.columns ? f32(frame, "target") : undefined,
      toleranceMm: Number(header.tolerance_mm ?? 0),
      fixtures: f32(frame, "fixtures"),
    };
    timeline = new StockTimeline(stock.heights);
    gaps = new Gaps();
    progress = 0;
    view.setStock(stock);
    controls.begin(stock, parts.run.units, {
      coarser: header.coarser === true,
      late: header.late === true,
      undercuts: header.undercuts === true,
      turned: header.turned === true,
    });
  }

  function add(frame: Frame): void {
    if (!timeline) return;
    timeline.add(u32(frame, "column"), u32(frame, "row"), f32(frame, "share"), f32(frame, "height"), slotOf);
    progress = Number(frame.header.progress);
    controls.progress(progress, timeline.count);
    show();
  }

  function addGaps(frame: Frame): void {
    gaps.add(u32(frame, "column"), u32(frame, "row"), f32(frame, "share"), u32(frame, "count"), f32(frame, "gaps"));
    view.stock.setGaps(gaps);
    show();
  }

  /** Takes the mesh of the part at the end, which shows what heights cannot. */
  function takePart(frame: Frame): void {
    view.stock.setPart(f32(frame, "corners"));
    controls.part();
    show();
  }

  /** The tool at its present position in the frame of the run; undefined in a rapid, and where position or shape are not known. */
  function toolInCut() {
    const { rows, position } = moment;
    if (!position || !Number.isFinite(rows)) return undefined;
    const path = parts.run.path;
    const found = path.find(Math.min(Math.floor(rows), path.rows - 1));
    if (!found) return undefined;
    const [batch, index] = found;
    if (kindOf(batch.kind[index]!) === RAPID || !(batch.kind[index]! & KNOWN_BIT)) return undefined;
    const number = batch.tool[index]!;
    const floor = floorOf(parts.run.machine?.tools.find((tool) => tool.number === number));
    const at = position.map((value, axis) => value + path.origin[axis]!) as Vec3;
    return floor && { floor, slot: 1 + (path.cutterIndex(number) % TOOL_SLOTS), at };
  }

  function show(): void {
    const { surface } = view.stock;
    if (!timeline || !surface) return;
    const { heights, slots } = timeline;
    if (timeline.leap(moment.rows)) surface.setAll(heights, slots);
    else timeline.seek(moment.rows, (column) => surface.set(column, heights[column]!, slots[column]!));
    gaps.seek(moment.rows, (column, bands) => {
      if (bands.length > 0) surface.mark(column, bands[0]!, bands.at(-1)!);
    });
    surface.cutUnderTool(toolInCut(), heights, slots);
    view.stock.showPart(moment.rows >= parts.run.path.rows);
    view.redraw();
  }

  return {
    root: controls.root,
    drops: () => timeline,
    gaps: () => gaps,
    /** A new run begins. */
    began(): void {
      if (timeline) view.setStock(undefined);
      timeline = undefined;
      moment = PROGRAM_END;
      controls.none();
    },
    /** Goes to the moment when `rows` rows of the path are done and the tool is at a position relative to the origin of the path. */
    goTo(rows: number, position: Vec3 | undefined): void {
      moment = { rows, position };
      show();
    },
    take(message: ServerMessage): boolean {
      if (message.type === "stock_report") {
        if (message.run === parts.run.number) {
          parts.report(message);
          controls.report(message, parts.run.units);
        }
        return true;
      }
      if (message.type !== "no_stock") return false;
      if (message.run === parts.run.number && message.message) parts.notify("warning", message.help ? `${message.message}: ${message.help}.` : `${message.message}.`);
      return true;
    },
    takeFrame(frame: Frame): boolean {
      const { type, run } = frame.header;
      if (type !== "stock" && type !== "stock_drops" && type !== "stock_gaps" && type !== "stock_part") return false;
      if (run === parts.run.number) ({ stock: begin, stock_drops: add, stock_gaps: addGaps, stock_part: takePart })[type](frame);
      return true;
    },
  };
}
