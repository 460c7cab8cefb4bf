"""Whole archives from Python: the table of the command, whatever the engine."""

from __future__ import annotations

import importlib
import importlib.util
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import fsspec
import pyarrow.parquet as pq
import pytest

import chordal
from chordal import archive
from conftest import BROKEN, PART, ROOT

CALLER = "O1\nG21 G90 S900 M3\nG0 X0 Y0\nM98 P2000\nG0 Z5.\nM30\n"
CALLED = "O2000\nG1 X10. F100.\nM99\n"

#: Endless programs end soon.
BUDGET = 2000

needs_ray = pytest.mark.skipif(
    importlib.util.find_spec("ray") is None, reason="Ray is not installed (pip install chordal[ray])"
)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Some hundred and fifty files with broken ones, a machine file and a caller."""
    maker = ROOT / "tools" / "make_archive.py"
    subprocess.run([sys.executable, maker, tmp_path / "in", "150", "3"], check=True)
    own = tmp_path / "in" / "own"
    own.mkdir()
    (own / "chordal.toml").write_text('machine = "vf2.toml"\n')
    (own / "vf2.toml").write_text('inherits = "haas-vf2"\nname = "own"\n')
    (own / "caller.nc").write_text(CALLER)
    (own / "O2000.nc").write_text(CALLED)
    (own / "part.nc").write_text(PART)
    (own / "broken.nc").write_text(BROKEN)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def check(paths: str | list[str], out: str, **options: Any) -> archive.Done:
    return archive.check(paths, out, max_blocks=BUDGET, plan=False, **options)


def of_command(folder: Path) -> bytes:
    words = ["archive", "check", "in", "--out", "command.parquet", "--no-plan"]
    code = chordal._chordal.main(["chordal", *words, "--max-blocks", str(BUDGET)])
    assert code == 1
    return (folder / "command.parquet").read_bytes()


def test_threads_make_the_table_of_the_command(folder: Path) -> None:
    expected = of_command(folder)
    heard: list[tuple[int, int]] = []
    for jobs in (1, 3):
        done = check("in", "own.parquet", jobs=jobs, progress=lambda *at: heard.append(at))
        assert (folder / "own.parquet").read_bytes() == expected
        assert not (folder / "own.parquet.journal").exists()
    table = pq.read_table(folder / "own.parquet")
    assert done.rows == table.num_rows and done.files > 100 and done.with_errors > 0
    assert heard[-1] == (done.files, done.files) and done.resumed == 0
    rows = {Path(row["path"]).name: row for row in table.to_pylist() if "/own/" in row["path"]}
    assert rows["caller.nc"]["machine"] == "own" and rows["caller.nc"]["x_max_mm"] == 10.0
    assert rows["broken.nc"]["problems"][0]["line"] == 3


def test_an_interrupted_run_goes_on(folder: Path) -> None:
    def stop(done: int, _: int) -> None:
        if done > 40:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        check("in", "own.parquet", jobs=2, progress=stop)
    assert not (folder / "own.parquet").exists()
    done = check("in", "own.parquet", jobs=2)
    assert done.resumed > 0
    assert (folder / "own.parquet").read_bytes() == of_command(folder)


def test_what_makes_no_sense(folder: Path) -> None:
    with pytest.raises(chordal.UsageError, match="ends in .parquet"):
        check("in", "in/own/part.nc")
    with pytest.raises(chordal.UsageError, match="no engine `cloud`"):
        check("in", "own.parquet", engine="cloud")
    with pytest.raises(chordal.UsageError):
        check("in", "own.parquet", machine="nobodys")
    with pytest.raises(FileNotFoundError):
        check(["in", "nowhere"], "own.parquet")
    with pytest.raises(FileNotFoundError):
        check("memory://nowhere", "own.parquet")
    assert not (folder / "own.parquet").exists()


def rows(table: Path, prefix: str) -> list[dict[str, Any]]:
    """The rows of a table, with paths below the root."""
    found: list[dict[str, Any]] = pq.read_table(table).to_pylist()
    for row in found:
        for column in ("path", "chosen"):
            row[column] = row[column] and row[column].removeprefix(prefix)
    return found


def test_another_file_system(folder: Path) -> None:
    """The same rows as from the disk, but for the paths."""
    memory = fsspec.filesystem("memory")
    memory.put(str(folder / "in"), "/archive", recursive=True)
    check("memory://archive", "memory.parquet", jobs=2)
    check("in", "disk.parquet")
    found = rows(folder / "memory.parquet", "memory://archive/")
    assert found == rows(folder / "disk.parquet", "in/")


def busy() -> list[int]:
    """The worker processes of this machine that are at a batch."""
    found = []
    for entry in Path("/proc").iterdir():
        try:
            command = (entry / "cmdline").read_bytes() if entry.name.isdigit() else b""
        except OSError:
            continue
        if command.startswith(b"ray::_done_on_ray"):
            found.append(int(entry.name))
    return found


@needs_ray
def test_ray_workers_may_die(folder: Path) -> None:
    """Real worker processes, one of which is killed in the middle of the run."""
    ray = importlib.import_module("ray")
    expected = of_command(folder)
    killed: list[int] = []

    def kill_one(done: int, _: int) -> None:
        """Kills a worker that is in the middle of a batch, once."""
        until = time.monotonic() + 2
        while done > 20 and not killed and time.monotonic() < until:
            for process in busy()[:1]:
                os.kill(process, signal.SIGKILL)
                killed.append(process)

    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        done = check("in", "ray.parquet", engine="ray", progress=kill_one)
        # Another file system, which every process sees.
        check((folder / "in").as_uri(), "uri.parquet", engine="ray")
    finally:
        ray.shutdown()
    assert killed, "no worker was killed"
    assert done.files > 100
    assert (folder / "ray.parquet").read_bytes() == expected
    found = rows(folder / "uri.parquet", f"{(folder / 'in').as_uri()}/")
    assert found == rows(folder / "ray.parquet", "in/")


@needs_ray
def test_a_file_that_ends_every_worker_is_a_row(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ray = importlib.import_module("ray")
    work = archive._done_on_ray

    def dies(batch: Any, run: Any) -> list[bytes]:
        if any(file[1].endswith("part.nc") for file in batch.files):
            os.kill(os.getpid(), signal.SIGKILL)
        return work(batch, run)

    monkeypatch.setattr(archive, "_done_on_ray", dies)
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False)
    try:
        done = check("in/own", "ray.parquet", engine="ray")
    finally:
        ray.shutdown()
    assert done.failed == 1
    check("in/own", "disk.parquet")
    found, expected = rows(folder / "ray.parquet", ""), rows(folder / "disk.parquet", "")
    places = [i for i, row in enumerate(expected) if row["path"] == "in/own/part.nc"]
    for i in reversed(places):
        assert found[i]["status"] == "failed" and found[i]["message"] == "its worker died 3 times"
        del found[i], expected[i]
    assert len(places) == 1 and found == expected
