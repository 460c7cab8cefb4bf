// Texts in which code is between backticks, as the library writes them.

/** The pieces of a text, and whether each is code. An unpaired backtick is text. */
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

/** A text without backticks, for titles and labels, which cannot contain elements. */
export function plainText(text: string): string {
  return codePieces(text).map(([piece]) => piece).join("");
}

/** Sets the content of an element, with code in `code` elements. */
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

/** Makes an element with such a text. */
export function codeSpans(text: string, className: string, name: "span" | "div" | "p" | "strong" | "dd" = "span"): HTMLElement {
  const root = document.createElement(name);
  if (className) root.className = className;
  setCodeSpans(root, text);
  return root;
}
