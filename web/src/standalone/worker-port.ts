// How a worker of the page that stands alone reaches the other side.

/** The other side: the page, or the worker that answers. */
export interface WorkerPort {
  name: string;
  postMessage(message: unknown, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent) => void) | null;
}
