"""Tetrahedra: properties of the filter, angles, volumes, and input that cannot be meshed.

TestOutputs.py has the tests that are common to both filters.
"""
import functools

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from vfmtest import (
    ORIGIN, SPACING, TET_METHODS, ball_and_plate, check_error, digest, elements, face_owners,
    facets, fraction_image, image, labels, list_defaults, main, mesh_of, OF_PANEL, producer, run,
    tet_volumes, VolumeFractionToTet)

N = 12
DATA = fraction_image(N)
HAS_TETGEN = "TetGen" in TET_METHODS
OUT_OF_RANGE = {
    "RelativeSize": (0.0, -1.0), "Growth": (-0.1,), "RadiusEdgeRatio": (0.9,),
    "MinimumDihedralAngle": (-1.0, 61.0), "OptimizationLevel": (-1, 11)}
FACE_PAIRS = [(a, b) for a in range(4) for b in range(a)]  # the faces at each of the six edges


def tets_of(data, **properties):
    return mesh_of(data, VolumeFractionToTet, **properties)


MESHES = {method: tets_of(DATA, Method=method) for method in TET_METHODS}


def dihedral_angles(result):
    """Returns the dihedral angles in degrees, six per tetrahedron."""
    p = vtk_to_numpy(result.mesh.GetPoints().GetData())[elements(result)]
    # face opposite to each corner, normals outward
    faces = [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)]
    normals = [np.cross(p[:, b] - p[:, a], p[:, c] - p[:, a]) for a, b, c in faces]
    normals = [normal / np.linalg.norm(normal, axis=1)[:, None] for normal in normals]
    cosines = [-np.einsum("ij,ij->i", normals[a], normals[b]) for a, b in FACE_PAIRS]
    return np.degrees(np.arccos(np.clip(cosines, -1, 1)))


def check_mesh(result):
    """Checks volumes and faces.

    Volumes are positive and sum to the volumes of the materials. A face has at most two tetrahedra.
    """
    volume = tet_volumes(vtk_to_numpy(result.mesh.GetPoints().GetData()), elements(result))
    material = result.cells("MaterialId")
    assert volume.min() > 0
    for label, expected in zip(result.field("MaterialIds"), result.field("MeshVolume")):
        assert abs(volume[material == label].sum() - expected) < 1e-9 * expected
    face_owners(elements(result), material)


def test_names_and_defaults():
    tets = VolumeFractionToTet(Input=producer(fraction_image(4)))
    defaults = list_defaults(of_tets=True)
    assert set(tets.ListProperties()) == {"HasTetGen"} | OF_PANEL | set(defaults)
    for name, value in defaults.items():
        assert getattr(tets, name) == value, (name, getattr(tets, name))


def test_default_method():
    assert digest(tets_of(DATA)) == digest(MESHES["Lattice"])


def test_interfaces_across_levels():
    """FineInterfaces off makes coarser cells at interfaces, but not for TetGen."""
    for method in TET_METHODS:
        fine, asked = (tets_of(DATA, FineInterfaces=on, Method=method, Refinement="Coarsen")
                       for on in (1, 0))
        assert max(fine.field("RefinedCells")) > 0
        assert (digest(fine) == digest(asked)) == (method == "TetGen"), method
        assert len(elements(asked)) <= len(elements(fine)), method
        check_mesh(asked)


def test_every_method():
    assert len({digest(result) for result in MESHES.values()}) == len(TET_METHODS)
    for method, result in MESHES.items():
        check_mesh(result)
        assert result.field("RefusedParts") == [0], method
        assert not result.warnings


def test_dihedral_angles():
    for method, result in MESHES.items():
        angles = dihedral_angles(result)
        assert abs(result.field("MinimumDihedralAngle")[0] - angles.min()) < 1e-6
        assert abs(result.field("MaximumDihedralAngle")[0] - angles.max()) < 1e-6
        counts = result.field("DihedralAngles")
        assert len(counts) == 18 and sum(counts) == angles.size
        expected, _ = np.histogram(angles, np.arange(0, 181, 10))
        # Right angles lie on the limit of two intervals.
        assert np.abs(np.cumsum(counts) - np.cumsum(expected)).max() <= 0.02 * angles.size
        # The cells measure 1 x 1 x 2.
        assert angles.min() > {"TetGen": 10, "Cells": 15,
                               "Lattice": 20}[method], (method, angles.min())


def test_without_quality():
    result = tets_of(DATA, Method="Cells", ComputeQuality=0)
    assert not result.mesh.GetCellData().HasArray("ScaledJacobian")
    field = result.mesh.GetFieldData()
    for name in ("MinimumScaledJacobian", "MinimumDihedralAngle", "MaximumDihedralAngle",
                 "DihedralAngles"):
        assert not field.HasArray(name), name
    assert field.HasArray("RefusedParts")


def test_hexahedra_have_no_angles():
    field = mesh_of(DATA).mesh.GetFieldData()
    for name in ("MinimumDihedralAngle", "MaximumDihedralAngle", "DihedralAngles", "RefusedParts"):
        assert not field.HasArray(name), name


def test_cells_has_the_faces_of_the_hexahedra():
    """Cells cuts each quadrilateral inside the domain into two triangles."""
    inside = lambda result: (
        vtk_to_numpy(result.surfaces.GetCellData().GetArray("DomainSide")) < 0).sum()
    assert inside(MESHES["Cells"]) == 2 * inside(mesh_of(DATA))


