"""Examples/mesh_series.py meshes all steps of a series, in order, and says so when one cannot be."""
import os
import subprocess
import tempfile

import numpy as np
from vtkmodules.vtkIOIOSS import vtkIOSSReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLUnstructuredGridReader

from vfmtest import fraction_image, image, main

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "mesh_series.py")


def write_image(data, path):
    writer = vtkXMLImageDataWriter()
    writer.SetDataModeToBinary()
    writer.SetInputData(data)
    writer.SetFileName(path)
    assert writer.Write()


def run_script(folder, *options):
    files = [os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".vti")]
    command = ["pvbatch", SCRIPT, "--plugin", os.environ["VFM_PLUGIN"], "--out", os.path.join(folder, "out"), *options, *files]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def read_vtu(folder, name):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(os.path.join(folder, "out", name))
    reader.Update()
    return reader.GetOutput()


def block_sizes(path):
    """Elements of each block of an Exodus file by its name."""
    reader = vtkIOSSReader()
    reader.SetFileName(path)
    reader.Update()
    blocks = reader.GetOutputDataObject(0)
    sizes = {}
    for i in range(blocks.GetNumberOfPartitionedDataSets()):
        if blocks.GetPartition(i, 0):
            sizes[blocks.GetMetaData(i).Get(blocks.NAME())] = blocks.GetPartition(i, 0).GetNumberOfCells()
    return sizes


def test_all_steps_in_order():
    with tempfile.TemporaryDirectory() as folder:
        for step, size in ((2, 8), (10, 12), (9, 10)):
            write_image(fraction_image(size), os.path.join(folder, "dump_%d.vti" % step))
        result = run_script(folder, "--array", "ball", "--array", "plate", "--exodus")
        assert result.returncode == 0, result
        assert result.stdout.count(" elements") == 3
        sizes = []
        for step in range(3):
            mesh = read_vtu(folder, "mesh_%04d.vtu" % step)
            materials = mesh.GetCellData().GetArray("MaterialId")
            ids = [materials.GetValue(i) for i in range(mesh.GetNumberOfCells())]
            blocks = block_sizes(os.path.join(folder, "out", "mesh_%04d.e" % step))
            assert blocks == {"ball": ids.count(1), "plate": ids.count(2)}, blocks
            sizes.append(mesh.GetNumberOfCells())
        assert sizes == sorted(sizes) and sizes[0] < sizes[2], sizes  # dump_9 comes before dump_10


def test_tetrahedra():
    with tempfile.TemporaryDirectory() as folder:
        write_image(fraction_image(8), os.path.join(folder, "dump_0.vti"))
        result = run_script(folder, "--array", "ball", "--array", "plate", "--exodus", "--tets", "Cells")
        assert result.returncode == 0, result
        mesh = read_vtu(folder, "mesh_0000.vtu")
        assert mesh.GetCellType(0) == 10
        blocks = block_sizes(os.path.join(folder, "out", "mesh_0000.e"))
        assert set(blocks) == {"ball", "plate"} and sum(blocks.values()) == mesh.GetNumberOfCells(), blocks


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


main(globals())
