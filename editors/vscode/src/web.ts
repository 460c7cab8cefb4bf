// The extension in a browser: the language server is WebAssembly in a worker, and nothing is started.
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/browser";

import { PathPanel } from "./panel.js";
import { initializationOptions } from "./server.js";
import { DEEPEST, isNeeded, isOpen, MOST_BYTES, MOST_FILES, NEEDED, pathOf } from "./web-files.js";

let client: LanguageClient | undefined;
let worker: Worker | undefined;

/** What programs may need, by their paths, as it was brought last. */
let brought: Record<string, string> = {};
let panel: PathPanel | undefined;

/** The addresses of files as the editor knows them, by their paths: the server speaks of paths. */
const known = new Map<string, vscode.Uri>();

function toServer(uri: vscode.Uri): string {
  const path = pathOf(uri);
  known.set(path, uri);
  return path;
}

function machine(): string {
  return vscode.workspace.getConfiguration("chordal").get("machine", "");
}

async function start(context: vscode.ExtensionContext): Promise<void> {
  const dist = vscode.Uri.joinPath(context.extensionUri, "dist");
  const module = await vscode.workspace.fs.readFile(vscode.Uri.joinPath(dist, "chordal.wasm"));
  worker = new Worker(vscode.Uri.joinPath(dist, "worker.js").toString(true));
  worker.postMessage({ module });
  client = new LanguageClient(
    "chordal",
    "Chordal",
    {
      documentSelector: [{ language: "nc" }],
      initializationOptions: initializationOptions({ command: "", machine: machine() }),
      synchronize: { configurationSection: "chordal" },
      uriConverters: {
        code2Protocol: toServer,
        protocol2Code: (value) => known.get(value) ?? vscode.Uri.parse(value),
      },
    },
    worker,
  );
  await client.start();
  await bringFiles();
}

/** Brings the server what programs may need: machine files, and the programs that others may call. */
async function bringFiles(): Promise<void> {
  const files: Record<string, string> = {};
  let bytes = 0;
  // Not by a search: folders that only an extension knows may have none.
  let folders = (vscode.workspace.workspaceFolders ?? []).map((folder) => folder.uri);
  for (let depth = 0; depth < DEEPEST && folders.length > 0; depth++) {
    const below: vscode.Uri[] = [];
    for (const folder of folders) {
      for (const [name, kind] of await listed(folder)) {
        const uri = vscode.Uri.joinPath(folder, name);
        if ((kind & vscode.FileType.Directory) !== 0) {
          if (isOpen(name)) below.push(uri);
        } else if (isNeeded(name) && Object.keys(files).length < MOST_FILES) {
          const content = await read(uri);
          if (content === undefined || bytes + content.length > MOST_BYTES) continue;
          bytes += content.length;
          files[uri.path] = new TextDecoder().decode(content);
        }
      }
    }
    folders = below;
  }
  brought = files;
  panel?.filesChanged();
  await client?.sendNotification("chordal/files", files);
}

/** What is in a folder; nothing where it cannot be read. */
async function listed(folder: vscode.Uri): Promise<[string, vscode.FileType][]> {
  try {
    return await vscode.workspace.fs.readDirectory(folder);
  } catch {
    return [];
  }
}

/** A file; nothing where it is gone since it was listed. */
async function read(uri: vscode.Uri): Promise<Uint8Array | undefined> {
  try {
    return await vscode.workspace.fs.readFile(uri);
  } catch {
    return undefined;
  }
}

/** Shows the path of the program in the active editor. */
async function view(): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (editor === undefined) {
    void vscode.window.showInformationMessage("Open a program first.");
    return;
  }
  try {
    await panel?.show(editor);
  } catch (error) {
    void vscode.window.showErrorMessage(`The path cannot be shown: ${String(error)}`);
  }
}

async function stop(): Promise<void> {
  const running = client;
  client = undefined;
  await running?.stop().catch(() => undefined);
  worker?.terminate();
  worker = undefined;
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const watcher = vscode.workspace.createFileSystemWatcher(NEEDED);
  let due: ReturnType<typeof setTimeout> | undefined;
  const changed = (): void => {
    clearTimeout(due);
    due = setTimeout(() => void bringFiles(), 300);
  };
  watcher.onDidChange(changed);
  watcher.onDidCreate(changed);
  watcher.onDidDelete(changed);
  panel = new PathPanel(vscode.Uri.joinPath(context.extensionUri, "dist", "view"), () => brought, machine);
  context.subscriptions.push(
    watcher,
    vscode.commands.registerCommand("chordal.restart", async () => {
      await stop();
      await start(context);
    }),
    vscode.commands.registerCommand("chordal.view", view),
    panel.listen(),
  );
  await start(context);
}

export function deactivate(): Promise<void> {
  return stop();
}
