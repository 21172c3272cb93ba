# SPDX-License-Identifier: MIT
"""A parameter sweep of the pivot experiment on a cluster: rotation of the block over offset and grip. Needs dask.distributed.

python 7_sweep.py                     two workers on this machine, one of which is killed on the way
python 7_sweep.py tcp://HOST:8786     the same on your scheduler's workers
"""

import sys
import time

import limitcurve as lc
import matplotlib.pyplot as plt
import numpy as np
from distributed import Client, LocalCluster

OFFSETS = np.linspace(0.002, 0.02, 8)  # of the centre of mass [m]
OPENINGS = np.geomspace(1, 8, 8)  # time in which the grip falls from 5 N to 0 [s]


def turned(offset: float, over: float) -> float:
    """Rotation of the block at the end [rad]."""
    table = lc.run("pivot", case="exact", material="sandpaper", offset=offset, release=f"from=5,to=0,over={over}")
    return float(table["angle"][-1])


def main() -> None:
    jobs = [(float(offset), float(over)) for offset in OFFSETS for over in OPENINGS]
    began = time.perf_counter()
    serial = [turned(*job) for job in jobs]
    serial_seconds = time.perf_counter() - began

    local = len(sys.argv) < 2
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) if local else Client(sys.argv[1]) as cluster:
        with Client(cluster) if local else cluster as client:
            client.wait_for_workers(1)
            began = time.perf_counter()
            futures = client.map(turned, *zip(*jobs))
            if local:  # another worker repeats the lost tasks
                while sum(future.done() for future in futures) < len(jobs) // 8:
                    time.sleep(0.01)
                next(iter(cluster.workers.values())).process.process.kill()
                assert not all(future.done() for future in futures), "it was done before a worker was killed"
            swept = client.gather(futures)
            seconds = time.perf_counter() - began
    print(f"{len(jobs)} runs: one after the other {serial_seconds:.1f} s, swept {seconds:.1f} s")
    assert swept == serial

    figure, axes = plt.subplots(layout="constrained")
    drawn = axes.pcolormesh(OPENINGS, 1e3 * OFFSETS, np.degrees(swept).reshape(len(OFFSETS), -1), shading="nearest")
    axes.set(xscale="log", xlabel="the grip eases over [s]", ylabel="offset of the centre of mass [mm]")
    figure.colorbar(drawn, label="turned [°]")
    figure.savefig("7_sweep.svg")


if __name__ == "__main__":
    main()
