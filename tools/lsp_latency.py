#!/usr/bin/env python3
"""How long the language server takes for a keystroke: a client types digits into the middle of a large
program and waits for the diagnostics of each version, and for a hover and the colours of a screen.

    tools/lsp_latency.py target/release/chordal part.nc [keystrokes]
"""

import json
import statistics
import subprocess
import sys
import time
from pathlib import Path


class Client:
    def __init__(self, command: str) -> None:
        pipe = subprocess.PIPE
        self.process = subprocess.Popen([command, "lsp"], stdin=pipe, stdout=pipe)
        self.next = 0

    def send(self, message: dict) -> None:
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.process.stdin.flush()

    def receive(self) -> dict:
        size = 0
        while line := self.process.stdout.readline().strip():
            if line.lower().startswith(b"content-length:"):
                size = int(line.split(b":")[1])
        return json.loads(self.process.stdout.read(size))

    def tell(self, method: str, params: dict) -> None:
        self.send({"method": method, "params": params})

    def ask(self, method: str, params: dict | None) -> dict:
        self.next += 1
        self.send({"id": self.next, "method": method, "params": params})
        while (answer := self.receive()).get("id") != self.next:
            pass
        return answer

    def diagnostics(self, version: int) -> None:
        while True:
            message = self.receive()
            if message.get("params") and message["params"].get("version") == version:
                return


def main() -> None:
    command, path = sys.argv[1], Path(sys.argv[2]).resolve()
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 30
    text = path.read_text()
    lines = text.splitlines()
    middle = len(lines) // 2
    column = len(lines[middle])
    client = Client(command)
    client.ask("initialize", {"capabilities": {}})
    client.tell("initialized", {})
    document = {"uri": path.as_uri()}
    began = time.perf_counter()
    opened = {**document, "languageId": "nc", "version": 1, "text": text}
    client.tell("textDocument/didOpen", {"textDocument": opened})
    client.diagnostics(1)
    print(f"{len(lines)} lines; opened: {(time.perf_counter() - began) * 1e3:.1f} ms")
    spent: dict[str, list[float]] = {"diagnostics": [], "hover": [], "colours of a screen": []}
    place = {"line": middle, "character": column}
    screen = {"start": {"line": middle, "character": 0}, "end": {"line": middle + 60, "character": 0}}
    for version in range(2, count + 2):
        began = time.perf_counter()
        change = {"range": {"start": place, "end": place}, "text": " "}
        changed = {"textDocument": {**document, "version": version}, "contentChanges": [change]}
        client.tell("textDocument/didChange", changed)
        client.diagnostics(version)
        spent["diagnostics"].append(time.perf_counter() - began)
        for name, method, more in (
            ("hover", "hover", {"position": {"line": middle, "character": 1}}),
            ("colours of a screen", "semanticTokens/range", {"range": screen}),
        ):
            began = time.perf_counter()
            client.ask(f"textDocument/{method}", {"textDocument": document, **more})
            spent[name].append(time.perf_counter() - began)
    for name, times in spent.items():
        median, worst = statistics.median(times) * 1e3, max(times) * 1e3
        print(f"{name}: median {median:.1f} ms, worst {worst:.1f} ms of {count}")
    client.ask("shutdown", None)
    client.tell("exit", {})
    client.process.wait()


if __name__ == "__main__":
    main()
