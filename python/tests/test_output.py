"""Tests that a name holds the earlier file or the whole new one, also after errors and signals."""

import os
import signal
import stat
import subprocess
import sys
import textwrap

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import LABELS
from volume_fraction_mesh._output import whole_file

SIGNALS = (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
# Places in which the signal arrives: a function, and whether the output is new afterwards.
PLACES = {
    "volume_fraction_mesh.__main__.read": False,
    "volume_fraction_mesh._npz.np.savez": False,
    "volume_fraction_mesh._output.os.fsync": False,
    "volume_fraction_mesh._output.os.replace": True,
}
# Runs vfmesh; the signal arrives when the function has been called.
PROGRAM = textwrap.dedent("""
    import importlib, os, sys
    from volume_fraction_mesh.__main__ import main
    place, number, *words = sys.argv[1:]
    module, *names = place.split(".")
    while names[:1] and names[0].startswith("_"):
        module += "." + names.pop(0)
    holder = importlib.import_module(module)
    for name in names[:-1]:
        holder = getattr(holder, name)
    function = getattr(holder, names[-1])
    def interrupted(*arguments, **options):
        result = function(*arguments, **options)
        os.kill(os.getpid(), int(number))
        return result
    setattr(holder, names[-1], interrupted)
    sys.exit(main(words))
""")


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


@pytest.mark.parametrize("number", SIGNALS)
def test_signals(tmp_path, number):
    np.save(tmp_path / "labels.npy", LABELS)
    for place, is_new in PLACES.items():
        (tmp_path / "mesh.npz").write_bytes(b"earlier")
        before = set(contents(tmp_path))
        run = subprocess.run(
            [sys.executable, "-c", PROGRAM, place, str(int(number)), str(tmp_path / "labels.npy"),
             str(tmp_path / "mesh.npz"), "--quiet"], capture_output=True, text=True, check=False)
        assert run.returncode == -number, (place, run)
        assert run.stderr == "vfmesh: ended by %s; unfinished files are removed.\n" % (
            signal.Signals(number).name), (place, run)
        after = contents(tmp_path)
        assert set(after) == before, (place, after.keys())
        assert (after["mesh.npz"] != b"earlier") == is_new, place
        if is_new:
            assert len(vfm.load(tmp_path / "mesh.npz").cells) > 0


# Runs vfmesh; the signal arrives in a function that VTK's library calls while it is loaded.
LOADING = textwrap.dedent("""
    import os, signal, sys
    from volume_fraction_mesh.__main__ import main
    loads = []
    def watch(frame, event, function):
        if event == "c_call" and function.__name__ == "exec_dynamic":
            loads.append("vtkCommonCore" in str(frame.f_locals.get("args")))
        elif event == "c_return" and function.__name__ == "exec_dynamic":
            loads.pop()
        elif event == "call" and loads and loads[-1]:
            sys.setprofile(None)
            os.kill(os.getpid(), signal.SIGTERM)
    sys.setprofile(watch)
    sys.exit(main(sys.argv[1:]))
""")


def test_a_signal_while_vtk_is_loaded(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    image = pyvista.ImageData(dimensions=(13, 13, 13))
    image.cell_data["labels"] = LABELS.ravel("F")
    image.save(tmp_path / "in.vti")
    run = subprocess.run(
        [sys.executable, "-c", LOADING, str(tmp_path / "in.vti"), str(tmp_path / "mesh.vtu")],
        capture_output=True, text=True, check=False)
    assert run.returncode == -signal.SIGTERM, run
    assert run.stderr == "vfmesh: ended by SIGTERM; unfinished files are removed.\n", run
    assert set(contents(tmp_path)) == {"in.vti"}


# Runs vfmesh on a legacy file, whose reading by another process does not end.
CONVERTING = textwrap.dedent("""
    import os, signal, subprocess, sys, threading, time
    from volume_fraction_mesh.__main__ import main
    start = subprocess.Popen
    def wait(words, **options):
        process = start([sys.executable, "-c", "import time; time.sleep(600)"], **options)
        print(process.pid, flush=True)
        threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGTERM)).start()
        return process
    subprocess.Popen = wait
    sys.exit(main(sys.argv[1:]))
""")


def test_a_signal_while_another_process_reads(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    pyvista.ImageData(dimensions=(3, 3, 3)).save(tmp_path / "in.vtk")
    (tmp_path / "temporary").mkdir()
    run = subprocess.run(
        [sys.executable, "-c", CONVERTING, str(tmp_path / "in.vtk"), str(tmp_path / "mesh.vtu")],
        capture_output=True, text=True, check=False,
        env={**os.environ, "TMPDIR": str(tmp_path / "temporary")})
    assert run.returncode == -signal.SIGTERM and run.stderr.startswith("vfmesh: ended by"), run
    assert not os.listdir(tmp_path / "temporary")
    with pytest.raises(ProcessLookupError):
        os.kill(int(run.stdout), 0)


def test_an_ignored_signal(tmp_path):
    np.save(tmp_path / "labels.npy", LABELS)
    run = subprocess.run(
        ["nohup", sys.executable, "-c", PROGRAM, "volume_fraction_mesh._npz.np.savez",
         str(int(signal.SIGHUP)), str(tmp_path / "labels.npy"), str(tmp_path / "mesh.npz"),
         "--quiet"], capture_output=True, stdin=subprocess.DEVNULL, text=True, check=False)
    assert run.returncode == 0 and set(contents(tmp_path)) == {"labels.npy", "mesh.npz"}, run


def test_errors_keep_the_earlier_files(tmp_path):
    mesh = vfm.hexes(labels=LABELS)
    for name in ("mesh.npz", "mesh.vtk", "mesh.vtu", "mesh.e", "mesh.inp", "mesh.xdmf"):
        path = tmp_path / name
        path.write_bytes(b"earlier")
        path.chmod(0o640)
        with pytest.raises(TypeError):
            mesh.save(path, nothing=1)
        assert path.read_bytes() == b"earlier", name
        mesh.save(path)
        assert path.read_bytes() != b"earlier" and stat.S_IMODE(path.stat().st_mode) == 0o640, name
    assert not [name for name in contents(tmp_path) if name.startswith(".")]


def test_files_of_a_block_are_replaced_together(tmp_path):
    order = []
    for name in ("a.xmf", "b.h5"):
        (tmp_path / name).write_text("earlier")
    with pytest.raises(ValueError, match="stop"):
        with whole_file(str(tmp_path / "a.xmf")) as path:
            for name in ("a.xmf", "b.h5"):
                with open(os.path.join(os.path.dirname(path), name), "w", encoding="ascii") as file:
                    file.write("part")
            raise ValueError("stop")
    assert set(contents(tmp_path).values()) == {b"earlier"}
    replace = os.replace
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "replace", lambda source, target: (order.append(os.path.basename(target)),
                                                             replace(source, target)))
        with whole_file(str(tmp_path / "a.xmf")) as path:
            for name in ("a.xmf", "b.h5"):
                with open(os.path.join(os.path.dirname(path), name), "w", encoding="ascii") as file:
                    file.write("new")
    assert order == ["b.h5", "a.xmf"] and contents(tmp_path) == {"a.xmf": b"new", "b.h5": b"new"}


def test_links_and_pipes(tmp_path):
    mesh = vfm.hexes(labels=LABELS)
    (tmp_path / "far").mkdir()
    (tmp_path / "link.npz").symlink_to("far/mesh.npz")
    mesh.save(tmp_path / "link.npz")
    assert (tmp_path / "link.npz").is_symlink() and (tmp_path / "far" / "mesh.npz").is_file()
    os.mkfifo(tmp_path / "pipe.vtk")
    with open(tmp_path / "read", "wb") as read, subprocess.Popen(
            ["cat", str(tmp_path / "pipe.vtk")], stdout=read):
        mesh.save(tmp_path / "pipe.vtk")
    mesh.save(tmp_path / "file.vtk")
    assert contents(tmp_path)["read"] == contents(tmp_path)["file.vtk"]
    (tmp_path / "full.npz").symlink_to("/dev/full")
    with pytest.raises(OSError, match="No space left"):
        mesh.save(tmp_path / "full.npz")
    assert stat.S_ISCHR(os.stat("/dev/full").st_mode)
