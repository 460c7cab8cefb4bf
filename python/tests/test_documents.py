"""What the documents show runs: docs/commands.md, docs/python.md, docstrings, examples, the notebook."""

from __future__ import annotations

import doctest
import os
import re
import subprocess
import sys
import types
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

import chordal
from chordal import _machine, _program, geometry, motion
from conftest import ROOT

# An example, and what it prints where the page shows that.
EXAMPLES = re.compile(r"^```python\n(.*?)^```\n(?:\n```text\n(.*?)^```)?", re.MULTILINE | re.DOTALL)
PAGES = ["docs/commands.md", "docs/python.md", "docs/getting-started/python.md"]


@pytest.mark.parametrize("page", PAGES)
def test_pages(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = (ROOT / page).read_text()
    examples = list(EXAMPLES.finditer(text))
    assert examples, f"{page} has no example"
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    # The examples of a page go on from each other.
    names: dict[str, object] = {}
    written, at = "", 0
    for example in examples:
        capsys.readouterr()
        exec(compile(example[1], page, "exec"), names)
        printed = capsys.readouterr().out
        if example[2] is not None:
            written += text[at : example.start(2)] + printed
            at = example.end(2)
    written += text[at:]
    if os.environ.get("DOCUMENTS_PAGE") == "write":
        (ROOT / page).write_text(written)
    else:
        assert written == text, f"{page} shows something else: DOCUMENTS_PAGE=write writes it anew"


@pytest.mark.parametrize("module", [chordal, _machine, _program, geometry, motion])
def test_docstrings(module: types.ModuleType) -> None:
    result = doctest.testmod(module)
    assert result.attempted > 0 and result.failed == 0


def test_the_example(examples: Path) -> None:
    script = ROOT / "python" / "examples" / "shop.py"
    done = subprocess.run(
        [sys.executable, script, examples / "haas"], capture_output=True, text=True, check=True
    )
    assert "thread-mill.nc" in done.stdout and " s   " in done.stdout


def test_the_notebook(tmp_path: Path) -> None:
    notebook = nbformat.read(  # type: ignore[no-untyped-call]
        ROOT / "python" / "examples" / "program.ipynb", as_version=4
    )
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    resources = {"metadata": {"path": str(tmp_path)}}
    done = NotebookClient(notebook, timeout=120, resources=resources).execute()
    outputs = [output for cell in done.cells for output in cell.get("outputs", [])]
    kinds = {kind for output in outputs for kind in output.get("data", {})}
    assert {"image/svg+xml", "text/html"} <= kinds
    pages = [output["data"]["text/html"] for output in outputs if "text/html" in output.get("data", {})]
    assert any("data:image/svg+xml" in page and "Haas VF-2" in page for page in pages)


def test_the_command() -> None:
    command = Path(sys.executable).with_name("chordal")

    def run(*words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([command, *words], capture_output=True, text=True)

    version = run("--version")
    assert (version.returncode, version.stdout) == (0, f"chordal {chordal.__version__}\n")
    part = ROOT / "examples" / "haas" / "thread-mill.nc"
    assert run("check", "--fail-on", "error", str(part)).returncode == 0
    wrong = run("check", "none.nc")
    assert wrong.returncode == 2 and "none.nc" in wrong.stderr
    usage = run("nothing")
    assert usage.returncode == 2 and "Usage" in usage.stderr
