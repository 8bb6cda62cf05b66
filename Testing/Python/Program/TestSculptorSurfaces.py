"""sculptor meshes closed surfaces: names, priority, grid, ranks, messages, and the same mesh as in
ParaView."""
import os

import numpy as np

from sculptor_program import check_same, mesh_file, refused, rows, sculptor
from vfmtest import (
    in_folder, main, save_data, simple, VolumeFractionOfSurface, VolumeFractionToHex)

SIDES = {"bottom": (0, 4, 6, 2), "top": (1, 3, 7, 5), "front": (0, 1, 5, 4), "back": (2, 6, 7, 3),
         "left": (0, 2, 3, 1), "right": (4, 5, 7, 6)}


def write_box(path, lower, upper, sides=SIDES, is_one=False):
    """Writes a box as text STL with one solid per side, or one for all, and returns the path."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    places = lower + corners * np.subtract(upper, lower)
    lines = []
    for name in sides:
        a, b, c, d = SIDES[name]
        if not is_one or lines == []:
            lines.append("solid %s" % name)
        for triangle in ((a, b, c), (a, c, d)):
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex %.17g %.17g %.17g" % tuple(places[p]) for p in triangle]
            lines += ["endloop", "endfacet"]
        if not is_one:
            lines.append("endsolid %s" % name)
    lines += ["endsolid"] if is_one else []
    with open(path, "w") as file:
        file.write("\n".join(lines) + "\n")
    return path


@in_folder
def test_names_priority_and_ranks(at):
    """The first file keeps its volume; each rank count gives the same file."""
    shaft = write_box(at("shaft.stl"), (0, 0, 0), (1, 1, 1))
    housing = write_box(at("housing.stl"), (0.5, 0, 0), (3, 1, 1))
    for ranks in (1, 3):
        result = sculptor(shaft, housing, at("%d.vtu" % ranks), "--cell-width", "0.125",
                          ranks=ranks)
        assert result.returncode == 0 and result.stderr == "", result
        assert list(rows(result.stdout))[:2] == ["1 shaft", "2 housing"], result.stdout
        assert "materials from shaft, housing (surfaces)" in result.stdout
    with open(at("1.vtu"), "rb") as one, open(at("3.vtu"), "rb") as three:
        assert one.read() == three.read()
    mesh = simple.OpenDataFile(at("1.vtu"))
    mesh.UpdatePipeline()
    fields = mesh.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
    found = [fields.GetArray("TargetVolume").GetValue(m) for m in (0, 1)]
    assert np.allclose(found, [1, 2], rtol=1e-12), found


@in_folder
def test_folder_of_surfaces(at):
    """--surfaces FOLDER makes the folder, with the files that {} gives, on any ranks."""
    words = [write_box(at("shaft.stl"), (0, 0, 0), (1, 1, 1)),
             write_box(at("housing.stl"), (0.5, 0, 0), (3, 1, 1)), at("out.vtu"), "--cells", "12"]
    for ranks, folder in ((1, "parts"), (3, "more/"), (3, "parts")):
        result = sculptor(*words, "--surfaces", at(folder), ranks=ranks)
        assert result.returncode == 0, result
        assert sorted(os.listdir(at(folder))) == ["housing.stl", "shaft.stl"]
    assert sculptor(*words, "--surfaces", at("of_{}.stl")).returncode == 0
    for name in ("shaft", "housing"):
        texts = []
        for path in ("parts/%s.stl", "more/%s.stl", "of_%s.stl"):
            with open(at(path % name), "rb") as file:
                texts.append(file.read())
        assert texts[0] == texts[1] == texts[2] and len(texts[0]) > 1000
    with open(at("file"), "w") as file:
        file.write("text")
    for folder in ("file", "missing/parts"):
        result = sculptor(*words, "--surfaces", at(folder))
        assert result.returncode == 4 and folder in result.stderr, result


@in_folder
def test_same_as_filter(at):
    """By ParaView's reader, whose coordinates are float, by a .vti file of the fractions with their
    surface, and by sculptor."""
    path = write_box(at("Material1.stl"), (0.25, 0.5, 0.75), (1.25, 1.5, 1.75), is_one=True)
    fractions = VolumeFractionOfSurface(Input=[simple.OpenDataFile(path)], Dimensions=[14] * 3)
    mesher = VolumeFractionToHex(Input=fractions)
    mesher.UpdatePipeline()
    mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
    assert mesh.GetNumberOfCells() > 0
    save_data(at("fractions.vti"), fractions)
    for ranks, source, words in ((1, path, ("--cells", "14")), (3, path, ("--cells", "14")),
                                 (3, at("fractions.vti"), ())):
        mesh_file(source, at("out.vtu"), *words, ranks=ranks)
        check_same(at("out.vtu"), mesh)


@in_folder
def test_width_of_cells(at):
    path = write_box(at("part.stl"), (0, 0, 0), (2, 1, 1))
    lines = sculptor("--list", path, "--cell-width", "0.1").stdout.splitlines()
    assert "grid around it: 24 x 14 x 14 cells of 0.1 x 0.1 x 0.1 (--cells, --cell-width)" in lines
    mesh_file(path, at("one.vtu"), "--cell-width", "0.125")
    mesh_file(path, at("other.vtu"), "--cells", "20")
    with open(at("one.vtu"), "rb") as one, open(at("other.vtu"), "rb") as other:
        assert one.read() == other.read()


@in_folder
def test_list(at):
    """On each number of ranks the same."""
    path = write_box(at("part.stl"), (0, 0, 0), (2, 1, 1))
    outputs = [sculptor("--list", path, "--cells", "24", ranks=ranks) for ranks in (1, 3)]
    assert outputs[0].stdout == outputs[1].stdout and outputs[0].stderr == "", outputs
    lines = outputs[0].stdout.splitlines()
    assert lines[0] == path and lines[1] == "x 0 to 2, y 0 to 1, z 0 to 1", lines
    assert lines[-2].split() == ["surface", "triangles", "patches", "volume"], lines
    assert lines[-1].split(None, 4) == ["part", "12", "6", "2", ", ".join(SIDES)], lines


@in_folder
def test_messages(at):
    """One line on any number of ranks."""
    part = write_box(at("part.stl"), (0, 0, 0), (1, 1, 1))
    open_part = write_box(at("open.stl"), (0, 0, 0), (1, 1, 1), list(SIDES)[1:])
    os.mkdir(at("more"))
    same = write_box(at("more/part.stl"), (0, 0, 0), (1, 1, 1))
    sheet = write_box(at("sheet.stl"), (0, 0, 0), (1, 1, 0.01))
    with open(at("empty.off"), "w") as file:
        file.write("OFF\n0 0 0\n")
    for ranks in (1, 3):
        for code, text, words in (
                (2, "open", [open_part]), (2, "none.stl", [at("none.stl")]),
                (2, "would both be the material part", [part, same]),
                (2, "empty.off", [part, at("empty.off")]),
                (1, "--cells takes an integer from 5, not '0'", [part, "--cells", "0"]),
                (2, "is too large", [part, "--cell-width", "1e-9"]),
                (3, "Use more cells (--cells)", [sheet, "--cells", "9"]),
                (1, "in.vti is not", [part, "in.vti"]),
                (2, "--labels", [part, "--labels", "id"]),
                (2, "no step 1", [part, "--step", "1"])):
            refused(code, text, *words, "--output", at("no.vtu"), ranks=ranks)
        refused(1, "same file as the input", part, "--output", part, ranks=ranks)


main(globals())
