"""Where the numbers lie: the addresses of one column as every library has it.

    python python/benchmarks/copies.py examples/haas/thread-mill.nc
"""

from __future__ import annotations

import sys

import duckdb
import pandas
import polars
import pyarrow

import chordal


def main(file: str) -> None:
    """Print the addresses."""
    run = chordal.load(file).trajectory(0.001)
    arrow = pyarrow.table(run)
    kept = arrow.to_pandas(types_mapper=pandas.ArrowDtype)["x_mm"].array.__arrow_array__()
    addresses = {
        "numpy, run['x_mm']": run["x_mm"].__array_interface__["data"][0],
        "numpy, run.position (n, axes)": run.position.__array_interface__["data"][0],
        "pyarrow": arrow["x_mm"].chunk(0).buffers()[1].address,
        "polars": polars.DataFrame(run)["x_mm"].to_numpy().__array_interface__["data"][0],
        "pandas, ArrowDtype": kept.chunk(0).buffers()[1].address,
        "pandas": pandas.DataFrame.from_arrow(run)["x_mm"].to_numpy().__array_interface__["data"][0],
    }
    print(f"{len(run)} rows, {run.nbytes / 1e6:.1f} MB")
    for name, address in addresses.items():
        same = "the same memory" if address == addresses["pyarrow"] else "a copy"
        print(f"{name:32} {address:#x}  {same}")
    count = duckdb.sql("select count(*) from arrow")
    print("duckdb counts in place:", count)


if __name__ == "__main__":
    main(sys.argv[1])
