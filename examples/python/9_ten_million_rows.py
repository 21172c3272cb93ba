# SPDX-License-Identifier: MIT
"""The grip for 10 million rows, in parts on all cores or machines by dask: flat memory, the same bits."""

import resource
from typing import Any

import limitcurve as lc
import numpy as np
from distributed import Client, LocalCluster
from numpy.typing import NDArray

Array = NDArray[Any]
ROWS = 250_000  # of a part


def read(part: int) -> tuple[Array, Array]:
    """Force [N] and moment [N m]; yours come from a file of the part's number."""
    random = np.random.default_rng(part)
    return random.uniform(0, 2, ROWS), random.uniform(0, 5e-3, ROWS)


def grip(part: int, table: lc.Table) -> Any:
    return table.load_to_hold(*read(part), mu=0.6, radius_law="power:c=0.00207,gamma=0.259")


def most(part: int, table: lc.Table) -> tuple[float, float]:
    """The largest grip of a part [N], and the most memory that this process ever had [MiB]."""
    return grip(part, table).max(), resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


if __name__ == "__main__":
    table = lc.Table("hertz", tolerance=1e-8)  # travels to the workers in about 2 KiB
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        memory = []
        for parts in (8, 40):
            found = client.gather(client.map(most, range(parts), table=table, pure=False))
            memory.append(max(used for _, used in found))
            print(f"{parts * ROWS:9} rows: {max(load for load, _ in found):.3f} N at most, {memory[-1]:.0f} MiB")
        there = client.submit(grip, 3, table).result()
    assert memory[1] < 1.2 * memory[0]
    assert np.array_equal(there, grip(3, table))
