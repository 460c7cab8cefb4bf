/** Lets the page handle its input before long work goes on. */
export function yieldToEventLoop(): Promise<void> {
  return new Promise((next) => setTimeout(next));
}
