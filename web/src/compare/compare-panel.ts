// The pane "Compare": the choice of the other program, the verdict, and the list of differences.

import { codeSpans, setCodeSpans } from "../panels/code-spans";
import { element } from "../panels/dom";
import { iconButton } from "../panels/icons";
import { type Units, count, countText } from "../panels/units";
import type { ComparedWith, Comparison, Difference, HelloMessage } from "../protocol/messages";
import { linesText } from "./difference-ranges";

const MM_PER_INCH = 25.4;
/** Differences that are listed at most; more are only counted. */
const MAX_LISTED = 300;

export interface CompareHandlers {
  /** Compares with another program or machine. */
  choose: (other: ComparedWith) => void;
  tolerance: (mm: number) => void;
  /** Shows the difference of this index. */
  show: (index: number) => void;
  /** Goes to the next difference or the one before. */
  walk: (by: 1 | -1) => void;
  /** Shows where the paths are furthest apart. */
  farthest: () => void;
  /** Shows a line of the other program. */
  read: (file: number, line: number) => void;
}

/** The value of an option of the choice. */
function keyOf(other: ComparedWith): string {
  return typeof other === "string" ? other : `machine ${other.machine ?? ""}`;
}

function otherOf(key: string): ComparedWith {
  if (key === "nothing" || key === "named") return key;
  return { machine: key.slice("machine ".length) || null };
}

function labelled(text: string, ...parts: HTMLElement[]): HTMLLabelElement {
  const label = element("label", "field", text);
  label.append(...parts);
  return label;
}

function button(text: string, label: string, act: () => void): HTMLButtonElement {
  const item = element("button", "", text);
  item.type = "button";
  item.title = label;
  if (text !== label) item.setAttribute("aria-label", label);
  item.addEventListener("click", act);
  return item;
}

/** Builds the pane into `root`. */
export function comparePanel(root: HTMLElement, handlers: CompareHandlers) {
  const against = element("select");
  against.id = "against";
  const tolerance = element("input");
  tolerance.id = "compare-tolerance";
  Object.assign(tolerance, { type: "number", min: "0", step: "any", value: "0" });
  const unit = element("span", "", "mm");
  const previous = iconButton("back", "Previous difference (P)", () => handlers.walk(-1));
  const next = iconButton("next", "Next difference (N)", () => handlers.walk(1));
  const position = element("span", "which");
  const controls = element("div", "controls");
  const walk = element("span", "walk");
  walk.append(previous, next, position);
  controls.append(labelled("Compare with", against), labelled("Tolerance", tolerance, unit), walk);
  const verdict = element("p", "verdict");
  const notes = element("div", "notes");
  const list = element("ul", "differences");
  root.append(controls, verdict, notes, list);

  let units: Units = { inch: false };
  let toleranceMm = 0;
  let shown: Comparison | undefined;
  const items: HTMLElement[] = [];

  against.addEventListener("change", () => handlers.choose(otherOf(against.value)));
  tolerance.addEventListener("change", () => {
    const value = Number(tolerance.value);
    if (!(value >= 0) || tolerance.value === "") return showTolerance();
    toleranceMm = units.inch ? value * MM_PER_INCH : value;
    handlers.tolerance(toleranceMm);
  });
  function showTolerance(): void {
    const value = units.inch ? toleranceMm / MM_PER_INCH : toleranceMm;
    tolerance.value = String(Number(value.toPrecision(4)));
    unit.textContent = units.inch ? "in" : "mm";
  }

  function differenceItem(difference: Difference, index: number, names: string[]): HTMLElement {
    const item = element("li", "difference");
    const show = element("button", "shows");
    show.type = "button";
    show.append(codeSpans(difference.head, "head"));
    for (const [side, { blocks, value, words, lacks, steps }] of difference.sides.entries()) {
      const line = element("span", "side");
      line.append(element("span", `swatch ${side === 0 ? "own" : "other"}`), element("span", "where", linesText(blocks)));
      if (value !== null) line.append(element("span", "value", value));
      line.append(element("code", "", lacks && blocks ? `no such block; it would come after ${words}` : words));
      if (steps > 1) line.append(element("span", "where", countText(steps, "block")));
      show.append(line);
    }
    show.addEventListener("click", () => handlers.show(index));
    item.append(show);
    const { blocks } = difference.sides[1];
    if (blocks) {
      const label = `Read line ${blocks.from} of ${names[1]}`;
      const read = button("Read", label, () => handlers.read(blocks.file, blocks.from));
      read.className = "read";
      item.append(read);
    }
    return item;
  }

  return {
    /** Sets the choice: the program of the command line, and machines. */
    offer({ compared: named, machines }: Pick<HelloMessage, "compared" | "machines">): void {
      const { value } = against;
      against.replaceChildren(new Option("nothing", "nothing"));
      if (named && !named.own_text) against.append(new Option(named.name.split(/[\\/]/).pop()!, "named"));
      if (named?.own_text) against.append(new Option("this program, as the command line says", "named"));
      const group = document.createElement("optgroup");
      group.label = "this program on another machine";
      group.append(new Option("the machine recognized from the program", "machine "));
      for (const { name, title } of machines) group.append(new Option(title, `machine ${name}`));
      against.append(group);
      if ([...against.options].some((option) => option.value === value)) against.value = value;
    },
    tolerance(mm: number): void {
      toleranceMm = mm;
      showTolerance();
    },
    /** Selects what was chosen; for the own text on the machine with this title. */
    chosen(other: ComparedWith, machine?: string): void {
      const key = keyOf(other);
      // A machine with units at power-on is in no list.
      if (![...against.options].some(({ value }) => value === key)) against.append(new Option(key.slice("machine ".length), key));
      against.value = key;
      const option = against.selectedOptions[0];
      if (option && other === "named" && machine) option.textContent = `this program on ${machine}`;
    },
    /** Shows that the comparison runs; the list of the one before stays until then. */
    waiting(): void {
      verdict.textContent = "Comparing…";
      verdict.className = "verdict waiting";
    },
    /** Shows a message instead of a comparison. */
    clear(message: string, isBad: boolean): void {
      setCodeSpans(verdict, message);
      verdict.className = `verdict ${isBad ? "different" : "waiting"}`;
      shown = undefined;
      items.length = 0;
      notes.replaceChildren();
      list.replaceChildren();
      position.textContent = "";
      previous.disabled = next.disabled = true;
    },
    show(comparison: Comparison, newUnits: Units): void {
      [shown, units] = [comparison, newUnits];
      showTolerance();
      setCodeSpans(verdict, comparison.headline);
      verdict.className = `verdict ${comparison.verdict}`;
      notes.replaceChildren();
      const names = comparison.sides.map(({ name }) => name);
      if (comparison.farthest) {
        const [a, b] = comparison.farthest.places;
        const text = `Furthest apart at line ${a!.line} of ${names[0]} and line ${b!.line} of ${names[1]}`;
        const link = button(text, text, handlers.farthest);
        link.className = "link";
        notes.append(link);
      }
      for (const { name, errors } of comparison.sides) {
        if (errors > 0) notes.append(element("p", "errors", `${name}: ${countText(errors, "error")}`));
      }
      items.length = 0;
      for (const [index, difference] of comparison.differences.slice(0, MAX_LISTED).entries()) items.push(differenceItem(difference, index, names));
      list.replaceChildren(...items);
      const more = comparison.dropped + comparison.differences.length - items.length;
      if (more > 0) notes.append(element("p", "more", `${count(items.length)} listed, ${countText(more, "more difference")} not listed`));
      previous.disabled = next.disabled = comparison.differences.length === 0;
      position.textContent = comparison.differences.length === 0 ? "" : countText(comparison.differences.length, "difference");
    },
    /** Highlights the difference of this index. */
    select(index: number): void {
      for (const [itemIndex, item] of items.entries()) {
        const isChosen = itemIndex === index;
        item.classList.toggle("chosen", isChosen);
        item.firstElementChild!.setAttribute("aria-current", String(isChosen));
        if (isChosen) item.scrollIntoView({ block: "nearest" });
      }
      position.textContent = `${count(index + 1)} of ${count(shown?.differences.length ?? 0)}`;
    },
  };
}

