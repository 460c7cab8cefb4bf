// The interpreter as WebAssembly, in a worker: messages into its memory, answers and columns out of it.
// See crates/chordal-page/src/interface.rs.

interface Exports {
  memory: WebAssembly.Memory;
  page_prepare(): void;
  page_input(length: number): number;
  page_begin(): number;
  page_text(): void;
  page_files(): void;
  page_serve(): void;
  page_ask(): void;
  page_ran(): void;
  page_hand_over(kind: number, number: number): number;
  page_take_over(): void;
  page_output(index: number): number;
  page_output_length(index: number): number;
  page_forget(): void;
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

/** The module ended: a panic, no memory, or too little stack. */
export class Ended extends Error {}

const encoder = new TextEncoder();

/** The length of an object, the object, the bytes that it names. */
function framed(object: Uint8Array, rest: ArrayBuffer[]): Uint8Array[] {
  const length = new Uint8Array(4);
  new DataView(length.buffer).setUint32(0, object.length, true);
  return [length, object, ...rest.map((bytes) => new Uint8Array(bytes))];
}

function beginning(name: string, program: ArrayBuffer | undefined, files: File_[], machine?: string): Uint8Array[] {
  const head = {
    name,
    program: program?.byteLength ?? null,
    files: files.map(({ path, bytes }) => ({ path, bytes: bytes.byteLength })),
    machine: machine ?? null,
  };
  const rest = files.map(({ bytes }) => bytes);
  return framed(encoder.encode(JSON.stringify(head)), program ? [program, ...rest] : rest);
}

export class Engine {
  private panic: string | undefined;

  private constructor(private module: Exports) {}

  static async start(compiled: WebAssembly.Module, hear: Hear): Promise<Engine> {
    const engine = new Engine(undefined as unknown as Exports);
    const decoder = new TextDecoder();
    const at = (pointer: number, length: number) => new Uint8Array(engine.module.memory.buffer, pointer >>> 0, length >>> 0);
    const imports = {
      panicked: (pointer: number, length: number) => (engine.panic = decoder.decode(at(pointer, length))),
      send: (kind: number, pointer: number, length: number) => {
        const bytes = at(pointer, length);
        // The one copy: what lies in the module is gone when this returns.
        hear.send(kind === 0 ? decoder.decode(bytes) : bytes.slice().buffer, kind === 2);
      },
      want: (kind: number, number: number) => hear.want(kind as Kind, number),
    };
    const made = await WebAssembly.instantiate(compiled, { chordal: imports });
    engine.module = made.exports as unknown as Exports;
    engine.module.page_prepare();
    return engine;
  }

  /** Begins the view of a page; whether its text can be sent. */
  begin({ name, program, files, machine }: Opened): boolean {
    return this.call(beginning(name, program, files, machine), () => this.module.page_begin() === 1);
  }

  /** Sends the page the text. */
  text(): void {
    this.call([], () => this.module.page_text());
  }

  /** Other files lie next to the program now. */
  files(name: string, files: File_[]): void {
    this.call(beginning(name, undefined, files), () => this.module.page_files());
  }

  /** Begins a view that works for another one. */
  serve({ name, files, machine }: Omit<Opened, "program">): void {
    this.call(beginning(name, undefined, files, machine), () => this.module.page_serve());
  }

  ask(text: string): void {
    this.call([encoder.encode(text)], () => this.module.page_ask());
  }

  /** A view elsewhere has run the program. */
  ran(told: string): void {
    this.call([encoder.encode(told)], () => this.module.page_ran());
  }

  /** What a view elsewhere needs; nothing where nobody wants the work any more. */
  handOver(kind: Kind, number: number): Job | undefined {
    return this.call([], () => {
      if (this.module.page_hand_over(kind, number) === 0) return undefined;
      return { handed: this.output(0), text: this.output(1) };
    });
  }

  /** Does the work of another view; after a run gives what that one is to be told. */
  takeOver({ handed, text }: Job): string {
    return this.call(framed(new Uint8Array(handed), [text]), () => {
      this.module.page_take_over();
      return new TextDecoder().decode(this.output(0));
    });
  }

  /** For tests. */
  fail(): void {
    this.call([], () => this.module.page_panic());
  }

  private output(index: number): ArrayBuffer {
    const start = this.module.page_output(index) >>> 0;
    return (this.module.memory.buffer as ArrayBuffer).slice(start, start + (this.module.page_output_length(index) >>> 0));
  }

  /** Puts a message into memory and calls what takes it. */
  private call<T>(parts: Uint8Array[], act: () => T): T {
    this.panic = undefined;
    try {
      const length = parts.reduce((sum, bytes) => sum + bytes.length, 0);
      const pointer = this.module.page_input(length) >>> 0;
      if (pointer === 0) throw new Ended(`a message of ${length} bytes has no room in memory`);
      let at = pointer;
      for (const bytes of parts) {
        new Uint8Array(this.module.memory.buffer, at, bytes.length).set(bytes);
        at += bytes.length;
      }
      const answer = act();
      this.module.page_forget();
      return answer;
    } catch (error) {
      if (error instanceof Ended) throw error;
      throw new Ended(this.panic ?? `it ended without a word (${String(error)}); it may have had too little memory`);
    }
  }
}
