"""Scripts of Examples and Data.

- mesh_series.py meshes all steps of a series in order and reports steps that fail
- ball_under_pressure.py and cube_under_pressure.py solve if CalculiX is installed
- write_exodus.py writes a mesh read from a file
- time_ranks.py times two ranks
- the fields of Data and the demo can be reproduced
"""
import contextlib
import csv
import io
import os
import re
import runpy
import shutil
import subprocess
import sys
import tempfile
import types

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataReader, vtkXMLImageDataWriter, vtkXMLUnstructuredGridReader,
    vtkXMLUnstructuredGridWriter)

from mpi_run import mpi_run
from vfmtest import (
    exodus_parts, fraction_image, image, in_folder, main, mesh_of, tet_volumes, write)

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Examples")
DATA = os.path.join(EXAMPLES, "..", "Data")
SCRIPT = os.path.join(EXAMPLES, "mesh_series.py")
ATLAS = "/usr/share/mricron/templates/HarvardOxford-cort-maxprob-thr0-1mm.nii.gz"


def write_image(data, path):
    writer = vtkXMLImageDataWriter()
    writer.SetDataModeToBinary()
    writer.SetInputData(data)
    writer.SetFileName(path)
    assert writer.Write()


def read_image(path):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def run_script(folder, *options):
    files = [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".vti")]
    command = ["pvbatch", SCRIPT, "--plugin", os.environ["VFM_PLUGIN"], "--out",
               os.path.join(folder, "out"), *options, *files]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def read_vtu(folder, name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(os.path.join(folder, "out", name))
    reader.Update()
    return reader.GetOutput()


def block_sizes(path):
    """Returns {block: number of elements} of an Exodus file."""
    return {name: part.GetNumberOfCells() for name, part in exodus_parts(path)}


def test_all_steps_in_order():
    with tempfile.TemporaryDirectory() as folder:
        for step, size in ((2, 8), (10, 12), (9, 10)):
            write_image(fraction_image(size), os.path.join(folder, "dump_%d.vti" % step))
        result = run_script(folder, "--array", "ball", "--array", "plate", "--exodus",
                            "--fragments")
        assert result.returncode == 0, result
        assert result.stdout.count(" elements") == 3
        sizes = []
        for step in range(3):
            mesh = read_vtu(folder, "mesh_%04d.vtu" % step)
            materials = mesh.GetCellData().GetArray("MaterialId")
            ids = [materials.GetValue(i) for i in range(mesh.GetNumberOfCells())]
            blocks = block_sizes(os.path.join(folder, "out", "mesh_%04d.e" % step))
            assert blocks == {"ball": ids.count(1), "plate": ids.count(2)}, blocks
            with open(os.path.join(folder, "out", "mesh_%04d.csv" % step), newline="") as file:
                assert {row["Material"]: int(row["Elements"])
                        for row in csv.DictReader(file)} == blocks
            sizes.append(mesh.GetNumberOfCells())
        assert sizes == sorted(sizes) and sizes[0] < sizes[2], sizes  # dump_9 comes before dump_10


def test_tetrahedra():
    with tempfile.TemporaryDirectory() as folder:
        write_image(fraction_image(8), os.path.join(folder, "dump_0.vti"))
        result = run_script(folder, "--array", "ball", "--array", "plate", "--exodus", "--tets",
                            "Cells")
        assert result.returncode == 0, result
        mesh = read_vtu(folder, "mesh_0000.vtu")
        assert mesh.GetCellType(0) == 10
        blocks = block_sizes(os.path.join(folder, "out", "mesh_0000.e"))
        assert set(blocks) == {"ball",
                               "plate"} and sum(blocks.values()) == mesh.GetNumberOfCells(), blocks


def test_steps_that_cannot_be_meshed():
    with tempfile.TemporaryDirectory() as folder:
        nothing = np.zeros((8, 8, 8))
        bad = nothing.copy()
        bad[1, 2, 3] = 2
        write_image(image({"ball": nothing}), os.path.join(folder, "dump_0.vti"))
        write_image(image({"ball": bad}), os.path.join(folder, "dump_1.vti"))
        write_image(fraction_image(8), os.path.join(folder, "dump_2.vti"))
        result = run_script(folder, "--array", "ball", "--exodus")
        assert result.returncode == 1 and "Traceback" not in result.stderr, result
        assert "'ball' holds 2 in cell (3, 2, 1)" in result.stderr
        assert "mesh_0001: no mesh" in result.stdout
        assert read_vtu(folder, "mesh_0002.vtu").GetNumberOfCells() > 0
        assert not os.path.exists(os.path.join(folder, "out", "mesh_0001.vtu"))


def test_arguments():
    with tempfile.TemporaryDirectory() as folder:
        assert run_script(folder).returncode == 2
        assert run_script(folder, "--array", "a", "--material-ids", "b", "x.vti").returncode == 2


@in_folder
def test_atlas(path):
    """Meshes every fourth voxel of the atlas, or reports the package that is missing."""
    script = [os.path.join(EXAMPLES, "atlas.py"), "--plugin", os.environ["VFM_PLUGIN"], "--every",
              "4", "--mesh", path("atlas.exo")]
    result = mpi_run(1, ["pvpython", *script])
    if not os.path.exists(ATLAS):
        assert (result.returncode == 1 and "apt-get install mricron-data" in result.stderr
                and not result.stdout), result
        return
    found = re.search(r"48 regions, (\d+) hexahedra, scaled Jacobian ([\d.]+) to 1", result.stdout)
    error = re.search(r"worst error of a volume ([\d.e-]+);", result.stdout)
    assert result.returncode == 0 and "     7 Precentral Gyrus " in result.stdout, result
    assert float(found[2]) > 0.3 and float(error[1]) < 1e-4, result.stdout
    blocks = block_sizes(path("atlas.exo"))
    assert len(blocks) == 48 and sum(blocks.values()) == int(
        found[1]) and "precentral_gyrus" in blocks, blocks


def test_ball_under_pressure():
    """The mean stress along z is minus the pressure, for any contents of the block."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        result = subprocess.run(
            ["pvpython", os.path.join(EXAMPLES, "ball_under_pressure.py"), "--plugin",
             os.environ["VFM_PLUGIN"], "--cells", "8",
             "--tets", "Lattice", "--out", out], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
             text=True)
        assert os.path.getsize(os.path.join(out,
                                            "ball.inp")) > os.path.getsize(
                                                os.path.join(out, "press.inp")) > 0
        if not shutil.which("ccx"):
            assert result.returncode == 1 and "is not installed" in result.stderr, result
            return
        assert result.returncode == 0 and "reaction below 4e+07 N" in result.stdout, result
        mesh = read_vtu(folder, "press.vtu")
        cells = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 4)
        volumes = tet_volumes(vtk_to_numpy(mesh.GetPoints().GetData()), cells)
        stress, equivalent = (vtk_to_numpy(mesh.GetCellData().GetArray(name))
                              for name in ("Stress", "VonMises"))
        mean = (volumes[:, None] * stress).sum(axis=0) / volumes.sum()
        assert np.allclose(mean[:3], [0, 0, -1e7], atol=10), mean
        ball = vtk_to_numpy(mesh.GetCellData().GetArray("MaterialId")) == 1
        assert equivalent[ball].mean() > 1.5 * equivalent[~ball].mean()
        upper = vtk_to_numpy(mesh.GetPoints().GetData())[:, 2] == 1
        sinks = -vtk_to_numpy(mesh.GetPointData().GetArray("Displacement"))[upper, 2].mean()
        assert 0.5 < sinks / (2 * 1e7 / 3e9) < 0.99, sinks  # less than in a block of epoxy


def test_cube_under_pressure():
    """The load on a face of the rotated cube is pressure times area, and equals the reaction."""
    with tempfile.TemporaryDirectory() as folder:
        result = subprocess.run(
            ["pvpython", os.path.join(EXAMPLES, "cube_under_pressure.py"), "--plugin",
             os.environ["VFM_PLUGIN"], "--cells", "16",
             "--out", folder], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        rows = re.findall(r"(MATERIAL1_TO_VOID_\d): area (\S+) m\^2, .* normal \((.*)\)",
                          result.stdout)
        assert len(rows) == 6 and all(abs(float(area) / 1.44 - 1) < 0.03
                                      for _, area, _ in rows), result
        with open(os.path.join(folder, "cube.inp"), encoding="ascii") as file:
            mesh = file.read()
        assert all("*NSET, NSET=%s\n" % name in mesh and "*SURFACE, NAME=%s," % name in mesh
                   for name, _, _ in rows)
        if not shutil.which("ccx"):
            assert result.returncode == 1 and "is not installed" in result.stderr, result
            return
        found = re.search(
            r"(\S+) clamped, (\S+) loaded: reaction (\S+) N, .* \((\S+) %\), of its facets (\S+) N",
            result.stdout)
        print("  " + found[0])
        normals = {name: np.array(normal.split(), dtype=float) for name, _, normal in rows}
        assert normals[found[1]] @ normals[found[2]] < -0.95
        assert abs(float(found[4])) < 2 and abs(float(found[3]) / float(found[5])
                                                - 1) < 1e-4, result


@in_folder
def test_shapes_of_the_data(path):
    """Data/shapes.py reproduces the fields in Data."""
    for scene, arrays in (("fin", ["body"]), ("ball_and_plate", ["ball", "plate"])):
        made = path(scene + ".vti")
        subprocess.run(["pvpython", os.path.join(DATA, "shapes.py"), os.environ["VFM_PLUGIN"],
                        scene, made], check=True)
        fields = [read_image(made), read_image(os.path.join(DATA, scene + ".vti"))]
        for array in arrays:
            new, old = (vtk_to_numpy(field.GetCellData().GetArray(array)) for field in fields)
            assert np.allclose(new, old, rtol=0, atol=1e-6), (scene, array)


@in_folder
def test_demo(path):
    """One case of the demo gives meshes in all formats, and pictures."""
    result = subprocess.run(
        ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", "pvpython",
         os.path.join(DATA, "..", "scripts", "demo.py"),
         os.environ["VFM_PLUGIN"], path("out"), "fin"], stdout=subprocess.PIPE,
         stderr=subprocess.STDOUT, text=True)
    assert result.returncode == 0 and "Traceback" not in result.stdout, result.stdout
    names = ["fin" + kind + ending for kind in ("", "_tets")
             for ending in (".vtu", ".e", ".inp", ".csv", "_cut.png")]
    assert sorted(os.listdir(path("out"))) == sorted(names + ["fin_surface.png"])
    assert re.search(r"^fin +body +10368 +0\.571 ", result.stdout, re.MULTILINE), result.stdout


@in_folder
def test_write_exodus(path):
    mesh = mesh_of(fraction_image(8)).mesh
    saved = write(mesh, path("mesh.vtu"), vtkXMLUnstructuredGridWriter)
    result = mpi_run(1,
                     ["pvpython", os.path.join(EXAMPLES, "write_exodus.py"), saved,
                      path("mesh.exo")])
    assert result.returncode == 0, result
    materials = vtk_to_numpy(mesh.GetCellData().GetArray("MaterialId")).tolist()
    assert block_sizes(path("mesh.exo")) == {"ball": materials.count(1),
                                             "plate": materials.count(2)}


def run_here(script, *arguments):
    """Runs a script in this process, which avoids another start of ParaView."""
    texts = io.StringIO(), io.StringIO()
    before, sys.argv, sys.path = (sys.argv, sys.path), [script,
                                                        *arguments], [
                                                            os.path.dirname(script), *sys.path]
    code = 0
    try:
        with contextlib.redirect_stdout(texts[0]), contextlib.redirect_stderr(texts[1]):
            runpy.run_path(script, run_name="__main__")
    except SystemExit as end:
        code, message = (1, end.code + "\n") if isinstance(end.code, str) else (end.code or 0, "")
        texts[1].write(message)
    finally:
        sys.argv, sys.path = before
    return types.SimpleNamespace(returncode=code, stdout=texts[0].getvalue(),
                                 stderr=texts[1].getvalue())


@in_folder
def test_missing_files(path):
    """Each script reports a missing file by one message and exit status 1."""
    none, plugin, data = path("none"), os.environ["VFM_PLUGIN"], os.path.join(DATA, "fin.vti")
    for script, arguments in (
            ("atlas.py", ["--plugin", plugin, "--atlas", none]),
            ("ball_under_pressure.py", ["--plugin", none]),
            ("cube_under_pressure.py", ["--plugin", none]),
            ("mesh_series.py", ["--plugin", none, "--array", "body", data]),
            ("mesh_series.py", ["--plugin", plugin, "--array", "body", none]),
            ("gerris_to_vthb.py", [none, path("out.vthb")]),
            ("time_ranks.py", [none]), ("write_exodus.py", [none, path("out.e")]),
            ("../Data/shapes.py", [none, "fin", path("out.vti")]),
            ("../Data/impact.py", [none, path("out")]),
            ("../Data/OpenFOAM/foam_to_vti.py", [none, "0", path("out.vti")]),
            ("../scripts/demo.py", [none, path("out")]),
            ("../scripts/run_document.py", [none, path("out")])):
        result = run_here(os.path.join(EXAMPLES, script), *arguments)
        lines = result.stderr.strip().splitlines()
        assert result.returncode == 1 and result.stdout == "" and len(lines) == 1, (script, result)
        assert lines[0].startswith("%s: %s" % (os.path.basename(script),
                                               none)) and lines[0].endswith(": no such file"), lines
    result = mpi_run(1, ["pvpython", os.path.join(EXAMPLES, "time_ranks.py")])
    assert result.returncode == 1 and "usage: " in result.stderr, result


@in_folder
def test_bracket(path):
    """With sharp edges the mesh is much closer to edges and rims; fillets are unchanged."""
    result = subprocess.run(["pvbatch", os.path.join(EXAMPLES, "bracket.py"), path("out"),
                             "--cells", "48", "--no-pictures",
                             "--plugin", os.environ["VFM_PLUGIN"]], stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, text=True)
    assert result.returncode == 0, result
    number = r"(\d\.\d+)"
    off, on = ([float(n)
                for n in re.search(r"\| %s \| %s/.* \| .*/%s \(.*\) \| .*/%s \(.*\) \| .*/%s \|"
                                   % (mode, *4 * (number,)), result.stdout).groups()]
               for mode in ("Off", "On"))
    assert on[0] > 0.4 and max(on[1:3]) < 0.045 and min(off[1:3]) > 0.35 and on[
        3] < 0.02, result.stdout
    assert ("surfaces, curves and vertices: 10, 21, 10\n" in result.stdout
            and "on curves there: 0\n" in result.stdout), result.stdout


def test_time_on_ranks():
    result = mpi_run(2,
                     ["pvbatch", "--sym", os.path.join(EXAMPLES, "time_ranks.py"),
                      os.environ["VFM_PLUGIN"], "12"])
    rows = re.findall(
        r"rank (\d) of 2: [\d.]+ s, (\d+) hexahedra, memory \d+ MB before, peak \d+ MB",
        result.stdout)
    assert result.returncode == 0 and sorted(rank for rank, _ in rows) == ["0", "1"], result
    assert all(int(hexes) > 100 for _, hexes in rows), rows


main(globals())
