"""Tests runs: progress, Ctrl-C, threads, memory."""

import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, PLATE, ball, same

INTERRUPTED = """
import os, signal, sys, threading, time
import numpy as np
import volume_fraction_mesh as vfm
x = np.arange(160) - 80.0
fraction = (x[:, None, None] ** 2 + x[:, None] ** 2 + x ** 2 < 70 ** 2).astype(float)
sent = []
def interrupt():
    sent.append(time.perf_counter())
    os.kill(os.getpid(), signal.SIGINT)
threading.Timer(float(sys.argv[1]), interrupt).start()
try:
    vfm.hexes(fraction, refinement="uniform", threads=int(sys.argv[2]))
except KeyboardInterrupt:
    print(time.perf_counter() - sent[0])
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals")
@pytest.mark.parametrize("after, threads", [(1.0, 1), (2.0, 2), (4.0, 2)])
def test_interrupt(after, threads):
    run = subprocess.run(
        [sys.executable, "-c", INTERRUPTED, str(after), str(threads)], capture_output=True,
        text=True, timeout=100
    )
    assert run.returncode == 0 and run.stdout, run.stderr
    print("Ctrl-C after %.0f s ended the run in %.2f s" % (after, float(run.stdout)))
    assert float(run.stdout) < 10


def test_two_at_once():
    """Meshes made at the same time equal meshes made one after the other."""
    makes = [lambda: vfm.hexes([BALL, PLATE]), lambda: vfm.tets(ball(14))] * 2
    alone = [make() for make in makes]
    together = [None] * len(makes)

    def run(i):
        together[i] = makes[i]()

    workers = [threading.Thread(target=run, args=(i,)) for i in range(len(makes))]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert all(same(mesh, expected) for mesh, expected in zip(together, alone))


def test_others_run_meanwhile():
    """The interpreter is free while a mesh is made."""
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.005)

    clock = threading.Thread(target=tick)
    clock.start()
    start = time.perf_counter()
    vfm.tets(ball(24), threads=1)
    took = time.perf_counter() - start
    done.set()
    clock.join()
    assert len(ticks) > 0.1 * took / 0.005


def test_progress_of_a_function():
    told = []
    vfm.hexes([BALL, PLATE], progress=lambda fraction, stage: told.append((fraction, stage)))
    assert all(0 <= fraction <= 1 and isinstance(stage, str) and stage for fraction, stage in told)
    assert len({stage for _, stage in told}) > 3
    shapes = []
    vfm.shapes("sphere radius=5 center=6,6,6", 12, progress=lambda fraction,
               stage: shapes.append(fraction))
    assert shapes


def test_progress_that_raises():
    class Enough(Exception):
        pass

    def stop(fraction, stage):
        if fraction > 0.2:
            raise Enough(stage)

    with pytest.raises(Enough):
        vfm.hexes([BALL, PLATE], progress=stop)
    assert len(vfm.hexes([BALL, PLATE], progress=False))


def test_progress_is_shown(capsys, monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    vfm.hexes([BALL], progress=True)
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) > 3 and all(" % " in line for line in lines)


def test_progress_by_tqdm(capsys):
    pytest.importorskip("tqdm")
    vfm.hexes([BALL], progress=True)
    assert "100%" in capsys.readouterr().err


def test_arrays_are_not_changed_nor_kept():
    array = BALL.copy(order="F")
    array.flags.writeable = False
    count = sys.getrefcount(array)
    mesh = vfm.hexes(array, state={"T": array * 2})
    assert np.array_equal(array, BALL) and sys.getrefcount(array) == count
    assert mesh.points.flags.writeable


def test_signal_handlers_stay():
    before = signal.getsignal(signal.SIGINT)
    vfm.hexes(BALL)
    assert signal.getsignal(signal.SIGINT) is before
