/** Lets the page answer before long work goes on. */
export function pause(): Promise<void> {
  return new Promise((next) => setTimeout(next));
}
