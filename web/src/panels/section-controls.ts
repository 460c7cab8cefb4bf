// The choice which part of the path is shown: by tool, lines and Z.

import type { VisibleSection } from "../view/visible-section";
import { closeOnEscape, element } from "./dom";
import { type Units, length } from "./units";

const SLIDER_STEPS = 1000;

/** `onChange` is called with each new section; `cursorLine` gives the line of the cursor. */
export function sectionControls(onChange: (section: VisibleSection) => void, cursorLine: () => number) {
  const root = element("details", "section");
  const summary = element("summary", "", "Section");
  const choices = element("div", "choices");
  const tool = element("select");
  tool.id = "section-tool";
  const from = numberField("First line");
  const to = numberField("Last line");
  const toCursor = element("button", "", "to cursor");
  toCursor.type = "button";
  toCursor.title = "Up to the line of the cursor";
  const low = slider("Lowest depth", 0);
  const high = slider("Highest depth", SLIDER_STEPS);
  const depthText = element("output");
  const showAll = element("button", "", "Show all");
  showAll.type = "button";
  /** Lowest and highest Z, mm. */
  let range: [number, number] = [0, 0];
  let units: Units = { inch: false };

  const pair = (...parts: HTMLElement[]) => {
    const span = element("span", "pair");
    span.append(...parts);
    return span;
  };
  const row = (name: string, ...parts: HTMLElement[]) => choices.append(element("span", "", name), pair(...parts));
  row("Tool", tool);
  row("Lines", from, element("span", "", "to"), to, toCursor);
  row("From Z", low);
  row("To Z", high);
  row("", depthText, showAll);
  root.append(summary, choices);

  const depthAt = (input: HTMLInputElement) => range[0] + ((range[1] - range[0]) * Number(input.value)) / SLIDER_STEPS;
  function section(): VisibleSection {
    const limits: VisibleSection = {};
    if (tool.value !== "") limits.tool = Number(tool.value);
    if (from.value !== "" || to.value !== "") {
      limits.lines = [Number(from.value || 0), to.value === "" ? Number.MAX_SAFE_INTEGER : Number(to.value)];
    }
    if (low.value !== "0" || high.value !== String(SLIDER_STEPS)) {
      // A slider at its end means no limit, so that rounding cannot cut off the ends of the path.
      limits.depth = [
        low.value === "0" ? -Number.MAX_VALUE : depthAt(low),
        high.value === String(SLIDER_STEPS) ? Number.MAX_VALUE : depthAt(high),
      ];
    }
    return limits;
  }
  function update(): void {
    const current = section();
    root.classList.toggle("active", Object.keys(current).length > 0);
    depthText.textContent = `Z ${length(units, depthAt(low), false)} to ${length(units, depthAt(high))}`;
    onChange(current);
  }
  for (const input of [tool, from, to, low, high]) input.addEventListener("input", update);
  toCursor.addEventListener("click", () => {
    to.value = String(cursorLine());
    update();
  });
  showAll.addEventListener("click", () => {
    tool.value = from.value = to.value = "";
    low.value = "0";
    high.value = String(SLIDER_STEPS);
    update();
  });
  closeOnEscape(root, summary);

  return {
    root,
    /** Sets tools, range of Z and units of a new path; the chosen tool stays chosen if the path has it. */
    offer(tools: number[], zRange: [number, number], newUnits: Units): void {
      const before = tool.value;
      tool.replaceChildren(new Option("all", ""));
      for (const number of tools) tool.append(new Option(number === 0 ? "no tool" : `T${number}`, String(number)));
      tool.value = tools.map(String).includes(before) ? before : "";
      [range, units] = [zRange, newUnits];
      depthText.textContent = `Z ${length(units, depthAt(low), false)} to ${length(units, depthAt(high))}`;
      if (root.classList.contains("active")) update();
    },
  };
}

function numberField(label: string): HTMLInputElement {
  const input = element("input");
  input.type = "number";
  input.min = "1";
  input.placeholder = label === "First line" ? "first" : "last";
  input.setAttribute("aria-label", label);
  return input;
}

function slider(label: string, value: number): HTMLInputElement {
  const input = element("input");
  input.type = "range";
  input.min = "0";
  input.max = String(SLIDER_STEPS);
  input.value = String(value);
  input.setAttribute("aria-label", label);
  return input;
}
