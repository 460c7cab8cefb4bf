// The view in a panel of an editor, next to the program: what is typed there is shown here, and both are at the same line.
// A panel may load nothing: the editor gives it all its parts.

import type { FromPanel, ShownProgram, ToPanel } from "./editor-messages";
import type { PageParts } from "./page-host";
import { textDifference, withUnixEndings } from "./panels/text-difference";
import type { OpenedProgram, ProgramFile } from "./standalone/engine";
import { WorkerConnection } from "./standalone/worker-connection";

declare function acquireVsCodeApi(): { postMessage(message: FromPanel): void };
const host = acquireVsCodeApi();

const encode = (text: string) => new TextEncoder().encode(text).buffer as ArrayBuffer;
const filesOf = (texts: Record<string, string>): ProgramFile[] => Object.entries(texts).map(([path, text]) => ({ path, bytes: encode(text) }));

let core: WorkerConnection | undefined;
let page: PageParts | undefined;
let shown: ShownProgram | undefined;
/** The page has not taken the text of the editor yet. */
let isTextPending = false;
/** The page goes to a line that the editor named. */
let isFollowingEditor = false;

function open(next: ShownProgram): void {
  shown = next;
  if (!core || !page) return;
  const { name, text, files, machine } = next;
  isTextPending = true;
  page.connection.dropQueries();
  const opened: OpenedProgram = { name, program: encode(text), files: filesOf(files), machine };
  core.open(opened).catch((error: unknown) => page?.ui.notify("error", `Chordal cannot start: ${String(error)}`));
}

/** The text of the page becomes that of the editor. */
function follow(text: string): void {
  if (!shown) return;
  shown = { ...shown, text };
  if (!page || isTextPending) return;
  const { editor } = page;
  const changes = textDifference(editor.view.state.doc.toString(), withUnixEndings(text));
  if (changes) editor.view.dispatch({ changes });
  // The editor keeps the file.
  editor.setDirty(false);
}

function goTo(line: number): void {
  if (!shown) return;
  shown = { ...shown, line };
  if (!page || isTextPending) return;
  isFollowingEditor = true;
  page.editor.goTo(line);
  isFollowingEditor = false;
  page.cursorAt(line);
}

function furnish(own: PageParts): void {
  page = own;
  const { editor, ui } = own;
  const showDirty = editor.onDirty;
  editor.onDirty = (dirty) => {
    showDirty(dirty);
    if (dirty || !isTextPending) return;
    isTextPending = false;
    // What was typed in the meantime; not within the change of the text that has just come.
    setTimeout(() => {
      if (!shown) return;
      follow(shown.text);
      goTo(shown.line);
    });
  };
  core!.onLost = (why) => {
    if (shown) ui.prompt(`Chordal failed: ${why}.`, [["Begin again", () => open(shown!)]]);
    else ui.notify("error", `Chordal cannot start: ${why}.`);
  };
  const follows = () => {
    const { classList } = document.body;
    const isDark = classList.contains("vscode-dark") || (classList.contains("vscode-high-contrast") && !classList.contains("vscode-high-contrast-light"));
    document.documentElement.dataset.theme = isDark ? "dark" : "light";
    ui.onTheme();
  };
  new MutationObserver(follows).observe(document.body, { attributes: true, attributeFilter: ["class"] });
  follows();
  if (shown) open(shown);
}

async function start({ module, worker }: { module: Uint8Array<ArrayBuffer>; worker: string }): Promise<void> {
  const address = URL.createObjectURL(new Blob([worker], { type: "text/javascript" }));
  const made = new WorkerConnection(WebAssembly.compile(module), (name) => new Worker(address, { type: "module", name }));
  core = made;
  const { Session } = await import("./session/session");
  new Session(document.querySelector<HTMLElement>("#app")!, {
    dial: (take) => made.dial(take),
    lostMessage: "",
    savedMessage: "",
    anotherHint: "",
    followLine: (line) => {
      if (!isFollowingEditor && !isTextPending) host.postMessage({ line });
    },
    addControls: furnish,
  });
  // After the styles of the page.
  await import("./editor-page.css");
}

window.addEventListener("message", ({ data }: MessageEvent<ToPanel>) => {
  if ("parts" in data) void start(data.parts);
  else if ("open" in data) open(data.open);
  else if ("text" in data) follow(data.text);
  else if ("line" in data) goTo(data.line);
  else if ("files" in data && shown) {
    shown = { ...shown, files: data.files };
    if (isTextPending || !page) return;
    core?.files(filesOf(data.files));
    page.connection.send("edit", { changes: [] });
  }
});
host.postMessage({ ready: true });
