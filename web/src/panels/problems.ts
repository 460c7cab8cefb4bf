// The panel of problems: by code, errors first, with a choice of severities.

import type { Problem, RunReport } from "../protocol/messages";
import { codeSpans } from "./code-spans";
import { element } from "./dom";
import { notVerified } from "./program-panels";
import { count, countText } from "./units";

type Severity = Problem["severity"];

const SEVERITIES: readonly Severity[] = ["error", "warning", "note"];

/** Other places of a code that its list names. */
const MAX_PLACES = 300;

/** The problems of one code and severity, by place. */
export interface ProblemGroup {
  severity: Severity;
  code: string;
  problems: Problem[];
}

/** Problems by code: errors, then warnings, then notes; within a severity by the first place. */
export function groups(problems: readonly Problem[]): ProblemGroup[] {
  const found = new Map<string, ProblemGroup>();
  for (const problem of problems) {
    const { severity, code } = problem;
    const key = `${severity} ${code}`;
    const group = found.get(key);
    if (group) group.problems.push(problem);
    else found.set(key, { severity, code, problems: [problem] });
  }
  const order = (group: ProblemGroup): number => SEVERITIES.indexOf(group.severity);
  return [...found.values()].sort((one, other) => order(one) - order(other));
}

function placeOf(problem: Problem): string {
  const { place } = problem;
  if (!place) return "program";
  return `line ${count(place.line)}${place.own ? "" : ` of ${place.file}`}`;
}

export class ProblemPanel {
  /** Severities that the reader does not want to see. */
  private readonly hidden = new Set<Severity>();

  constructor(
    private readonly root: HTMLElement,
    private readonly go: (problem: Problem) => void,
  ) {}

  show(report: RunReport | undefined, refused: { message: string; help?: string | null } | undefined): void {
    this.root.replaceChildren();
    if (refused) {
      const item = element("p", "refused");
      item.append(codeSpans(refused.message, "", "strong"));
      if (refused.help) item.append(codeSpans(` ${refused.help}`, "help"));
      this.root.append(item);
    }
    if (!report) return;
    const unknown = notVerified(report);
    if (unknown) this.root.append(element("p", "refused", unknown));
    if (report.diagnostics.length === 0 && !refused) {
      this.root.append(element("p", "clean", "No problems found: this machine would run the program."));
    }
    const list = element("ul", "problems");
    for (const group of groups(report.diagnostics)) list.append(this.group(group));
    this.root.append(...this.filter(report, list), list);
    if (report.left_out > 0) this.root.append(element("p", "more", `${countText(report.left_out, "more problem")} not listed`));
    for (const line of report.output.slice(0, 50)) this.root.append(element("p", "output", line));
  }

  /** Buttons that show or hide a severity, where there is more than one. */
  private filter(report: RunReport, list: HTMLElement): HTMLElement[] {
    const counts: Record<Severity, number> = { error: report.errors, warning: report.warnings, note: report.notes };
    const present = SEVERITIES.filter((severity) => counts[severity] > 0);
    if (present.length < 2) return [];
    const row = element("div", "filter");
    row.setAttribute("role", "group");
    row.setAttribute("aria-label", "Show");
    for (const severity of present) {
      const button = element("button", severity, countText(counts[severity], severity));
      button.type = "button";
      const apply = (): void => {
        const shown = !this.hidden.has(severity);
        button.setAttribute("aria-pressed", String(shown));
        list.classList.toggle(`without-${severity}`, !shown);
      };
      button.addEventListener("click", () => {
        if (!this.hidden.delete(severity)) this.hidden.add(severity);
        apply();
      });
      apply();
      row.append(button);
    }
    return [row];
  }

  /** The first problem in full, and after it the other places. */
  private group({ severity, code, problems }: ProblemGroup): HTMLElement {
    const item = element("li", `of-${severity}`);
    const [first, ...others] = problems;
    item.append(this.whole(first!));
    if (others.length === 0) return item;
    const rest = element("details", "others");
    rest.append(element("summary", "", `${code} in ${countText(others.length, "more place")}`));
    // Made when it is opened: hundreds of places are not looked at in most programs.
    rest.addEventListener(
      "toggle",
      () => {
        const places = element("ul");
        for (const problem of others.slice(0, MAX_PLACES)) places.append(this.short(problem));
        rest.append(places);
      },
      { once: true },
    );
    item.append(rest);
    return item;
  }

  private whole(problem: Problem): HTMLElement {
    const button = element("button", `problem ${problem.severity}`);
    button.type = "button";
    button.append(element("span", "severity", problem.severity), element("span", "where", placeOf(problem)));
    button.append(codeSpans(problem.message, "message"));
    if (problem.alarm) button.append(codeSpans(`The control shows: ${problem.alarm}`, "alarm"));
    if (problem.help) button.append(codeSpans(problem.help, "help"));
    button.addEventListener("click", () => this.go(problem));
    return button;
  }

  private short(problem: Problem): HTMLElement {
    const item = element("li");
    const button = element("button", `problem short ${problem.severity}`);
    button.type = "button";
    button.append(element("span", "where", placeOf(problem)), codeSpans(problem.message, "message"));
    button.addEventListener("click", () => this.go(problem));
    item.append(button);
    return item;
  }
}
