// The language server in a worker: messages of the editor in, messages for the editor out.
import { Module, NoRoom } from "../../../npm/src/memory.js";

interface Exports {
  chordal_language(): void;
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
let server: Module<Exports> | undefined;
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
  server = await Module.start<Exports>(await WebAssembly.compile(bytes));
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
  const used = server;
  if (used === undefined) return nothing;
  try {
    const text = used.call([new TextEncoder().encode(JSON.stringify(next))], (own) => {
      own.chordal_language();
      return used.text(0);
    });
    return JSON.parse(text) as Told;
  } catch (error) {
    if (error instanceof NoRoom) return nothing;
    server = undefined;
    const why = error instanceof Error ? error.message : String(error);
    const message = `Chordal failed: ${why}. Please report it with the program. "Restart the language server" starts it again.`;
    const shown = { method: "window/showMessage", params: { type: 1, message } };
    return { ...nothing, messages: [shown] };
  }
}
