// The client's own protocol library speaks with the real server, as the extension starts it.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";

import protocol from "vscode-languageserver-protocol/node";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "../../..");
const program = process.env.CHORDAL ?? join(root, "target/debug/chordal");
const part = join(root, "examples/haas/parametric.nc");
const uri = pathToFileURL(part).href;

let server;
let connection;
let capabilities;
const told = new Map();
const waiting = [];

before(async () => {
  assert.ok(existsSync(program), `${program} is not built: cargo build -p chordal-cli`);
  server = spawn(program, ["lsp", "--stdio"], { stdio: ["pipe", "pipe", "inherit"] });
  connection = protocol.createProtocolConnection(server.stdout, server.stdin);
  connection.onNotification(protocol.PublishDiagnosticsNotification.type, (found) => {
    told.set(found.version, found.diagnostics);
    waiting.splice(0).forEach((wake) => wake());
  });
  connection.onRequest(protocol.InlayHintRefreshRequest.type, () => undefined);
  connection.listen();
  const answer = await connection.sendRequest(protocol.InitializeRequest.type, {
    processId: process.pid,
    rootUri: null,
    capabilities: {},
  });
  capabilities = answer.capabilities;
  connection.sendNotification(protocol.InitializedNotification.type, {});
  connection.sendNotification(protocol.DidOpenTextDocumentNotification.type, {
    textDocument: { uri, languageId: "nc", version: 1, text: readFileSync(part, "utf8") },
  });
});

after(async () => {
  await connection.sendRequest(protocol.ShutdownRequest.type);
  const ended = new Promise((resolve) => server.once("exit", resolve));
  connection.sendNotification(protocol.ExitNotification.type);
  assert.equal(await ended, 0, "the server ends well");
  connection.dispose();
});

async function diagnostics(version) {
  while (!told.has(version)) {
    await new Promise((resolve) => waiting.push(resolve));
  }
  return told.get(version);
}

const textDocument = { uri };

test("the server says what it can do", () => {
  assert.equal(capabilities.textDocumentSync, protocol.TextDocumentSyncKind.Incremental);
  assert.ok(capabilities.hoverProvider && capabilities.renameProvider.prepareProvider);
});

test("the example is sound, an error is told and goes again", async () => {
  const errors = async (version) =>
    (await diagnostics(version)).filter((found) => found.severity === 1);
  assert.deepEqual(await errors(1), []);
  const start = { line: 0, character: 0 };
  const change = (version, range, text) =>
    connection.sendNotification(protocol.DidChangeTextDocumentNotification.type, {
      textDocument: { uri, version },
      contentChanges: [{ range, text }],
    });
  change(2, { start, end: start }, "G1 X1O.5 F20.\n");
  assert.equal((await errors(2)).length, 1);
  change(3, { start, end: { line: 1, character: 0 } }, "");
  assert.deepEqual(await errors(3), []);
});

test("hover, outline, references and colours answer", async () => {
  const lines = readFileSync(part, "utf8").split(/\r?\n/);
  const line = lines.findIndex((text) => /\bG0*1\b/.test(text));
  const position = { line, character: lines[line].search(/G0*1\b/) };
  const hover = await connection.sendRequest(protocol.HoverRequest.type, { textDocument, position });
  assert.match(hover.contents.value, /G1 on Haas/);
  const symbols = await connection.sendRequest(protocol.DocumentSymbolRequest.type, {
    textDocument,
  });
  assert.ok(symbols.length > 0);
  const at = lines.findIndex((text) => /#\d+\s*=/.test(text));
  const references = await connection.sendRequest(protocol.ReferencesRequest.type, {
    textDocument,
    position: { line: at, character: lines[at].indexOf("#") + 1 },
    context: { includeDeclaration: true },
  });
  assert.ok(references.length > 1);
  const tokens = await connection.sendRequest(protocol.SemanticTokensRequest.type, { textDocument });
  assert.ok(tokens.data.length > 0 && tokens.data.length % 5 === 0);
});
