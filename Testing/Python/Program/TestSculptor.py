"""The command-line tool `sculptor` (VFM_SCULPTOR) on several ranks: meshes, messages, status."""
import ctypes
import os
import re

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkRectilinearGrid, vtkUniformGrid)
from vtkmodules.vtkIOParallelXML import vtkXMLPImageDataWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter, vtkXMLMultiBlockDataWriter, vtkXMLRectilinearGridWriter,
    vtkXMLUniformGridAMRWriter)

from amr_cases import amr_data
from compare_meshes import difference, merge, read_pieces
from exodus_grids import hexes, shuffled, write_exodus
from sculptor_program import check_same, mesh_file, refused, rows, sculptor
from vfmtest import (
    ORIGIN, SPACING, VolumeFractionToHex, VolumeFractionToTet, add_array, ball_and_plate,
    box_along_axes, exodus_parts, fraction_image,
    image, in_folder, labels, main, mesh_of, rectilinear, uniform, write, simple)

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data")
BALL_AND_PLATE = os.path.join(DATA, "ball_and_plate.vti")
SPLASH = os.path.join(DATA, "splash_2ms.vti")
# options that --refine-cells and --refine-box set
NAMED = {"Refinement": "Automatic", "ThinCells": 0, "FineInterfaces": 0}


def filter_mesh(path, tets=False, **properties):
    """Returns the mesh that the filter makes of a file."""
    make = VolumeFractionToTet if tets else VolumeFractionToHex
    reader = simple.OpenDataFile(path)
    if path.endswith(".vthb"):
        reader.DefaultNumberOfLevels = 0  # all levels
    mesher = make(Input=reader, **properties)
    mesher.UpdatePipeline()
    mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
    assert mesh.GetNumberOfCells() > 0
    return mesh


@in_folder
def test_same_as_filter(at):
    hexes = filter_mesh(BALL_AND_PLATE, VolumeFractionArrays=["ball", "plate"])
    for ranks, name in ((1, "whole.vtu"), (4, "pieces.pvtu")):
        mesh_file(BALL_AND_PLATE, at(name), ranks=ranks)
        check_same(at(name), hexes)
    assert len(read_pieces(at("pieces.pvtu"))) == 4
    mesh_file(SPLASH, at("splash.vtu"), "--fractions", "water", ranks=2)
    check_same(at("splash.vtu"), filter_mesh(SPLASH, VolumeFractionArrays=["water"]))


@in_folder
def test_one_file_is_that_of_one_rank(at):
    path = write(fraction_image(), at("in.vti"))
    for ranks in (1, 3):
        mesh_file(path, at("%d.vtu" % ranks), ranks=ranks)
    with open(at("1.vtu"), "rb") as one, open(at("3.vtu"), "rb") as three:
        assert one.read() == three.read()


@in_folder
def test_options(at):
    """Options are properties of the filter; ArgumentsTest.cxx tests each option."""
    path = write(fraction_image(), at("in.vti"))
    both = dict(VolumeFractionArrays=["ball", "plate"])
    cases = [
        (["--iso", "0.3", "--void", "--smooth=geometrybased"],
         dict(IsoValue=0.3, MeshVoid=1, Smoothing="Geometry Based")),
        (["--set", "targetscaledjacobian = .3", "ConserveVolume=off", "--refine", "1"],
         dict(uniform(1), TargetScaledJacobian=0.3, ConserveVolume=0)),
        (["--aspect", "1.5", "--no-smooth"], dict(MaximumAspectRatio=1.5, Smoothing="Off")),
        (["--refine-box", "-1,.5,2,0,1,4", "--refine-box=1,2,3,2,3,4,2", "--set",
          "FineInterfaces=on", "MaximumLevel=1"],
         dict(NAMED, RefinementBoxes=[-1, 0.5, 2, 0, 1, 4, 1, 1, 2, 3, 2, 3, 4, 2],
              FineInterfaces=1, MaximumLevel=1)),
        (["--tetmesh", "lattice", "--refine-box", "-1,.5,2,0,1,4"],
         dict(NAMED, tets=True, Method="Lattice", RefinementBoxes=[-1, 0.5, 2, 0, 1, 4, 1])),
    ]
    plain = merge([filter_mesh(path, **both)])
    for arguments, properties in cases:
        mesh_file(path, at("out.vtu"), *arguments)
        mesh = filter_mesh(path, **both, **properties)
        assert difference(merge([mesh]), plain), "%s changes nothing" % arguments
        check_same(at("out.vtu"), mesh)


