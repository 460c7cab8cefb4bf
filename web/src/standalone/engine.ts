// The interpreter as WebAssembly, in a worker: messages into its memory, answers and columns out of it.
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

/** The kinds of work that take long, as `interface.rs` numbers them. */
export const RUN = 0;
export const PLAN = 1;
export const COMPARE = 2;
export const CUT = 3;
export type WorkKind = typeof RUN | typeof PLAN | typeof COMPARE | typeof CUT;

/** Is called while the module works. */
export interface EngineEvents {
  /** An answer, or columns; `later`: the first picture need not wait for them. */
  send(data: string | ArrayBuffer, later: boolean): void;
  want(kind: WorkKind, number: number): void;
}

/** A program and what lies next to it. */
export interface OpenedProgram {
  name: string;
  program: ArrayBuffer;
  files: ProgramFile[];
  /** The machine that it runs on unless another one is chosen: a name, or the path of one of the files. */
  machine?: string;
  /** The program that it is compared with. */
  against?: OtherProgram;
}

/** Another program, with the same files next to it. */
export interface OtherProgram {
  name: string;
  program: ArrayBuffer;
  machine?: string;
}

export interface ProgramFile {
  path: string;
  bytes: ArrayBuffer;
}

/** What a view needs to work for another one. */
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
  // The program comes last: it keeps the memory of the message.
  const rest = [...files.map(({ bytes }) => bytes), against?.program, program].filter((bytes) => bytes !== undefined);
  return messageOf(JSON.stringify(head), rest.map((bytes) => new Uint8Array(bytes)));
}

export class Engine {
  private constructor(private module: Module<EngineExports>) {}

  static async start(compiled: WebAssembly.Module, events: EngineEvents): Promise<Engine> {
    const decoder = new TextDecoder();
    const module = await Module.start<EngineExports>(compiled, (at) => ({
      send: (kind, pointer, length) => {
        const bytes = at(pointer!, length!);
        // The one copy: what lies in the module is gone when this returns.
        events.send(kind === 0 ? decoder.decode(bytes) : (bytes.slice().buffer as ArrayBuffer), kind === 2);
      },
      want: (kind, number) => events.want(kind as WorkKind, number!),
    }));
    module.call([], (own) => own.page_prepare());
    return new Engine(module);
  }

  /** Begins the view of a page; whether its text can be sent. */
  open(opened: OpenedProgram): boolean {
    return this.module.call(openMessage(opened), (own) => own.page_open() === 1);
  }

  /** Sends the page the text. */
  text(): void {
    this.module.call([], (own) => own.page_text());
  }

  /** Other files lie next to the program now, or it is compared with another one. */
  files(opened: Omit<OpenedProgram, "program">): void {
    this.module.call(openMessage(opened), (own) => own.page_files());
  }

  /** Begins a view that works for another one. */
  serve(opened: Omit<OpenedProgram, "program">): void {
    this.module.call(openMessage(opened), (own) => own.page_serve());
  }

  request(text: string): void {
    this.module.call([encoder.encode(text)], (own) => own.page_request());
  }

  /** Another worker has run the program: its report. */
  runFinished(remoteRun: string): void {
    this.module.call([encoder.encode(remoteRun)], (own) => own.page_run_finished());
  }

  /** What another worker needs for a piece of work; undefined where the work is out of date. */
  dispatch(kind: WorkKind, number: number): WorkOrder | undefined {
    return this.module.call([], (own) => {
      if (own.page_dispatch(kind, number) === 0) return undefined;
      return { order: this.module.part(0), text: this.module.part(1) };
    });
  }

  /** Does the work of another view; after a run gives the report for that view. */
  execute({ order, text }: WorkOrder): string {
    const json = new TextDecoder().decode(order);
    return this.module.call(messageOf(json, [new Uint8Array(text)]), (own) => {
      own.page_execute();
      return this.module.text(0);
    });
  }

  /** For tests. */
  fail(): void {
    this.module.call([], (own) => own.page_panic());
  }
}
