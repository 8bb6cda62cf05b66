"""Exodus files and other hexahedra that form a Cartesian grid, as input.

The meshes are bitwise identical to meshes of images, with ParaView's readers and with `sculptor`
on several ranks. Other meshes and damaged files are reported.
"""
import functools
import os
import re
import shutil
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import (
    VTK_QUAD, VTK_TETRA, VTK_VOXEL, vtkMultiBlockDataSet, vtkStructuredGrid, vtkUnstructuredGrid)

import exodus_grids
import sculptor_program
from compare_meshes import difference, merge, read_pieces
from exodus_grids import GRADED, N, TIMES, UNIFORM, fields, hexes, shuffled, write_exodus
from mpi_run import mpi_run
from vfmtest import (
    PYTHON, GHOST, HIDDEN, VolumeFractionToTet, add_array, check_error, digest, image, in_folder,
    main, mesh_of, rectilinear, uniform, write)

FRACTIONS = ["MAT_10", "MAT_20"]
CHOSEN = {"VolumeFractionArrays": FRACTIONS, "StateArrays": ["number"]}
check_input_error = functools.partial(check_error, **CHOSEN)
ALL = np.arange(N ** 3)


def blocks(*data):
    result = vtkMultiBlockDataSet()
    for i, block in enumerate(data):
        result.SetBlock(i, block)
    return result


def of_grid(step=0, coordinates=UNIFORM, **properties):
    return mesh_of(rectilinear(fields(step), coordinates), **{**CHOSEN, **properties})


def check_same(data, expected, **properties):
    assert digest(mesh_of(data, **{**CHOSEN, **properties})) == digest(expected)


def test_order_of_cells():
    """The order of cells and of corners does not change the mesh."""
    expected = of_grid()
    check_same(image(fields()), expected)
    for cells in (ALL, shuffled(), ALL[::-1], ALL.reshape(N, N, N).T.ravel()):
        check_same(hexes(fields(), cells), expected)
    check_same(hexes(fields(), shuffled(), kind=VTK_VOXEL), expected)


def test_blocks():
    """Blocks of cells, also mixed with images, give the mesh of one grid."""
    cells = shuffled()
    expected = of_grid()
    check_same(blocks(*[hexes(fields(), part) for part in np.split(cells, [5, 600, 601])]),
               expected)
    left = np.flatnonzero(ALL % N < 5)
    right = image({name: values[:, :, 5:] for name, values in fields().items()})
    right.SetOrigin(UNIFORM[0][5], UNIFORM[1][0], UNIFORM[2][0])
    check_same(blocks(right, None, hexes(fields(), left)), expected)


def test_spacing_and_options():
    """Graded cells give the mesh of a rectilinear grid, with each kind of option."""
    graded = hexes(fields(), shuffled(), GRADED)
    for properties in ({}, uniform(1), {"make": VolumeFractionToTet, "Method": "Cells"},
                       {"MeshVoid": 1}):
        check_same(graded, of_grid(coordinates=GRADED, **properties), **properties)


def test_float_coordinates():
    """Nodes that differ by rounding are merged."""
    tenths = [0.1 * np.arange(N + 1.0)] * 3
    data = hexes(fields(), shuffled(), tenths)
    points = vtk_to_numpy(data.GetPoints().GetData())
    points += np.random.default_rng(2).uniform(0, 1e-6, points.shape)
    exact = [np.array([points[np.abs(points[:, a] - x) < 0.01, a].min() for x in tenths[a]])
             for a in range(3)]
    check_same(data, of_grid(coordinates=exact))


def test_labels():
    """Labels on hexahedra give the mesh of labels on an image."""
    ids = np.random.default_rng(3).choice([0, 2, 5], (N, N, N)).astype(np.int32)
    expected = mesh_of(image({"id": ids}), MaterialIdArray="id", StateArrays=["id"])
    check_same(hexes({"id": ids}, shuffled()), expected, MaterialIdArray="id", StateArrays=["id"],
               VolumeFractionArrays=[])


