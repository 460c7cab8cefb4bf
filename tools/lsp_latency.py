#!/usr/bin/env python3
"""How long the language server takes for a keystroke: a client types at several places of a large program
and waits for the diagnostics of each version; then for a hover, the colours of a screen and its hints.

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


def places(lines: list[str]) -> dict[str, tuple[int, int, str]]:
    """What is typed where: a line, a column and what; it is taken back by the next keystroke."""
    middle, last = len(lines) // 2, len(lines) - 5
    feed = next(number for number, line in enumerate(lines) if " F" in line)
    return {
        "a blank in the middle": (middle, len(lines[middle]), " "),
        "a digit in the middle": (middle, len(lines[middle]), "1"),
        "a new line in the middle": (middle, len(lines[middle]), "\n"),
        "a digit near the beginning": (9, len(lines[9]), "1"),
        "a digit near the end": (last, len(lines[last]), "1"),
        "the feed of all that follows": (feed, len(lines[feed]), "1"),
    }


def main() -> None:
    command, path = sys.argv[1], Path(sys.argv[2]).resolve()
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 40
    text = path.read_text()
    lines = text.splitlines()
    client = Client(command)
    client.ask("initialize", {"capabilities": {}})
    client.tell("initialized", {})
    document = {"uri": path.as_uri()}
    began = time.perf_counter()
    opened = {**document, "languageId": "nc", "version": 1, "text": text}
    client.tell("textDocument/didOpen", {"textDocument": opened})
    client.diagnostics(1)
    print(f"{len(lines)} lines; opened: {(time.perf_counter() - began) * 1e3:.1f} ms")
    spent: dict[str, list[float]] = {}
    asked: dict[str, list[float]] = {}
    version = 1
    for name, (line, column, typed) in places(lines).items():
        start = {"line": line, "character": column}
        behind = {"line": line + 1, "character": 0} if typed == "\n" else {**start, "character": column + 1}
        screen = {"start": {"line": line, "character": 0}, "end": {"line": line + 60, "character": 0}}
        for step in range(count):
            version += 1
            change = {"range": {"start": start, "end": behind if step % 2 else start}}
            change["text"] = "" if step % 2 else typed
            changed = {"textDocument": {**document, "version": version}, "contentChanges": [change]}
            began = time.perf_counter()
            client.tell("textDocument/didChange", changed)
            client.diagnostics(version)
            spent.setdefault(name, []).append(time.perf_counter() - began)
            for what, method, more in (
                ("hover", "hover", {"position": {"line": line, "character": 1}}),
                ("colours of a screen", "semanticTokens/range", {"range": screen}),
                ("hints of a screen", "inlayHint", {"range": screen}),
            ):
                # Whoever types on does not wait for hints.
                if what.startswith("hints") and step % 4:
                    continue
                began = time.perf_counter()
                client.ask(f"textDocument/{method}", {"textDocument": document, **more})
                asked.setdefault(what, []).append(time.perf_counter() - began)
    for name, times in [*spent.items(), *asked.items()]:
        median, worst = statistics.median(times) * 1e3, max(times) * 1e3
        print(f"{name}: median {median:.1f} ms, worst {worst:.1f} ms of {len(times)}")
    client.ask("shutdown", None)
    client.tell("exit", {})
    client.process.wait()


if __name__ == "__main__":
    main()
