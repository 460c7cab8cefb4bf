// The message port of a worker of the standalone page.

/** Connected to the page or to the session worker. */
export interface WorkerPort {
  name: string;
  postMessage(message: unknown, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
}
