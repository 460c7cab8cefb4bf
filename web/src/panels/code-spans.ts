// Texts of the library, in which code is between backticks.

/** The pieces of a text, and whether each is code. A backtick without a partner is text. */
export function codePieces(text: string): [string, boolean][] {
  const pieces: [string, boolean][] = [];
  let last = 0;
  for (const match of text.matchAll(/`([^`]+)`/g)) {
    if (match.index > last) pieces.push([text.slice(last, match.index), false]);
    pieces.push([match[1]!, true]);
    last = match.index + match[0].length;
  }
  if (last < text.length) pieces.push([text.slice(last), false]);
  return pieces;
}

/** A text for where no element can be: a title, a label. */
export function plainText(text: string): string {
  return codePieces(text).map(([piece]) => piece).join("");
}

/** Gives an element a text. */
export function setCodeSpans(element: HTMLElement, text: string): void {
  element.replaceChildren(
    ...codePieces(text).map(([piece, isCode]) => {
      if (!isCode) return piece;
      const code = document.createElement("code");
      code.textContent = piece;
      return code;
    }),
  );
}

export function codeSpans(text: string, className: string, name: "span" | "div" | "p" | "strong" | "dd" = "span"): HTMLElement {
  const made = document.createElement(name);
  if (className) made.className = className;
  setCodeSpans(made, text);
  return made;
}
