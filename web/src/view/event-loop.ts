/** Lets the page answer before long work goes on. */
export function yieldToEventLoop(): Promise<void> {
  return new Promise((next) => setTimeout(next));
}