def test_state_arrays():
    """State arrays keep their types and values."""
    generator = np.random.default_rng(4)
    state = {"v": generator.normal(size=(N, N, N, 3)).astype(np.float32),
             "n": generator.integers(0, 9, (N, N, N)).astype(np.int16)}
    expected = of_grid()
    cells = shuffled()
    result = mesh_of(hexes({**fields(), **state}, cells),
                     **{**CHOSEN, "StateArrays": ["number", "v", "n"]})
    place = expected.cells("number").astype(int)
    for name, values in state.items():
        found = result.cells(name)
        assert found.dtype == values.dtype and (found
                                                == values.reshape(N ** 3, *values.shape[3:])[
                                                    place]).all()


def test_ghosts():
    """Values of ghost cells are ignored; blanked cells are void."""
    cells = shuffled()
    types = np.zeros((N, N, N), np.uint8)
    types[4:6, 3:9, 3:9] = HIDDEN
    data = image({**fields(), "vtkGhostType": types})
    check_same(hexes({**fields(), "vtkGhostType": types}, cells), mesh_of(data, **CHOSEN))
    parts = []
    for mine, others in ((cells[:800], cells[800:900]), (cells[800:], cells[100:200])):
        types = np.zeros(N ** 3, np.uint8)
        types[others] = GHOST
        arrays = {name: np.where(types.reshape(N, N, N) > 0, 77.0, values)
                  for name, values in fields().items()}
        mixed = np.random.default_rng(1).permutation(np.concatenate([mine, others]))
        parts.append(hexes({**arrays, "vtkGhostType": types.reshape(N, N, N)}, mixed))
    check_same(blocks(*parts), of_grid())


def quads(kind=VTK_QUAD, count=4):
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    for point in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1))[:count]:
        points.InsertNextPoint(point)
    grid.SetPoints(points)
    grid.InsertNextCell(kind, count, list(range(count)))
    return grid


def test_cells_of_less_dimensions_are_left_out():
    """Cells of fewer dimensions are ignored."""
    expected = of_grid()
    check_same(blocks(quads(), hexes(fields(), shuffled()), vtkUnstructuredGrid()), expected)
    data = hexes(fields(), shuffled())
    data.InsertNextCell(VTK_QUAD, 4, [0, 500, 3, 7])
    for name in fields():
        data.GetCellData().GetArray(name).InsertNextTuple1(77)
    data.GetCellData().SetGlobalIds(None)
    check_same(data, expected)


def structured(coordinates):
    grid = vtkStructuredGrid()
    size = [len(x) for x in coordinates]
    grid.SetDimensions(size)
    nodes = np.stack(np.meshgrid(*coordinates, indexing="ij"),
                     axis=-1).transpose(2, 1, 0, 3).reshape(-1, 3)
    points = vtkPoints()
    for node in nodes:
        points.InsertNextPoint(node)
    grid.SetPoints(points)
    return grid


def test_structured_grid():
    """Structured grids are accepted, also with reversed axes and blanked cells."""
    data = structured(GRADED)
    for name, values in fields().items():
        add_array(data.GetCellData(), name, values)
    expected = of_grid(coordinates=GRADED)
    check_same(data, expected)
    flipped = structured([GRADED[0][::-1], *GRADED[1:]])
    for name, values in fields().items():
        add_array(flipped.GetCellData(), name, values[:, :, ::-1])
    check_same(flipped, expected)
    data.BlankCell(600)
    types = np.zeros(N ** 3, np.uint8)
    types[600] = HIDDEN
    check_same(data,
               mesh_of(rectilinear({**fields(), "vtkGhostType": types.reshape(N, N, N)}, GRADED),
                       **CHOSEN))


def moved(change, cells=ALL):
    """Returns the hexahedra after change(points)."""
    data = hexes(fields(), cells)
    change(vtk_to_numpy(data.GetPoints().GetData()))
    return data


def turn(points):
    points[:] = points @ np.array([[0.8, 0.6, 0], [-0.6, 0.8, 0], [0, 0, 1]])


def set_point(point, axis, value):
    def change(points):
        points[point, axis] = value
    return change


def test_other_shapes():
    """Hexahedra that are not boxes along the axes are rejected; the message names the cell."""
    check_input_error(moved(set_point(0, 0, -0.9)), "The input: cell 0 is not a box",
                      "its point 0 at (-0.9, 0.5, 2)", "Transform")
    check_input_error(moved(turn), "cell 0 is not a box with sides along the axes", "Transform",
                      "Resample To Image")
    check_input_error(moved(set_point(14, 2, np.nan)), "corner that is not finite", "point 14")
    check_input_error(moved(lambda points: points.__setitem__((slice(None), 1), 3.0)),
                      "cell 0 is flat along y")
    data = hexes(fields(), ALL)
    # Corner 0 of cell 1 becomes its corner 1.
    vtk_to_numpy(data.GetCells().GetConnectivityArray())[8] = 2
    check_input_error(data, "cell 1 has two corners in the same place")