@in_folder
def test_sharp_edges(at):
    path = write(image({"box": box_along_axes((2.3, 3.6, 2.8), (9.4, 8.7, 9.1))}), at("in.vti"))
    plain, sharp = (filter_mesh(path, VolumeFractionArrays=["box"], SharpEdges=mode)
                    for mode in ("Off", "On"))
    assert difference(merge([plain]), merge([sharp]))
    mesh_file(path, at("out.vtu"), "--sharp-edges", "on")
    check_same(at("out.vtu"), sharp)


@in_folder
def test_cells_to_refine(at):
    """The array for refinement is not a material; each reader reads it, for any other options."""
    arrays = dict(zip(("ball", "plate"), ball_and_plate()))
    arrays["wish"] = np.zeros((12, 12, 12))
    arrays["wish"][3:5, 5, 6:8] = 1
    path = write(image(arrays), at("in.vti"))
    mesh = filter_mesh(path, VolumeFractionArrays=["ball", "plate"], RefinementArray="wish",
                       **NAMED)
    for ranks, words in ((1, ()), (3, ("--fractions", "ball,plate"))):
        out = mesh_file(path, at("out.vtu"), "--refine-cells", "wish", *words, ranks=ranks)
        check_same(at("out.vtu"), mesh)
        assert "materials from ball, plate (" in out
    cells = shuffled()
    exodus = write_exodus(at("in.e"), lambda step: {"all": hexes(arrays, cells)}, [0.0])
    mesh_file(exodus, at("out.vtu"), "--refine-cells", "wish", "--fractions", "ball,plate", ranks=2)
    check_same(at("out.vtu"), mesh, 0)
    refused(2, "no numeric array 'missing' (--refine-cells)", path, at("no.vtu"), "--refine-cells",
            "missing", ranks=2)
    arrays["wish"][0, 0, 0] = 0.5
    refused(3, "'wish' holds 0.5", write(image(arrays), at("half.vti")), at("no.vtu"),
            "--refine-cells", "wish", "--fractions", "ball,plate", ranks=2)


@in_folder
def test_options_of_labels(at):
    ids = labels()
    ids[10, 1, 1] = 2
    path = write(image({"id": ids}), at("in.vti"))
    for arguments, properties in (
            (["--label-smoothing", "2"], dict(LabelSmoothing=2)),
            (["--material-widths", "auto", "--set", "AllowedError=1"],
             dict(MaterialWidths="auto", AllowedError=1)),
            (["--cell-width", "0.5,0.5,1", "--material-widths", "2=0.25"],
             dict(CellWidth="0.5,0.5,1", MaterialWidths="2=0.25")),
            (["--minimum-region", "2"], dict(MinimumRegionCells=2))):
        mesh_file(path, at("out.vtu"), "--labels", "id", *arguments, ranks=2)
        mesh = filter_mesh(path, MaterialIdArray="id", **properties)
        assert difference(merge([mesh]), merge([filter_mesh(path, MaterialIdArray="id")])), (
            "%s changes nothing" % arguments)
        check_same(at("out.vtu"), mesh)


def write_formats(at):
    """Writes the same field in each format that VTK can write; returns {name: path}.

    Blocks are adjacent along x.
    """
    ball, plate = ball_and_plate()
    arrays = {"ball": ball, "plate": plate}
    whole = image(arrays)
    parts = [image({name: value[:, :, span] for name, value in arrays.items()}, first)
             for span, first in ((slice(0, 5), (0, 0, 0)), (slice(5, 12), (5, 0, 0)))]
    blocks = vtkMultiBlockDataSet()
    for i, part in enumerate(parts):
        blocks.SetBlock(i, part)
    grid = vtkRectilinearGrid()
    grid.SetExtent(whole.GetExtent())
    for a, set_nodes in enumerate((grid.SetXCoordinates, grid.SetYCoordinates,
                                   grid.SetZCoordinates)):
        set_nodes(add_array(vtkMultiBlockDataSet().GetFieldData(), "x",
                            ORIGIN[a] + SPACING[a] * np.arange(13.0)))
    grid.GetCellData().ShallowCopy(whole.GetCellData())
    return {
        "vti": write(whole, at("image.vti")),
        "pvti": write(whole, at("pieces.pvti"), vtkXMLPImageDataWriter, pieces=3),
        "vtr": write(grid, at("grid.vtr"), vtkXMLRectilinearGridWriter),
        "vtm": write(blocks, at("blocks.vtm"), vtkXMLMultiBlockDataWriter),
        "vthb": write(amr(parts), at("level.vthb"), vtkXMLUniformGridAMRWriter),
        "refined": write(amr(parts, fine=True), at("refined.vthb"), vtkXMLUniformGridAMRWriter),
    }


