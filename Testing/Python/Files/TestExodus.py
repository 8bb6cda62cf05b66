"""Exodus files: ncdump and ParaView's readers find the mesh in them, in one file and in parts."""
import os
import resource

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOExodus import vtkExodusIIReader

import exodus_dump
from exodus_dump import Dump, check_parts, join, side_corners
from exodus_of_mesh import check, expected
from mesh_sets import AXES, array, find_sets, material_names
from mpi_run import mpi_run
from spyplot import split, write_spyplot
from vfmtest import (
    ORIGIN, SPACING, TET_METHODS, add_array, ball_and_plate, collect, fraction_image, image,
    held_class, in_folder, labels, main, mesh_of,
    new_ioss_reader, producer, save_data, servermanager, simple, VolumeFractionShapes,
    VolumeFractionToHex, VolumeFractionToTet)

SCULPTOR = os.environ["VFM_SCULPTOR"]
CELLS = {"make": VolumeFractionToTet, "Method": "Cells"}
SPY = "Material volume fraction - %d"


def writer_of(mesh, path, **properties):
    return servermanager.writers.VolumeFractionExodusWriter(Input=producer(mesh), FileName=path,
                                                            **properties)


def write(mesh, path, **properties):
    """Writes a mesh and returns the error messages."""
    writer = writer_of(mesh, path, **properties)
    errors, _ = collect(held_class(writer))
    writer.UpdatePipeline()
    return errors


def area_vectors(faces):
    """Returns the area vectors of faces (n, 3 or 4, 3)."""
    return np.cross(faces[:, 2] - faces[:, 0],
                    faces[:, -1] - faces[:, 1] if faces.shape[1] == 4
                    else faces[:, 1] - faces[:, 0]) / (
        2 if faces.shape[1] == 4 else -2)


def surface_areas(result, names):
    """Returns {name of a side set: sum of the area vectors} from the surfaces of the filter."""
    surfaces, sums = result.surfaces, {}
    points = vtk_to_numpy(surfaces.GetPoints().GetData())
    facets = vtk_to_numpy(surfaces.GetPolys().GetConnectivityArray()).reshape(
        surfaces.GetNumberOfCells(), -1)
    areas = area_vectors(points[facets])
    pairs, sides, ids = (array(surfaces.GetCellData(), name)
                         for name in ("MaterialPair", "DomainSide", "SurfaceId"))
    parts = array(surfaces.GetFieldData(), "SurfaceParts")
    for area, (low, high), side, surface in zip(areas, pairs.tolist(), sides.tolist(),
                                                ids.tolist()):
        # The normal points out of the second material.
        keys = [(AXES[side], 1)] if side >= 0 else [("%s_to_%s" % (names[high], names[low]), 1)]
        if side < 0 and low > 0:
            keys.append(("%s_to_%s" % (names[low], names[high]), -1))
        if parts[surface - 1] > 0:
            keys += [("%s_%d" % (name, surface), sign) for name, sign in keys]
        if side < 0 and low > 0:
            keys.append(("interfaces", -1))
        for key, sign in keys:
            sums[key] = sums.get(key, 0) + sign * area
    for material in set(result.cells("MaterialId").tolist()):
        sums[names[material] + "_skin"] = np.zeros(3)  # a closed surface
    return sums


def check_areas(path, result):
    """Checks the faces of each side set in the file.

    They point out of their elements, and their total area vector is that of the surfaces.
    """
    dump = Dump(path)
    elements, points = dump.elements(), dump.points()
    sums = surface_areas(result, material_names(result.mesh))
    assert set(dump.names("ss")) == set(sums), (dump.names("ss"), set(sums))
    for i, name in enumerate(dump.names("ss")):
        faces = points[np.array(side_corners(dump, i, elements))]
        middles = points[np.array([elements[e][1] for e in dump.sides(i)[0]])].mean(axis=1)
        areas = area_vectors(faces)
        assert (np.einsum("ij,ij->i", areas, faces.mean(axis=1) - middles) > 0).all(), name
        assert np.allclose(areas.sum(axis=0), sums[name], rtol=1e-12,
                           atol=1e-12), (name, areas.sum(axis=0), sums[name])


def velocity_field():
    data = fraction_image()
    velocity = numpy_to_vtk(np.random.default_rng(3).normal(size=(12 ** 3, 3)), deep=1)
    velocity.SetName("velocity")
    data.GetCellData().AddArray(velocity)
    return data


