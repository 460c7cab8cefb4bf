// How a worker of the standalone page sends and receives messages.

/** The other side: the page, or the worker that answers. */
export interface WorkerPort {
  name: string;
  postMessage(message: unknown, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
}
