// The connection to the server or worker: requests are JSON, answers are JSON or binary frames of columns.

import { type Frame, readFrame } from "./frame";
import type { ServerMessage } from "./messages";

/** Sends requests as text. */
export interface Transport {
  readonly isOpen: boolean;
  send(text: string): void;
}

/** Opens the connection; `onData` gets messages and frames, `onClose` is called when it has ended. */
export type TransportDialer = (onData: (data: string | ArrayBuffer) => void, onClose: () => void) => Transport;

export class Connection {
  private transport: Transport;
  private lastId = 0;
  /** By id, what resolves the queries that wait for their answers. */
  private queries = new Map<number, (message: ServerMessage) => void>();

  constructor(
    dial: TransportDialer,
    private onMessage: (message: ServerMessage) => void,
    private onFrame: (frame: Frame) => void,
    onClose: () => void,
  ) {
    this.transport = dial((data) => this.receive(data), onClose);
  }

  private receive(data: string | ArrayBuffer): void {
    if (data instanceof ArrayBuffer) {
      this.onFrame(readFrame(data));
      return;
    }
    const message = JSON.parse(data) as ServerMessage;
    if ("id" in message) {
      const resolve = this.queries.get(message.id);
      if (resolve) {
        this.queries.delete(message.id);
        resolve(message);
        return;
      }
    }
    this.onMessage(message);
  }

  /** Sends a request without waiting for its answer; the only answer that may come is an error, which goes to `onMessage`. */
  send(request: string, fields: object = {}): void {
    if (!this.transport.isOpen) return;
    this.transport.send(JSON.stringify({ id: ++this.lastId, request, ...fields }));
  }

  /** Stops waiting for all answers, before another program is opened. */
  dropQueries(): void {
    this.queries.clear();
  }

  /** Sends a request and waits for its answer; never resolves if the connection has ended. */
  query(request: string, fields: object = {}): Promise<ServerMessage> {
    return new Promise((resolve) => {
      if (!this.transport.isOpen) return;
      const id = ++this.lastId;
      this.queries.set(id, resolve);
      this.transport.send(JSON.stringify({ id, request, ...fields }));
    });
  }
}
