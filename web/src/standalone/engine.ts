// The interpreter as WebAssembly, in a worker: messages into its memory, answers and columns out of it.
// See crates/chordal-page/src/interface.rs.

import { Module, messageOf } from "../../../npm/src/memory";

interface Exports {
  page_prepare(): void;
  page_begin(): number;
  page_text(): void;
  page_files(): void;
  page_serve(): void;
  page_ask(): void;
  page_ran(): void;
  page_hand_over(kind: number, number: number): number;
  page_take_over(): void;
  page_panic(): void;
}

/** What takes long, as the interface numbers it. */
export const RUN = 0;
export const PLAN = 1;
export const COMPARE = 2;
export const CUT = 3;
export type Kind = typeof RUN | typeof PLAN | typeof COMPARE | typeof CUT;

/** What comes out while it works. */
export interface Hear {
  /** An answer, or columns; `later`: the first picture need not wait for them. */
  send(data: string | ArrayBuffer, later: boolean): void;
  want(kind: Kind, number: number): void;
}

/** A program and what lies next to it. */
export interface Opened {
  name: string;
  program: ArrayBuffer;
  files: File_[];
  /** The machine that it runs on unless another one is chosen: a name, or the path of one of the files. */
  machine?: string;
  /** The program that it is compared with. */
  against?: Against;
}

/** Another program, with the same files next to it. */
export interface Against {
  name: string;
  program: ArrayBuffer;
  machine?: string;
}

export interface File_ {
  path: string;
  bytes: ArrayBuffer;
}

/** What a view needs to work for another one. */
export interface Job {
  handed: ArrayBuffer;
  text: ArrayBuffer;
}

const encoder = new TextEncoder();

type Beginning = Omit<Opened, "program"> & { program?: ArrayBuffer };

function beginning({ name, program, files, machine, against }: Beginning): Uint8Array[] {
  const head = {
    name,
    program: program !== undefined,
    files: files.map(({ path, bytes }) => ({ path, bytes: bytes.byteLength })),
    machine: machine ?? null,
    against: against ? { name: against.name, bytes: against.program.byteLength, machine: against.machine ?? null } : null,
  };
  // The program comes last: it keeps the memory of the message.
  const rest = [...files.map(({ bytes }) => bytes), against?.program, program].filter((bytes) => bytes !== undefined);
  return messageOf(JSON.stringify(head), rest.map((bytes) => new Uint8Array(bytes)));
}

export class Engine {
  private constructor(private module: Module<Exports>) {}

  static async start(compiled: WebAssembly.Module, hear: Hear): Promise<Engine> {
    const decoder = new TextDecoder();
    const module = await Module.start<Exports>(compiled, (at) => ({
      send: (kind, pointer, length) => {
        const bytes = at(pointer!, length!);
        // The one copy: what lies in the module is gone when this returns.
        hear.send(kind === 0 ? decoder.decode(bytes) : (bytes.slice().buffer as ArrayBuffer), kind === 2);
      },
      want: (kind, number) => hear.want(kind as Kind, number!),
    }));
    module.call([], (own) => own.page_prepare());
    return new Engine(module);
  }

  /** Begins the view of a page; whether its text can be sent. */
  begin(opened: Opened): boolean {
    return this.module.call(beginning(opened), (own) => own.page_begin() === 1);
  }

  /** Sends the page the text. */
  text(): void {
    this.module.call([], (own) => own.page_text());
  }

  /** Other files lie next to the program now, or it is compared with another one. */
  files(opened: Omit<Opened, "program">): void {
    this.module.call(beginning(opened), (own) => own.page_files());
  }

  /** Begins a view that works for another one. */
  serve(opened: Omit<Opened, "program">): void {
    this.module.call(beginning(opened), (own) => own.page_serve());
  }

  ask(text: string): void {
    this.module.call([encoder.encode(text)], (own) => own.page_ask());
  }

  /** A view elsewhere has run the program. */
  ran(told: string): void {
    this.module.call([encoder.encode(told)], (own) => own.page_ran());
  }

  /** What a view elsewhere needs; nothing where nobody wants the work any more. */
  handOver(kind: Kind, number: number): Job | undefined {
    return this.module.call([], (own) => {
      if (own.page_hand_over(kind, number) === 0) return undefined;
      return { handed: this.module.part(0), text: this.module.part(1) };
    });
  }

  /** Does the work of another view; after a run gives what that one is to be told. */
  takeOver({ handed, text }: Job): string {
    const json = new TextDecoder().decode(handed);
    return this.module.call(messageOf(json, [new Uint8Array(text)]), (own) => {
      own.page_take_over();
      return this.module.text(0);
    });
  }

  /** For tests. */
  fail(): void {
    this.module.call([], (own) => own.page_panic());
  }
}