def uniform_grid(part, spacing):
    """Returns the image with its origin at its first node, as AMR requires."""
    grid = vtkUniformGrid()
    first = part.GetExtent()[::2]
    grid.SetOrigin([ORIGIN[a] + SPACING[a] * first[a] for a in range(3)])
    grid.SetSpacing(spacing)
    grid.SetDimensions(part.GetDimensions())
    grid.GetCellData().ShallowCopy(part.GetCellData())
    return grid


def amr(parts, fine=False):
    levels = [[uniform_grid(part, SPACING) for part in parts]]
    if fine:
        arrays = {name: value[:12, :12, :8]
                  for name, value in zip(("ball", "plate"), ball_and_plate(24))}
        levels.append([uniform_grid(image(arrays), [h / 2 for h in SPACING])])
    return amr_data(levels, 2)


@in_folder
def test_formats(at):
    paths = write_formats(at)
    refined = paths.pop("refined")
    mesh = filter_mesh(paths["vti"], VolumeFractionArrays=["ball", "plate"])
    for kind, path in paths.items():
        mesh_file(path, at("out.vtu"), ranks=3)
        check_same(at("out.vtu"), mesh)
    mesh_file(paths["vtm"], at("out.vtu"))
    check_same(at("out.vtu"), mesh)
    mesh = filter_mesh(refined, VolumeFractionArrays=["ball", "plate"], Refinement="Uniform")
    for ranks in (1, 3):
        mesh_file(refined, at("out.vtu"), "--set", "Refinement=Uniform", ranks=ranks)
        check_same(at("out.vtu"), mesh)


@in_folder
def test_fewer_cells_than_ranks(at):
    path = write(image({"full": np.ones((2, 2, 2))}), at("tiny.vti"))
    for kind, ranks in (("vtu", 12), ("pvtu", 9)):
        mesh_file(path, at("tiny." + kind), ranks=ranks)
        check_same(at("tiny." + kind), filter_mesh(path, VolumeFractionArrays=["full"]))


@in_folder
def test_empty_mesh(at):
    path = write(image({"ball": np.zeros((4, 4, 4))}), at("in.vti"))
    for kind, ranks in (("vtu", 1), ("vtu", 2), ("pvtu", 2), ("inp", 2), ("e", 1), ("e", 2)):
        refused(3, "The mesh has no elements, so no file is written: the materials from ball (all "
                "cell arrays with values in [0, 1]) fill no cell", "--input", path, "--output",
                at("out." + kind), ranks=ranks)
    assert sorted(os.listdir(at(""))) == ["in.vti"], os.listdir(at(""))
    with open(at("old.vtu"), "w") as old:
        old.write("old")
    refused(3, "no elements", path, at("old.vtu"))
    with open(at("old.vtu")) as old:
        assert old.read() == "old"


@in_folder
def test_materials_without_elements_are_named(at):
    wall = np.ones((6, 6, 6))
    wall[3] = 0.8
    path = write(image({"wall": wall, "trace": 1 - wall}), at("in.vti"))
    for ranks in (1, 2):
        result = sculptor("--input", path, "--output", at("out.vtu"), ranks=ranks)
        assert result.returncode == 0 and result.stderr.count("'trace' (id 2)") == 1, result


def read_exodus(path):
    """Returns {block: (element ids, {node id: coordinates})}."""
    found = {}
    for name, part in exodus_parts(path):
        elements, nodes = found.setdefault(name, ([], {}))
        elements += vtk_to_numpy(part.GetCellData().GetGlobalIds()).tolist()
        ids = vtk_to_numpy(part.GetPointData().GetGlobalIds()).tolist()
        nodes.update(zip(ids, map(tuple, vtk_to_numpy(part.GetPoints().GetData()).tolist())))
    return found


