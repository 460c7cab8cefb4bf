// The pane "Compare": what the program is compared with, the answer, and the differences one by one.

import { codeSpans, setCodeSpans } from "../panels/code-spans";
import { element } from "../panels/dom";
import { signButton } from "../panels/icons";
import { type Units, count, countText } from "../panels/units";
import type { ComparedWith, Comparison, Difference, HelloMessage } from "../protocol/messages";
import { linesText } from "./difference-ranges";

const MM_PER_INCH = 25.4;
/** Differences that are listed; more are counted. */
const MAX_LISTED = 300;

export interface CompareHandlers {
  /** The program is to be compared with something else. */
  choose: (other: ComparedWith) => void;
  tolerance: (mm: number) => void;
  /** A difference is to be shown, by its number. */
  show: (index: number) => void;
  /** The next one, or the one before. */
  walk: (by: 1 | -1) => void;
  farthest: () => void;
  /** A line of the other program is to be read. */
  read: (file: number, line: number) => void;
}

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
  const made = element("button", "", text);
  made.type = "button";
  made.title = label;
  if (text !== label) made.setAttribute("aria-label", label);
  made.addEventListener("click", act);
  return made;
}

/** Builds the pane into `root`. */
export function comparePanel(root: HTMLElement, handlers: CompareHandlers) {
  const against = element("select");
  against.id = "against";
  const tolerance = element("input");
  tolerance.id = "compare-tolerance";
  Object.assign(tolerance, { type: "number", min: "0", step: "any", value: "0" });
  const unit = element("span", "", "mm");
  const back = signButton("back", "Previous difference (P)", () => handlers.walk(-1));
  const forth = signButton("next", "Next difference (N)", () => handlers.walk(1));
  const which = element("span", "which");
  const controls = element("div", "controls");
  const walk = element("span", "walk");
  walk.append(back, forth, which);
  controls.append(labelled("Compare with", against), labelled("Tolerance", tolerance, unit), walk);
  const verdict = element("p", "verdict");
  const notes = element("div", "notes");
  const list = element("ul", "differences");
  root.append(controls, verdict, notes, list);

  let units: Units = { inch: false };
  let toleranceMm = 0;
  let shown: Comparison | undefined;
  const rows: HTMLElement[] = [];

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

  function row(difference: Difference, index: number, names: string[]): HTMLElement {
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
    /** What there is to choose from. */
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
    /** What was chosen; the same text, on the machine of this title. */
    chosen(other: ComparedWith, machine?: string): void {
      const key = keyOf(other);
      // A machine with units is in no list.
      if (![...against.options].some(({ value }) => value === key)) against.append(new Option(key.slice("machine ".length), key));
      against.value = key;
      const option = against.selectedOptions[0];
      if (option && other === "named" && machine) option.textContent = `this program on ${machine}`;
    },
    /** The answer is still to come; the one before stays until then. */
    waiting(): void {
      verdict.textContent = "Comparing…";
      verdict.className = "verdict waiting";
    },
    /** There is no answer; the message says why. */
    clear(message: string, isBad: boolean): void {
      setCodeSpans(verdict, message);
      verdict.className = `verdict ${isBad ? "different" : "waiting"}`;
      shown = undefined;
      rows.length = 0;
      notes.replaceChildren();
      list.replaceChildren();
      which.textContent = "";
      back.disabled = forth.disabled = true;
    },
    show(found: Comparison, own: Units): void {
      [shown, units] = [found, own];
      showTolerance();
      setCodeSpans(verdict, found.headline);
      verdict.className = `verdict ${found.verdict}`;
      notes.replaceChildren();
      const names = found.sides.map(({ name }) => name);
      if (found.farthest) {
        const [a, b] = found.farthest.places;
        const text = `Furthest apart at line ${a!.line} of ${names[0]} and line ${b!.line} of ${names[1]}`;
        const link = button(text, text, handlers.farthest);
        link.className = "link";
        notes.append(link);
      }
      for (const { name, errors } of found.sides) {
        if (errors > 0) notes.append(element("p", "errors", `${name}: ${countText(errors, "error")}`));
      }
      rows.length = 0;
      for (const [index, difference] of found.differences.slice(0, MAX_LISTED).entries()) rows.push(row(difference, index, names));
      list.replaceChildren(...rows);
      const more = found.dropped + found.differences.length - rows.length;
      if (more > 0) notes.append(element("p", "more", `${count(rows.length)} listed, ${countText(more, "more difference")} not listed`));
      back.disabled = forth.disabled = found.differences.length === 0;
      which.textContent = found.differences.length === 0 ? "" : countText(found.differences.length, "difference");
    },
    /** One is chosen. */
    select(index: number): void {
      for (const [at, item] of rows.entries()) {
        const isChosen = at === index;
        item.classList.toggle("chosen", isChosen);
        item.firstElementChild!.setAttribute("aria-current", String(isChosen));
        if (isChosen) item.scrollIntoView({ block: "nearest" });
      }
      which.textContent = `${count(index + 1)} of ${count(shown?.differences.length ?? 0)}`;
    },
  };
}

/** Which path is which, with a switch for each and an end to it all. */
export function pathLegend(root: HTMLElement, handlers: { own: (shown: boolean) => void; other: (shown: boolean) => void; end: () => void }) {
  const made = (side: "own" | "other", act: (shown: boolean) => void): [HTMLInputElement, HTMLElement, HTMLElement] => {
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
  const [ownBox, ownSwatch, ownText] = made("own", handlers.own);
  const [otherBox, , otherText] = made("other", handlers.other);
  const end = signButton("close", "Stop comparing", handlers.end);
  const differenceKey = element("span", "key");
  differenceKey.append(element("span", "swatch differs"), "different");
  differenceKey.hidden = true;
  root.append(differenceKey, end);
  root.hidden = true;
  return {
    hide(): void {
      root.hidden = true;
      // Nothing may stay hidden without a switch that says so.
      if (!ownBox.checked) handlers.own((ownBox.checked = true));
    },
    show(own: string, other: string): void {
      root.hidden = false;
      [ownText.textContent, otherText.textContent] = [own, other];
      handlers.other(otherBox.checked);
    },
    /** Whether the two paths differ anywhere. */
    showDifferenceKey: (is: boolean) => (differenceKey.hidden = !is),
    color: (color: string) => (ownSwatch.style.color = color),
  };
}
