// Opens files and texts that are dropped or pasted on the page.

export interface DropHandlers {
  files: (files: File[]) => void;
  text: (text: string) => void;
}

/** Opens what is dropped anywhere, or pasted anywhere but in a text field. */
export function openDroppedFiles(root: Document, handlers: DropHandlers): void {
  root.addEventListener("dragover", (event) => {
    if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
  });
  root.addEventListener("drop", (event) => {
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length === 0) return;
    event.preventDefault();
    handlers.files(files);
  }, true);
  root.addEventListener("paste", (event) => {
    if ((event.target as HTMLElement | null)?.closest?.(".cm-editor, input, textarea")) return;
    const files = [...(event.clipboardData?.files ?? [])];
    const text = event.clipboardData?.getData("text/plain") ?? "";
    if (files.length === 0 && text.trim() === "") return;
    event.preventDefault();
    if (files.length > 0) handlers.files(files);
    else handlers.text(text);
  });
}
