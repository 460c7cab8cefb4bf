// The worker that answers the page, as a server would: it has the text, and dispatches long work to other workers.

import { type EngineEvents, type OpenedProgram, type OtherProgram, type ProgramFile, type WorkKind, type WorkOrder, COMPARE, CUT, Engine, PLAN, RUN } from "./engine";
import { Outbox } from "./outbox";
import { type JobWorker, WorkerHandle } from "./worker-handle";
import type { WorkerPort } from "./worker-port";

export type ToSessionWorker =
  | { module: WebAssembly.Module }
  | { open: OpenedProgram }
  /** Replaces the files of the program. */
  | { files: ProgramFile[] }
  /** Replaces the program to compare with. */
  | { against: OtherProgram }
  /** How many more messages with columns the page has handled. */
  | { taken: number }
  /** For tests: one of the workers fails. */
  | { fail: WorkKind | "answers" }
  /** A request of the page. */
  | string;

/** The only message that is not as from a server: the worker has failed, for this reason, and will send no more. */
export interface ClosedMessage {
  closed: string;
}

/** Requests about a run, which are answered by the worker that has run the program. */
const RUN_REQUESTS: Record<string, WorkKind> = { state: RUN, chords: RUN, other_text: COMPARE };
/** Requests for which this worker must read the whole text: they wait for the end of the run, whose path passes through it. */
const WORD_REQUESTS = new Set(["tokens", "hover", "definition", "outline"]);
/** How long a long text waits for the first part of the path, ms. */
const TEXT_PAUSE_MS = 1000;

const WORKER_NAMES: Record<WorkKind, string> = { [RUN]: "paths", [PLAN]: "times", [COMPARE]: "others", [CUT]: "stocks" };

/** Leaves the text of the other program out: only the worker that compares needs it. */
function withoutText(opened: Omit<OpenedProgram, "program">): Omit<OpenedProgram, "program"> {
  const { against } = opened;
  return against ? { ...opened, against: { ...against, program: new ArrayBuffer(0) } } : opened;
}

