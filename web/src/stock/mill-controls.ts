// How the stock is shown: colours, where it is cut open, how fine it is, and what was found.

import { closesOnEscape, element } from "../panels/dom";
import { type Units, count, length, volume } from "../panels/units";
import type { StockReport } from "../protocol/messages";
import { type StockColor, type StockCut, MAX_TOLERANCES } from "./stock-layer";
import type { StockBefore } from "./stock-timeline";

const SLIDER_STEPS = 1000;
/** Columns to choose from, about. */
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

/** What the picture does not show in full. */
interface Less {
  coarser: boolean;
  late: boolean;
  undercuts: boolean;
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
  const found = element("output", "about");
  found.setAttribute("aria-live", "polite");
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
  row("", found);
  root.append(summary, choices);

  let stock: StockBefore | undefined;
  let units: Units = { inch: false };
  let less: Less = { coarser: false, late: false, undercuts: false, turned: false };
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
    const number = ["x", "y", "z"].indexOf(chosen);
    const [low, high] = [stock.low[number]!, stock.high[number]!];
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
    const more = changes === undefined ? "" : `, ${count(changes)} changes`;
    const [nx, ny] = stock.columns;
    const coarser = less.coarser ? ", coarser than chosen: the program lowers them too often" : "";
    const late = less.late ? `, at most ${length(units, stock.pitch / 2)} late in places` : "";
    const far = stock.target && color.value === "deviation" ? `. Red: too deep, blue: too high, by up to ${length(units, MAX_TOLERANCES * stock.toleranceMm)}` : "";
    const where = hasPart ? "drawn at the end of the program only" : "not drawn";
    const missing = [less.undercuts && `Undercuts are ${where}`, less.turned && `Cuts while the part is turned are ${where}`];
    const notDrawn = missing.filter(Boolean).map((text) => `. ${text}`).join("");
    about.textContent = `${length(units, stock.pitch)}, ${count(nx * ny)} columns${coarser}${late}${more}${far}${notDrawn}`;
  }
  fixtures.addEventListener("change", () => handlers.showFixtures(fixtures.checked));
  shown.addEventListener("change", () => handlers.show(shown.checked));
  color.addEventListener("change", updateColor);
  for (const input of [axis, place]) input.addEventListener("input", updateCut);
  columns.addEventListener("change", () => handlers.columns(Number(columns.value)));
  closesOnEscape(root, summary);

  return {
    root,
    none(): void {
      root.hidden = true;
      stock = undefined;
    },
    begin(own: StockBefore, its: Units, missing: Less): void {
      [stock, units, less] = [own, its, missing];
      root.hidden = false;
      fixturesRow.forEach((part) => (part.hidden = !own.fixtures?.length));
      color.querySelector<HTMLOptionElement>("[value=deviation]")!.disabled = !own.target;
      if (!own.target && color.value === "deviation") color.value = "tool";
      found.textContent = "";
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
      found.textContent = "Looking for touches…";
    },
    part(): void {
      hasPart = true;
      updateSummary();
    },
    report({ verdict, removed_mm3: { least, most } }: StockReport, its: Units): void {
      found.textContent = `${VERDICT_TEXTS[verdict]}; removed ${volume(its, least, most)}`;
    },
  };
}

function select(id: string, label: string, options: [string, string][]): HTMLSelectElement {
  const made = element("select");
  made.id = id;
  made.setAttribute("aria-label", label);
  for (const [value, text] of options) made.append(new Option(text, value));
  return made;
}
