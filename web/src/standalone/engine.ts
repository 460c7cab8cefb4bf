// The view as a WebAssembly module, in a worker: messages are written to its memory, answers and columns read from it.
// See crates/chordal-page/src/interface.rs.

import { Module, messageOf } from "../../../npm/src/memory";

interface EngineExports {
  page_prepare(): void;
  page_open(): number;
  page_text(): void;
  page_files(): void;
  page_serve(): void;
  page_request(): void;
  page_run_finished(): void;
  page_dispatch(kind: number, number: number): number;
  page_execute(): void;
  page_panic(): void;
}

/** The kinds of long work, numbered as in `interface.rs`. */
export const RUN = 0;
export const PLAN = 1;
export const COMPARE = 2;
export const CUT = 3;
export type WorkKind = typeof RUN | typeof PLAN | typeof COMPARE | typeof CUT;

/** Calls from the module. */
export interface EngineEvents {
  /** Sends an answer or columns to the page; the first picture need not wait for what is `deferrable`. */
  send(data: string | ArrayBuffer, deferrable: boolean): void;
  /** Requests that work of a kind for this run be dispatched. */
  want(kind: WorkKind, number: number): void;
}

/** A program with the files of its folder. */
export interface OpenedProgram {
  name: string;
  program: ArrayBuffer;
  files: ProgramFile[];
  /** The machine that it runs on unless another one is chosen: a name, or the path of one of the files. */
  machine?: string;
  /** The program to compare it with. */
  against?: OtherProgram;
}

/** Another program, in the same folder. */
export interface OtherProgram {
  name: string;
  program: ArrayBuffer;
  machine?: string;
}

export interface ProgramFile {
  path: string;
  bytes: ArrayBuffer;
}

/** What the module of another worker needs to carry out a piece of work. */
export interface WorkOrder {
  order: ArrayBuffer;
  text: ArrayBuffer;
}

const encoder = new TextEncoder();

type OpenRequest = Omit<OpenedProgram, "program"> & { program?: ArrayBuffer };

function openMessage({ name, program, files, machine, against }: OpenRequest): Uint8Array[] {
  const head = {
    name,
    program: program !== undefined,
    files: files.map(({ path, bytes }) => ({ path, bytes: bytes.byteLength })),
    machine: machine ?? null,
    compared: against ? { name: against.name, bytes: against.program.byteLength, machine: against.machine ?? null } : null,
  };
  // The program comes last: the module keeps using this part of the message.
  const contents = [...files.map(({ bytes }) => bytes), against?.program, program].filter((bytes) => bytes !== undefined);
  return messageOf(JSON.stringify(head), contents.map((bytes) => new Uint8Array(bytes)));
}

export class Engine {
  private constructor(private module: Module<EngineExports>) {}

  static async start(compiled: WebAssembly.Module, events: EngineEvents): Promise<Engine> {
    const decoder = new TextDecoder();
    const module = await Module.start<EngineExports>(compiled, (bytesAt) => ({
      send: (kind, pointer, length) => {
        const bytes = bytesAt(pointer!, length!);
        // Copied, because the memory of the module is reused when this returns.
        events.send(kind === 0 ? decoder.decode(bytes) : (bytes.slice().buffer as ArrayBuffer), kind === 2);
      },
      want: (kind, number) => events.want(kind as WorkKind, number!),
    }));
    module.call([], (wasm) => wasm.page_prepare());
    return new Engine(module);
  }

  /** Opens a program for the page; returns whether its text can be sent. */
  open(opened: OpenedProgram): boolean {
    return this.module.call(openMessage(opened), (wasm) => wasm.page_open() === 1);
  }

  /** Sends the text of the program to the page. */
  text(): void {
    this.module.call([], (wasm) => wasm.page_text());
  }

  /** Replaces the files of the program, or the program to compare it with. */
  setFiles(opened: Omit<OpenedProgram, "program">): void {
    this.module.call(openMessage(opened), (wasm) => wasm.page_files());
  }

  /** Prepares the module for work orders of another one. */
  serve(opened: Omit<OpenedProgram, "program">): void {
    this.module.call(openMessage(opened), (wasm) => wasm.page_serve());
  }

  request(text: string): void {
    this.module.call([encoder.encode(text)], (wasm) => wasm.page_request());
  }

  /** Takes the report of a run by another worker. */
  runFinished(remoteRun: string): void {
    this.module.call([encoder.encode(remoteRun)], (wasm) => wasm.page_run_finished());
  }

  /** The order for a piece of work; undefined where the work is out of date. */
  dispatch(kind: WorkKind, number: number): WorkOrder | undefined {
    return this.module.call([], (wasm) => {
      if (wasm.page_dispatch(kind, number) === 0) return undefined;
      return { order: this.module.part(0), text: this.module.part(1) };
    });
  }

  /** Carries out the order of another module; returns its report after a run, otherwise an empty text. */
  execute({ order, text }: WorkOrder): string {
    const json = new TextDecoder().decode(order);
    return this.module.call(messageOf(json, [new Uint8Array(text)]), (wasm) => {
      wasm.page_execute();
      return this.module.text(0);
    });
  }

  /** Panics: for tests. */
  fail(): void {
    this.module.call([], (wasm) => wasm.page_panic());
  }
}
