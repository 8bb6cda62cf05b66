"""Abaqus input files: contents, names, numbers, and messages about meshes and files that fail."""
import os
import resource
import signal

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, VTK_TETRA, VTK_WEDGE, vtkUnstructuredGrid
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints, vtkStringArray

from inp_file import InpFile
from mpi_run import mpi_run
from vfmtest import (
    TET_METHODS, VolumeFractionToTet, add_array, collect, elements, face_owners, fraction_image,
    in_folder, main, mesh_of, producer, tet_volumes, write, simple)

SCULPTOR = os.environ["VFM_SCULPTOR"]
SIDES = ("X_MIN", "X_MAX", "Y_MIN", "Y_MAX", "Z_MIN", "Z_MAX")
NAMES = {0: "VOID", 1: "BALL", 2: "PLATE"}
NEAR = 5e-14  # relative error of numbers whose shortest text has more than 20 characters


def write_inp(mesh, path):
    """Writes a mesh and returns the error messages, which are empty if the file is written."""
    writer = simple.CreateWriter(path, producer(mesh))
    algorithm = writer.GetClientSideObject()
    assert algorithm.GetClassName() == "vtkVolumeFractionAbaqusWriter"
    errors, warnings = collect(algorithm)
    writer.UpdateVTKObjects()
    assert algorithm.Write() == (0 if errors else 1) and not warnings, warnings
    return errors


def saved(mesh, path):
    errors = write_inp(mesh, path)
    assert not errors, errors
    return InpFile(path)


def check_coordinates(texts, values):
    texts, values = np.ravel(texts).tolist(), np.ravel(values).tolist()
    assert len(texts) == len(values)
    for text, value in zip(texts, values):
        error = abs(float(text) - value)
        near = NEAR if 1e-99 <= abs(value) < 1e100 else 10 * NEAR
        assert error == 0 if len(repr(value)) <= 19 else error <= near * abs(value), (text, value)


def sides_of(points):
    """Returns the numbers of the nodes on each side of the box of the fields."""
    low, high = np.array([-1, 0.5, 2]), np.array([2, 3.5, 8])  # bounds of fraction_image()
    on = [points[:, axis] == bound[axis] for axis in range(3) for bound in (low, high)]
    return {name: set((np.flatnonzero(mask) + 1).tolist()) for name, mask in zip(SIDES, on)
            if mask.any()}


def expected_surfaces(result):
    """Returns {name: faces as sorted corners} from the materials on both sides of each face."""
    numbers = elements(result) + 1
    sides = sides_of(vtk_to_numpy(result.mesh.GetPoints().GetData()))
    surfaces = {}
    for face, owners in face_owners(numbers, result.cells("MaterialId")).items():
        for owner in set(owners) if len(set(owners)) == len(owners) else ():
            surfaces.setdefault(NAMES[owner] + "_SKIN", set()).add(face)
        if len(owners) == 1:
            name = [side for side, nodes in sides.items()
                    if nodes.issuperset(face)] or [NAMES[owners[0]] + "_TO_VOID"]
            surfaces.setdefault(name[0], set()).add(face)
        elif owners[0] != owners[1]:
            surfaces.setdefault("INTERFACES", set()).add(face)
            for a, b in (owners, owners[::-1]):
                surfaces.setdefault("%s_TO_%s" % (NAMES[a], NAMES[b]), set()).add(face)
    return surfaces


def check_orientation(points, cells):
    """Checks that the corners turn counterclockwise seen from the opposite corner.

    The corners are 1, 2 and 4, seen from 5; of a tetrahedron 1, 2 and 3, seen from 4.
    """
    if cells.shape[1] == 8:
        cells = cells[:, [0, 1, 3, 4]]
    assert (tet_volumes(points, cells) > 0).all()


def check_file(file, result):
    points, materials = vtk_to_numpy(result.mesh.GetPoints().GetData()), result.cells("MaterialId")
    assert str(len(points)) in file.heading[0] and str(len(materials)) in file.heading[0]
    check_coordinates(file.nodes, points)
    corners = np.array([file.elements[number + 1] for number in range(len(file.elements))])
    assert (corners == elements(result) + 1).all() and file.type == "C3D%d" % corners.shape[1]
    check_orientation(file.nodes.astype(float), corners - 1)
    sets = {NAMES[m]: set((np.flatnonzero(materials == m) + 1).tolist())
            for m in set(materials.tolist())}
    assert {name: set(numbers) for name, numbers in file.element_sets.items()} == {
        **sets, "EALL": set(range(1, len(materials) + 1))}
    assert len(file.element_sets["EALL"]) == len(materials)
    ids = {m or max(NAMES) + 1: NAMES[m] for m in set(materials.tolist())}
    assert file.blocks == {"EB%d" % i: file.element_sets[name] for i, name in ids.items()}
    nodes = {name: set(numbers) for name, numbers in file.node_sets.items()}
    assert nodes == {**sides_of(points), "NALL": set(range(1, len(points) + 1))}
    expected = expected_surfaces(result)
    assert {name: set(file.side_corners(name)) for name in file.surfaces} == expected
    assert all(len(file.surfaces[name]) == len(faces) for name, faces in expected.items())