def test_other_cells():
    """Other types of cells are rejected."""
    check_input_error(quads(VTK_TETRA), "The input: cell 0 is a vtkTetra", "Resample To Image")
    check_input_error(blocks(hexes(fields(), ALL), quads(VTK_TETRA)),
                      "Block 1: cell 0 is a vtkTetra")
    check_input_error(quads(), "no cells", "3D grid of cells")
    check_input_error(blocks(quads(), quads()), "no cells", "3D grid of cells")


def test_cells_that_do_not_tile():
    """Gaps and overlaps between cells are rejected."""
    check_input_error(hexes(fields(), np.delete(ALL, [40, 400])), "leave a gap: 2 of the 1728",
                      "cell (4, 3, 0)")
    check_input_error(hexes(fields(), np.append(ALL, 77)),
                      "cell 77 and cell 1728 lie in the same place")
    check_input_error(blocks(hexes(fields(), ALL[:300]), hexes(fields(), ALL[299:])),
                      "Block 0 and Block 1 overlap", "cell (11, 0, 2)")
    half = [np.linspace(x[0], x[-1], 2 * N + 1) for x in UNIFORM]
    fine = hexes({name: np.repeat(np.repeat(np.repeat(v, 2, 0), 2, 1), 2, 2)
                  for name, v in fields().items()}, [0, 1], half)
    check_input_error(blocks(fine, hexes(fields(), ALL[1:])),
                      "Finer blocks cover only a part of cell (0, 0, 0) of level 0")


def test_missing_arrays():
    """Missing arrays are reported with the available ones."""
    data = hexes(fields(), shuffled())
    check_input_error(data,
                      "has no numeric cell array 'MAT_30'. Its cell arrays: "
                      "'ids', 'MAT_10', 'MAT_20', 'number'", VolumeFractionArrays=["MAT_30"])
    check_input_error(data, "has no numeric cell array 'heat'", StateArrays=["heat"])


def run_script(ranks, *words):
    result = mpi_run(ranks, [*PYTHON, exodus_grids.__file__, *words])
    assert result.returncode == 0 and "ERR|" not in result.stderr, result


def sculptor(path, output, *arguments, ranks=1):
    return sculptor_program.sculptor("--input", path, "--output", output, *arguments, ranks=ranks)


FOLDER = tempfile.TemporaryDirectory()


@functools.lru_cache()
def files():
    """Writes the same grid to files of several forms; returns {form: path}."""
    at = lambda name: os.path.join(FOLDER.name, name)
    cells = shuffled()
    run_script(3, "write", at("parts.e"))
    return {
        "one": write_exodus(at("one.exo"), lambda step: {"all": hexes(fields(step), ALL)}),
        "blocks": write_exodus(at("blocks.g"), lambda step: {
            name: hexes(fields(step), part)
            for name, part in zip("zay", np.split(cells, [600, 601]))}),
        "parts": at("parts.e.3.0"),
    }


def check_pieces(pieces, expected, label):
    """Compares pieces with the expected mesh, without the field data that the reader adds."""
    for piece in pieces:
        field = piece.GetFieldData()
        for name in [field.GetArrayName(i) for i in range(field.GetNumberOfArrays())]:
            if not expected.mesh.GetFieldData().HasArray(name):
                field.RemoveArray(name)
    problem = difference(merge(pieces), merge([expected.mesh]))
    assert not problem, "%s: %s" % (label, problem)


def check_file(output, expected, label):
    check_pieces(read_pieces(output), expected, label)


@in_folder
def test_readers_of_paraview(at):
    """All readers of ParaView give the mesh of each time step, also on ranks."""
    expected = [of_grid(step) for step in range(len(TIMES))]
    assert digest(expected[0]) != digest(expected[1])
    for kind, path in files().items():
        for reader in ("OpenDataFile", "IOSSReader", "ExodusIIReader"):
            for step in range(len(TIMES)):
                mesher = exodus_grids.mesh_of_reader(reader, step, path)
                mesh = mesher.GetClientSideObject().GetOutputDataObject(0)
                check_pieces([mesh], expected[step], (kind, reader, step))
    for ranks, reader, kind in ((2, "IOSSReader", "blocks"), (3, "ExodusIIReader", "parts"),
                                (3, "OpenDataFile", "parts")):
        run_script(ranks, "mesh", reader, "1", files()[kind], at("out.pvtu"))
        check_file(at("out.pvtu"), expected[1], (kind, reader, ranks))