@in_folder
def test_exodus(at):
    path = write(fraction_image(), at("in.vti"))
    mesh = filter_mesh(path, VolumeFractionArrays=["ball", "plate"])
    cells = {name: vtk_to_numpy(mesh.GetCellData().GetArray(name))
             for name in ("GlobalCellIds", "MaterialId")}
    ids = vtk_to_numpy(mesh.GetPointData().GetGlobalIds()).tolist()
    points = dict(zip(ids, map(tuple, vtk_to_numpy(mesh.GetPoints().GetData()).tolist())))
    for ranks, kind in ((1, ".e"), (2, ".ex2"), (3, ".exo")):
        output = at("mesh%d%s" % (ranks, kind))
        mesh_file(path, output, ranks=ranks)
        assert ranks == 1 or sum(name.startswith("mesh%d" % ranks)
                                 for name in os.listdir(at(""))) == ranks
        found = read_exodus(output if ranks == 1 else "%s.%d.0" % (output, ranks))
        assert set(found) == {"ball", "plate"}
        for material, name in enumerate(("ball", "plate"), 1):
            assert sorted(found[name][0]) == sorted(
                cells["GlobalCellIds"][cells["MaterialId"] == material].tolist())
        assert {**found["ball"][1], **found["plate"][1]} == points


def names_of(output):
    field = read_pieces(output)[0].GetFieldData()
    names = field.GetAbstractArray("MaterialNames")
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())]


@in_folder
def test_arrays_are_found(at):
    ball, plate = ball_and_plate()
    data = image({"pressure": 1e5 * ball, "plate": plate})
    add_array(data.GetCellData(), "ball", np.floor(255 * ball), np.uint8)
    add_array(data.GetCellData(), "velocity", np.zeros((12, 12, 12, 3)))
    add_array(data.GetCellData(), "count", np.ones((12, 12, 12)), np.int32)
    path = write(data, at("in.vti"))
    text = mesh_file(path, at("out.vtu"), ranks=2)
    assert names_of(at("out.vtu")) == ["plate", "ball"]
    assert "materials from plate, ball (all cell arrays with values in [0, 1])" in text
    mesh_file(path, at("out.vtu"), "--fractions", "ball, plate")
    assert names_of(at("out.vtu")) == ["ball", "plate"]

    spy = {"Material volume fraction - %d" % i: value for i, value in ((10, plate), (9, ball))}
    path = write(image({"other": ball, **spy}), at("spy.vti"))
    mesh_file(path, at("out.vtu"))
    assert names_of(at("out.vtu")) == ["Material volume fraction - 9",
                                       "Material volume fraction - 10"]

    path = write(image({"pressure": 1e5 * ball}), at("none.vti"))
    refused(2, "pressure (double, 0 to 100000)", "--input", path, "--output", at("no.vtu"), ranks=2)


@in_folder
def test_point_data_is_told(at):
    """Point data of other grids than images are reported: their points are not centres of cells."""
    data = rectilinear({"count": np.full((4, 4, 4), 1.5)}, [np.arange(5.0)] * 3)
    add_array(data.GetPointData(), "phi", np.full((5, 5, 5), 0.25))
    files = ["--input", write(data, at("in.vtr"), vtkXMLRectilinearGridWriter), "--output",
             at("no.vtu")]
    points = ("Its point arrays, which cannot be meshed, because points are the centres of cells "
              "only in images (.vti; STRUCTURED_POINTS in .vtk): phi (double, 0.25 to 0.25).")
    for ranks in (1, 2):
        refused(2, "Its cell arrays: count (double, 1.5 to 1.5). " + points, *files, ranks=ranks)
        for option in ("--fractions", "--labels", "--state"):
            refused(2, "The array 'phi' (%s) has values of points, not of cells. "
                    "Its cell arrays: count" % option, *files, option, "phi", ranks=ranks)


@in_folder
def test_the_only_array_as_density(at):
    path = write(image({"ball": ball_and_plate()[0]}), at("in.vti"))
    files = ["--fragments", at("table.csv"), "--density", "ball"]
    refused(2, "Arrays of --state, --density, --velocity, --energy and --refine-cells are not used "
            "as materials, unless --fractions or --labels names them.", "--input", path, "--output",
            at("no.vtu"), *files)
    mesh_file(path, at("out.vtu"), *files, "--fractions", "ball")


