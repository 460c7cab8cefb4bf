// Messages to the page, no faster than it takes them: otherwise its own work, drawing and keys, would wait after a
// long path. A long text waits for the first picture, and then alternates with the path.

/** Messages with columns that the page has not taken yet. */
const MAX_IN_FLIGHT = 8;

interface OutgoingMessage {
  data: string | ArrayBuffer;
  isPicture: boolean;
}

export class Outbox {
  private soon: OutgoingMessage[] = [];
  private later: ArrayBuffer[] = [];
  private inFlight = 0;
  private isPaused = false;
  private wasLater = false;

  constructor(private post: (data: string | ArrayBuffer) => void) {}

  put(data: string | ArrayBuffer, isPicture = false): void {
    this.soon.push({ data, isPicture });
    this.go();
  }

  /** Columns that the first picture need not wait for. */
  putLater(data: ArrayBuffer): void {
    this.later.push(data);
    this.go();
  }

  /** What may wait does so, until a picture is sent or [`Outbox.release`]. */
  pause(): void {
    this.isPaused = true;
  }

  release(): void {
    this.isPaused = false;
    this.go();
  }

  /** The page has taken so many messages with columns. */
  taken(count: number): void {
    this.inFlight -= count;
    this.go();
  }

  private go(): void {
    while (this.inFlight < MAX_IN_FLIGHT) {
      const isLater = this.later.length > 0 && !this.isPaused && (this.soon.length === 0 || !this.wasLater);
      const message = isLater ? { data: this.later.shift()!, isPicture: false } : this.soon.shift();
      if (!message) return;
      this.wasLater = isLater;
      if (message.isPicture) this.isPaused = false;
      if (typeof message.data !== "string") this.inFlight++;
      this.post(message.data);
    }
  }
}