@in_folder
def test_one_file(at):
    """A single file holds blocks, sets, ids and state of each kind of mesh."""
    data = velocity_field()
    cases = ({}, {"MeshVoid": 1}, {"StairStep": 1}, CELLS,
             {"make": VolumeFractionToTet, "Method": "Lattice"}, {**CELLS, "MeshVoid": 1})
    for i, properties in enumerate(cases):
        result = mesh_of(data, StateArrays=["velocity"], **properties)
        path = at("mesh%d.exo" % i)
        assert not write(result.mesh, path) and exodus_dump.kind(path) == "64-bit offset"
        check([Dump(path)], result.mesh)
        assert (3 in join([Dump(path)])["blocks"]) == ("MeshVoid" in properties)
        if "MeshVoid" not in properties:
            check_areas(path, result)


@in_folder
def test_values_of_nodes(at):
    """Variables of nodes and elements may have the same name."""
    result = mesh_of(velocity_field(), StateArrays=["velocity"])
    values = np.random.default_rng(4).normal(size=(result.mesh.GetNumberOfPoints(), 3))
    add_array(result.mesh.GetPointData(), "velocity", values).SetNumberOfComponents(3)
    assert not write(result.mesh, at("mesh.e"))
    dump = Dump(at("mesh.e"))
    check([dump], result.mesh)
    for kind in ("nod", "elem"):
        assert {"velocity_X", "velocity_Y",
                "velocity_Z"} <= set(dump.get("name_%s_var" % kind)), kind
    ids = array(result.mesh.GetPointData(), "GlobalPointIds")
    wanted = dict(zip(ids.tolist(), values.tolist()))
    for part in (part for name in ("ball", "plate") for part in ioss(at("mesh.e"))[name]):
        found = dict(zip(array(part.GetPointData(), "ids").tolist(),
                         array(part.GetPointData(), "velocity").tolist()))
        assert found and all(wanted[point] == velocity for point, velocity in found.items())


def ioss(path):
    reader = new_ioss_reader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    for kind in range(reader.NUMBER_OF_ENTITY_TYPES):
        reader.GetEntitySelection(kind).EnableAllArrays()
    reader.Update()
    found = {}
    data = reader.GetOutputDataObject(0)
    for i in range(data.GetNumberOfPartitionedDataSets()):
        for p in range(data.GetNumberOfPartitions(i)):
            if data.GetPartition(i, p):
                found.setdefault(data.GetMetaData(i).Get(data.NAME()),
                                 []).append(data.GetPartition(i, p))
    return found


@in_folder
def test_paraview_reads_it(at):
    """Both Exodus readers of VTK return blocks, ids, vectors, side sets and node sets."""
    result = mesh_of(velocity_field(), StateArrays=["velocity"])
    write(result.mesh, at("mesh.exo"))
    parts, (sides, nodes) = ioss(at("mesh.exo")), find_sets(result.mesh)
    for material, name in material_names(result.mesh).items():
        if material:
            block, chosen = parts[name][0], result.cells("MaterialId") == material
            ids = array(block.GetCellData(), "ids")
            # vectors of three components
            velocities = dict(zip(ids.tolist(), array(block.GetCellData(), "velocity").tolist()))
            wanted = zip(result.cells("GlobalCellIds")[chosen].tolist(),
                         result.cells("velocity")[chosen].tolist())
            assert velocities == dict(wanted)
    for sets in (sides, nodes):
        for (_, name), items in sets.items():
            # IOSS converts names to lower case.
            assert len(items) in [part.GetNumberOfCells() for part in parts[name.lower()]], name
    reader = vtkExodusIIReader()
    reader.SetFileName(at("mesh.exo"))
    reader.UpdateInformation()
    for kind, names in ((reader.ELEM_BLOCK, ["ball", "plate"]),
                        (reader.SIDE_SET, [name for _, name in sorted(sides)]),
                        (reader.NODE_SET, [name for _, name in sorted(nodes)])):
        assert [reader.GetObjectName(kind, i)
                for i in range(reader.GetNumberOfObjects(kind))] == names
        for i in range(len(names)):
            reader.SetObjectStatus(kind, i, 1)
    reader.Update()
    for i, (_, items) in enumerate(sorted(sides.items())):
        assert reader.GetOutput().GetBlock(4).GetBlock(i).GetNumberOfCells() == len(items)


