// The question which control a program is for, where it is ambiguous, with the candidates side by side. The run does not wait for
// an answer.

import type { MachineChoice, ProgramReadings } from "../protocol/messages";
import { codeSpans, setCodeSpans } from "./code-spans";
import { element } from "./dom";
import { count, countText } from "./units";

/** What to do about the readings of a run. */
export type ReadingsStep = { do: "ask"; readings: ProgramReadings } | { do: "read"; machine: MachineChoice } | { do: "nothing" };

/** The questions that were answered since the page was loaded, and the answers. */
export class AnsweredReadings {
  /** By question: the machine that was picked; undefined where the assumed reading was kept. */
  private readonly answers = new Map<string, MachineChoice | undefined>();
  private isAnswered = false;
  private question = "";

  /** Begins with another program. */
  opened(): void {
    this.isAnswered = false;
    this.question = "";
  }

  /** What to do about the readings of a run of a program. */
  next(program: string, readings: ProgramReadings | null): ReadingsStep {
    // Readings change while the program is edited; one answer is enough.
    if (!readings || this.isAnswered) return { do: "nothing" };
    this.question = JSON.stringify([program, readings]);
    if (!this.answers.has(this.question)) return { do: "ask", readings };
    this.isAnswered = true;
    const machine = this.answers.get(this.question);
    return machine ? { do: "read", machine } : { do: "nothing" };
  }

  /** Records the answer; undefined keeps the assumed reading. */
  answer(machine: MachineChoice | undefined): void {
    if (this.question !== "") this.answers.set(this.question, machine);
    this.isAnswered = true;
  }
}

/** The text above the columns. */
export function introduction({ message, line, block, more }: Pick<ProgramReadings, "message" | "line" | "block" | "more">): string {
  const sentence = `${message.slice(0, 1).toUpperCase()}${message.slice(1)}.`;
  const first = line === null ? "" : ` The first block that differs is line ${count(line)}${block ? `, \`${block}\`` : ""}.`;
  return `${sentence}${first}${more > 0 ? ` ${countText(more, "more reading")} not shown.` : ""}`;
}

/** The rows of a column: label and text. */
export function columnRows({ size, motion }: ProgramReadings["shown"][number], line: number | null): [string, string][] {
  return [
    ["Cuts", size ?? "size not known"],
    [line === null ? "Moves" : `Line ${count(line)}`, motion],
  ];
}

export interface ReadingsHandlers {
  /** Reads the program for this machine. */
  read: (machine: MachineChoice) => void;
  /** Moves the focus when the panel is closed. */
  leave: () => void;
}

/** The panel of this question. */
export function readingsPanel(root: HTMLElement, handlers: ReadingsHandlers) {
  const answered = new AnsweredReadings();
  const title = element("h2", "", "How should this program be read?");
  title.id = "readings-title";
  title.tabIndex = -1;
  const text = element("p", "readings-text");
  text.id = "readings-text";
  // A screen reader announces it, without taking the focus from a text field.
  text.setAttribute("role", "status");
  const keep = element("button", "keep", "Keep the assumed one");
  Object.assign(keep, { type: "button", title: "The program stays not verified (Esc)" });
  const list = element("ul", "readings-list");
  const head = element("div", "readings-head");
  head.append(title, keep);
  root.setAttribute("role", "region");
  root.setAttribute("aria-labelledby", title.id);
  root.setAttribute("aria-describedby", text.id);
  root.append(head, text, list);

  function close(): void {
    const hadFocus = root.contains(document.activeElement);
    root.hidden = true;
    if (hadFocus) handlers.leave();
  }

  function pick(machine: MachineChoice | undefined): void {
    answered.answer(machine);
    close();
    if (machine) handlers.read(machine);
  }

  function column(reading: ProgramReadings["shown"][number], line: number | null, isAssumed: boolean): HTMLElement {
    const item = element("li", "reading");
    const name = element("h3", "", reading.title);
    if (isAssumed) name.append(" ", element("span", "assumed", "assumed"));
    const rows = element("dl");
    for (const [label, value] of columnRows(reading, line)) rows.append(element("dt", "", label), codeSpans(value, "", "dd"));
    const use = element("button", "use", `Use ${reading.machine.title}`);
    Object.assign(use, { type: "button", title: `Read the program as for ${reading.title}` });
    use.addEventListener("click", () => pick(reading.machine));
    item.append(name, rows, use);
    return item;
  }

  function show(readings: ProgramReadings): void {
    const hadFocus = root.contains(document.activeElement);
    setCodeSpans(text, introduction(readings));
    list.replaceChildren(...readings.shown.map((reading, index) => column(reading, readings.line, index === 0)));
    root.hidden = false;
    // The question takes the focus where nothing else has it.
    if (hadFocus || document.activeElement === document.body) title.focus();
  }

  keep.addEventListener("click", () => pick(undefined));
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    pick(undefined);
  });

  return {
    opened(): void {
      answered.opened();
      close();
    },
    /** Shows the question of a run, once. */
    programRun(program: string, readings: ProgramReadings | null): void {
      const step = answered.next(program, readings);
      if (step.do === "ask") return show(step.readings);
      close();
      if (step.do === "read") handlers.read(step.machine);
    },
    /** Takes the choice in the list of machines as an answer. */
    machineChosen(machine: MachineChoice | undefined): void {
      answered.answer(machine);
      close();
    },
  };
}
