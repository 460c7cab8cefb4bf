// Chordal in this thread: in Node, in a page, or in a worker of your own. A long program holds the thread up;
// ./worker.js asks a worker instead.
import { chordal } from "./api.js";
import { ask } from "./engine.js";

export const { check, run, commands, path, curves, time, sample, compare, convert, explain, machines, machine } = chordal(ask);

export { init, type Source } from "./engine.js";
export { ChordalError } from "./error.js";
export { Column, Setpoints, Table, type ColumnKind, type Values } from "./table.js";
export type { Chordal } from "./api.js";
export type { Text } from "./question.js";
export type * from "./types.js";
