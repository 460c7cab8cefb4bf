// The controls of the stock: colours, section, number of columns; and the result of its simulation.

import { closeOnEscape, element } from "../panels/dom";
import { type Units, count, length, volume } from "../panels/units";
import type { StockReport } from "../protocol/messages";
import { type StockColor, type StockCut, MAX_TOLERANCES } from "./stock-layer";
import type { StockBefore } from "./stock-timeline";

const SLIDER_STEPS = 1000;
/** Approximate numbers of columns to choose from. */
const COLUMN_CHOICES: [number, string][] = [[60_000, "60,000"], [250_000, "250,000"], [500_000, "500,000"], [1_000_000, "1,000,000"]];
const DEFAULT_COLUMNS = 250_000;
const VERDICT_TEXTS = { clean: "clean", problems: "problems, see Problems", "not-proved": "not proved, see Problems" } as const;

interface MillHandlers {
  show: (shown: boolean) => void;
  showFixtures: (shown: boolean) => void;
  color: (by: StockColor) => void;
  cut: (cut: StockCut | undefined) => void;
  columns: (columns: number) => void;
}

/** What the drawn stock does not show exactly. */
interface StockLimits {
  /** There are fewer columns than chosen. */
  coarser: boolean;
  /** Some columns are lowered a little late. */
  late: boolean;
  /** There are undercuts. */
  undercuts: boolean;
  /** There are cuts while a rotary axis turns the part. */
  turned: boolean;
}

export function millControls(handlers: MillHandlers) {
  const root = element("details", "section");
  root.id = "stock";
  root.hidden = true;
  const summary = element("summary", "", "Stock");
  const choices = element("div", "choices");
  const shown = element("input");
  shown.type = "checkbox";
  shown.checked = true;
  shown.id = "stock-shown";
  const fixtures = element("input");
  fixtures.type = "checkbox";
  fixtures.checked = true;
  fixtures.id = "stock-fixtures";
  fixtures.setAttribute("aria-label", "Show fixtures");
  const color = select("stock-color", "Colour of the stock", [["tool", "By tool"], ["depth", "By depth"], ["deviation", "By deviation"], ["plain", "One colour"]]);
  const axis = select("stock-axis", "Cut open across", [["", "no"], ["x", "X"], ["y", "Y"], ["z", "Z"]]);
  const place = element("input");
  place.type = "range";
  place.id = "stock-cut";
  Object.assign(place, { min: "0", max: String(SLIDER_STEPS), value: String(SLIDER_STEPS / 2) });
  place.setAttribute("aria-label", "Where the stock is cut open");
  const placeText = element("output");
  const columns = select("stock-columns", "Number of columns", COLUMN_CHOICES.map(([value, text]) => [String(value), text]));
  columns.value = String(DEFAULT_COLUMNS);
  const about = element("output", "about");
  const result = element("output", "about");
  result.setAttribute("aria-live", "polite");
  const row = (name: string, ...parts: HTMLElement[]) => {
    const pair = element("span", "pair");
    pair.append(...parts);
    choices.append(element("span", "", name), pair);
  };
  row("Show", shown);
  const fixturesRow = [element("span", "", "Fixtures"), element("span", "pair")] as const;
  fixturesRow[1].append(fixtures);
  choices.append(...fixturesRow);
  row("Colour", color);
  row("Cut open", axis, place);
  row("", placeText);
  row("Columns", columns);
  row("", about);
  row("", result);
  root.append(summary, choices);

  let stock: StockBefore | undefined;
  let units: Units = { inch: false };
  let limits: StockLimits = { coarser: false, late: false, undercuts: false, turned: false };
  /** How many drops the timeline has; undefined until it is complete. */
  let changes: number | undefined;
  let hasPart = false;

  function updateCut(): void {
    const chosen = axis.value as StockCut["axis"] | "";
    place.disabled = chosen === "";
    root.classList.toggle("active", chosen !== "");
    if (!stock || chosen === "") {
      placeText.textContent = "";
      return handlers.cut(undefined);
    }
    const axisIndex = ["x", "y", "z"].indexOf(chosen);
    const [low, high] = [stock.low[axisIndex]!, stock.high[axisIndex]!];
    const at = low + ((high - low) * Number(place.value)) / SLIDER_STEPS;
    placeText.textContent = `${chosen.toUpperCase()} ${length(units, at)}`;
    handlers.cut({ axis: chosen, at });
  }
  function updateColor(): void {
    handlers.color(color.value as StockColor);
    updateSummary();
  }
  function updateSummary(): void {
    if (!stock) return;
    const changesText = changes === undefined ? "" : `, ${count(changes)} changes`;
    const [nx, ny] = stock.columns;
    const coarser = limits.coarser ? ", coarser than chosen: the program lowers them too often" : "";
    const late = limits.late ? `, at most ${length(units, stock.pitch / 2)} late in places` : "";
    const deviation = stock.target && color.value === "deviation" ? `. Red: too deep, blue: too high, by up to ${length(units, MAX_TOLERANCES * stock.toleranceMm)}` : "";
    const where = hasPart ? "drawn at the end of the program only" : "not drawn";
    const missingParts = [limits.undercuts && `Undercuts are ${where}`, limits.turned && `Cuts while the part is turned are ${where}`];
    const notDrawn = missingParts.filter(Boolean).map((text) => `. ${text}`).join("");
    about.textContent = `${length(units, stock.pitch)}, ${count(nx * ny)} columns${coarser}${late}${changesText}${deviation}${notDrawn}`;
  }
  fixtures.addEventListener("change", () => handlers.showFixtures(fixtures.checked));
  shown.addEventListener("change", () => handlers.show(shown.checked));
  color.addEventListener("change", updateColor);
  for (const input of [axis, place]) input.addEventListener("input", updateCut);
  columns.addEventListener("change", () => handlers.columns(Number(columns.value)));
  closeOnEscape(root, summary);

  return {
    root,
    none(): void {
      root.hidden = true;
      stock = undefined;
    },
    begin(newStock: StockBefore, newUnits: Units, newLimits: StockLimits): void {
      [stock, units, limits] = [newStock, newUnits, newLimits];
      root.hidden = false;
      fixturesRow.forEach((part) => (part.hidden = !newStock.fixtures?.length));
      color.querySelector<HTMLOptionElement>("[value=deviation]")!.disabled = !newStock.target;
      if (!newStock.target && color.value === "deviation") color.value = "tool";
      result.textContent = "";
      changes = undefined;
      hasPart = false;
      updateColor();
      updateCut();
    },
    progress(fraction: number, drops: number): void {
      summary.textContent = fraction < 1 ? `Stock ${Math.floor(100 * fraction)} %` : "Stock";
      if (fraction < 1) return;
      changes = drops;
      updateSummary();
      result.textContent = "Looking for touches…";
    },
    part(): void {
      hasPart = true;
      updateSummary();
    },
    report({ verdict, removed_mm3: { least, most } }: StockReport, reportUnits: Units): void {
      result.textContent = `${VERDICT_TEXTS[verdict]}; removed ${volume(reportUnits, least, most)}`;
    },
  };
}

function select(id: string, label: string, options: [string, string][]): HTMLSelectElement {
  const field = element("select");
  field.id = id;
  field.setAttribute("aria-label", label);
  for (const [value, text] of options) field.append(new Option(text, value));
  return field;
}