@in_folder
def test_clipped_fractions(at):
    ball, plate = ball_and_plate()
    path = write(image({"ball": ball - 0.01 * (ball == 0), "plate": plate}), at("in.vti"))
    arguments = ["--input", path, "--output", at("out.vtu")]
    for ranks in (1, 2):
        result = sculptor(*arguments, ranks=ranks)
        assert result.returncode == 0 and names_of(at("out.vtu")) == ["plate"]
        assert result.stderr == (
            "sculptor: warning: Not used as volume fractions: ball, with values up to 0.01 outside "
            "[0, 1]. --clip T accepts values up to T outside.\n"), result
        result = sculptor(*arguments, "--clip", "0.01", ranks=ranks)
        assert result.returncode == 0 and names_of(at("out.vtu")) == ["ball", "plate"]
        assert result.stderr == (
            "sculptor: warning: Volume fractions of %d cells lay outside [0, 1] and were "
            "clipped.\n" % (ball == 0).sum())


@in_folder
def test_long_names_are_told_in_full(at):
    ball, plate = ball_and_plate(8)
    names = ["the name of a material that ends in aluminium",
             "the name of a material that ends in steel"]
    text = mesh_file(write(image(dict(zip(names, (ball, plate)))), at("in.vti")), at("out.vtu"))
    rows = [re.match(r"(\d) (.*?)  +\d+ ", line) for line in text.splitlines()]
    assert [row.groups() for row in rows if row][:2] == [("1", names[0]), ("2", names[1])], text
    columns = [line.rindex("%") for line in text.splitlines() if line.endswith("%")]
    assert len(columns) == 3 and len(set(columns)) == 1, text


@in_folder
def test_files_without_options(at):
    path = write(fraction_image(8), at("in.vti"))
    assert sculptor(path,
                    at("out.vtu")).returncode == 0 and names_of(at("out.vtu")) == ["ball", "plate"]


def materials_of(output):
    return set(vtk_to_numpy(read_pieces(output)[0].GetCellData().GetArray("MaterialId")).tolist())


@in_folder
def test_material(at):
    ball, plate = ball_and_plate()
    path = write(image({"ball": ball, "plate": plate}), at("in.vti"))
    alone = filter_mesh(write(image({"ball": 0 * ball, "plate": plate}), at("plate.vti")),
                        VolumeFractionArrays=["ball", "plate"])
    for material, ranks in (("2", 1), ("plate", 3)):
        mesh_file(path, at("out.vtu"), "--material", material, ranks=ranks)
        assert materials_of(at("out.vtu")) == {2}
        check_same(at("out.vtu"), alone)
    for material in ("1,plate", "all"):
        mesh_file(path, at("out.vtu"), "--material", material)
        check_same(at("out.vtu"), filter_mesh(path, VolumeFractionArrays=["ball", "plate"]))
    refused(1, "The materials are: 1 ball, 2 plate", "--input", path, "--output", at("no.vtu"),
            "--material", "3", ranks=2)


@in_folder
def test_labels(at):
    path = write(image({"id": 5 * labels()}), at("in.vti"))
    mesh_file(path, at("out.vtu"), "--labels", "id", ranks=2)
    check_same(at("out.vtu"), filter_mesh(path, MaterialIdArray="id"))
    mesh_file(path, at("out.vtu"), "--labels", "id", "--material", "10", ranks=2)
    assert materials_of(at("out.vtu")) == {10}
    refused(1, "It holds 5, 10.", "--input", path, "--output", at("no.vtu"), "--labels", "id",
            "--material", "7")


@in_folder
def test_state(at):
    ball, plate = ball_and_plate()
    states = {"damage": 0.5 * ball + plate,
              "velocity": np.stack([ball, plate, ball + plate], axis=3)}
    path = write(image({"ball": ball, "plate": plate, **states}), at("in.vti"))
    mesh = filter_mesh(path, VolumeFractionArrays=["ball", "plate"], StateArrays=list(states))
    for ranks in (1, 3):
        # With --state, 'damage' is not a material.
        mesh_file(path, at("out.vtu"), "--state", "damage,velocity", ranks=ranks)
        check_same(at("out.vtu"), mesh)
    files = ["--input", path, "--output", at("no.vtu")]
    refused(1, "'ball' cannot be transferred", *files, "--fractions", "ball,plate", "--state",
            "ball", "--material", "2", ranks=2)


