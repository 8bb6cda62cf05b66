"""Split interfaces in the filters: nodes, cohesive elements, nodal state, files and geometry."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from exodus_dump import Dump
from vfmtest import (
    VolumeFractionToHex, VolumeFractionToTet, check_error, digest, image, in_folder, main, mesh_of,
    points_of, producer, save_data, simple)

N = 10
RANDOM = np.random.default_rng(5)
SEEDS = RANDOM.uniform(0, N, (8, 3))
CENTRES = np.stack(np.meshgrid(*[np.arange(N) + 0.5] * 3, indexing="ij"), -1)
LABELS = ((CENTRES[..., None, :] - SEEDS) ** 2).sum(-1).argmin(-1) + 1
INPUT = {"data": image({"id": LABELS}), "MaterialIdArray": "id"}
SPLIT = {"SplitInterfaces": "all", "SplitConnection": "Cohesive"}
CASES = [{"make": VolumeFractionToHex}, {"make": VolumeFractionToTet, "Method": "Lattice"}]
VTK_HEXAHEDRON, VTK_WEDGE = 12, 13


def ids_of(output):
    return vtk_to_numpy(output.GetPointData().GetArray("GlobalPointIds"))


def corners_of(grid):
    """Returns the global ids of the corners of each cell."""
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    return ids_of(grid)[cells].reshape(grid.GetNumberOfCells(), -1)


def test_cohesive_elements():
    for case in CASES:
        result = mesh_of(**INPUT, **SPLIT, **case)
        grid = result.cohesive
        is_hex = case["make"] is VolumeFractionToHex
        corners = corners_of(grid)
        assert len(corners) > 100
        assert grid.GetCellType(0) == (VTK_HEXAHEDRON if is_hex else VTK_WEDGE)
        first, second = np.split(corners, 2, axis=1)
        original = dict(zip(result.points("GlobalPointIds"), result.points("OriginalPointIds")))
        before = np.vectorize(original.get)
        assert np.array_equal(before(first), before(second)) and (first != second).all()
        materials = vtk_to_numpy(grid.GetCellData().GetArray("MaterialPair"))
        assert (materials[:, 0] < materials[:, 1]).all()
        ids = vtk_to_numpy(grid.GetCellData().GetArray("GlobalCellIds"))
        assert np.array_equal(ids, result.cells("GlobalCellIds").max() + 1 + np.arange(len(ids)))


def test_the_mesh_is_the_same_without_copies():
    for case in CASES:
        whole, split = mesh_of(**INPUT, **case), mesh_of(**INPUT, **SPLIT, **case)
        assert whole.mesh.GetNumberOfCells() == split.mesh.GetNumberOfCells()
        before = np.searchsorted(whole.points("GlobalPointIds"), split.points("OriginalPointIds"))
        assert np.array_equal(points_of(whole)[before], points_of(split))
        for name in ("GeometryDimension", "GeometryId"):
            assert np.array_equal(whole.points(name)[before], split.points(name))
        assert split.field("AddedNodes") == [len(before) - whole.mesh.GetNumberOfPoints()]
        for name in ("surfaces", "curves", "vertices"):
            one, other = getattr(whole, name), getattr(split, name)
            assert one.GetNumberOfCells() == other.GetNumberOfCells() > 0
            assert np.array_equal(np.sort(ids_of(one)), np.sort(ids_of(other)))
        off = mesh_of(**INPUT, SplitConnection="Cohesive", **case)
        assert digest(off) == digest(whole)
        assert off.mesh.GetPointData().GetArray("OriginalPointIds") is None


def test_nodal_velocity_follows():
    velocity = RANDOM.uniform(-1, 1, (N, N, N, 3))
    fractions = {"ball": (LABELS < 5) * 1.0, "rest": (LABELS >= 5) * 1.0,
                 "velocity": velocity, "density": np.ones((N, N, N))}
    properties = {"VolumeFractionArrays": ["ball", "rest"], "DensityArrays": ["density"],
                  "VelocityArray": "velocity", "NodalVelocity": 1, "StateTransfer": "Conserve"}
    whole = mesh_of(image(fractions), **properties)
    split = mesh_of(image(fractions), SplitInterfaces="ball/rest", **properties)
    before = np.searchsorted(whole.points("GlobalPointIds"), split.points("OriginalPointIds"))
    assert len(before) > whole.mesh.GetNumberOfPoints()
    assert np.array_equal(whole.points("velocity")[before], split.points("velocity"))


@in_folder
def test_files_of_a_mesh_read_back(at):
    """The cohesive elements are found again in a mesh that was read from a file."""
    for case in CASES:
        properties = {**INPUT, **SPLIT, **case}
        mesher = properties.pop("make")(Input=producer(properties.pop("data")), **properties)
        simple.SaveData(at("mesh.exo"), proxy=mesher)
        save_data(at("mesh.vtu"), mesher)
        simple.SaveData(at("again.exo"), proxy=simple.OpenDataFile(at("mesh.vtu")))
        one, other = Dump(at("mesh.exo")), Dump(at("again.exo"))
        assert one.names("eb") == other.names("eb") and len(one.names("eb")) > 16
        assert any(name.endswith("_cohesive") for name in one.names("eb"))
        for name in one.values:
            if name != "qa_records":
                assert np.array_equal(one.values[name], other.values[name]), name


def test_wrong_pairs():
    for text in ("1/9", "a/b", "1", "1/1"):
        check_error(INPUT["data"], "SplitInterfaces contains '%s'" % text, "Material 8 (8)",
                    MaterialIdArray="id", SplitInterfaces=text)


main(globals())