@in_folder
def test_sculptor(at):
    """sculptor gives the mesh of each time step on 1 to 4 ranks."""
    expected = [of_grid(step) for step in range(len(TIMES))]
    asked = ("--fractions", "MAT_10,MAT_20", "--state", "number", "--quiet")
    for kind, path in files().items():
        for ranks, step, words in ((1, 0, ()), (2, 1, ("--time", "1.9")), (3, 0, ()),
                                   (4, 1, ("--step", "1"))):
            # Any part identifies the file.
            result = sculptor(path.replace("3.0", "3.1"), at("out.vtu"), *asked, *words,
                              ranks=ranks)
            assert result.returncode == 0 and result.stderr == "", result
            check_file(at("out.vtu"), expected[step], (kind, ranks, words))
        result = sculptor(path, at("out.vtu"))
        assert ("materials from MAT_10, MAT_20 (all cell arrays" in result.stdout
                and "time 0.5" in result.stdout), result


@in_folder
def test_sculptor_part_of_one(at):
    """FILE.1.0 is part 0 of 1, for any FILE, written by ParaView or by sculptor."""
    expected, cells = of_grid(1), shuffled()
    path = write_exodus(at("whole.exo"), lambda step: {"all": hexes(fields(step), cells)})
    for name in ("cube_mesh.exo.1.0", "cube.1.0", "cube.E.1.0", "cube.1.00"):
        path = shutil.move(path, at(name))  # There is no file named FILE.
        for ranks in (1, 3):
            result = sculptor(path, at("out.vtu"), "--fractions", "MAT_10,MAT_20", "--state",
                              "number", "--time", "2", ranks=ranks)
            assert (result.returncode == 0 and result.stderr == ""
                    and "time 2\n" in result.stdout), result
            check_file(at("out.vtu"), expected, (name, ranks))
    sculptor_program.refused(2, "No such file", at("other.1.0"), at("no.vtu"), ranks=2)
    sculptor_program.refused(1, "of an unknown format", at("cube.1.1"), at("no.vtu"))
    grid = write(image(fields()), at("grid.vti"))
    sculptor_program.mesh_file(grid, at("ours.e"), "--fractions", "MAT_10,MAT_20", "--stairstep",
                               "--void", "--state", "number")
    sculptor_program.mesh_file(shutil.move(at("ours.e"), at("ours.1.0")), at("out.vtu"), "--labels",
                               "object_id", "--state", "number")
    numbers = np.concatenate([vtk_to_numpy(piece.GetCellData().GetArray("number"))
                              for piece in read_pieces(at("out.vtu"))])
    assert set(numbers.tolist()) == set(ALL.tolist())


@in_folder
def test_sculptor_velocity(at):
    """The components vel_X, vel_Y, vel_Z form one vector; the image gives the same sums."""
    arrays = fields()
    ramp = np.linspace(1, 2, N)[:, None, None] + 0 * arrays["MAT_10"]
    grid = write(image({**arrays, "vel": np.stack([ramp, ramp ** 2, 1 - ramp], -1),
                        "rho": 1 + ramp}), at("grid.vti"))
    words = ["--fractions", "MAT_10,MAT_20"]
    sculptor_program.mesh_file(grid, at("cells.e"), *words, "--stairstep", "--void", "--state",
                               "MAT_10,MAT_20,vel,rho")
    words += ["--density", "rho", "--velocity", "vel", "--nodal-velocity"]
    sums = [re.findall("^(?:mass|momentum).*",
                       sculptor_program.mesh_file(path, at("out.vtu"), *words), re.M)
                       for path in (grid, at("cells.e"))]
    assert len(sums[0]) == 4 and sums[0] == sums[1], sums