def reads_appended_data():
    """Returns whether VTK 9.2 can read them with this expat (see save_data in vfmtest.py)."""
    return not hasattr(ctypes.CDLL("libexpat.so.1"), "XML_SetReparseDeferralEnabled")


@in_folder
def test_times(at):
    if not reads_appended_data():
        return  # files of several times hold appended data
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(at("times.vti"))
    writer.SetNumberOfTimeSteps(2)
    steps = [image({"ball": value}) for value in (ball_and_plate()[0], ball_and_plate()[0][::-1])]
    for step in steps:  # VTK's reader does not read these from files with several times
        step.SetOrigin(0, 0, 0)
        step.SetSpacing(1, 1, 1)
    writer.SetInputData(steps[0])
    writer.Start()
    for time, step in enumerate(steps):  # VTK numbers the times, whatever their values are
        writer.SetInputData(step)
        writer.WriteNextTime(time)
    writer.Stop()
    first, second = (mesh_of(step, VolumeFractionArrays=["ball"]).mesh for step in steps)
    for arguments, mesh in (([], first), (["--step", "1"], second), (["--time", "0.4"], first),
                            (["--time", "0.6"], second)):
        text = mesh_file(at("times.vti"), at("out.vtu"), *arguments, ranks=2)
        assert "time %d\n" % (mesh is second) in text
        check_same(at("out.vtu"), mesh, int(mesh is second))
    refused(2, "no step 2: it has 2", "--input", at("times.vti"), "--output", at("no.vtu"),
            "--step", "2", ranks=2)


@in_folder
def test_table(at):
    path = write(fraction_image(), at("in.vti"))
    mesh = filter_mesh(path, VolumeFractionArrays=["ball", "plate"])
    texts = [mesh_file(path, at("out.vtu"), ranks=ranks) for ranks in (1, 2, 4)]
    tables = [text[:text.index("seconds:")] for text in texts]
    assert tables[0] == tables[1] == tables[2]
    assert re.search(r"^seconds: read \d+\.\d\d mesh \d+\.\d\d write \d+\.\d\d$", texts[2],
                     re.MULTILINE)
    quality, material, fragment = (
        vtk_to_numpy(mesh.GetCellData().GetArray(name))
        for name in ("ScaledJacobian", "MaterialId", "FragmentId"))
    connectivity = vtk_to_numpy(mesh.GetCells().GetConnectivityArray()).reshape(-1, 8)
    field = {name: vtk_to_numpy(mesh.GetFieldData().GetArray(name))
             for name in ("MeshVolume", "TargetVolume")}
    table = rows(tables[0])
    assert set(table) >= {"1 ball", "2 plate", "all"} and len(table) == 3 + fragment.max(), table

    def check(row, cells, volume):
        expected = [cells.sum(), len(np.unique(connectivity[cells])), quality[cells].min(),
                    quality[cells].mean(), volume]
        assert np.allclose(row[:5], expected, rtol=6e-6, atol=6e-5), (row, expected)

    for m, name in enumerate(("1 ball", "2 plate")):
        check(table[name], material == m + 1, field["MeshVolume"][m])
        assert np.allclose(table[name][5], field["TargetVolume"][m],
                           rtol=6e-6) and abs(table[name][6]) < 0.01
    check(table["all"], material > 0, field["MeshVolume"].sum())
    for f in range(1, fragment.max() + 1):
        m = material[fragment == f][0]
        assert (material[fragment == f] == m).all()
        if (fragment[material == m] == f).all():
            check(table["%d of material %d" % (f, m)], fragment == f, field["MeshVolume"][m - 1])


@in_folder
def test_table_of_many_fragments(at):
    drops = np.zeros((13, 13, 13))
    drops[1::3, 1::3, 1:4:3] = 1
    text = mesh_file(write(image({"drops": drops}), at("in.vti")), at("out.vtu"), "--stairstep",
                     ranks=2)
    assert "and 6 smaller fragments" in text and text.count(" of material 1") == 10, text
    assert rows(text)["all"][:2] == [16, 128]


