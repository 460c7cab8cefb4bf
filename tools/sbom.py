#!/usr/bin/env python3
"""Writes what the packages are made of, as a CycloneDX 1.6 bill of materials.

usage: tools/sbom.py OUT.json

The crates are those that the command, the Python package and the npm package are built from (no
tests, no build tools); the npm packages are those whose code is in the page of `chordal view`.
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def crates() -> list[dict]:
    """The packages of Cargo.lock that a build for this platform takes."""
    host = next(
        line.split()[1]
        for line in subprocess.check_output(["rustc", "-vV"], text=True).splitlines()
        if line.startswith("host:")
    )
    told = subprocess.check_output(
        ["cargo", "metadata", "--format-version", "1", "--locked", "--filter-platform", host], cwd=ROOT
    )
    metadata = json.loads(told)
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    wanted = [package["id"] for package in metadata["packages"] if package["name"].startswith("chordal")]
    seen: set[str] = set()
    while wanted:
        own = wanted.pop()
        if own in seen:
            continue
        seen.add(own)
        for dependency in nodes[own]["deps"]:
            if any(kind["kind"] is None for kind in dependency["dep_kinds"]):
                wanted.append(dependency["pkg"])
    listed = []
    for package in sorted((packages[own] for own in seen), key=lambda package: (package["name"], package["version"])):
        if package["source"] is None:
            continue
        component = {
            "type": "library",
            "name": package["name"],
            "version": package["version"],
            "purl": f"pkg:cargo/{package['name']}@{package['version']}",
        }
        if package["license"]:
            component["licenses"] = [{"expression": package["license"].replace("/", " OR ")}]
        listed.append(component)
    return listed


def npm() -> list[dict]:
    """The packages that web/package.json names as dependencies, and theirs."""
    lock = json.loads((ROOT / "web/package-lock.json").read_text())
    listed = []
    for path, package in sorted(lock["packages"].items()):
        if not path or package.get("dev") or package.get("devOptional"):
            continue
        name = path.rpartition("node_modules/")[2]
        component = {
            "type": "library",
            "name": name,
            "version": package["version"],
            "purl": f"pkg:npm/{name.replace('@', '%40')}@{package['version']}",
        }
        if "license" in package:
            component["licenses"] = [{"expression": package["license"]}]
        listed.append(component)
    return listed


def main() -> None:
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(ROOT / "Cargo.toml", encoding="utf-8") as manifest:
        version = next(line.split('"')[1] for line in manifest if line.startswith("version = "))
    components = crates() + npm()
    bill = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {"component": {"type": "application", "name": "chordal", "version": version}},
        "components": components,
    }
    Path(sys.argv[1]).write_text(json.dumps(bill, indent=2) + "\n", encoding="utf-8")
    print(f"{len(components)} components")


if __name__ == "__main__":
    main()
