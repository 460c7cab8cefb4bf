// Which part of the path is shown: by tool, by lines, by depth.

import type { VisibleSection } from "../view/visible-section";
import { closesOnEscape, element } from "./dom";
import { type Units, length } from "./units";

const SLIDER_STEPS = 1000;

export function sectionControls(changed: (section: VisibleSection) => void, cursor: () => number) {
  const root = element("details", "section");
  const summary = element("summary", "", "Section");
  const choices = element("div", "choices");
  const tool = element("select");
  tool.id = "section-tool";
  const from = numberField("First line");
  const to = numberField("Last line");
  const here = element("button", "", "to cursor");
  here.type = "button";
  here.title = "Up to the line of the cursor";
  const low = slider("Lowest depth", 0);
  const high = slider("Highest depth", SLIDER_STEPS);
  const depthText = element("output");
  const all = element("button", "", "Show all");
  all.type = "button";
  let range: [number, number] = [0, 0];
  let units: Units = { inch: false };

  const pair = (...parts: HTMLElement[]) => {
    const made = element("span", "pair");
    made.append(...parts);
    return made;
  };
  const row = (name: string, ...parts: HTMLElement[]) => choices.append(element("span", "", name), pair(...parts));
  row("Tool", tool);
  row("Lines", from, element("span", "", "to"), to, here);
  row("From Z", low);
  row("To Z", high);
  row("", depthText, all);
  root.append(summary, choices);

  const depthAt = (input: HTMLInputElement) => range[0] + ((range[1] - range[0]) * Number(input.value)) / SLIDER_STEPS;
  function section(): VisibleSection {
    const made: VisibleSection = {};
    if (tool.value !== "") made.tool = Number(tool.value);
    if (from.value !== "" || to.value !== "") {
      made.lines = [Number(from.value || 0), to.value === "" ? Number.MAX_SAFE_INTEGER : Number(to.value)];
    }
    if (low.value !== "0" || high.value !== String(SLIDER_STEPS)) {
      // A slider at its end means no limit, whatever rounding makes of the depth there.
      made.depth = [
        low.value === "0" ? -Number.MAX_VALUE : depthAt(low),
        high.value === String(SLIDER_STEPS) ? Number.MAX_VALUE : depthAt(high),
      ];
    }
    return made;
  }
  function update(): void {
    const made = section();
    root.classList.toggle("active", Object.keys(made).length > 0);
    depthText.textContent = `Z ${length(units, depthAt(low), false)} to ${length(units, depthAt(high))}`;
    changed(made);
  }
  for (const input of [tool, from, to, low, high]) input.addEventListener("input", update);
  here.addEventListener("click", () => {
    to.value = String(cursor());
    update();
  });
  all.addEventListener("click", () => {
    tool.value = from.value = to.value = "";
    low.value = "0";
    high.value = String(SLIDER_STEPS);
    update();
  });
  closesOnEscape(root, summary);

  return {
    root,
    /** What there is to choose from; the tool that was chosen stays chosen if the new path has it. */
    offer(tools: number[], depth: [number, number], own: Units): void {
      const before = tool.value;
      tool.replaceChildren(new Option("all", ""));
      for (const number of tools) tool.append(new Option(number === 0 ? "no tool" : `T${number}`, String(number)));
      tool.value = tools.map(String).includes(before) ? before : "";
      [range, units] = [depth, own];
      depthText.textContent = `Z ${length(units, depthAt(low), false)} to ${length(units, depthAt(high))}`;
      if (root.classList.contains("active")) update();
    },
  };
}

function numberField(label: string): HTMLInputElement {
  const made = element("input");
  made.type = "number";
  made.min = "1";
  made.placeholder = label === "First line" ? "first" : "last";
  made.setAttribute("aria-label", label);
  return made;
}

function slider(label: string, value: number): HTMLInputElement {
  const made = element("input");
  made.type = "range";
  made.min = "0";
  made.max = String(SLIDER_STEPS);
  made.value = String(value);
  made.setAttribute("aria-label", label);
  return made;
}
