// The view in a panel of an editor, next to the program: what is typed there is shown here, and both are at the same line.
// A panel may load nothing: the editor gives it all its parts.

import { Core } from "./standalone/worker-connection";
import type { File_, Opened } from "./standalone/engine";
import { replaced, unified } from "./panels/text-difference";
import type { FromPanel, Shown, ToPanel } from "./editor-messages";
import type { Page } from "./page-host";

declare function acquireVsCodeApi(): { postMessage(message: FromPanel): void };
const host = acquireVsCodeApi();

const encode = (text: string) => new TextEncoder().encode(text).buffer as ArrayBuffer;
const filesOf = (texts: Record<string, string>): File_[] => Object.entries(texts).map(([path, text]) => ({ path, bytes: encode(text) }));

let core: Core | undefined;
let page: Page | undefined;
let shown: Shown | undefined;
/** The text is on its way to the page. */
let isArriving = false;
/** The page goes to a line that the editor named. */
let isLed = false;

function open(next: Shown): void {
  shown = next;
  if (!core || !page) return;
  const { name, text, files, machine } = next;
  isArriving = true;
  page.link.forget();
  const opened: Opened = { name, program: encode(text), files: filesOf(files), machine };
  core.open(opened).catch((error: unknown) => page?.ui.tell("error", `Chordal cannot start: ${String(error)}`));
}

/** The text of the page becomes that of the editor. */
function follow(text: string): void {
  if (!shown) return;
  shown = { ...shown, text };
  if (!page || isArriving) return;
  const { editor } = page;
  const changes = replaced(editor.view.state.doc.toString(), unified(text));
  if (changes) editor.view.dispatch({ changes });
  // The editor keeps the file.
  editor.setDirty(false);
}

function goTo(line: number): void {
  if (!shown) return;
  shown = { ...shown, line };
  if (!page || isArriving) return;
  isLed = true;
  page.editor.goTo(line);
  isLed = false;
  page.cursorAt(line);
}

function furnish(own: Page): void {
  page = own;
  const { editor, ui } = own;
  const tellDirty = editor.onDirty;
  editor.onDirty = (dirty) => {
    tellDirty(dirty);
    if (dirty || !isArriving) return;
    isArriving = false;
    // What was typed in the meantime; not within the change of the text that has just come.
    setTimeout(() => {
      if (!shown) return;
      follow(shown.text);
      goTo(shown.line);
    });
  };
  core!.onLost = (why) => {
    if (shown) ui.ask(`Chordal failed: ${why}.`, [["Begin again", () => open(shown!)]]);
    else ui.tell("error", `Chordal cannot start: ${why}.`);
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

async function begin({ module, worker }: { module: Uint8Array<ArrayBuffer>; worker: string }): Promise<void> {
  const address = URL.createObjectURL(new Blob([worker], { type: "text/javascript" }));
  const made = new Core(WebAssembly.compile(module), (name) => new Worker(address, { type: "module", name }));
  core = made;
  const { Session } = await import("./session/session");
  new Session(document.querySelector<HTMLElement>("#app")!, {
    dial: (take) => made.dial(take),
    lost: "",
    saved: "",
    another: "",
    follow: (line) => {
      if (!isLed && !isArriving) host.postMessage({ line });
    },
    furnish,
  });
  // After the styles of the page.
  await import("./editor-page.css");
}

window.addEventListener("message", ({ data }: MessageEvent<ToPanel>) => {
  if ("parts" in data) void begin(data.parts);
  else if ("open" in data) open(data.open);
  else if ("text" in data) follow(data.text);
  else if ("line" in data) goTo(data.line);
  else if ("files" in data && shown) {
    shown = { ...shown, files: data.files };
    if (isArriving || !page) return;
    core?.files(filesOf(data.files));
    page.link.tell("edit", { changes: [] });
  }
});
host.postMessage({ ready: true });
