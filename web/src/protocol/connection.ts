// The connection to what answers, a server or a worker: requests as JSON, answers as JSON and frames of columns.

import { type Frame, readFrame } from "./frame";
import type { Told } from "./messages";

/** The way to what answers: requests go out as text; answers come in as text, columns as bytes. */
export interface Line {
  readonly isOpen: boolean;
  send(text: string): void;
}

/** Opens the connection; `take` gets what comes in, `closed` is called when it has ended. */
export type Dial = (take: (data: string | ArrayBuffer) => void, closed: () => void) => Line;

export class Link {
  private line: Line;
  private number = 0;
  private waiting = new Map<number, (told: Told) => void>();

  constructor(
    dial: Dial,
    private take: (told: Told) => void,
    private takeFrame: (frame: Frame) => void,
    closed: () => void,
  ) {
    this.line = dial((data) => this.receive(data), closed);
  }

  private receive(data: string | ArrayBuffer): void {
    if (data instanceof ArrayBuffer) {
      this.takeFrame(readFrame(data));
      return;
    }
    const told = JSON.parse(data) as Told;
    if ("id" in told) {
      const answer = this.waiting.get(told.id);
      if (answer) {
        this.waiting.delete(told.id);
        answer(told);
        return;
      }
    }
    this.take(told);
  }

  /** Asks without waiting for an answer; one that comes all the same, an error, is told to all. */
  tell(ask: string, rest: object = {}): void {
    if (!this.line.isOpen) return;
    this.line.send(JSON.stringify({ id: ++this.number, ask, ...rest }));
  }

  /** Another program is opened: nobody waits for answers about the one before. */
  forget(): void {
    this.waiting.clear();
  }

  ask(ask: string, rest: object = {}): Promise<Told> {
    return new Promise((resolve) => {
      if (!this.line.isOpen) return;
      const id = ++this.number;
      this.waiting.set(id, resolve);
      this.line.send(JSON.stringify({ id, ask, ...rest }));
    });
  }
}