export function sessionWorker(port: WorkerPort): void {
  let module: WebAssembly.Module;
  let engine: Engine;
  let opened: Omit<OpenedProgram, "program"> = { name: "", files: [] };
  /** The newest run for which each kind of work was requested. */
  const pendingWork = new Map<WorkKind, number>();
  /** The number of the newest run. */
  let run = 0;
  let isRunning = false;
  /** Requests that wait for the end of the run. */
  let waitingRequests: string[] = [];
  /** The page may be showing a comparison. */
  let isComparisonShown = false;

  const out = new Outbox((data) => port.postMessage(data, typeof data === "string" ? [] : [data]));
  const sendJson = (object: object) => out.put(JSON.stringify(object));

  function handleOf(kind: WorkKind): WorkerHandle {
    const start = () => {
      const worker = new Worker(self.location.href, { type: "module", name: WORKER_NAMES[kind] }) as unknown as JobWorker;
      worker.postMessage({ module });
      return worker;
    };
    return new WorkerHandle(start, () => (kind === COMPARE ? opened : withoutText(opened)), {
      out: (data) => out.put(data, kind === RUN && data instanceof ArrayBuffer),
      done: (remoteRun) => {
        if (kind === RUN) out.release();
        if (remoteRun !== "") guarded(() => engine.runFinished(remoteRun));
        if (kind === RUN) answerWaiting();
      },
      failed: (why, queries) => failed(kind, why, queries),
    });
  }

  const handles: Record<WorkKind, WorkerHandle> = { [RUN]: handleOf(RUN), [PLAN]: handleOf(PLAN), [COMPARE]: handleOf(COMPARE), [CUT]: handleOf(CUT) };

  /** Reports the failure of a worker to the page; the next work order gets another worker. */
  function failed(kind: WorkKind, why: string, queries: number[]): void {
    const message = `Chordal failed: ${why}`;
    const help = "Please report it with the program";
    if (kind === RUN) sendJson({ type: "refused", run, message, help });
    else if (kind === PLAN) sendJson({ type: "no_times", run, message });
    else if (kind === COMPARE) sendJson({ type: "no_comparison", run, version: 0, message });
    else sendJson({ type: "no_stock", run, message, help });
    for (const id of queries) sendJson({ type: "error", id, message, help });
    out.release();
    if (kind === RUN) answerWaiting();
  }

  function answerWaiting(): void {
    isRunning = false;
    const requests = waitingRequests;
    waitingRequests = [];
    for (const request of requests) guarded(() => engine.request(request));
  }

  /** Dispatches the newest work of each kind. */
  function dispatchAll(): void {
    for (const [kind, number] of pendingWork) {
      if (kind === RUN) run = number;
      const job = engine.dispatch(kind, number);
      if (job) assign(kind, job);
    }
    pendingWork.clear();
  }

  function assign(kind: WorkKind, job: WorkOrder): void {
    if (kind === RUN) isRunning = true;
    if (kind !== COMPARE) return handles[kind].assign(job);
    const order = JSON.parse(new TextDecoder().decode(job.order)) as { other: unknown; is_shown?: boolean };
    const isNothing = order.other === "nothing";
    if (isNothing && !isComparisonShown) return;
    // A new worker does not know whether the page shows a comparison.
    const bytes = new TextEncoder().encode(JSON.stringify({ ...order, is_shown: isComparisonShown }));
    isComparisonShown = !isNothing;
    handles[COMPARE].assign({ ...job, order: bytes.buffer as ArrayBuffer });
  }

  /** Calls the module; if it fails, the page terminates this worker and starts another one. */
  function guarded(call: () => void): void {
    try {
      call();
      dispatchAll();
    } catch (error) {
      port.postMessage({ closed: error instanceof Error ? error.message : String(error) } satisfies ClosedMessage);
    }
  }

  function take(message: ToSessionWorker): void {
    if (typeof message === "string") {
      const { request, id } = JSON.parse(message) as { request: string; id: number };
      const kind = RUN_REQUESTS[request];
      if (kind !== undefined) handles[kind].query(id, message);
      else if (isRunning && WORD_REQUESTS.has(request)) waitingRequests.push(message);
      else guarded(() => engine.request(message));
    } else if ("open" in message) {
      const { program, ...rest } = message.open;
      opened = rest;
      out.pause();
      setTimeout(() => out.release(), TEXT_PAUSE_MS);
      guarded(() => {
        if (!engine.open({ ...withoutText(rest), program })) return;
        // The run first: it goes on in its worker while the text is sent.
        dispatchAll();
        engine.text();
      });
    } else if ("files" in message) {
      opened = { ...opened, files: message.files };
      Object.values(handles).forEach((handle) => handle.renew());
      guarded(() => engine.setFiles(withoutText(opened)));
    } else if ("against" in message) {
      opened = { ...opened, against: message.against };
      handles[COMPARE].renew();
      guarded(() => engine.setFiles(withoutText(opened)));
    } else if ("taken" in message) {
      out.acknowledge(message.taken);
    } else if ("fail" in message) {
      if (message.fail === "answers") guarded(() => engine.fail());
      else handles[message.fail].breakDown();
    }
  }

  let ready: Promise<void> | undefined;
  port.onmessage = (event: MessageEvent<ToSessionWorker>) => {
    const { data } = event;
    if (typeof data === "object" && "module" in data) {
      module = data.module;
      // The first run will be requested soon.
      handles[RUN].warm();
      const events: EngineEvents = {
        send: (data, deferrable) => (deferrable && data instanceof ArrayBuffer ? out.putDeferred(data) : out.put(data)),
        want: (kind, number) => pendingWork.set(kind, number),
      };
      ready = Engine.start(module, events).then((started) => {
        engine = started;
      });
      ready.catch((error: unknown) => port.postMessage({ closed: String(error) } satisfies ClosedMessage));
      return;
    }
    // In their order, once the module is ready.
    void ready?.then(() => take(data));
  };
}