@in_folder
def test_wide_ids(at):
    """Ids above 2^31 (tets of large grids) and above 2^53 (not exact as double) are kept."""
    for shift in (2 ** 31, 2 ** 62):
        mesh = vtkUnstructuredGrid()
        mesh.DeepCopy(mesh_of(fraction_image(8)).mesh)
        for data, name in ((mesh.GetPointData(), "GlobalPointIds"),
                           (mesh.GetCellData(), "GlobalCellIds")):
            array(data, name)[:] += shift
        assert not write(mesh, at("wide.exo")) and exodus_dump.kind(at("wide.exo")) == "netCDF-4"
        dump = Dump(at("wide.exo"))
        assert dump.types["node_num_map"] == dump.types["elem_num_map"] == "int64"
        check([dump], mesh)
        assert array(ioss(at("wide.exo"))["ball"][0].GetPointData(), "ids").min() >= shift


@in_folder
def test_pieces_that_one_process_reads(at):
    """Points on the border between pieces are written once."""
    result = mesh_of(fraction_image())
    save_data(at("mesh.vtu"), producer(result.mesh))
    assert mpi_run(2,
                   [SCULPTOR, "--input", vti(at, fraction_image()), "--output",
                    at("mesh.pvtu")]).returncode == 0
    for name in ("mesh.vtu", "mesh.pvtu"):
        reader = simple.OpenDataFile(at(name))
        simple.SaveData(at(name + ".exo"), proxy=reader)
        check([Dump(at(name + ".exo"))], result.mesh)


@in_folder
def test_names(at):
    """Names that are too long, or that differ only in capitals, get the number as a suffix."""
    ball, plate = ball_and_plate(8)
    names = ["m" * 300, "Iron", "IRON"]
    half = np.where(np.arange(8) < 4, 1.0, 0.0)
    result = mesh_of(image({names[0]: ball, names[1]: plate * half, names[2]: plate * (1 - half)}),
                     VolumeFractionArrays=names)
    assert not write(result.mesh, at("mesh.exo"))
    dump = Dump(at("mesh.exo"))
    assert sorted(dump.names("eb")) == sorted(["m" * 253 + "_1", "Iron",
                                               "IRON_3"]), dump.names("eb")
    for kind in ("eb", "ss", "ns"):
        lower = [name.lower() for name in dump.names(kind)]
        assert len(set(lower)) == len(lower) and max(map(len, lower)) <= 255
    assert len(ioss(at("mesh.exo"))) >= 3


@in_folder
def test_material_ids(at):
    """Ids of four digits use a larger factor for side sets; near 2^31 the sets are numbered."""
    for high, factor in ((4711, 10000), (2 ** 31 - 1, None)):
        ids = np.where(labels(8) == 2, high, labels(8)).astype(np.int32)
        result = mesh_of(image({"id": ids}), MaterialIdArray="id")
        assert not write(result.mesh, at("mesh.exo"))
        dump = Dump(at("mesh.exo"))
        assert dump.get("eb_prop1").tolist() == [1, high]
        pairs = dict(zip(dump.names("ss"), dump.get("ss_prop1").tolist()))
        order = [pairs[name] for name in dump.names("ss") if "_to_" in name]
        assert order == ([factor, factor + high, high * factor, high * factor + 1] if factor
                         else [7, 8, 9, 10]), pairs
    result = mesh_of(image({"id": ids}), MaterialIdArray="id", MeshVoid=1)
    errors = write(result.mesh, at("none.exo"))
    assert len(errors) == 1 and "No number is left for the void" in errors[0], errors


def vti(at, data, name="in.vti"):
    save_data(at(name), producer(data))
    return at(name)


