// The language server in a worker: messages of the editor in, messages for the editor out.

interface Exports {
  memory: WebAssembly.Memory;
  chordal_input(length: number): number;
  chordal_language(): number;
  chordal_part(index: number): number;
  chordal_part_length(index: number): number;
  chordal_forget(): void;
}

/** What the module says to a step. */
interface Told {
  messages: object[];
  more: boolean;
  problem: string | null;
}

type Step = { message: unknown } | { files: unknown } | "work";

interface Scope {
  onmessage: ((event: { data: unknown }) => void) | null;
  postMessage(message: unknown): void;
}

const scope = globalThis as unknown as Scope;
const waiting: unknown[] = [];
let server: Exports | undefined;
let panic = "";
let isDue = false;

scope.onmessage = ({ data }) => {
  if (typeof data === "object" && data !== null && "module" in data) {
    void load(data.module as Uint8Array<ArrayBuffer>);
  } else if (server === undefined) {
    waiting.push(data);
  } else {
    take(data);
  }
};

async function load(bytes: Uint8Array<ArrayBuffer>): Promise<void> {
  let memory: WebAssembly.Memory | undefined;
  const panicked = (pointer: number, length: number): void => {
    if (memory !== undefined) panic = textAt(memory, pointer, length);
  };
  const made = await WebAssembly.instantiate(bytes, { chordal: { panicked } });
  server = made.instance.exports as unknown as Exports;
  memory = server.memory;
  waiting.splice(0).forEach(take);
}

function take(message: unknown): void {
  const { method, params } = message as { method?: string; params?: unknown };
  step(method === "chordal/files" ? { files: params } : { message });
}

/** Takes a step; programs are run when no message waits. */
function step(next: Step): void {
  const told = ask(next);
  for (const message of told.messages) scope.postMessage({ jsonrpc: "2.0", ...message });
  if (told.more && !isDue) {
    isDue = true;
    setTimeout(() => {
      isDue = false;
      step("work");
    }, 0);
  }
}

function ask(next: Step): Told {
  const nothing: Told = { messages: [], more: false, problem: null };
  if (server === undefined) return nothing;
  const bytes = new TextEncoder().encode(JSON.stringify(next));
  try {
    const pointer = server.chordal_input(bytes.length) >>> 0;
    if (pointer === 0) return nothing;
    new Uint8Array(server.memory.buffer, pointer, bytes.length).set(bytes);
    server.chordal_language();
    const text = textAt(server.memory, server.chordal_part(0), server.chordal_part_length(0));
    server.chordal_forget();
    return JSON.parse(text) as Told;
  } catch (error) {
    // Its memory cannot be trusted any more.
    server = undefined;
    const why = panic === "" ? String(error) : panic;
    const message = `Chordal failed: ${why}. Please report it with the program. "Restart the language server" starts it again.`;
    const shown = { method: "window/showMessage", params: { type: 1, message } };
    return { ...nothing, messages: [shown] };
  }
}

function textAt(memory: WebAssembly.Memory, pointer: number, length: number): string {
  return new TextDecoder().decode(new Uint8Array(memory.buffer, pointer >>> 0, length >>> 0));
}
