"""Whole archives: checks all programs of folder trees into one table.

>>> from chordal import archive
>>> done = archive.check("archive/", "results.parquet")                 # doctest: +SKIP
>>> done.programs, done.with_errors                                     # doctest: +SKIP
(9812, 431)

The table is equal to that of ``chordal archive check``, byte for byte, independent of the engine and the number of
workers. A run that was interrupted continues when it is started again with the same ``out``.
"""

from __future__ import annotations

import importlib
import os
import posixpath
import tempfile
import threading
import uuid
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from . import _chordal
from ._machine import Machine, MachineLike, machine_of
from ._program import Tools, _options
from .errors import UsageError

if TYPE_CHECKING:
    from ._control import _ControlName

__all__ = ["Done", "check"]

#: Files in one batch: some tenths of a second of work, which is lost when a worker dies.
_FILES_OF_A_BATCH = 16

#: How often a batch is tried when its workers die, before its files are tried one by one.
_TRIES = 3


@dataclass(frozen=True, slots=True)
class Done:
    """The result of an archive."""

    #: Files with at least one row.
    files: int
    #: Rows of the table.
    rows: int
    #: Programs that were run.
    programs: int
    #: Programs with errors, or stopped by the limit on blocks.
    with_errors: int
    #: Programs with only warnings.
    with_warnings: int
    #: Files and programs that could not be run.
    failed: int
    #: Files that are not programs.
    skipped: int
    #: Files that an earlier run has done.
    resumed: int


class _Tree(NamedTuple):
    """A folder in an fsspec file system."""

    url: str
    system: Any
    top: str

    def at(self, below: str) -> str:
        return f"{self.top}/{below}" if self.top else below


class _File(NamedTuple):
    """A file of the archive. In a tree, ``path`` is relative to the tree."""

    name: str
    path: str
    failure: str | None
    tree: _Tree | None


class _Batch(NamedTuple):
    """Files of one tree or of the disk: index in the table, name, path, and the key of an old record."""

    tree: _Tree | None
    files: list[tuple[int, str, str, str | None]]


@dataclass(frozen=True)
class _Run:
    """What a worker needs in addition to its files."""

    id: str
    version: str
    folder: str
    roots: tuple[str, ...]
    plan: bool
    machine: Machine | None
    control: _ControlName | None
    tools: Tools | None
    settings: Mapping[str, object] | None
    block_delete: bool
    max_blocks: int | None

    def worker(
        self, roots: Sequence[str], renamed: tuple[str, str] = ("", "")
    ) -> _chordal.ArchiveWorker:
        options = _options(
            self.machine,
            self.control,
            self.tools,
            self.settings,
            None,
            self.block_delete,
            self.max_blocks,
            None,
        )
        return _chordal.ArchiveWorker(options, self.plan, roots, renamed)


