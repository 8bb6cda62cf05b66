"""Tests that sculptor meshes a picture of one slice as a plane, unless an option says otherwise."""
import os
import struct
import zlib

import numpy as np

from compare_meshes import difference, merge, read_pieces
from sculptor_program import mesh_file, refused
from vfmtest import in_folder, main, write

from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

VOXEL, HEXAHEDRON, QUAD, TRIANGLE = 11, 12, 9, 5
PICTURE = np.zeros((12, 15), np.uint8)  # a[y, x]
PICTURE[2:10, 2:7], PICTURE[2:10, 7:13] = 1, 2


def save_png(path, pixels):
    """Writes grey pixels of one byte."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(
            ">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(
            ">IIBBBBB", pixels.shape[1], pixels.shape[0], 8, 0, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def piece_of(path):
    [piece] = read_pieces(path)
    return piece


def types(path):
    mesh = piece_of(path)
    return {mesh.GetCellType(cell) for cell in range(mesh.GetNumberOfCells())}


@in_folder
def test_a_picture_is_a_plane(at):
    save_png(at("a.png"), PICTURE)
    os.mkdir(at("one"))
    save_png(at("one/a.png"), PICTURE)
    for name, words, kind in (
            ("a", (), QUAD), ("b", ("--flat",), QUAD), ("c", ("--tetmesh",), TRIANGLE),
            ("d", ("--set", "Flat=off"), HEXAHEDRON), ("e", ("--set", "Flat=on"), QUAD)):
        for ranks in (1, 2):
            mesh_file(at("a.png"), at(name + ".vtu"), *words, ranks=ranks)
            assert types(at(name + ".vtu")) == {kind}, (name, ranks)
    mesh_file(at("one"), at("f.vtu"))
    for name in ("b", "e", "f"):
        assert not difference(merge([piece_of(at("a.vtu"))]), merge([piece_of(at(name + ".vtu"))]))
    field = piece_of(at("a.vtu")).GetFieldData()
    areas = vtk_to_numpy(field.GetArray("MeshVolume"))
    assert np.allclose(areas, [40, 48], rtol=1e-6), areas


@in_folder
def test_slices_are_no_plane(at):
    os.mkdir(at("two"))
    for number in range(3):
        save_png(at("two/%d.png" % number), PICTURE)
    mesh_file(at("two"), at("a.vtu"), "--spacing", "1,1,1")
    assert types(at("a.vtu")) == {HEXAHEDRON}


@in_folder
def test_an_image_of_one_layer_is_a_plane_by_option(at):
    image = vtkImageData()
    image.SetDimensions(16, 13, 2)
    image.SetSpacing(1, 1, 1)
    labels = numpy_to_vtk(PICTURE.astype(np.int32).ravel(), deep=True)
    labels.SetName("MaterialId")
    image.GetCellData().AddArray(labels)
    write(image, at("a.vti"))
    mesh_file(at("a.vti"), at("a.vtu"))
    assert types(at("a.vtu")) == {HEXAHEDRON}
    mesh_file(at("a.vti"), at("b.vtu"), "--flat")
    assert types(at("b.vtu")) == {QUAD}


def bytes_below(folder):
    """Returns the bytes of all files in a folder, by their paths in it."""
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = file.read()
    return found


@in_folder
def test_files_do_not_depend_on_ranks(at):
    """Also OpenFOAM's: a plane is one case."""
    save_png(at("a.png"), PICTURE)
    for name, words in (("a.k", ()), ("a.rad", ()), ("a.bdf", ()), ("a.inp", ("--tetmesh",)),
                        ("a.foam", ()), ("a.foam", ("--tetmesh", "--binary")),
                        ("a.msh", ("--msh-version", "4.1")), ("a.xdmf", ())):
        found = []
        for ranks in (1, 2, 3):
            folder = at("%s_%d_%d" % (name, len(words), ranks))
            os.mkdir(folder)
            mesh_file(at("a.png"), os.path.join(folder, name), *words, ranks=ranks)
            found.append(bytes_below(folder))
        assert found[0] == found[1] == found[2] and len(found[0]) > 0, name
        assert name != "a.foam" or os.path.join("constant", "polyMesh", "faces") in found[0]


@in_folder
def test_options_and_formats_of_solids(at):
    save_png(at("a.png"), PICTURE)
    for ranks in (1, 2):
        refused(3, "as a plane (--set Flat=off: as a layer of solid elements): The option Flat",
                at("a.png"), at("a.vtu"), "--set", "ElementOrder=Quadratic", ranks=ranks)
        refused(4, "not written for meshes of a plane (option Flat)", at("a.png"), at("a.feb"),
                ranks=ranks)
    refused(3, "Cannot mesh %s: The option Flat" % at("a.png"), at("a.png"), at("a.vtu"), "--flat",
            "--set", "ElementOrder=Quadratic")


@in_folder
def test_planes_of_decks(at):
    save_png(at("a.png"), PICTURE)
    for words, kind in (((), "CPE4"), (("--plane", "strain"), "CPE4"),
                        (("--plane", "stress"), "CPS4")):
        mesh_file(at("a.png"), at("a.inp"), *words)
        with open(at("a.inp"), encoding="ascii") as file:
            assert "*ELEMENT, TYPE=%s, ELSET=EB1" % kind in file.read()
    refused(1, "--plane takes strain or stress, not 'bent'", at("a.png"), at("a.inp"), "--plane",
            "bent")
    refused(1, "has no choice of plane stress. Formats that have it: .inp, .k, .key, .bdf, .nas.",
            at("a.png"), at("a.e"), "--plane", "stress")


main(globals())
