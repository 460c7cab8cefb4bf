// The view in a panel of an editor, next to the program: it follows the text and the line of the editor. A panel may load
// nothing, so the editor sends it the module and the script of the worker.

import type { FromPanel, ShownProgram, ToPanel } from "./editor-messages";
import type { PageParts } from "./page-host";
import { textDifference, withUnixEndings } from "./panels/text-difference";
import type { OpenedProgram, ProgramFile } from "./standalone/engine";
import { WorkerConnection } from "./standalone/worker-connection";

declare function acquireVsCodeApi(): { postMessage(message: FromPanel): void };
const host = acquireVsCodeApi();

const encode = (text: string) => new TextEncoder().encode(text).buffer as ArrayBuffer;
const filesOf = (texts: Record<string, string>): ProgramFile[] => Object.entries(texts).map(([path, text]) => ({ path, bytes: encode(text) }));

let workers: WorkerConnection | undefined;
let page: PageParts | undefined;
let shown: ShownProgram | undefined;
/** The page has not received the text of the editor yet. */
let isTextPending = false;
/** The page is going to a line of the editor, which must not be sent back. */
let isFollowingEditor = false;

function open(next: ShownProgram): void {
  shown = next;
  if (!workers || !page) return;
  const { name, text, files, machine } = next;
  isTextPending = true;
  page.connection.dropQueries();
  const opened: OpenedProgram = { name, program: encode(text), files: filesOf(files), machine };
  workers.open(opened).catch((error: unknown) => page?.ui.notify("error", `Chordal cannot start: ${String(error)}`));
}

/** Replaces the text of the page by that of the editor. */
function setText(text: string): void {
  if (!shown) return;
  shown = { ...shown, text };
  if (!page || isTextPending) return;
  const { editor } = page;
  const changes = textDifference(editor.view.state.doc.toString(), withUnixEndings(text));
  if (changes) editor.view.dispatch({ changes });
  // The editor saves the file, not the page.
  editor.setDirty(false);
}

/** Goes to a line of the editor. */
function goTo(line: number): void {
  if (!shown) return;
  shown = { ...shown, line };
  if (!page || isTextPending) return;
  isFollowingEditor = true;
  page.editor.goTo(line);
  isFollowingEditor = false;
  page.cursorAt(line);
}

/** Connects the page to the editor. */
function connectPage(parts: PageParts): void {
  page = parts;
  const { editor, ui } = parts;
  const showDirty = editor.onDirty;
  editor.onDirty = (dirty) => {
    showDirty(dirty);
    if (dirty || !isTextPending) return;
    isTextPending = false;
    // What was typed in the meantime; after the change of the text that is just being made.
    setTimeout(() => {
      if (!shown) return;
      setText(shown.text);
      goTo(shown.line);
    });
  };
  workers!.onLost = (why) => {
    if (shown) ui.prompt(`Chordal failed: ${why}.`, [["Begin again", () => open(shown!)]]);
    else ui.notify("error", `Chordal cannot start: ${why}.`);
  };
  const updateTheme = () => {
    const { classList } = document.body;
    const isDark = classList.contains("vscode-dark") || (classList.contains("vscode-high-contrast") && !classList.contains("vscode-high-contrast-light"));
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
    ui.onTheme();
  };
  new MutationObserver(updateTheme).observe(document.body, { attributes: true, attributeFilter: ["class"] });
  updateTheme();
  if (shown) open(shown);
}

async function start({ module, worker }: { module: Uint8Array<ArrayBuffer>; worker: string }): Promise<void> {
  const address = URL.createObjectURL(new Blob([worker], { type: "text/javascript" }));
  const connection = new WorkerConnection(WebAssembly.compile(module), (name) => new Worker(address, { type: "module", name }));
  workers = connection;
  const { Session } = await import("./session/session");
  new Session(document.querySelector<HTMLElement>("#app")!, {
    dial: (onData) => connection.dial(onData),
    lostMessage: "",
    savedMessage: "",
    anotherHint: "",
    followLine: (line) => {
      if (!isFollowingEditor && !isTextPending) host.postMessage({ line });
    },
    addControls: connectPage,
  });
  // Imported after the styles of the page, which it overrides.
  await import("./editor-page.css");
}

window.addEventListener("message", ({ data }: MessageEvent<ToPanel>) => {
  if ("parts" in data) void start(data.parts);
  else if ("open" in data) open(data.open);
  else if ("text" in data) setText(data.text);
  else if ("line" in data) goTo(data.line);
  else if ("files" in data && shown) {
    shown = { ...shown, files: data.files };
    if (isTextPending || !page) return;
    workers?.setFiles(filesOf(data.files));
    page.connection.send("edit", { changes: [] });
  }
});
host.postMessage({ ready: true });
