// What must be replaced in a text so that it becomes another one.

/** A text with the line ends that the page counts with. */
export function withUnixEndings(text: string): string {
  return text.replace(/\r\n?/g, "\n");
}

/** The one piece that differs, from its first to its last character; nothing where the texts are the same. */
export function textDifference(from: string, to: string): { from: number; to: number; insert: string } | undefined {
  if (from === to) return undefined;
  const least = Math.min(from.length, to.length);
  let head = 0;
  while (head < least && from[head] === to[head]) head++;
  let tail = 0;
  while (tail < least - head && from[from.length - 1 - tail] === to[to.length - 1 - tail]) tail++;
  return { from: head, to: from.length - tail, insert: to.slice(head, to.length - tail) };
}
