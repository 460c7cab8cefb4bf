import { ChordalError } from "./error.js";
import { bytesOf, questionOf, type Ask, type File, type Program, type Text } from "./question.js";
import { setpointsOf, tableOf, type Setpoints, type Table } from "./table.js";
import type {
  Check, CompareOptions, Comparison, Conversion, ConvertOptions, Machine, MachineName, ProgramOptions, Run, SampleOptions,
  Time, TimeOptions,
} from "./types.js";

/** An object or a table. */
type AsObject = { format?: "object" };
/** A text, as the command prints it. */
type As<F extends string> = { format: F };

/** Everything that can be asked. Each answer is a promise; what cannot be answered is a `ChordalError`. */
export interface Chordal {
  /** The problems of a program. */
  check(text: Text, options?: ProgramOptions & AsObject): Promise<Check>;
  check(text: Text, options: ProgramOptions & As<"json" | "text" | "github" | "gitlab" | "sarif">): Promise<string>;
  /** The problems of a program and what it comes to. */
  run(text: Text, options?: ProgramOptions & AsObject): Promise<Run>;
  run(text: Text, options: ProgramOptions & As<"json">): Promise<string>;
  /** The commands that the control makes, one row each. */
  commands(text: Text, options?: ProgramOptions & AsObject): Promise<Table>;
  commands(text: Text, options: ProgramOptions & As<"jsonl" | "csv" | "canon">): Promise<string>;
  /** The commands of the tool centre, after cutter compensation, one row each. */
  path(text: Text, options?: ProgramOptions & AsObject): Promise<Table>;
  path(text: Text, options: ProgramOptions & As<"jsonl" | "csv">): Promise<string>;
  /** The exact path, one row for each curve: enough to make every curve again. */
  curves(text: Text, options?: ProgramOptions & AsObject): Promise<Table>;
  /** How long a program takes, where and why. */
  time(text: Text, options?: ProgramOptions & TimeOptions & AsObject): Promise<Time>;
  time(text: Text, options: ProgramOptions & TimeOptions & As<"json">): Promise<string>;
  /** The setpoints of the axes at a period, one row each. */
  sample(text: Text, options?: ProgramOptions & SampleOptions & AsObject): Promise<Setpoints>;
  sample(text: Text, options: ProgramOptions & SampleOptions & As<"csv" | "jsonl">): Promise<string>;
  /** How far apart the motions of two programs are, and what else differs. */
  compare(a: Text, b: Text, options?: CompareOptions & AsObject): Promise<Comparison>;
  compare(a: Text, b: Text, options: CompareOptions & As<"json" | "text">): Promise<string>;
  /** A program for another machine, with the proof that the motion is the same. */
  convert(text: Text, options: ConvertOptions & AsObject): Promise<Conversion>;
  convert(text: Text, options: ConvertOptions & As<"json">): Promise<string>;
  /** What a message, a code, a letter, a setting or an alarm means. */
  explain(word: string, options?: { machine?: string; files?: ProgramOptions["files"] }): Promise<string>;
  /** The built-in machines. */
  machines(): Promise<MachineName[]>;
  /** A built-in machine, or one of a machine file among `files`. */
  machine(name: string, options?: { files?: ProgramOptions["files"] }): Promise<Machine>;
}

/** The options that belong to a program and not to a question. */
const OF_PROGRAM = ["name", "machine", "set", "tools", "settings", "program", "blockDelete", "maxBlocks"];

type Options = Record<string, unknown>;

/** The functions over whoever answers. */
export function chordal(ask: Ask): Chordal {
  const aboutOne = async (name: string, text: unknown, given: unknown, parse: (answer: { text: string; parts: ArrayBuffer[] }) => unknown): Promise<unknown> => {
    const { files, ...options } = optionsOf(given);
    const [program, others] = programOf(text, options);
    const answer = await ask(questionOf(name, [program], filesOf(files), others));
    return isObject(options) ? parse(answer) : answer.text;
  };
  const json = (answer: { text: string }): unknown => JSON.parse(answer.text);
  const functions = {
    check: (text: unknown, options?: unknown) => aboutOne("check", text, options, json),
    run: (text: unknown, options?: unknown) => aboutOne("run", text, options, json),
    commands: (text: unknown, options?: unknown) => aboutOne("commands", text, options, tableOf),
    path: (text: unknown, options?: unknown) => aboutOne("path", text, options, tableOf),
    curves: (text: unknown, options?: unknown) => aboutOne("curves", text, options, tableOf),
    time: (text: unknown, options?: unknown) => aboutOne("time", text, options, json),
    sample: (text: unknown, options?: unknown) => aboutOne("sample", text, options, setpointsOf),
    convert: (text: unknown, options?: unknown) => aboutOne("convert", text, options, json),
    compare: async (a: unknown, b: unknown, given?: unknown) => {
      const { a: ofA, b: ofB, ...options } = optionsOf(given);
      const sides = [ofA, ofB].map((of) => optionsOf(of));
      const programs = [a, b].map((text, side) => {
        const { files: _, ...own } = sides[side] ?? {};
        const [program, others] = programOf(text, own);
        // What a program does not take is named as it is for one program.
        return { ...program, options: { ...program.options, ...others } };
      });
      const files = Object.assign({}, ...sides.map((side) => side["files"] ?? {}));
      const answer = await ask(questionOf("compare", programs, filesOf(files), options));
      return isObject(options) ? json(answer) : answer.text;
    },
    explain: async (word: unknown, given?: unknown) => {
      const { files, ...options } = optionsOf(given);
      return (await ask(questionOf("explain", [], filesOf(files), { word, ...options }))).text;
    },
    machines: async () => json(await ask(questionOf("machines", [], [], {}))),
    machine: async (name: unknown, given?: unknown) => {
      const { files, ...options } = optionsOf(given);
      return json(await ask(questionOf("machine", [], filesOf(files), { name, ...options })));
    },
  };
  return functions as Chordal;
}

function isObject(options: Options): boolean {
  return options["format"] === undefined || options["format"] === "object";
}

function optionsOf(given: unknown): Options {
  if (given === undefined) return {};
  if (typeof given !== "object" || given === null || Array.isArray(given)) {
    throw new ChordalError("use", `the options are ${given === null ? "null" : `a ${typeof given}`}`, "give an object, or nothing");
  }
  return { ...given };
}

/** A program with its options, and the options of the question. */
function programOf(text: unknown, options: Options): [Program, Options] {
  const own: Options = {};
  const others: Options = {};
  for (const [name, value] of Object.entries(options)) {
    if (value !== undefined) (OF_PROGRAM.includes(name) ? own : others)[name] = value;
  }
  return [{ options: own, text: bytesOf(text, "the program") }, others];
}

function filesOf(given: unknown): File[] {
  return Object.entries(optionsOf(given)).map(([path, text]) => ({ path, text: bytesOf(text, `the file ${path}`) }));
}
