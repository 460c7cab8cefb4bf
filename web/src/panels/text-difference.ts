// The difference of two texts as one replacement.

/** A text with LF line ends, as the page counts offsets. */
export function withUnixEndings(text: string): string {
  return text.replace(/\r\n?/g, "\n");
}

/** The range of `from` that must be replaced, and by what, to get `to`; undefined where the texts are equal. */
export function textDifference(from: string, to: string): { from: number; to: number; insert: string } | undefined {
  if (from === to) return undefined;
  const shorter = Math.min(from.length, to.length);
  let head = 0;
  while (head < shorter && from[head] === to[head]) head++;
  let tail = 0;
  while (tail < shorter - head && from[from.length - 1 - tail] === to[to.length - 1 - tail]) tail++;
  return { from: head, to: from.length - tail, insert: to.slice(head, to.length - tail) };
}
