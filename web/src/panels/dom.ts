// Helpers for elements of the page.

/** Makes an element with a class and a text. */
export function element<K extends keyof HTMLElementTagNameMap>(
  name: K,
  className = "",
  text = "",
): HTMLElementTagNameMap[K] {
  const created = document.createElement(name);
  if (className) created.className = className;
  if (text) created.textContent = text;
  return created;
}

/** Makes Escape close a details element and return the focus to its summary. */
export function closeOnEscape(root: HTMLDetailsElement, summary: HTMLElement): void {
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    root.open = false;
    summary.focus();
  });
}