@in_folder
def test_file_is_the_mesh(at):
    """The file holds elements, sets and surfaces of the mesh, for each kind of mesh."""
    kinds = [{},
             {"MeshVoid": 1}] + [{"make": VolumeFractionToTet, "Method": method}
                                 for method in TET_METHODS]
    for kind in kinds:
        result = mesh_of(fraction_image(), **kind)
        file = saved(result.mesh, at("mesh.inp"))
        assert len(file.element_sets) == (4 if kind == {"MeshVoid": 1} else 3)
        check_file(file, result)


@in_folder
def test_velocities_of_nodes(at):
    """A point vector is written as initial velocity if its name says so, and no other array is."""
    result = mesh_of(fraction_image())
    values = np.random.default_rng(5).normal(size=(result.mesh.GetNumberOfPoints(),
                                                   3)) * 10.0 ** np.arange(-3, 6, 3)
    for name, array in (("velocity gradient", np.tile(values, 3)), ("force", values)):
        add_array(result.mesh.GetPointData(), name, array).SetNumberOfComponents(array.shape[1])
    assert not len(saved(result.mesh, at("mesh.inp")).velocities)
    add_array(result.mesh.GetPointData(), "Nodal Velocity", values).SetNumberOfComponents(3)
    file = saved(result.mesh, at("mesh.inp"))
    check_file(file, result)
    check_coordinates(file.velocities, values)


@in_folder
def test_save_data(at):
    """SaveData of ParaView writes the same mesh."""
    hexes = VolumeFractionToTet(Input=producer(fraction_image()),
                                VolumeFractionArrays=["ball", "plate"], Method="Lattice")
    simple.SaveData(at("mesh.inp"), proxy=hexes)
    check_file(InpFile(at("mesh.inp")),
               mesh_of(fraction_image(), VolumeFractionToTet, Method="Lattice"))


def row_of_elements(count, kind=VTK_HEXAHEDRON, scale=1.0):
    """Makes unit cubes or tetrahedra, one per material, with the arrays that the writer needs."""
    mesh = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    mesh.SetPoints(points)
    cube = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1],
                     [0, 1, 1]])
    corners = {VTK_HEXAHEDRON: range(8), VTK_TETRA: [0, 1, 3, 4],
               VTK_WEDGE: [0, 1, 3, 4, 5, 7]}[kind]
    for i in range(count):
        ids = [points.InsertNextPoint(*(scale * (cube[c] + [2 * i, 0, 0]))) for c in corners]
        mesh.InsertNextCell(kind, len(ids), ids)
    for data, name, numbers in ((mesh.GetCellData(), "MaterialId",
                                 np.arange(1, count + 1, dtype=np.int32)),
                                (mesh.GetCellData(), "GlobalCellIds", np.arange(count) + 1),
                                (mesh.GetPointData(), "GlobalPointIds",
                                 np.arange(mesh.GetNumberOfPoints()) + 1)):
        array = numpy_to_vtk(numbers, deep=1)
        array.SetName(name)
        data.AddArray(array)
    return mesh


@in_folder
def test_names(at):
    """Names become valid and unique names of sets."""
    long = "x" * 90
    cases = [("Material volume fraction - 1", "MATERIAL_VOLUME_FRACTION_1"),
             ("material/volume//fraction 1", "MATERIAL_VOLUME_FRACTION_1_2"),
             ("MATERIAL_VOLUME_FRACTION_1_2", "MATERIAL_VOLUME_FRACTION_1_2_2"), ("7 up", "S_7_UP"),
             ("", "S_"), ("größe", "GR_E"),
             ("EALL", "EALL_2"), ("eb1", "EB1_2"), (" a, b\n*STEP ", "A_B_STEP"), (long, "X" * 80),
             (long + "y", "X" * 78 + "_2"), ("_tail_", "TAIL")]
    mesh = row_of_elements(len(cases) + 1)
    names, ids = vtkStringArray(), vtkIntArray()
    names.SetName("MaterialNames")
    ids.SetName("MaterialIds")
    for i, (name, _) in enumerate(cases):
        names.InsertNextValue(name)
        ids.InsertNextValue(i + 1)
    mesh.GetFieldData().AddArray(names)
    mesh.GetFieldData().AddArray(ids)
    file = saved(mesh, at("mesh.inp"))
    found = {numbers[0]: name for name, numbers in file.element_sets.items() if name != "EALL"}
    assert found == {i + 1: name
                     for i, name in enumerate([name for _, name in cases]
                                              + ["MATERIAL_%d" % (len(cases) + 1)])}
    assert len(file.surfaces) == 2 * len(cases) + 2
    assert {"MATERIAL_VOLUME_FRACTION_1_TO_VOID",
            "MATERIAL_VOLUME_FRACTION_1_SKIN"} <= set(file.surfaces)
    assert ("** MATERIAL_VOLUME_FRACTION_1: material 1, Material volume fraction - 1"
            in file.comments)