@in_folder
def test_refused(at):
    """Invalid meshes and errors of the file system are reported, and no file is left."""
    mesh = mesh_of(fraction_image(8)).mesh
    copy = lambda: (lambda other: other.DeepCopy(mesh) or other)(vtkUnstructuredGrid())
    no_material, zero, mixed = copy(), copy(), copy()
    no_material.GetCellData().RemoveArray("MaterialId")
    array(zero.GetPointData(), "GlobalPointIds")[:] -= 100
    cells = mixed.GetCellTypesArray()
    cells.SetValue(0, 10)
    os.mkdir(at("folder.exo"))
    os.symlink("/dev/full", at("full.exo"))
    for data, name, text in (
            (no_material, "a.exo", "no array MaterialId"), (zero, "b.exo", "must be 1 or more"),
            (mixed, "c.exo", "all hexahedra or all tetrahedra"),
            (vtkUnstructuredGrid(), "d.exo", "The mesh is empty"),
            (mesh, "no/e.exo", "No such file or directory"), (mesh, "folder.exo", "Is a directory"),
            (mesh, "full.exo", "No space left on device")):
        errors = write(data, at(name))
        assert len(errors) == 1 and text in errors[0], (name, errors)
    assert set(os.listdir(at(""))) <= {"folder.exo", "full.exo"}, os.listdir(at(""))


@in_folder
def test_file_that_was_begun_is_removed(at):
    """A file that exceeds the size limit is removed; the earlier one stays."""
    mesh = mesh_of(fraction_image()).mesh
    write(mesh, at("mesh.exo"))
    size = os.path.getsize(at("mesh.exo"))
    with open(at("mesh.exo"), "w", encoding="ascii") as file:
        file.write("earlier")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    for part in (0.1, 0.5, 0.99):
        resource.setrlimit(resource.RLIMIT_FSIZE, (int(part * size), limits[1]))
        errors = write(mesh, at("mesh.exo"))
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        assert len(errors) == 1 and "File too large" in errors[0], errors
        assert os.listdir(at("")) == ["mesh.exo"]
        with open(at("mesh.exo"), encoding="ascii") as file:
            assert file.read() == "earlier"


def without_date(path):
    """Returns the bytes of a file with date and time of the QA record blanked."""
    with open(path, "rb") as file:
        content = file.read()
    for text in Dump(path).get("qa_records")[2:]:
        assert content.count(text.encode()) == 1
        content = content.replace(text.encode(), b"-" * len(text))
    return content


def check_ranks(at, path, mesh, *arguments):
    """Checks that files of sculptor on 1 to 3 ranks hold the mesh, in parts and as one file."""
    wanted = expected(mesh)
    x_min = sum(len(items) for key, items in wanted["sides"].items() if key[1] == "x_min")
    for ranks in (1, 2, 3):
        output = at("mesh%d.exo" % ranks)
        result = mpi_run(ranks, [SCULPTOR, "--input", path, "--output", output, *arguments])
        assert result.returncode == 0 and result.stderr == "", result
        names = [output] if ranks == 1 else ["%s.%d.%d" % (output, ranks, rank)
                                             for rank in range(ranks)]
        dumps = [Dump(name) for name in names]
        check(dumps, mesh, wanted)
        if ranks > 1:
            check_parts(dumps)
            single = at("single%d.exo" % ranks)
            result = mpi_run(ranks,
                             [SCULPTOR, "--input", path, "--output", single, "--single-file",
                              *arguments])
            assert result.returncode == 0 and without_date(single) == without_date(
                at("mesh1.exo")), result
            parts = ioss(names[-1])  # Any part gives access to all.
            # Cells of type 1 belong to the node set.
            assert sum(part.GetNumberOfCells() for part in parts["x_min"]
                       if part.GetCellType(0) != 1) == x_min


@in_folder
def test_ranks(at):
    """Files of sculptor on 1, 2 and 3 ranks hold the mesh."""
    path = vti(at, fraction_image())
    check_ranks(at, path, mesh_of(fraction_image()).mesh)
    check_ranks(at, path, mesh_of(fraction_image(), **CELLS, MeshVoid=1).mesh, "--tetmesh", "Cells",
                "--void")


@in_folder
def test_spyplot(at):
    """SpyPlot files become Exodus files with time and state."""
    ball, plate = ball_and_plate()
    step = {"Pressure": 1e5 * ball, SPY % 1: ball, SPY % 2: np.minimum(plate, 1 - ball)}
    step = {name: value.astype(np.float32) for name, value in step.items()}
    nodes = [x + h * np.arange(13) for x, h in zip(ORIGIN, SPACING)]
    path = write_spyplot(at(""), "case", [2e-6], split(nodes, [step], (2, 1, 2)), 2)
    for properties, arguments in (({}, []), (CELLS, ["--tetmesh", "Cells"])):
        mesh = mesh_of(image(step), VolumeFractionArrays=[SPY % 1, SPY % 2],
                       StateArrays=["Pressure"], **properties).mesh
        check_ranks(at, path, mesh, "--state", "Pressure", *arguments)
        assert Dump(at("mesh1.exo")).get("time_whole").tolist() == [2e-6]
        assert sorted(join([Dump(at("mesh1.exo"))])["blocks"].values()) == [SPY % 1, SPY % 2]


