// The path of a program in a panel next to it. The panel is a page that may load nothing: it is given its parts.
import * as vscode from "vscode";

import type { FromPanel, ToPanel } from "../../../web/src/editor-messages.js";

/** How long nobody must type before the panel gets the text, ms. */
const QUIET_MS = 100;

export class PathPanel {
  private panel: vscode.WebviewPanel | undefined;
  private document: vscode.TextDocument | undefined;
  private due: ReturnType<typeof setTimeout> | undefined;

  constructor(
    /** Where the parts are. */
    private readonly folder: vscode.Uri,
    /** What programs may need, by their paths. */
    private readonly files: () => Record<string, string>,
    private readonly machine: () => string,
  ) {}

  /** Listens to the editor until it is told not to. */
  listen(): vscode.Disposable {
    return vscode.Disposable.from(
      vscode.workspace.onDidChangeTextDocument(({ document }) => {
        if (document !== this.document) return;
        clearTimeout(this.due);
        this.due = setTimeout(() => this.tell({ text: document.getText() }), QUIET_MS);
      }),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor, kind }) => {
        // Of those that the panel itself makes no kind is known.
        if (textEditor.document === this.document && kind !== undefined) this.tell({ line: lineOf(textEditor) });
      }),
      { dispose: () => this.panel?.dispose() },
    );
  }

  /** Shows the program of an editor. */
  async show(editor: vscode.TextEditor): Promise<void> {
    this.document = editor.document;
    if (this.panel !== undefined) {
      this.panel.reveal(undefined, true);
      this.open();
      return;
    }
    const [script, style, worker, module] = await Promise.all(["app.js", "app.css", "worker.js", "page.wasm"].map((name) => this.part(name)));
    const panel = vscode.window.createWebviewPanel(
      "chordal.path",
      "Path",
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
    );
    this.panel = panel;
    const text = (bytes: Uint8Array | undefined): string => new TextDecoder().decode(bytes);
    panel.onDidDispose(() => (this.panel = undefined));
    panel.webview.onDidReceiveMessage((told: FromPanel) => {
      if ("line" in told) return this.reveal(told.line);
      this.tell({ parts: { module: new Uint8Array(module ?? []), worker: text(worker) } });
      this.open();
    });
    panel.webview.html = page(text(script), text(style));
  }

  /** Other files lie next to the program now. */
  filesChanged(): void {
    this.tell({ files: this.files() });
  }

  private open(): void {
    const { document } = this;
    if (document === undefined || this.panel === undefined) return;
    const name = document.uri.path;
    this.panel.title = `Path of ${name.split("/").pop() ?? name}`;
    const editor = vscode.window.visibleTextEditors.find((own) => own.document === document);
    const machine = this.machine().trim() || undefined;
    this.tell({ open: { name, text: document.getText(), files: this.files(), machine, line: editor ? lineOf(editor) : 1 } });
  }

  private tell(message: ToPanel): void {
    void this.panel?.webview.postMessage(message);
  }

  /** Puts the cursor of the editor on a line. */
  private reveal(line: number): void {
    const editor = vscode.window.visibleTextEditors.find((own) => own.document === this.document);
    if (editor === undefined || lineOf(editor) === line) return;
    const at = new vscode.Position(line - 1, 0);
    editor.selection = new vscode.Selection(at, at);
    editor.revealRange(new vscode.Range(at, at), vscode.TextEditorRevealType.InCenterIfOutsideViewport);
  }

  private part(name: string): Thenable<Uint8Array> {
    return vscode.workspace.fs.readFile(vscode.Uri.joinPath(this.folder, name));
  }
}

function lineOf(editor: vscode.TextEditor): number {
  return editor.selection.active.line + 1;
}

/** The page of the panel, with its script and its styles in it. */
function page(script: string, style: string): string {
  const nonce = crypto.randomUUID();
  const policy = [
    "default-src 'none'", `script-src 'nonce-${nonce}' 'wasm-unsafe-eval'`, "worker-src blob:", "img-src data:", "style-src 'unsafe-inline'",
  ].join("; ");
  // What would end the element, or begin a comment in it, is written otherwise: in JavaScript it means the same.
  const inline = script.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta http-equiv="Content-Security-Policy" content="${policy}" />
    <title>Chordal</title>
    <style>${style}</style>
  </head>
  <body>
    <div id="app"></div>
    <script nonce="${nonce}">${inline}</script>
  </body>
</html>`;
}
