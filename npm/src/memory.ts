// How messages lie in the memory of a module: the other half of crates/chordal-memory. The npm package, the page without
// a server and the extension for the editor in the browser have their modules through it.

/** What every module offers. */
interface Exports {
  memory: WebAssembly.Memory;
  memory_input(length: number): number;
  memory_parts(): number;
  memory_part(index: number): number;
  memory_part_length(index: number): number;
  memory_forget(): void;
}

/** What a module calls: it gets bytes as the place where they lie and how many there are. */
type Imports = (at: (pointer: number, length: number) => Uint8Array) => Record<string, (...numbers: number[]) => void>;

/** The module ended: a panic, no memory, or too little stack. Its memory cannot be trusted any more. */
export class Ended extends Error {}

/** There is no memory for a message of so many bytes; the module goes on. */
export class NoRoom extends Error {
  constructor(readonly bytes: number) {
    super(`a message of ${bytes} bytes has no room in memory`);
  }
}

/** A message: the length of a JSON object, the object, the bytes that it names. */
export function messageOf(json: string, rest: Uint8Array[]): Uint8Array[] {
  const object = new TextEncoder().encode(json);
  const length = new Uint8Array(4);
  new DataView(length.buffer).setUint32(0, object.length, true);
  return [length, object, ...rest];
}

/** A module at work; `Own` is what it offers in addition. */
export class Module<Own> {
  /** The words of the panic that ended it. */
  private panic: string | undefined;

  private constructor(private exports: Exports & Own) {}

  static async start<Own>(compiled: WebAssembly.Module, imports: Imports = () => ({})): Promise<Module<Own>> {
    const module = new Module<Own>(undefined as unknown as Exports & Own);
    const at = (pointer: number, length: number): Uint8Array => new Uint8Array(module.memory.buffer, pointer >>> 0, length >>> 0);
    const panicked = (pointer: number, length: number): void => {
      module.panic = new TextDecoder().decode(at(pointer, length));
    };
    const made = await WebAssembly.instantiate(compiled, { chordal: { panicked, ...imports(at) } });
    module.exports = made.exports as unknown as Exports & Own;
    return module;
  }

  get memory(): WebAssembly.Memory {
    return this.exports.memory;
  }

  /** Puts a message into memory and calls what takes it; its parts can be read until that returns. */
  call<T>(message: Uint8Array[], act: (own: Own) => T): T {
    this.panic = undefined;
    try {
      const length = message.reduce((sum, bytes) => sum + bytes.length, 0);
      const pointer = length < 2 ** 31 ? this.exports.memory_input(length) >>> 0 : 0;
      if (pointer === 0) throw new NoRoom(length);
      let at = pointer;
      for (const bytes of message) {
        new Uint8Array(this.memory.buffer, at, bytes.length).set(bytes);
        at += bytes.length;
      }
      const answer = act(this.exports);
      this.exports.memory_forget();
      return answer;
    } catch (error) {
      if (error instanceof NoRoom) throw error;
      throw new Ended(this.panic ?? `it ended without a word (${String(error)}); it may have had too little memory`);
    }
  }

  get parts(): number {
    return this.exports.memory_parts();
  }

  /** A part. The one copy: what lies in the module is gone with the next message. */
  part(index: number): ArrayBuffer {
    const start = this.exports.memory_part(index) >>> 0;
    return (this.memory.buffer as ArrayBuffer).slice(start, start + (this.exports.memory_part_length(index) >>> 0));
  }

  text(index: number): string {
    const start = this.exports.memory_part(index) >>> 0;
    return new TextDecoder().decode(new Uint8Array(this.memory.buffer, start, this.exports.memory_part_length(index) >>> 0));
  }
}