def check(
    paths: str | os.PathLike[str] | Sequence[str | os.PathLike[str]],
    out: str | os.PathLike[str],
    *,
    engine: Literal["local", "ray"] = "local",
    address: str | None = None,
    jobs: int | None = None,
    machine: MachineLike | None = None,
    control: _ControlName | None = None,
    tools: Tools | None = None,
    settings: Mapping[str, object] | None = None,
    block_delete: bool = False,
    max_blocks: int | None = None,
    plan: bool = True,
    storage_options: Mapping[str, Any] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Done:
    """Check every program of folder trees and write one Parquet table.

    ``paths`` are folders and files, on disk or, such as ``s3://bucket/archive``, on any fsspec file system
    (``storage_options`` are passed to it). ``out`` is a file on the caller's disk.

    ``engine="local"`` uses threads of this process: ``jobs``, or as many as there are processors. ``"ray"`` uses the
    workers of the Ray cluster at ``address``, or of one that is started here (``pip install chordal[ray]``); ``jobs``
    then limits the batches at a time. Paths on disk must be visible to every worker under the same names. A batch
    whose worker dies is done again.

    ``machine``, ``control``, ``tools``, ``settings``, ``block_delete`` and ``max_blocks`` are as in
    :func:`chordal.load`. Without ``plan`` there are no times with acceleration and jerk, and the check takes half as
    long. ``progress`` is called with the number of finished files and of all files.

    Raises :class:`OSError` if a path does not exist or the table cannot be written, :class:`~chordal.UsageError` for
    invalid arguments and :class:`~chordal.MachineError` for a wrong machine. A problem with a file of the archive is
    a row of the table.
    """
    given = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    target = os.path.abspath(os.fspath(out))
    if not target.lower().endswith(".parquet") or os.path.isdir(target):
        raise UsageError(f"the table cannot be {os.fspath(out)}", "give it a name that ends in .parquet")
    if engine not in ("local", "ray"):
        raise UsageError(f"there is no engine `{engine}`", "the engines are `local` and `ray`")
    roots = [os.fspath(path) for path in given]
    run = _Run(
        id=uuid.uuid4().hex,
        version=_chordal.__version__,
        folder=os.getcwd(),
        roots=tuple(root for root in roots if "://" not in root),
        plan=plan,
        machine=None if machine is None else machine_of(machine),
        control=control,
        tools=tools if tools is None or isinstance(tools, Mapping) else os.path.abspath(tools),
        settings=settings,
        block_delete=block_delete,
        max_blocks=max_blocks,
    )
    # Errors of the machine are reported before the archive is listed.
    run.worker(())
    files = _listed(roots, target, storage_options or {})
    if not files:
        raise UsageError("there is no file in the folders", "name a folder of programs")
    journal = _chordal.Journal(target, [file.name for file in files])
    for place, file in enumerate(files):
        if file.failure is not None:
            journal.put(place, _chordal.archive_failed(file.name, file.failure))
    batches = _batches(files, journal)
    done = len(files) - sum(len(batch.files) for batch in batches)
    resumed = 0
    results = _on_ray(batches, run, address, jobs) if engine == "ray" else _on_threads(batches, run, jobs)
    for batch, records in results:
        for (place, *_), record in zip(batch.files, records, strict=True):
            if record:
                journal.put(place, record)
            else:
                resumed += 1
        done += len(batch.files)
        if progress is not None:
            progress(done, len(files))
    return Done(*journal.finish(), resumed)


def _listed(roots: Sequence[str], target: str, storage: Mapping[str, Any]) -> list[_File]:
    """All files in the order of the table, without duplicates."""
    local = [root for root in roots if "://" not in root]
    for root in local:
        os.stat(root)  # a path that does not exist is an error
    own = [target, _chordal.Journal.folder_of(target)]
    files = [_File(*found, None) for found in _chordal.archive_walk(local, own)]
    for root in roots:
        if "://" in root:
            files.extend(_listed_elsewhere(root, storage))
    files.sort(key=lambda file: os.fsencode(file.path if file.tree is None else file.name))
    return [file for i, file in enumerate(files) if i == 0 or file.name != files[i - 1].name]


def _listed_elsewhere(root: str, storage: Mapping[str, Any]) -> Iterator[_File]:
    core: Any = _needed("fsspec.core", f"{root} needs fsspec")
    system, top = core.url_to_fs(root, **storage)
    url, top = root.rstrip("/"), top.rstrip("/")
    if not system.exists(top):
        raise FileNotFoundError(f"there is no {root}")
    found = [top] if system.isfile(top) else system.find(top)
    if found == [top]:
        url, top = posixpath.dirname(url), posixpath.dirname(top)
    tree = _Tree(url, system, top)
    for path in found:
        below = path[len(top) :].strip("/")
        if not any(part.startswith(".") for part in below.split("/")):
            yield _File(f"{url}/{below}", below, None, tree)


def _needed(module: str, message: str) -> Any:
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise UsageError(message, "pip install chordal[ray]") from error


def _batches(files: Sequence[_File], journal: _chordal.Journal) -> list[_Batch]:
    batches: list[_Batch] = []
    for place, file in enumerate(files):
        if file.failure is not None:
            continue
        last = batches[-1] if batches else None
        if last is None or last.tree is not file.tree or len(last.files) >= _FILES_OF_A_BATCH:
            last = _Batch(file.tree, [])
            batches.append(last)
        last.files.append((place, file.name, file.path, journal.key(place)))
    return batches


#: The worker of the current thread, and the run to which it belongs.
_held = threading.local()


def _done(batch: _Batch, run: _Run) -> list[bytes]:
    """The records of a batch, which is the unit of work of both engines."""
    if batch.tree is not None:
        return _done_of_tree(batch.tree, batch.files, run)
    if getattr(_held, "run", None) != run.id:
        _held.worker = run.worker(run.roots)
        _held.run = run.id
    records: list[bytes] = _held.worker.records([file[1:] for file in batch.files])
    return records


def _done_of_tree(
    tree: _Tree, files: Sequence[tuple[int, str, str, str | None]], run: _Run
) -> list[bytes]:
    """The records of files in an fsspec tree, which are copied here with all files that their runs need."""
    with tempfile.TemporaryDirectory(prefix="chordal-") as stage:
        failures = {name: _bring(tree, below, stage) for _, name, below, _ in files}
        here = [below for _, name, below, _ in files if failures[name] is None]
        for folder in sorted({posixpath.dirname(below) for below in here}):
            texts = [below for below in here if posixpath.dirname(below) == folder]
            _bring_beside(tree, folder, texts, stage)
        worker = run.worker([stage], (os.path.join(stage, ""), f"{tree.url}/"))
        records = []
        for _, name, below, known in files:
            failure = failures[name]
            if failure is None:
                records += worker.records([(name, _place(stage, below), known)])
            else:
                records.append(_chordal.archive_failed(name, failure))
        return records


def _place(stage: str, below: str) -> str:
    return os.path.join(stage, *below.split("/"))


def _bring(tree: _Tree, below: str, stage: str) -> str | None:
    """Copies a file here; returns a message if it cannot be read. Temporary failures are raised."""
    place = _place(stage, below)
    os.makedirs(os.path.dirname(place), exist_ok=True)
    try:
        tree.system.get_file(tree.at(below), place)
    except (FileNotFoundError, PermissionError) as error:
        if os.path.exists(place):
            os.unlink(place)
        return f"cannot read {tree.url}/{below}: {type(error).__name__}"
    return None


def _bring_beside(tree: _Tree, folder: str, texts: Sequence[str], stage: str) -> None:
    """Copies the machine files of the parent folders, and the whole folder if a program calls others."""
    above = folder
    while True:
        if tree.system.isfile(tree.at(posixpath.join(above, "chordal.toml"))):
            # It may refer to a machine file in its folder.
            _bring_all(tree, above, ".toml", stage)
        if not above:
            break
        above = posixpath.dirname(above)
    if any(_calls(_place(stage, text)) for text in texts):
        _bring_all(tree, folder, "", stage)


def _bring_all(tree: _Tree, folder: str, ending: str, stage: str) -> None:
    """Copies the files of a folder that have this ending and are not here yet."""
    for entry in tree.system.ls(tree.at(folder), detail=True):
        below = posixpath.join(folder, posixpath.basename(entry["name"].rstrip("/")))
        wanted = entry["type"] == "file" and below.endswith(ending)
        if wanted and not os.path.exists(_place(stage, below)):
            _bring(tree, below, stage)


def _calls(path: str) -> bool:
    with open(path, "rb") as text:
        return _chordal.archive_calls(text.read())


_Results = Iterator[tuple[_Batch, list[bytes]]]


def _on_threads(batches: Sequence[_Batch], run: _Run, jobs: int | None) -> _Results:
    count = max(1, jobs if jobs is not None else os.cpu_count() or 1)
    left = deque(batches)
    with ThreadPoolExecutor(count) as pool:
        running: dict[Future[list[bytes]], _Batch] = {}
        try:
            while left or running:
                while left and len(running) < 2 * count:
                    batch = left.popleft()
                    running[pool.submit(_done, batch, run)] = batch
                finished, _ = wait(running, return_when=FIRST_COMPLETED)
                for future in finished:
                    yield running.pop(future), future.result()
        finally:
            for future in running:
                future.cancel()


def _done_on_ray(batch: _Batch, run: _Run) -> list[bytes]:
    if run.version != _chordal.__version__:
        message = f"a worker has Chordal {_chordal.__version__}, and this is {run.version}"
        raise UsageError(message, "install the same version on all machines of the cluster")
    if any(not os.path.isabs(root) for root in run.roots):
        os.chdir(run.folder)
    return _done(batch, run)


def _on_ray(
    batches: Sequence[_Batch], run: _Run, address: str | None, jobs: int | None
) -> _Results:
    ray: Any = _needed("ray", "the engine `ray` needs Ray")
    started = not ray.is_initialized()
    if started:
        options = {"include_dashboard": False} if address is None else {"address": address}
        ray.init(log_to_driver=False, **options)
    try:
        yield from _by_ray(ray, batches, run, jobs)
    finally:
        if started:
            ray.shutdown()


def _by_ray(ray: Any, batches: Sequence[_Batch], run: _Run, jobs: int | None) -> _Results:
    # One batch waits for every worker, so that none is idle.
    most = jobs if jobs is not None else 2 * int(ray.cluster_resources().get("CPU", 1))
    task = ray.remote(max_retries=_TRIES - 1, retry_exceptions=[OSError])(_done_on_ray)
    shared = ray.put(run)
    left = deque(batches)
    running: dict[Any, _Batch] = {}
    try:
        while left or running:
            while left and len(running) < max(1, most):
                batch = left.popleft()
                running[task.remote(batch, shared)] = batch
            (reference, *_), _ = ray.wait(list(running), num_returns=1)
            batch = running.pop(reference)
            try:
                yield batch, ray.get(reference)
            except (ray.exceptions.WorkerCrashedError, ray.exceptions.NodeDiedError):
                if len(batch.files) > 1:
                    # One of the files kills its worker; the others must not be affected.
                    left.extend(_Batch(batch.tree, [file]) for file in batch.files)
                else:
                    message = f"its worker died {_TRIES} times"
                    yield batch, [_chordal.archive_failed(batch.files[0][1], message)]
    finally:
        for reference in running:
            ray.cancel(reference)
