// The panel of problems: grouped by code, errors first, with a filter of severities.

import type { Problem, RunReport } from "../protocol/messages";
import { codeSpans } from "./code-spans";
import { element } from "./dom";
import { notVerified } from "./program-panels";
import { count, countText } from "./units";

type Severity = Problem["severity"];

const SEVERITIES: readonly Severity[] = ["error", "warning", "note"];

/** Further occurrences of a code that are listed at most. */
const MAX_OCCURRENCES = 300;
/** Lines of program output that are listed at most. */
const MAX_OUTPUT_LINES = 50;

/** The problems of one code and severity, in source order. */
export interface ProblemGroup {
  severity: Severity;
  code: string;
  problems: Problem[];
}

/** Groups problems by code: errors, then warnings, then notes; within a severity by the first occurrence. */
export function problemGroups(problems: readonly Problem[]): ProblemGroup[] {
  const groups = new Map<string, ProblemGroup>();
  for (const problem of problems) {
    const { severity, code } = problem;
    const key = `${severity} ${code}`;
    const group = groups.get(key);
    if (group) group.problems.push(problem);
    else groups.set(key, { severity, code, problems: [problem] });
  }
  const order = (group: ProblemGroup): number => SEVERITIES.indexOf(group.severity);
  return [...groups.values()].sort((one, other) => order(one) - order(other));
}

function placeOf(problem: Problem): string {
  const { place } = problem;
  if (!place) return "program";
  return `line ${count(place.line)}${place.own ? "" : ` of ${place.file}`}`;
}

export class ProblemPanel {
  /** Severities that the user has switched off. */
  private readonly hidden = new Set<Severity>();

  constructor(
    private readonly root: HTMLElement,
    private readonly goTo: (problem: Problem) => void,
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
    const unverified = notVerified(report);
    if (unverified) this.root.append(element("p", "refused", unverified));
    if (report.diagnostics.length === 0 && !refused) {
      this.root.append(element("p", "clean", "No problems found: this machine would run the program."));
    }
    const list = element("ul", "problems");
    for (const group of problemGroups(report.diagnostics)) list.append(this.group(group));
    this.root.append(...this.filter(report, list), list);
    if (report.left_out > 0) this.root.append(element("p", "more", `${countText(report.left_out, "more problem")} not listed`));
    for (const line of report.output.slice(0, MAX_OUTPUT_LINES)) this.root.append(element("p", "output", line));
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

  /** The first problem in full, followed by the other occurrences. */
  private group({ severity, code, problems }: ProblemGroup): HTMLElement {
    const item = element("li", `of-${severity}`);
    const [first, ...others] = problems;
    item.append(this.fullItem(first!));
    if (others.length === 0) return item;
    const rest = element("details", "others");
    rest.append(element("summary", "", `${code} in ${countText(others.length, "more place")}`));
    // Filled when it is opened, because most users never open a list of hundreds.
    rest.addEventListener(
      "toggle",
      () => {
        const list = element("ul");
        for (const problem of others.slice(0, MAX_OCCURRENCES)) list.append(this.shortItem(problem));
        rest.append(list);
      },
      { once: true },
    );
    item.append(rest);
    return item;
  }

  private fullItem(problem: Problem): HTMLElement {
    const button = element("button", `problem ${problem.severity}`);
    button.type = "button";
    button.append(element("span", "severity", problem.severity), element("span", "where", placeOf(problem)));
    button.append(codeSpans(problem.message, "message"));
    if (problem.alarm) button.append(codeSpans(`The control shows: ${problem.alarm}`, "alarm"));
    if (problem.help) button.append(codeSpans(problem.help, "help"));
    button.addEventListener("click", () => this.goTo(problem));
    return button;
  }

  private shortItem(problem: Problem): HTMLElement {
    const item = element("li");
    const button = element("button", `problem short ${problem.severity}`);
    button.type = "button";
    button.append(element("span", "where", placeOf(problem)), codeSpans(problem.message, "message"));
    button.addEventListener("click", () => this.goTo(problem));
    item.append(button);
    return item;
  }
}
