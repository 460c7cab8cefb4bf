import * as vscode from "vscode";
import { LanguageClient, TransportKind } from "vscode-languageclient/node";

import { initializationOptions, serverCommand, startFailure, type Settings } from "./server.js";

let client: LanguageClient | undefined;

function settings(): Settings {
  const values = vscode.workspace.getConfiguration("chordal");
  return { command: values.get("command", "chordal"), machine: values.get("machine", "") };
}

async function start(): Promise<void> {
  const own = settings();
  const { command, args } = serverCommand(own);
  const run = { command, args, transport: TransportKind.stdio };
  client = new LanguageClient(
    "chordal",
    "Chordal",
    { run, debug: run },
    {
      documentSelector: [{ language: "nc" }],
      initializationOptions: initializationOptions(own),
      synchronize: { configurationSection: "chordal" },
    },
  );
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    const reason = error instanceof Error ? error.message : String(error);
    void vscode.window.showErrorMessage(startFailure(command, reason));
  }
}

async function stop(): Promise<void> {
  const running = client;
  client = undefined;
  await running?.stop();
}

/** Opens the viewer on the file of the active editor, in a terminal of its own. */
function view(): void {
  const file = vscode.window.activeTextEditor?.document;
  if (file === undefined || file.uri.scheme !== "file") {
    void vscode.window.showInformationMessage("Save the program to a file first.");
    return;
  }
  const own = settings();
  const machine = own.machine === "" ? [] : ["--machine", own.machine];
  const shellArgs = ["view", file.uri.fsPath, ...machine];
  vscode.window.createTerminal({ name: "chordal view", shellPath: own.command, shellArgs });
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const restart = async (): Promise<void> => {
    await stop();
    await start();
  };
  context.subscriptions.push(
    vscode.commands.registerCommand("chordal.restart", restart),
    vscode.commands.registerCommand("chordal.view", view),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      if (change.affectsConfiguration("chordal.command")) {
        await restart();
      }
    }),
  );
  await start();
}

export function deactivate(): Promise<void> {
  return stop();
}
