// The worker that answers the page, as a server would: it holds the text, and gives what takes long to other workers.

import { type Against, COMPARE, CUT, Engine, type File_, type Hear, type Job, type Kind, type Opened, PLAN, RUN } from "./engine";
import { Hand, type Works } from "./worker-handle";
import { Outgoing } from "./outbox";
import type { Port } from "./worker-port";

export type ToAnswers =
  | { module: WebAssembly.Module }
  | { open: Opened }
  /** What lies next to the program now. */
  | { files: File_[] }
  /** What it is compared with now. */
  | { against: Against }
  /** So many more messages with columns were taken by the page. */
  | { taken: number }
  /** For tests: one of the workers fails. */
  | { fail: Kind | "answers" }
  /** A request of the page. */
  | string;

/** Answers and columns go to the page as from a server; this says that none will come any more. */
export interface Closed {
  closed: string;
}

/** Questions that are about a run: the worker that has it answers. */
const ROUTES: Record<string, Kind> = { state: RUN, chords: RUN, other_text: COMPARE };
/** Questions about words, for which this worker reads the whole text: they wait while the path comes through it. */
const WORDS = new Set(["tokens", "hover", "definition", "outline"]);
/** How long a long text waits for the first lines of the path, ms. */
const HOLD_MS = 1000;

const NAMES: Record<Kind, string> = { [RUN]: "paths", [PLAN]: "times", [COMPARE]: "others", [CUT]: "stocks" };

/** Only the worker that compares reads the other program: the rest need its name. */
function withoutText(opened: Omit<Opened, "program">): Omit<Opened, "program"> {
  const { against } = opened;
  return against ? { ...opened, against: { ...against, program: new ArrayBuffer(0) } } : opened;
}

export function answers(port: Port): void {
  let module: WebAssembly.Module;
  let engine: Engine;
  let opened: Omit<Opened, "program"> = { name: "", files: [] };
  const wants = new Map<Kind, number>();
  /** The number of the run that each worker works on or for. */
  let run = 0;
  let isRunning = false;
  /** Questions that wait for the end of the run. */
  let waiting: string[] = [];
  /** The page may show another program. */
  let isTold = false;

  const out = new Outgoing((data) => port.postMessage(data, typeof data === "string" ? [] : [data]));
  const tell = (object: object) => out.put(JSON.stringify(object));

  function hand(kind: Kind): Hand {
    const start = () => {
      const worker = new Worker(self.location.href, { type: "module", name: NAMES[kind] }) as unknown as Works;
      worker.postMessage({ module });
      return worker;
    };
    return new Hand(start, () => (kind === COMPARE ? opened : withoutText(opened)), {
      out: (data) => out.put(data, kind === RUN && data instanceof ArrayBuffer),
      done: (told) => {
        if (kind === RUN) out.release();
        if (told !== "") guarded(() => engine.ran(told));
        if (kind === RUN) askWaiting();
      },
      failed: (why, asked) => failed(kind, why, asked),
    });
  }

  const hands: Record<Kind, Hand> = { [RUN]: hand(RUN), [PLAN]: hand(PLAN), [COMPARE]: hand(COMPARE), [CUT]: hand(CUT) };

  /** A worker has ended: the page hears of it, and the next job gets another one. */
  function failed(kind: Kind, why: string, asked: number[]): void {
    const message = `Chordal failed: ${why}`;
    const help = "Please report it with the program";
    if (kind === RUN) tell({ type: "refused", run, message, help });
    else if (kind === PLAN) tell({ type: "no_times", run, message });
    else if (kind === COMPARE) tell({ type: "no_comparison", run, version: 0, message });
    else tell({ type: "no_stock", run, message, help });
    for (const id of asked) tell({ type: "error", id, message, help });
    out.release();
    if (kind === RUN) askWaiting();
  }

  function askWaiting(): void {
    isRunning = false;
    const asked = waiting;
    waiting = [];
    for (const each of asked) guarded(() => engine.ask(each));
  }

  /** Gives out what is wanted, the newest of each kind. */
  function handOut(): void {
    for (const [kind, number] of wants) {
      if (kind === RUN) run = number;
      const job = engine.handOver(kind, number);
      if (job) give(kind, job);
    }
    wants.clear();
  }

  function give(kind: Kind, job: Job): void {
    if (kind === RUN) isRunning = true;
    if (kind !== COMPARE) return hands[kind].give(job);
    const handed = JSON.parse(new TextDecoder().decode(job.handed)) as { other: unknown; is_told?: boolean };
    const isNothing = handed.other === "nothing";
    if (isNothing && !isTold) return;
    // A worker that begins anew does not know what the page was shown before.
    const bytes = new TextEncoder().encode(JSON.stringify({ ...handed, is_told: isTold }));
    isTold = !isNothing;
    hands[COMPARE].give({ ...job, handed: bytes.buffer as ArrayBuffer });
  }

  /** Calls the module; a failure of it ends this worker, and the page begins anew. */
  function guarded(act: () => void): void {
    try {
      act();
      handOut();
    } catch (error) {
      port.postMessage({ closed: error instanceof Error ? error.message : String(error) } satisfies Closed);
    }
  }

  function take(message: ToAnswers): void {
    if (typeof message === "string") {
      const { ask, id } = JSON.parse(message) as { ask: string; id: number };
      const kind = ROUTES[ask];
      if (kind !== undefined) hands[kind].ask(id, message);
      else if (isRunning && WORDS.has(ask)) waiting.push(message);
      else guarded(() => engine.ask(message));
    } else if ("open" in message) {
      const { program, ...rest } = message.open;
      opened = rest;
      out.hold();
      setTimeout(() => out.release(), HOLD_MS);
      guarded(() => {
        if (!engine.begin({ ...withoutText(rest), program })) return;
        // The run first: its picture is made while the text goes over.
        handOut();
        engine.text();
      });
    } else if ("files" in message) {
      opened = { ...opened, files: message.files };
      Object.values(hands).forEach((each) => each.renew());
      guarded(() => engine.files(withoutText(opened)));
    } else if ("against" in message) {
      opened = { ...opened, against: message.against };
      hands[COMPARE].renew();
      guarded(() => engine.files(withoutText(opened)));
    } else if ("taken" in message) {
      out.taken(message.taken);
    } else if ("fail" in message) {
      if (message.fail === "answers") guarded(() => engine.fail());
      else hands[message.fail].breakDown();
    }
  }

  let ready: Promise<void> | undefined;
  port.onmessage = (event: MessageEvent<ToAnswers>) => {
    const { data } = event;
    if (typeof data === "object" && "module" in data) {
      module = data.module;
      // The first run is wanted soon.
      hands[RUN].warm();
      const heard: Hear = {
        send: (data, isLater) => (isLater && data instanceof ArrayBuffer ? out.putLater(data) : out.put(data)),
        want: (kind, number) => wants.set(kind, number),
      };
      ready = Engine.start(module, heard).then((made) => {
        engine = made;
      });
      ready.catch((error: unknown) => port.postMessage({ closed: String(error) } satisfies Closed));
      return;
    }
    // In their order, once the module is there.
    void ready?.then(() => take(data));
  };
}
