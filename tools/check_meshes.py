#!/usr/bin/env python3
"""Opens the meshes that Chordal writes with trimesh: closed, the same volume in every form.

    python3 -m venv target/meshes && target/meshes/bin/pip install trimesh networkx lxml
    cargo run --release -p chordal-stock --example meshes -- target/meshes/files
    target/meshes/bin/python tools/check_meshes.py target/meshes/files
"""
import json
import sys
from pathlib import Path

import trimesh

# STL and glTF round coordinates to 32 bits: 6e-8 of a size of about 150 mm. In STL columns that touch are
# 0.0001 mm apart.
SAME_VOLUME = {".stl": 1e-5, ".glb": 1e-5, ".3mf": 1e-9}
METRE = 1000.0
# From metres with Y up.
UPRIGHT = [[METRE, 0, 0, 0], [0, 0, -METRE, 0], [0, METRE, 0, 0], [0, 0, 0, 1]]


def colours(path):
    """How many vertices of a GLB have a colour."""
    data = path.read_bytes()
    size = int.from_bytes(data[12:16], "little")
    document = json.loads(data[20:20 + size])
    attributes = document["meshes"][0]["primitives"][0]["attributes"]
    return document["accessors"][attributes["COLOR_0"]]["count"]


def check(path, expected):
    faults = []
    mesh = trimesh.load_mesh(path, process=False)
    if len(mesh.faces) != expected["triangles"]:
        faults.append(f"{len(mesh.faces)} triangles")
    if path.suffix == ".stl":
        # No vertex is shared in the file.
        mesh.merge_vertices()
    elif len(mesh.vertices) != expected["vertices"]:
        faults.append(f"{len(mesh.vertices)} vertices")
    if path.suffix == ".glb":
        mesh.apply_transform(UPRIGHT)
        if colours(path) != expected["vertices"]:
            faults.append("no colours")
    closed = mesh.is_watertight and mesh.is_winding_consistent
    if not closed:
        faults.append("open")
    off = abs(float(mesh.volume) - expected["volume"]) / expected["volume"]
    if not off <= SAME_VOLUME[path.suffix]:
        faults.append("another volume")
    low, high = mesh.bounds.round(4).tolist()
    print(f"{path.name}: {len(mesh.faces)} triangles, {len(mesh.vertices)} vertices, volume off by {off:.1e}, "
          f"box {low} {high}, {', '.join(faults) or 'closed'}")
    return not faults


def main():
    folder = Path(sys.argv[1])
    rows = json.loads((folder / "meshes.json").read_text())
    results = [check(folder / (row["name"] + suffix), row) for row in rows for suffix in SAME_VOLUME]
    sys.exit(0 if results and all(results) else 1)


main()