@in_folder
def test_table_of_tets(at):
    path = write(fraction_image(), at("in.vti"))
    mesh = filter_mesh(path, tets=True, VolumeFractionArrays=["ball", "plate"], Method="Lattice")
    text = mesh_file(path, at("out.vtu"), "--tetmesh", "Lattice", ranks=2)
    angles = [mesh.GetFieldData().GetArray(name).GetValue(0)
              for name in ("MinimumDihedralAngle", "MaximumDihedralAngle")]
    assert "dihedral angles: %.2f to %.2f degrees" % tuple(angles) in text
    counts = [int(n) for n in re.findall(r"^ +\d+ to +\d+ +(\d+)$", text, re.MULTILINE)]
    assert sum(counts) == 6 * mesh.GetNumberOfCells()
    volumes = vtk_to_numpy(mesh.GetFieldData().GetArray("MeshVolume"))
    assert np.allclose([rows(text)[name][4] for name in ("1 ball", "2 plate")], volumes, rtol=6e-6)


@in_folder
def test_quiet(at):
    assert mesh_file(write(fraction_image(), at("in.vti")), at("out.vtu"), "--quiet", ranks=2) == ""


def test_help():
    for ranks in (1, 2):
        result = sculptor("--help", ranks=ranks)
        assert result.returncode == 0 and result.stderr == "" and result.stdout.count("usage:") == 1
    assert re.fullmatch(r"sculptor \d+\.\d+\.\d+\n", sculptor("--version").stdout)


@in_folder
def test_wrong_arguments(at):
    """Messages and exit codes of wrong arguments; ArgumentsTest.cxx tests each one."""
    path = write(fraction_image(8), at("in.vti"))
    for ranks in (1, 3):
        refused(1, "'--wrong' is not an option. See sculptor --help.", path, at("no.vtu"),
                "--wrong", ranks=ranks)
    refused(1, "There is no material '2'", "test", "--material", "2")
    refused(1, "Cells cannot be refined by 'plate'", path, at("no.vtu"), "--fractions",
            "ball,plate", "--refine-cells", "plate", "--material", "ball", ranks=2)
    assert not os.path.exists(at("no.vtu"))


@in_folder
def test_unreadable_input(at):
    path = write(fraction_image(), at("in.vti"))
    with open(path, "rb") as file:
        content = file.read()
    for name, part in (("empty", b""), ("text", b"no grid\n"), ("cut", content[:-200])):
        with open(at(name + ".vti"), "wb") as file:
            file.write(part)
    os.mkdir(at("folder.vti"))
    for name, text in (("missing", "No such file"), ("folder", "Is a directory"),
                       ("empty", "Cannot read the input"),
                       ("text", "Cannot read the input"), ("cut", "Cannot read the input")):
        for ranks in ((1, 3) if name in ("missing", "cut") else (2,)):
            refused(2, text, "--input", at(name + ".vti"), "--output", at("no.vtu"), ranks=ranks)
    refused(2, "no times", "--input", path, "--output", at("no.vtu"), "--time", "1", ranks=2)
    refused(2, "no step 1", "--input", path, "--output", at("no.vtu"), "--step", "1")


@in_folder
def test_refused_input(at):
    ball = ball_and_plate()[0].copy()
    ball[2, 3, 11] = 1.5  # only on the last rank
    path = write(image({"ball": ball}), at("in.vti"))
    for ranks in (1, 3):
        files = ["--input", path, "--output", at("no.vtu")]
        refused(3, "'ball' holds 1.5 in cell", *files, "--fractions", "ball", ranks=ranks)
        refused(2, "no numeric array 'wrong' (--fractions). "
                "Its cell arrays: ball (double, 0 to 1.5).",
                *files, "--fractions", "wrong", ranks=ranks)
        refused(3, "material ids are integers", *files, "--labels", "ball", ranks=ranks)
    assert not os.path.exists(at("no.vtu"))


@in_folder
def test_unwritable_output(at):
    path = write(fraction_image(8), at("in.vti"))
    os.symlink("/dev/full", at("full.vtu"))
    for name in ("folder.vtu", "folder.pvtu"):
        os.mkdir(at(name))
    for name, text in (("missing/out.vtu", "No such file"), ("folder.vtu", "directory"),
                       ("folder.pvtu", "directory"), ("full.vtu", "No space left")):
        refused(4, text, "--input", path, "--output", at(name), ranks=2)
    refused(4, "No space left", "--input", path, "--output", at("full.vtu"))
    os.symlink("/dev/full", at("full.inp"))
    for ranks in (1, 2):
        refused(4, "No space left", "--input", path, "--output", at("full.inp"), ranks=ranks)


main(globals())
