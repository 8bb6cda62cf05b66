"""sculptor --geometry: surfaces, curves and vertices in one file; --surfaces: STL of materials.

Any number of ranks writes identical bytes.
"""
import glob
import os

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader

from compare_meshes import difference, merge, read_pieces
from sculptor_program import mesh_file, refused
from vfmtest import (
    VolumeFractionToTet, fraction_image, image, in_folder, main, mesh_of, producer, write, simple)

BLOCKS = ["Surfaces", "Curves", "Vertices"]


def read_geometry(path):
    """Returns {name: block}."""
    reader = vtkXMLMultiBlockDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    blocks = range(data.GetNumberOfBlocks())
    return {data.GetMetaData(block).Get(data.NAME()): data.GetBlock(block) for block in blocks}


def write_on_ranks(at, path, *arguments):
    """Returns the geometry that one rank writes; runs on more ranks must write the same bytes."""
    written = []
    for ranks in (1, 3, 8):
        mesh_file(path, at("mesh.vtu"), "--geometry", at("geometry.vtm"), *arguments, ranks=ranks)
        files = sorted(glob.glob(at("geometry") + "*")
                       + glob.glob(os.path.join(at("geometry"), "*")))
        written.append({name: open(name, "rb").read() for name in files if os.path.isfile(name)})
        assert written[-1] == written[0], ranks
    return read_geometry(at("geometry.vtm"))


def check_ports(geometry, result):
    """Checks that the blocks are bitwise identical to the output ports that have cells."""
    ports = zip(BLOCKS, (result.surfaces, result.curves, result.vertices))
    filled = {name: port for name, port in ports if port.GetNumberOfCells() > 0}
    assert list(geometry) == list(filled)
    for name, port in filled.items():
        assert geometry[name].GetNumberOfCells() == port.GetNumberOfCells()
        problem = difference(merge([geometry[name]]), merge([port]))
        assert not problem, "%s: %s" % (name, problem)
        assert geometry[
            name].GetCellData().GetScalars().GetName() == port.GetCellData().GetScalars().GetName()


@in_folder
def test_same_as_the_ports(at):
    data = fraction_image()
    path = write(data, at("in.vti"))
    check_ports(write_on_ranks(at, path), mesh_of(data))
    check_ports(write_on_ranks(at, path, "--void", "--tetmesh", "Lattice"),
                mesh_of(data, VolumeFractionToTet, Method="Lattice", MeshVoid=1))


def ball(side):
    """Returns a ball in 8^3 cells that lies inside, or reaches out through side -x or all sides."""
    z, y, x = np.meshgrid(*[(np.arange(24) + 0.5) / 3] * 3, indexing="ij")
    centre, radius = {"inside": (4, 2.5), "-x": (0, 2.5), "all": (4, 20)}[side]
    within = (x - centre) ** 2 + (y - 4) ** 2 + (z - 4) ** 2 < radius ** 2
    return image({"ball": within.reshape(8, 3, 8, 3, 8, 3).mean(axis=(1, 3, 5))})


@in_folder
def test_what_there_is_none_of_is_no_block(at):
    """A port without cells is not in the file."""
    for side, counts in (("inside", (1, 0, 0)), ("-x", (2, 1, 0)), ("all", (6, 12, 8))):
        data = ball(side)
        geometry = write_on_ranks(at, write(data, at("in.vti")))
        result = mesh_of(data, VolumeFractionArrays=["ball"])
        check_ports(geometry, result)
        assert tuple(result.field("NumberOf" + name)[0] for name in BLOCKS) == counts
        assert [name in geometry for name in BLOCKS] == [count > 0 for count in counts]


def time_of(data):
    return data.GetFieldData().GetArray("TimeValue").GetTuple1(0)


@in_folder
def test_time(at):
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data",
                        "impact.spcth")
    mesh_file(path, at("mesh.vtu"), "--geometry", at("geometry.vtm"), "--step", "1", ranks=2)
    time = time_of(read_pieces(at("mesh.vtu"))[0])
    assert time > 0 and {time_of(block)
                         for block in read_geometry(at("geometry.vtm")).values()} == {time}


@in_folder
def test_opens_in_paraview(at):
    path = write(fraction_image(), at("in.vti"))
    mesh_file(path, at("mesh.vtu"), "--geometry", at("geometry.vtm"))
    reader = simple.OpenDataFile(at("geometry.vtm"))
    curves = simple.ExtractBlock(Input=reader, Selectors=["/Root/Curves"])
    curves.UpdatePipeline()
    assert curves.CellData["CurveId"].GetRange()[0] == 1


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


@in_folder
def test_surfaces_of_materials(at):
    """sculptor on any number of ranks and Save Data write the same surfaces."""
    data = fraction_image()
    path = write(data, at("in.vti"))
    simple.SaveData(at("saved.stl"),
                    proxy=producer(mesh_of(data, VolumeFractionArrays=["ball", "plate"]).mesh))
    saved = read_bytes(at("saved.stl"))
    names = [line.split(b" ", 1)[1].decode() for line in saved.splitlines()
             if line.startswith(b"solid ")]
    print("solids:", names)
    assert names
    for ranks in (1, 3):
        mesh_file(path, at("parts.stl"), "--surfaces", at("part_{}.stl"), ranks=ranks)
        assert read_bytes(at("parts.stl")) == saved
        assert b"".join(read_bytes(at("part_%s.stl" % name)) for name in names) == saved


@in_folder
def test_refused(at):
    path = write(fraction_image(), at("in.vti"))
    mesh = "--input", path, "--output", at("mesh.vtu")
    refused(4, "No such file or directory", *mesh, "--geometry", at("none/geometry.vtm"), ranks=2)
    assert not os.path.exists(at("mesh.vtu"))
    open(at("geometry"), "w").close()  # a file in the place of the folder for the blocks
    refused(4, "Cannot write the geometry", *mesh, "--geometry", at("geometry.vtm"), ranks=2)


main(globals())
