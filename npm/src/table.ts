import type { Check } from "./types.js";
import type { Answer } from "./question.js";

/** Numbers of a column as they are, one for each row. */
export type Values = Float64Array | Uint32Array | Int16Array | Int8Array | Uint8Array;

/** What a column holds: doubles, whole numbers, words of a small set, names of files, yes and no, or texts. */
export type ColumnKind = "number" | "integer" | "word" | "file" | "flag" | "text";

/** A column of a table. Its meaning is in docs/columns.md. */
export class Column {
  constructor(
    readonly name: string,
    /** `mm`, `deg`, `mm/min`, `s`; null where it has none. */
    readonly unit: string | null,
    readonly kind: ColumnKind,
    /**
     * A number: Float64Array, NaN where there is none. Whole number: Uint32Array. Word: Int8Array and file:
     * Int16Array, places in `words`. Flag: Uint8Array, 0 and 1. Text: empty, see `words`.
     */
    readonly values: Values,
    /** The words of a `word` or `file`, or the text of each row. */
    readonly words: readonly (string | null)[] | null,
    /** 1 where a row has a value; null where all have. */
    readonly valid: Uint8Array | null,
  ) {}

  /** The value of a row for people: null where there is none. */
  at(row: number): number | string | boolean | null {
    if (this.valid !== null && this.valid[row] !== 1) return null;
    const value = this.values[row];
    switch (this.kind) {
      case "text":
        return this.words?.[row] ?? null;
      case "word":
      case "file":
        return value === undefined ? null : (this.words?.[value] ?? null);
      case "flag":
        return value === undefined ? null : value === 1;
      case "number":
      case "integer":
        return value === undefined || Number.isNaN(value) ? null : value;
    }
  }
}

/** Rows as columns. */
export class Table {
  /** The columns by their names, in their order. */
  readonly columns: Readonly<Record<string, Column>>;

  constructor(
    /** Name and version of the columns, such as `chordal.commands/1`. */
    readonly schema: string,
    readonly rows: number,
    readonly machine: string,
    readonly control: string,
    /** SHA-256 of the program's text. */
    readonly sha256: string,
    columns: readonly Column[],
    /** The problems of the program. */
    readonly report: Check,
  ) {
    this.columns = Object.fromEntries(columns.map((column) => [column.name, column]));
  }

  /** A column that must be there. */
  column(name: string): Column {
    const column = this.columns[name];
    if (column === undefined) {
      throw new RangeError(`there is no column ${name}; there are ${Object.keys(this.columns).join(", ")}`);
    }
    return column;
  }

  /** A row as an object. */
  row(index: number): Record<string, number | string | boolean | null> {
    return Object.fromEntries(Object.values(this.columns).map((column) => [column.name, column.at(index)]));
  }
}

/** Setpoints, and what they came to. */
export class Setpoints extends Table {
  constructor(
    table: Table,
    /** Time of the run, s. */
    readonly time_s: number,
    /** How far the tool is from the path at most when the axes go straight from one setpoint to the next, mm. */
    readonly chord_mm: number,
    /** The line of that place. */
    readonly chord_line: number,
  ) {
    super(table.schema, table.rows, table.machine, table.control, table.sha256, Object.values(table.columns), table.report);
  }
}

/** What the text of an answer says of its columns. */
interface Head {
  schema: string;
  rows: number;
  machine: string;
  control: string;
  program_sha256: string;
  report: Check;
  time_s?: number;
  chord_mm?: number;
  chord_line?: number;
  columns: {
    name: string;
    unit: string | null;
    kind: ColumnKind;
    part: number | null;
    valid: number | null;
    words: (string | null)[] | null;
  }[];
}

/** The table of an answer. */
export function tableOf(answer: Answer): Table {
  return tableFrom(JSON.parse(answer.text) as Head, answer.parts);
}

/** The setpoints of an answer. */
export function setpointsOf(answer: Answer): Setpoints {
  const head = JSON.parse(answer.text) as Head;
  return new Setpoints(tableFrom(head, answer.parts), head.time_s ?? 0, head.chord_mm ?? 0, head.chord_line ?? 0);
}

function tableFrom(head: Head, parts: ArrayBuffer[]): Table {
  const part = (number: number | null): ArrayBuffer => (number === null ? undefined : parts[number - 1]) ?? new ArrayBuffer(0);
  const columns = head.columns.map(({ name, unit, kind, part: values, words, valid }) => {
    return new Column(name, unit, kind, valuesOf(kind, part(values)), words, valid === null ? null : new Uint8Array(part(valid)));
  });
  return new Table(head.schema, head.rows, head.machine, head.control, head.program_sha256, columns, head.report);
}

function valuesOf(kind: ColumnKind, bytes: ArrayBuffer): Values {
  switch (kind) {
    case "number":
      return new Float64Array(bytes);
    case "integer":
      return new Uint32Array(bytes);
    case "file":
      return new Int16Array(bytes);
    case "word":
      return new Int8Array(bytes);
    case "flag":
    case "text":
      return new Uint8Array(bytes);
  }
}
