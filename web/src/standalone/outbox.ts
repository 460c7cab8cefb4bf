// Messages to the page with flow control: they are sent no faster than the page handles them, so that it can draw and handle its
// input during a long path. A long text waits for the first part of the path, and then alternates with it.

/** The largest number of messages with columns that are sent and not handled by the page yet. */
const MAX_IN_FLIGHT = 8;

interface OutgoingMessage {
  data: string | ArrayBuffer;
  /** Whether it has columns of the path, so that there is something to draw. */
  isPicture: boolean;
}

export class Outbox {
  private urgent: OutgoingMessage[] = [];
  private deferred: ArrayBuffer[] = [];
  private inFlight = 0;
  /** Deferred messages wait. */
  private isPaused = false;
  /** The last message was a deferred one. */
  private wasDeferred = false;

  constructor(private post: (data: string | ArrayBuffer) => void) {}

  /** Sends a message, after earlier ones. */
  put(data: string | ArrayBuffer, isPicture = false): void {
    this.urgent.push({ data, isPicture });
    this.sendAll();
  }

  /** Sends columns that the first picture need not wait for. */
  putDeferred(data: ArrayBuffer): void {
    this.deferred.push(data);
    this.sendAll();
  }

  /** Holds deferred messages back until a picture is sent, or `release` is called. */
  pause(): void {
    this.isPaused = true;
  }

  release(): void {
    this.isPaused = false;
    this.sendAll();
  }

  /** The page has handled `count` more messages with columns. */
  acknowledge(count: number): void {
    this.inFlight -= count;
    this.sendAll();
  }

  /** Sends what the limit allows. */
  private sendAll(): void {
    while (this.inFlight < MAX_IN_FLIGHT) {
      const isDeferred = this.deferred.length > 0 && !this.isPaused && (this.urgent.length === 0 || !this.wasDeferred);
      const message = isDeferred ? { data: this.deferred.shift()!, isPicture: false } : this.urgent.shift();
      if (!message) return;
      this.wasDeferred = isDeferred;
      if (message.isPicture) this.isPaused = false;
      if (typeof message.data !== "string") this.inFlight++;
      this.post(message.data);
    }
  }
}
