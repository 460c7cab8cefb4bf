// What goes to the page, no faster than it takes it: otherwise its own work, drawing and keys, would wait behind a
// long path. A long text waits for the first picture, and then takes turns with the path.

/** Messages with columns that the page has not taken yet. */
const MOST_UNDER_WAY = 8;

interface Message {
  data: string | ArrayBuffer;
  isPicture: boolean;
}

export class Outgoing {
  private soon: Message[] = [];
  private later: ArrayBuffer[] = [];
  private underWay = 0;
  private isHeld = false;
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

  /** What may wait does so, until a picture is on its way or [`Outgoing.release`]. */
  hold(): void {
    this.isHeld = true;
  }

  release(): void {
    this.isHeld = false;
    this.go();
  }

  /** The page has taken so many messages with columns. */
  taken(count: number): void {
    this.underWay -= count;
    this.go();
  }

  private go(): void {
    while (this.underWay < MOST_UNDER_WAY) {
      const isLater = this.later.length > 0 && !this.isHeld && (this.soon.length === 0 || !this.wasLater);
      const message = isLater ? { data: this.later.shift()!, isPicture: false } : this.soon.shift();
      if (!message) return;
      this.wasLater = isLater;
      if (message.isPicture) this.isHeld = false;
      if (typeof message.data !== "string") this.underWay++;
      this.post(message.data);
    }
  }
}
