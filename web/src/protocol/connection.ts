// The connection to what answers, a server or a worker: requests as JSON, answers as JSON and frames of columns.

import { type Frame, readFrame } from "./frame";
import type { ServerMessage } from "./messages";

/** Carries requests as text, answers as text and columns as bytes. */
export interface Transport {
  readonly isOpen: boolean;
  send(text: string): void;
}

/** Opens the connection; `take` gets what comes in, `closed` is called when it has ended. */
export type TransportDialer = (take: (data: string | ArrayBuffer) => void, closed: () => void) => Transport;

export class Connection {
  private transport: Transport;
  private lastId = 0;
  private queries = new Map<number, (message: ServerMessage) => void>();

  constructor(
    dial: TransportDialer,
    private take: (message: ServerMessage) => void,
    private takeFrame: (frame: Frame) => void,
    closed: () => void,
  ) {
    this.transport = dial((data) => this.receive(data), closed);
  }

  private receive(data: string | ArrayBuffer): void {
    if (data instanceof ArrayBuffer) {
      this.takeFrame(readFrame(data));
      return;
    }
    const message = JSON.parse(data) as ServerMessage;
    if ("id" in message) {
      const answer = this.queries.get(message.id);
      if (answer) {
        this.queries.delete(message.id);
        answer(message);
        return;
      }
    }
    this.take(message);
  }

  /** Sends a request without waiting for its answer; an answer that comes all the same is an error, and goes to `take`. */
  send(request: string, fields: object = {}): void {
    if (!this.transport.isOpen) return;
    this.transport.send(JSON.stringify({ id: ++this.lastId, request, ...fields }));
  }

  /** Another program is opened: answers about the one before are no longer expected. */
  dropQueries(): void {
    this.queries.clear();
  }

  /** Sends a request and waits for its answer; never resolves where the connection has ended. */
  query(request: string, fields: object = {}): Promise<ServerMessage> {
    return new Promise((resolve) => {
      if (!this.transport.isOpen) return;
      const id = ++this.lastId;
      this.queries.set(id, resolve);
      this.transport.send(JSON.stringify({ id, request, ...fields }));
    });
  }
}
