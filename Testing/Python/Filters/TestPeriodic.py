"""Periodic meshes: pairs of points and sides, in the filters and in files."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from exodus_dump import Dump
from vfmtest import (
    ORIGIN, SPACING, VolumeFractionToHex, VolumeFractionToTet, at_points, check_error, digest,
    image, in_folder, main, mesh_of, points_of, producer, save_data, simple)

RANDOM = np.random.default_rng(7)
LABELS = RANDOM.integers(0, 3, (6, 7, 8))
INPUT = {"data": image({"id": LABELS}), "MaterialIdArray": "id", "Periodic": "XYZ"}
LENGTHS = np.array([8, 7, 6]) * SPACING
CASES = [{"make": VolumeFractionToHex, "PeriodicSides": "Flat"},
         {"make": VolumeFractionToHex, "PeriodicSides": "Free"},
         {"make": VolumeFractionToTet, "Method": "Lattice"},
         {"make": VolumeFractionToTet, "Method": "Cells"}]


def array(result, name):
    return vtk_to_numpy(result.mesh.GetPointData().GetArray(name))


def sizes_of_sets(path):
    """Returns the number of faces of each side set."""
    dump = Dump(path)
    return {name: len(dump.sides(i)[0]) for i, name in enumerate(dump.names("ss"))}


def test_pairs_are_exact_translates():
    for case in CASES:
        mesh = mesh_of(**INPUT, **case)
        ids, partners, points = array(mesh, "GlobalPointIds"), array(
            mesh, "PeriodicPartner"), points_of(mesh)
        lengths = mesh.field("PeriodLengths")
        assert np.allclose(lengths, LENGTHS)
        copies = np.flatnonzero(ids != partners)
        assert len(copies) > 40
        partners = np.searchsorted(ids, partners[copies])
        periods = np.rint((points[copies] - points[partners]) / lengths)
        assert np.abs(periods).sum(axis=1).min() > 0
        assert np.array_equal(points[copies], points[partners] + periods * lengths)


def test_flat_sides_are_plane():
    mesh = mesh_of(**INPUT, **CASES[0])
    bounds = mesh.field("DomainBounds")
    assert np.array_equal(mesh.mesh.GetBounds(), bounds)
    free = mesh_of(**INPUT, **CASES[1])
    assert free.mesh.GetBounds()[1] > bounds[1] + 0.01 * SPACING[0]


def test_refined_sides_are_plane():
    away = (np.indices((24, 24, 24)) + 0.5) / 24
    labels = np.where((np.minimum(away, 1 - away)**2).sum(0) < 0.1**2, 2, 1)
    for properties, parts in (CASES[0], 1), (CASES[2], 12), (CASES[3], 12):
        mesh = mesh_of(**{**INPUT, "data": image({"id": labels})}, **properties,
                       Refinement="Coarsen", MaximumLevel=1)
        assert np.array_equal(mesh.mesh.GetBounds(), mesh.field("DomainBounds"))
        assert 0 < mesh.mesh.GetNumberOfCells() < parts * 24**3


def test_joined_sides_have_no_copies():
    for make in VolumeFractionToHex, VolumeFractionToTet:
        mesh = mesh_of(**INPUT, make=make, PeriodicSides="Joined")
        assert mesh.mesh.GetPointData().GetArray("PeriodicPartner") is None
        assert len(np.unique(array(mesh, "GlobalPointIds"))) == mesh.mesh.GetNumberOfPoints()


def test_points_are_centres_of_cells():
    for case in CASES[:2]:
        points = {**INPUT, "data": at_points(INPUT["data"])}
        assert digest(mesh_of(**points, **case)) == digest(mesh_of(**INPUT, **case))


@in_folder
def test_files_have_sides(at):
    """A mesh read back has the same sides: opposite ones have equally many faces."""
    for case in CASES:
        properties = {**INPUT, **case, "MeshVoid": 1}
        mesher = properties.pop("make")(Input=producer(properties.pop("data")), **properties)
        simple.SaveData(at("mesh.exo"), proxy=mesher)
        save_data(at("mesh.vtu"), mesher)
        simple.SaveData(at("again.exo"), proxy=simple.OpenDataFile(at("mesh.vtu")))
        sizes = sizes_of_sets(at("mesh.exo"))
        assert sizes == sizes_of_sets(at("again.exo"))
        for axis in "xyz":
            assert sizes[axis + "_min"] == sizes[axis + "_max"] > 0


def test_errors():
    check_error(image({"id": np.ones((3, 3, 2), int)}), "at least 3 cells along x, not 2",
                MaterialIdArray="id", Periodic="X")
    check_error(INPUT["data"], "can only be Flat or Joined", make=VolumeFractionToTet,
                MaterialIdArray="id", Periodic="Z", PeriodicSides="Free")


main(globals())