@in_folder
def test_sides_keep_their_names(at):
    """Names of domain sides are reserved; equal names of materials get a suffix."""
    result = mesh_of(fraction_image())
    names = result.mesh.GetFieldData().GetAbstractArray("MaterialNames")
    names.SetValue(0, "x min")
    names.SetValue(1, "x_min_to_Void")
    file = saved(result.mesh, at("mesh.inp"))
    assert {"X_MIN", "X_MIN_TO_VOID_2"} < set(file.surfaces)
    assert set(file.element_sets) == {"X_MIN_2", "X_MIN_TO_VOID", "EALL"}


@in_folder
def test_numbers(at):
    """Coordinates have at most 20 characters and the smallest possible error."""
    random = np.random.default_rng(1)
    values = np.concatenate([random.normal(size=600) * 10.0 ** random.integers(-30, 30, 600),
                             [0, -0.0, 1, -1 / 3, 1e22 / 3, 5e-324,
                             -1e-99 / 7, -1e-7 / 3, 1.7976931348623157e308, 0.1,
                             123456789012345680000.0, 1e5]])
    mesh = row_of_elements(51)
    coordinates = vtk_to_numpy(mesh.GetPoints().GetData()).ravel()
    coordinates[:len(values)] = values
    texts = saved(mesh, at("mesh.inp")).nodes.ravel()
    check_coordinates(texts, coordinates)
    assert sum(len(text) == 20 for text in texts) > 100


@in_folder
def test_same_bytes_on_all_ranks(at):
    """Runs on 1, 2 and 3 ranks write identical files."""
    path = write(fraction_image(), at("in.vti"))
    for arguments, kind in (([], {}),
                            (["--tetmesh", "Lattice"],
                             {"make": VolumeFractionToTet, "Method": "Lattice"})):
        result = mesh_of(fraction_image(), **kind)
        assert not write_inp(result.mesh, at("filter.inp"))
        for ranks in (1, 2, 3):
            run = mpi_run(ranks,
                          [SCULPTOR, "--input", path, "--output", at("%d.inp" % ranks), *arguments])
            assert run.returncode == 0 and run.stderr == "", run
            check_same_bytes(at("filter.inp"), at("%d.inp" % ranks))


def check_same_bytes(one, other):
    with open(one, "rb") as a, open(other, "rb") as b:
        assert a.read() == b.read(), (one, other)


@in_folder
def test_pieces_read_by_one_rank(at):
    """Pieces with duplicate points and another order of cells give the file of the whole mesh."""
    path = write(fraction_image(), at("in.vti"))
    assert mpi_run(3, [SCULPTOR, "--input", path, "--output", at("mesh.pvtu")]).returncode == 0
    mesh = simple.OpenDataFile(at("mesh.pvtu"))
    simple.SaveData(at("pieces.inp"), proxy=mesh)
    whole = mesh_of(fraction_image()).mesh
    assert mesh.GetDataInformation().GetNumberOfPoints() > whole.GetNumberOfPoints()
    assert not write_inp(whole, at("whole.inp"))
    check_same_bytes(at("pieces.inp"), at("whole.inp"))


def refuse(mesh, path, text):
    errors = write_inp(mesh, path)
    assert len(errors) == 1 and text in errors[0] and path in errors[0], errors
    assert not os.path.isfile(path)


@in_folder
def test_meshes_that_cannot_be_written(at):
    """An empty mesh, mixed or other cells and missing arrays are reported, and no file is left."""
    path = at("mesh.inp")
    refuse(vtkUnstructuredGrid(), path, "empty")
    refuse(row_of_elements(2, VTK_WEDGE), path, "all hexahedra or all tetrahedra")
    mixed = row_of_elements(2)
    mixed.InsertNextCell(VTK_TETRA, 4, [0, 1, 3, 4])
    refuse(mixed, path, "all hexahedra or all tetrahedra")
    for cells, name in ((True, "MaterialId"), (True, "GlobalCellIds"), (False, "GlobalPointIds")):
        mesh = row_of_elements(2)
        (mesh.GetCellData() if cells else mesh.GetPointData()).RemoveArray(name)
        refuse(mesh, path, "no array " + name)


@in_folder
def test_files_that_cannot_be_written(at):
    """Errors of the file system are reported, and no partial file is left."""
    mesh = mesh_of(fraction_image()).mesh
    refuse(mesh, at("missing/mesh.inp"), "No such file")
    os.mkdir(at("folder.inp"))
    refuse(mesh, at("folder.inp"), "Is a directory")
    os.symlink("/dev/full", at("full.inp"))
    refuse(mesh, at("full.inp"), "No space left")
    assert os.path.exists("/dev/full")
    assert not write_inp(mesh, at("whole.inp"))
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (os.path.getsize(at("whole.inp")) - 1, limits[1]))
    try:
        refuse(mesh, at("large.inp"), "File too large")  # The partial file is removed.
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)


main(globals())