@in_folder
def test_sculptor_labels(at):
    """Element variables with integer values, or the ids of blocks, can be labels."""
    ids = np.random.default_rng(3).choice([0, 2, 5], (N, N, N))
    expected = mesh_of(image({"MAT": ids.astype(np.int32)}), MaterialIdArray="MAT")
    cells = shuffled()
    path = write_exodus(at("in.e"), lambda step: {"all": hexes({"MAT": ids.astype(float)}, cells)})
    assert sculptor(path, at("out.vtu"), "--labels", "MAT").returncode == 0
    check_file(at("out.vtu"), expected, "labels")
    path = write_exodus(at("in.e"), lambda step: {
        "five": hexes({}, ALL[ids.ravel() == 5]), "rest": hexes({}, ALL[ids.ravel() != 5])}, [0.0])
    expected = mesh_of(image({"object_id": np.where(ids == 5, 1, 2).astype(np.int32)}),
                       MaterialIdArray="object_id")
    assert sculptor(path, at("out.vtu"), "--labels", "object_id").returncode == 0
    check_file(at("out.vtu"), expected, "ids of blocks")
    path = write_exodus(at("in.e"), lambda step: {"all": hexes({"MAT": ids + 0.5}, cells)})
    refused(3, "'MAT' holds 5.5 in cell (0, 0, 0): material ids are integers", path, at("no.vtu"),
            "--labels", "MAT")


def refused(code, text, path, output, *arguments, ranks=1):
    sculptor_program.refused(code, text, "--input", path, "--output", output, *arguments,
                             ranks=ranks)


@in_folder
def test_sculptor_refuses(at):
    """Missing variables, steps and files, unknown formats and skewed cells are reported."""
    no = at("no.vtu")
    for ranks, kind in ((1, "one"), (1, "parts"), (2, "parts"), (3, "blocks")):
        path = files()[kind]
        refused(2, "has no element variable 'MAT_30'. It has: MAT_10, MAT_20, number.", path, no,
                "--fractions", "MAT_30", ranks=ranks)
        refused(2, "has no element variable 'heat'", path, no, "--state", "heat", ranks=ranks)
        refused(2, "has no step 2: it has 2, counted from 0", path, no, "--step", "2", ranks=ranks)
    refused(2, "absent.e: No such file", at("absent.e"), no)
    refused(1, "unknown format", at("parts.e.3.3"), no)
    skewed = write_exodus(at("skewed.e"), lambda step: {"all": moved(turn)}, [0.0])
    refused(3, "Block 0 of rank 0: cell 0 is not a box", skewed, no, "--fractions", "MAT_10",
            ranks=3)


@in_folder
def test_damaged_files(at):
    """Truncated files and other contents are reported."""
    no = at("no.vtu")
    with open(files()["blocks"], "rb") as file:
        whole = file.read()
    for length in [0, 3, 100, 2000] + [len(whole) * i // 5 for i in range(1, 5)] + [len(whole) - 9]:
        with open(at("cut.e"), "wb") as file:
            file.write(whole[:length])
        refused(2, "Cannot read the input " + at("cut.e"), at("cut.e"), no, "--fractions", "MAT_10")
    with open(at("cut.e"), "wb") as file:
        file.write(b"no Exodus file at all" * 100)
    refused(2, "Cannot read the input " + at("cut.e"), at("cut.e"), no)


@in_folder
def test_damaged_parts(at):
    """Missing, truncated and inconsistent parts are reported on any number of ranks."""
    no = at("no.vtu")
    part = [at("parts.e.3.%d" % rank) for rank in range(3)]
    files()
    for rank, counts in enumerate(((1, 3), (2, 3), (4,))):
        for path in part:
            shutil.copy(os.path.join(FOLDER.name, os.path.basename(path)), path)
        os.remove(part[rank])
        for ranks in counts:
            refused(2, "parts.e.3.%d (one of 3 files): No such file" % rank, part[(rank + 1) % 3],
                    no, ranks=ranks)
        with open(os.path.join(FOLDER.name, "parts.e.3.%d" % rank),
                  "rb") as whole, open(part[rank], "wb") as cut:
            cut.write(whole.read()[:-20000])
        for ranks in counts:
            refused(2, "parts.e.3.%d: the file is truncated" % rank, part[0], no, ranks=ranks)
        shutil.copy(write_exodus(at("other.e"), lambda step: {"left": hexes(fields(), ALL)}, [0.5]),
                    part[rank])
        refused(2, "it holds %d times, but " % (1 if rank else 2), part[2], no, ranks=counts[0])


main(globals())
