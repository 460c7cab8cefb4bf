// The controls of a lathe's half section, and the result of its simulation.

import { closeOnEscape, element } from "../panels/dom";
import { type Units, countText, volume } from "../panels/units";
import type { TurnedReport } from "../protocol/messages";
import type { HalfSections } from "./half-sections";

const VERDICT_TEXTS = { clean: "clean", problems: "problems, see Problems", "not-proved": "not proved, see Problems" } as const;

type VisiblePart = "stock" | "fixtures" | "target";

export function latheControls(show: (what: VisiblePart, shown: boolean) => void) {
  const root = element("details", "section");
  root.id = "turned";
  root.hidden = true;
  const summary = element("summary", "", "Stock");
  const choices = element("div", "choices");
  const rows = new Map<VisiblePart, HTMLElement[]>();
  for (const [what, name] of [["stock", "Show"], ["fixtures", "Fixtures"], ["target", "Target"]] as const) {
    const box = element("input");
    box.type = "checkbox";
    box.checked = true;
    box.id = `turned-${what}`;
    box.setAttribute("aria-label", what === "stock" ? "Show the stock" : `Show ${what === "target" ? "the target" : "fixtures"}`);
    box.addEventListener("change", () => show(what, box.checked));
    const pair = element("span", "pair");
    pair.append(box);
    rows.set(what, [element("span", "", name), pair]);
    choices.append(...rows.get(what)!);
  }
  const about = element("output", "about");
  const result = element("output", "about");
  result.setAttribute("aria-live", "polite");
  for (const line of [about, result]) choices.append(element("span", ""), line);
  root.append(summary, choices);
  closeOnEscape(root, summary);

  return {
    root,
    none(): void {
      root.hidden = true;
    },
    begin(sections: HalfSections): void {
      root.hidden = false;
      rows.get("fixtures")!.forEach((part) => (part.hidden = sections.fixtures.length === 0));
      rows.get("target")!.forEach((part) => (part.hidden = !sections.target));
      const omission = sections.isWhole ? "" : ". Of so many only those after each tool are shown";
      const threads = sections.threads.length > 0 ? ". Threads are thin lines" : "";
      about.textContent = `Exact, ${countText(sections.count, "pass", "passes")}${omission}${threads}`;
      result.textContent = "";
    },
    report({ verdict, removed_mm3: { least, most }, parts_off }: TurnedReport, units: Units): void {
      const off = parts_off > 0 ? `; ${countText(parts_off, "part")} cut off` : "";
      result.textContent = `${VERDICT_TEXTS[verdict]}; removed ${volume(units, least, most)}${off}`;
    },
  };
}