/** The legend of both paths, with a checkbox for each, and a button that ends the comparison. */
export function pathLegend(root: HTMLElement, handlers: { own: (shown: boolean) => void; other: (shown: boolean) => void; end: () => void }) {
  const makeSwitch = (side: "own" | "other", act: (shown: boolean) => void): [HTMLInputElement, HTMLElement, HTMLElement] => {
    const label = element("label", "check");
    const box = element("input");
    box.type = "checkbox";
    box.checked = true;
    box.id = `show-${side}`;
    box.addEventListener("change", () => act(box.checked));
    const swatch = element("span", `swatch ${side}`);
    const text = element("span");
    label.append(box, swatch, text);
    root.append(label);
    return [box, swatch, text];
  };
  root.setAttribute("role", "group");
  root.setAttribute("aria-label", "Paths");
  const [ownBox, ownSwatch, ownText] = makeSwitch("own", handlers.own);
  const [otherBox, , otherText] = makeSwitch("other", handlers.other);
  const end = iconButton("close", "Stop comparing", handlers.end);
  const differenceKey = element("span", "key");
  differenceKey.append(element("span", "swatch differs"), "different");
  differenceKey.hidden = true;
  root.append(differenceKey, end);
  root.hidden = true;
  return {
    hide(): void {
      root.hidden = true;
      // The own path must not stay hidden without the checkbox that says so.
      if (!ownBox.checked) handlers.own((ownBox.checked = true));
    },
    show(own: string, other: string): void {
      root.hidden = false;
      [ownText.textContent, otherText.textContent] = [own, other];
      handlers.other(otherBox.checked);
    },
    /** Shows the colour of differences in the legend, or not. */
    showDifferenceKey: (shown: boolean) => (differenceKey.hidden = !shown),
    color: (color: string) => (ownSwatch.style.color = color),
  };
}
