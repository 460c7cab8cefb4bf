#!/usr/bin/env python3
"""Compares what two builds of the command answer, byte for byte.

    tools/compare_builds.py OLD NEW [PROGRAM ...]

Runs every command that takes a program on every program of tests/suite and examples (or on those named), with both builds,
and compares standard output, standard error, the exit code and the files written. Prints each difference with the command
that shows it; exit code 1 if there is one. Meant for changes that must not change an answer.
"""

import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# `{out}` is a file in an empty folder of the run; its bytes are compared too.
COMMANDS = [
    ["run", "--format", "json"],
    ["run", "-o", "{out}.svg"],
    ["run", "-o", "{out}.dxf"],
    ["check"],
    ["check", "--format", "sarif"],
    ["time", "--what-if"],
    ["time", "--format", "json"],
    ["commands", "--format", "jsonl"],
    ["commands", "--format", "canon"],
    ["commands", "--format", "csv"],
    ["path"],
    ["chords", "--tolerance", "0.01"],
    ["sample", "--period", "20ms"],
    ["comp-range"],
    ["stock"],
    ["report", "--date", "2026-01-01", "--output", "{out}.html"],
    ["convert", "--to", "haas-vf2"],
    ["convert", "--to", "linuxcnc-mill"],
    ["transform", "--rotate", "90", "--output", "{out}.nc"],
    ["transform", "--units", "inch"],
    ["restart", "--line", "12"],
]

# A run that takes longer is ended in both builds and not compared.
TIMEOUT_S = 60


def answer(build, command, program):
    """The exit code, the two streams and the files of one run, or None where it takes too long."""
    with tempfile.TemporaryDirectory() as folder:
        head, *rest = [part.replace("{out}", "answer") for part in command]
        line = [build, head, str(program), *rest]
        try:
            done = subprocess.run(
                line, cwd=folder, capture_output=True, timeout=TIMEOUT_S, env=dict(os.environ, NO_COLOR="1")
            )
        except subprocess.TimeoutExpired:
            return None
        files = {path.name: path.read_bytes() for path in sorted(pathlib.Path(folder).iterdir()) if path.is_file()}
        return done.returncode, done.stdout, done.stderr, files


def compare(builds, command, program):
    """What differs in the answers of the builds: names of their parts."""
    answers = [answer(build, command, program) for build in builds]
    if None in answers:
        return ["not compared: too long"] if answers != [None, None] else []
    parts = ("exit code", "standard output", "standard error", "files")
    return [part for part, old, new in zip(parts, *answers) if old != new]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("programs", nargs="*", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    args = parser.parse_args()
    builds = [os.path.abspath(args.old), os.path.abspath(args.new)]
    programs = args.programs or [
        path
        for folder in ("tests/suite", "examples")
        for path in sorted((ROOT / folder).rglob("*"))
        if path.suffix in (".nc", ".ngc")
    ]
    count = differences = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        tasks = {
            pool.submit(compare, builds, command, program.resolve()): (command, program)
            for program in programs
            for command in COMMANDS
        }
        for task in concurrent.futures.as_completed(tasks):
            command, program = tasks[task]
            count += 1
            if parts := task.result():
                differences += 1
                print(f"{program}: {' '.join(command)}: {', '.join(parts)}", flush=True)
    print(f"{count} answers compared, {differences} differ")
    sys.exit(differences > 0)


if __name__ == "__main__":
    main()