def turned_box(n=16):
    """Returns a rotated box in a matrix, not aligned with the grid: both have smooth sides."""
    source = VolumeFractionShapes(
        Shapes="box size=0.95,1.05,1 rotation=25,20,15 center=0.02,0,0.03 material=1; "
               "box size=2,2,2 material=2",
        Bounds=[-1, 1] * 3, Dimensions=[n] * 3)
    return servermanager.Fetch(source)


@in_folder
def test_smooth_sides(at):
    """Each smooth side is a side set of each material and a node set, also in files of ranks."""
    data = turned_box()
    for kind, properties in (("", {}),
                             ("Lattice", {"make": VolumeFractionToTet, "Method": "Lattice"})):
        arguments = {"VolumeFractionArrays": ["Material1", "Material2"], "SharpEdges": "On"}
        result = mesh_of(data, **arguments, **properties)
        path = at("sides.exo")
        assert not write(result.mesh, path)
        check_areas(path, result)
        whole = join([Dump(path)])
        sides = [key for key in whole["sides"] if key[1].startswith("Material1_to_Material2_")]
        assert len(sides) == 6 and all(key[0] == 1002000 + int(key[1].rsplit("_", 1)[1])
                                       for key in sides), sides
        for key in sides:
            nodes = {node for _, corners in whole["sides"][key] for node in corners}
            assert whole["node sets"][key] == nodes and len(nodes) > 30, key
        output = at("parts%s.exo" % kind)
        run = mpi_run(3,
                      [SCULPTOR, "--input", vti(at, data), "--fractions", "Material1,Material2",
                       "--sharp-edges", "On", "--output", output,
                          *(["--tetmesh", kind] if kind else [])])
        assert run.returncode == 0, run
        dumps = [Dump("%s.3.%d" % (output, rank)) for rank in range(3)]
        parts = join(dumps)
        assert parts["sides"] == whole["sides"] and parts["node sets"] == whole["node sets"]
        check_parts(dumps)


@in_folder
def test_ranks_without_elements(at):
    """With more ranks than cells, all parts have the same names and arrays."""
    data = image({"id": np.array([[[1, 2], [2, 0]]], np.int32)})
    path, mesh = vti(at, data), mesh_of(data, MaterialIdArray="id").mesh
    result = mpi_run(12, [SCULPTOR, "--input", path, "--labels", "id", "--output", at("mesh.exo")])
    assert result.returncode == 0, result
    assert all("warning: Label 0" in line for line in result.stderr.splitlines()), result
    dumps = [Dump(at("mesh.exo.12.%02d" % rank)) for rank in range(12)]
    assert min(dump.size("num_elem") for dump in dumps) == 0
    found, wanted = join(dumps), expected(mesh)
    assert all(found[part] == items for part, items in wanted.items()), (found, wanted)
    check_parts(dumps)
    for dump in dumps:
        for kind in ("eb", "ss", "ns"):
            assert dump.names(kind) == dumps[0].names(kind)
        assert dump.get("name_elem_var") == dumps[0].get(
            "name_elem_var") and dump.globals() == dumps[0].globals()
    # IOSS converts names to lower case and spaces to underscores.
    blocks = ioss(at("mesh.exo.12.03"))
    names = [name.lower().replace(" ", "_") for name in wanted["blocks"].values()]
    assert sum(part.GetNumberOfCells() for name in names
               for part in blocks[name]) == len(wanted["elements"]), blocks


@in_folder
def test_ranks_fail_alike(at):
    """If one part cannot be written, all ranks report it and remove their parts."""
    path = vti(at, fraction_image(8))
    os.symlink("/dev/full", at("full.exo.3.1"))
    result = mpi_run(3, [SCULPTOR, "--input", path, "--output", at("full.exo")])
    assert result.returncode == 4 and result.stderr.count("sculptor:") == 1, result
    assert "full.exo.3.1: No space left on device" in result.stderr, result
    assert set(os.listdir(at(""))) <= {"full.exo.3.1", "in.vti"}, os.listdir(at(""))


main(globals())