def test_stair_step():
    cells = labels(N)
    volume = (cells > 0).sum() * np.prod(SPACING)
    for method in TET_METHODS:
        result = tets_of(image({"id": cells}), MaterialIdArray="id", Method=method, StairStep=1)
        check_mesh(result)
        if method != "Lattice":  # surfaces of Lattice lie between the cells
            assert abs(sum(result.field("MeshVolume")) - volume) < 1e-9 * volume


def test_mesh_void():
    whole = N ** 3 * np.prod(SPACING)
    for method in TET_METHODS:
        result = tets_of(DATA, Method=method, MeshVoid=1)
        check_mesh(result)
        assert set(result.cells("MaterialId")) == {0, 1, 2}
        assert result.field("MaterialNames") == ["Void", "ball", "plate"]
        assert abs(sum(result.field("MeshVolume")) - whole) < 1e-9 * whole


def test_smoothing():
    for method in TET_METHODS:
        off, facet_based = (tets_of(DATA, Method=method, Smoothing=kind)
                            for kind in ("Off", "Geometry Based"))
        assert len({digest(result) for result in (off, facet_based, MESHES[method])}) == 3
        for result in (off, facet_based):
            check_mesh(result)


def test_target_scaled_jacobian_is_a_sine():
    """A lower target than the automatic one, which is above 0.5, gives smaller angles."""
    for method in ("Cells", "Lattice"):
        low = tets_of(DATA, Method=method, TargetScaledJacobian=0.25)
        assert low.field("MinimumDihedralAngle")[0] < MESHES[method].field("MinimumDihedralAngle")[
            0]


def test_conserve_volume():
    for method in ("Cells", "Lattice"):
        free = tets_of(DATA, Method=method, ConserveVolume=0)
        errors = [max(abs(mesh / target - 1)
                      for mesh, target in zip(result.field("MeshVolume"),
                                              result.field("TargetVolume")))
                  for result in (MESHES[method], free)]
        assert errors[0] < 1e-3 < errors[1] < 0.1, errors


def test_properties_of_tetgen():
    if not HAS_TETGEN:
        return
    count = lambda **properties: tets_of(DATA, Method="TetGen",
                                         **properties).mesh.GetNumberOfCells()
    usual = MESHES["TetGen"].mesh.GetNumberOfCells()
    assert count(Growth=0.0) > usual
    assert count(RelativeSize=0.6) > usual > count(RelativeSize=2.0)
    assert count(RadiusEdgeRatio=1.1) > usual
    assert count(MinimumDihedralAngle=0.0) <= usual < count(MinimumDihedralAngle=18.0)
    assert digest(tets_of(DATA, Method="TetGen", OptimizationLevel=0)) != digest(MESHES["TetGen"])


def test_tetgen_keeps_the_surfaces_of_cells():
    if HAS_TETGEN:
        cells, tetgen = MESHES["Cells"], MESHES["TetGen"]
        assert facets(cells).shape == facets(tetgen).shape
        points = [vtk_to_numpy(result.surfaces.GetPoints().GetData()) for result in (cells, tetgen)]
        assert np.array_equal(*[np.unique(p, axis=0) for p in points])


check_tet_error = functools.partial(check_error, make=VolumeFractionToTet)


def test_options_out_of_range():
    check_tet_error(DATA, "IsoValue", IsoValue=0.0)
    check_tet_error(DATA, "TargetScaledJacobian", TargetScaledJacobian=1.0)
    for name, values in OUT_OF_RANGE.items():
        for value in values:
            check_tet_error(DATA, name, Method="Cells", **{name: value})


def test_tetgen_that_was_not_built_in():
    if not HAS_TETGEN:
        check_tet_error(DATA, "no TetGen", "Lattice", Method="TetGen")


def test_input_that_cannot_be_meshed():
    check_tet_error(DATA, "No array is chosen", VolumeFractionArrays=[])
    ball, plate = ball_and_plate(N)
    ball[3, 4, 5] = np.nan
    check_tet_error(image({"ball": ball, "plate": plate}), "'ball' holds nan")


def test_empty_field_is_no_error():
    nothing = image({name: np.zeros((N, N, N)) for name in ("ball", "plate")})
    for method in TET_METHODS:
        result = run(nothing, VolumeFractionToTet, Method=method)
        assert not result.errors and result.mesh.GetNumberOfCells() == 0
        assert len(result.warnings) == 1 and "The mesh is empty" in result.warnings[0]


def test_planes_on_round_numbers():
    """Layers that meet at 0.3 of a cell are flat within 0.06 of a cell.

    Lattice nodes then have the smallest distance allowed
    from a surface that does not pass through them.
    """
    n = 8
    for height in (4.3, 4.7):
        low = np.broadcast_to(np.clip(height - np.arange(n), 0, 1)[:, None, None], (n, n, n)).copy()
        result = mesh_of(image({"low": low, "high": 1 - low}), make=VolumeFractionToTet,
                         Method="Lattice", VolumeFractionArrays=["low", "high"])
        between = vtk_to_numpy(result.surfaces.GetCellData().GetArray("DomainSide")) < 0
        z = vtk_to_numpy(result.surfaces.GetPoints().GetData())[
            np.unique(facets(result)[between]), 2]
        off = np.abs((z - ORIGIN[2]) / SPACING[2] - height)
        assert off.max() < 0.06, off.max()


main(globals())
