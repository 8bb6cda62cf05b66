"""Arrays of all outputs, for hexahedra and each tetrahedral method.

Names, types, ids, quality, tables and closed surfaces are checked.
"""
import os
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkAbstractArray
from vtkmodules.vtkFiltersVerdict import vtkMeshQuality

from compare_meshes import read_pieces
from vfmtest import (
    SPACING, TET_METHODS, ball_and_plate, check_surfaces, elements, facets, fraction_image, image,
    main, mesh_of, save_data, table_of, VolumeFractionToTet, simple)

N = 12
DATA = fraction_image(N)
MESHES = [mesh_of(DATA)] + [mesh_of(DATA, VolumeFractionToTet, Method=method)
                            for method in TET_METHODS]
WITH_VOID = [mesh_of(DATA, MeshVoid=1)] + [
    mesh_of(DATA, VolumeFractionToTet, Method=method, MeshVoid=1) for method in TET_METHODS]


def describe(attributes):
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {a.GetName(): (a.GetDataTypeAsString(), a.GetNumberOfComponents()) for a in arrays}


def surface_array(result, name):
    return vtk_to_numpy(result.surfaces.GetCellData().GetArray(name))


def facet_corners(result):
    return vtk_to_numpy(result.surfaces.GetPoints().GetData())[facets(result)]


def area_vectors(corners):
    """Returns the area vectors of quadrilaterals or triangles, along their normals."""
    return np.cross(corners[:, 2] - corners[:, 0], corners[:, -1] - corners[:, 1]) / 2


def cone_volumes(corners):
    """Returns the volumes of the cones from the origin to each facet.

    A quadrilateral is bilinear: the mean of its two cuts into triangles.
    """
    cone = lambda *abc: np.einsum("ij,ij->i", corners[:, abc[0]],
                                  np.cross(corners[:, abc[1]], corners[:, abc[2]])) / 6
    if corners.shape[1] == 3:
        return cone(0, 1, 2)
    return (cone(0, 1, 2) + cone(0, 2, 3) + cone(1, 2, 3) + cone(1, 3, 0)) / 2


def test_kinds_of_cells():
    for result, kind in zip(MESHES, [12] + [10] * len(TET_METHODS)):
        assert set(vtk_to_numpy(result.mesh.GetCellTypesArray())) == {kind}
        assert facets(result).shape[1] == (4 if kind == 12 else 3)


def test_arrays_of_the_mesh():
    for result in MESHES:
        assert describe(result.mesh.GetCellData()) == {
            "MaterialId": ("int", 1), "FragmentId": ("int", 1), "GlobalCellIds": ("idtype", 1),
            "ScaledJacobian": ("float", 1)}
        assert describe(result.mesh.GetPointData()) == {
            "GlobalPointIds": ("idtype", 1), "GeometryDimension": ("int", 1),
            "GeometryId": ("int", 1)}
        assert result.mesh.GetCellData().GetGlobalIds().GetName() == "GlobalCellIds"
        assert result.mesh.GetPointData().GetGlobalIds().GetName() == "GlobalPointIds"
        assert len(np.unique(elements(result))) == result.mesh.GetNumberOfPoints()


def test_arrays_of_the_surfaces():
    for result in MESHES:
        assert describe(result.surfaces.GetCellData()) == {
            "SurfaceId": ("int", 1), "MaterialPair": ("int", 2), "DomainSide": ("int", 1)}
        assert result.surfaces.GetPointData().GetGlobalIds().GetName() == "GlobalPointIds"
        assert result.surfaces.GetNumberOfPoints() == len(np.unique(facets(result)))


def test_table_of_materials():
    assert list(table_of(MESHES[0].materials)) == [
        "Name", "MaterialId", "TargetVolume", "MeshVolume", "VolumeError", "LostCells",
        "GainedCells", "Elements", "Fragments", "MinimumScaledJacobian", "MeanScaledJacobian"]
    for result in MESHES + WITH_VOID:
        table = table_of(result.materials)
        for name in ("TargetVolume", "MeshVolume", "VolumeError", "LostCells", "GainedCells"):
            assert table[name] == result.field(name)
        assert sum(table["LostCells"]) <= result.field("FlippedCells")[0]
        assert table["Name"] == result.field("MaterialNames") and table[
            "MaterialId"] == result.field("MaterialIds")
        quality = result.cells("ScaledJacobian").astype(float)
        for row, material in enumerate(table["MaterialId"]):
            own = result.cells("MaterialId") == material
            assert table["Elements"][row] == own.sum() and table["Fragments"][row] == len(
                np.unique(result.cells("FragmentId")[own]))
            assert table["MinimumScaledJacobian"][row] == quality[own].min()
            assert np.isclose(table["MeanScaledJacobian"][row], quality[own].mean(), rtol=1e-9)
        assert sum(table["Elements"]) == result.mesh.GetNumberOfCells() and sum(
            table["Fragments"]) == result.field("NumberOfFragments")[0]
    bare = table_of(mesh_of(DATA, ComputeQuality=0).materials)
    assert list(bare) == list(table_of(MESHES[0].materials))[:-2] and bare["Elements"] == table_of(
        MESHES[0].materials)["Elements"]


def test_material_without_an_element():
    ball, plate = ball_and_plate(N)
    table = table_of(mesh_of(image({"ball": ball, "plate": plate,
                                    "dust": 0.01 * (ball == 0) * (plate == 0)}),
                             VolumeFractionArrays=["ball", "dust", "plate"]).materials)
    assert table["Elements"][1] == table["Fragments"][1] == table["MinimumScaledJacobian"][
        1] == table["MeanScaledJacobian"][1] == 0
    assert table["TargetVolume"][1] > 0 and table["VolumeError"][1] == -1 and min(
        table["Elements"][::2]) > 0


def test_field_data_are_not_offered_as_colours():
    """Field data carry the key GUI_HIDE, so that ParaView does not list them as colours.

    Scripts, files and downstream filters still have the arrays and the key.
    """
    mesh = simple.TrivialProducer()
    mesh.GetClientSideObject().SetOutput(MESHES[-1].mesh)
    clip = simple.Clip(Input=mesh)
    clip.UpdatePipeline()
    with tempfile.TemporaryDirectory() as folder:
        save_data(os.path.join(folder, "mesh.vtu"), mesh)
        read = read_pieces(os.path.join(folder, "mesh.vtu"))[0]
    for data in (MESHES[-1].mesh, MESHES[-1].surfaces, MESHES[-1].curves,
                 clip.GetClientSideObject().GetOutputDataObject(0), read):
        field = data.GetFieldData()
        arrays = [field.GetAbstractArray(a) for a in range(field.GetNumberOfArrays())]
        assert arrays and all(array.HasInformation()
                              and array.GetInformation().Has(vtkAbstractArray.GUI_HIDE())
                              for array in arrays)


def column(data, name):
    return vtk_to_numpy(data.GetFieldData().GetArray(name))


def point_ids(data, cells, corners):
    """Returns the global ids of the points of cells."""
    ids = vtk_to_numpy(data.GetPointData().GetGlobalIds())
    return ids[vtk_to_numpy(cells.GetConnectivityArray())].reshape(-1, corners)


def curve_edges(result):
    """Returns {ids of the points of an edge: surfaces} for the edges on several surfaces."""
    ids = vtk_to_numpy(result.surfaces.GetPointData().GetGlobalIds())[facets(result)]
    edges = {}
    for facet, surface in zip(ids.tolist(), surface_array(result, "SurfaceId").tolist()):
        for edge in zip(facet, facet[1:] + facet[:1]):
            edges.setdefault(tuple(sorted(edge)), set()).add(surface)
    return {edge: surfaces for edge, surfaces in edges.items() if len(surfaces) > 1}


def test_points_of_the_geometry_are_those_of_the_mesh():
    for result in MESHES + WITH_VOID:
        places = dict(zip(result.points("GlobalPointIds").tolist(),
                          vtk_to_numpy(result.mesh.GetPoints().GetData()).tolist()))
        for data in (result.surfaces, result.curves, result.vertices):
            ids = vtk_to_numpy(data.GetPointData().GetGlobalIds()).tolist()
            assert len(set(ids)) == len(ids) > 0
            assert [places[i] for i in ids] == vtk_to_numpy(data.GetPoints().GetData()).tolist()


def test_curves():
    for result in MESHES + WITH_VOID:
        assert describe(result.curves.GetCellData()) == {"CurveId": ("int", 1)}
        assert describe(result.curves.GetFieldData()) == {"CurveEnds": ("int", 1),
                                                          "SurfaceCurves": ("int", 2)}
        curve = vtk_to_numpy(result.curves.GetCellData().GetArray("CurveId"))
        assert (np.diff(curve) >= 0).all() and curve[0] == 1 and result.field("NumberOfCurves") == [
            curve[-1]]
        edges, surfaces = curve_edges(result), {}
        for c, s in column(result.curves, "SurfaceCurves")[:, ::-1].tolist():
            surfaces.setdefault(c, set()).add(s)
        lines = point_ids(result.curves, result.curves.GetLines(), 2)
        assert (lines[:, 0] < lines[:, 1]).all() and len(lines) == len(edges)
        assert {tuple(line): surfaces[c]
                for line, c in zip(lines.tolist(), curve.tolist())} == edges


def test_vertices():
    for result in MESHES + WITH_VOID:
        assert describe(result.vertices.GetCellData()) == {"VertexId": ("int", 1)}
        assert describe(result.vertices.GetFieldData()) == {"CurveVertices": ("int", 2)}
        vertex = vtk_to_numpy(result.vertices.GetCellData().GetArray("VertexId"))
        assert vertex.tolist() == list(range(1, result.field("NumberOfVertices")[0] + 1))
        ids = point_ids(result.vertices, result.vertices.GetVerts(), 1)[:, 0]
        expected = result.points("GlobalPointIds")[result.points("GeometryDimension") == 0]
        assert sorted(ids) == sorted(expected)
        number = dict(zip(ids.tolist(), vertex.tolist()))
        curve = vtk_to_numpy(result.curves.GetCellData().GetArray("CurveId"))
        lines = point_ids(result.curves, result.curves.GetLines(), 2)
        ends = [(c, number[p]) for line, c in zip(lines.tolist(), curve.tolist()) for p in line
                if p in number]
        assert sorted(set(ends)) == list(map(tuple,
                                             column(result.vertices, "CurveVertices").tolist()))
        assert column(result.curves,
                      "CurveEnds").tolist() == np.bincount([c for c, _ in ends],
                                                           minlength=curve[-1] + 1)[1:].tolist()


def test_what_surfaces_bound():
    """Tables of surfaces, volumes, materials and sides agree with the facets."""
    for result in MESHES + WITH_VOID:
        volumes, pairs, sides, bounds = (column(result.surfaces, name) for name in (
            "SurfaceVolumes", "SurfaceMaterials", "SurfaceSides", "VolumeSurfaces"))
        surface = surface_array(result, "SurfaceId") - 1
        assert np.array_equal(pairs[surface], surface_array(result, "MaterialPair"))
        assert np.array_equal(sides[surface], surface_array(result, "DomainSide"))
        assert bounds.tolist() == sorted([v, s + 1] for s, both in enumerate(volumes.tolist())
                                         for v in both if v > 0)
        fragment_materials = dict(zip(result.cells("FragmentId").tolist(),
                                      result.cells("MaterialId").tolist()))
        assert all(v == 0 or fragment_materials[v] == m
                   for v, m in zip(volumes.ravel().tolist(), pairs.ravel().tolist()))


def test_field_data():
    for result in MESHES:
        assert result.field("MaterialNames") == ["ball", "plate"]
        assert result.field("MaterialIds") == [1, 2]
        for name in ("TargetVolume", "MeshVolume"):
            for value, fractions in zip(result.field(name), ball_and_plate(N)):
                expected = fractions.sum() * np.prod(SPACING)
                assert abs(value - expected) < (1e-9 if name == "TargetVolume" else 2e-3) * expected
        assert result.field("NormalisedCells") == [0]
        for name in ("FlippedCells", "ResolveRounds", "NarrowVoidCells", "NumberOfCurves",
                     "NumberOfVertices"):
            assert result.field(name)[0] >= 0
        assert result.field("NumberOfFragments") == [len(set(result.cells("FragmentId")))]
        surface_ids = surface_array(result, "SurfaceId")
        assert result.field("NumberOfSurfaces") == [surface_ids.max()] == [len(set(surface_ids))]
        quality = result.cells("ScaledJacobian")
        assert abs(result.field("MinimumScaledJacobian")[0] - quality.min()) < 1e-6
        assert abs(result.field("MeanScaledJacobian")[0] - quality.mean()) < 1e-5


def test_volume_errors():
    for result in MESHES + WITH_VOID:
        target, volume = (np.array(result.field(name)) for name in ("TargetVolume", "MeshVolume"))
        assert np.allclose(result.field("VolumeError"), volume / target - 1, rtol=0, atol=1e-15)
        assert not result.warnings


def test_materials_without_elements_are_named():
    wall, names = np.ones((8, 8, 8)), ["wall", "trace", "none", "dust"]
    wall[4] = 0.7
    data = image({"wall": wall, "trace": (1 - wall) * 0.6, "none": 0 * wall,
                  "dust": (1 - wall) * 0.4})
    for kind in ({}, {"make": VolumeFractionToTet, "Method": "Lattice"}):
        result = mesh_of(data, VolumeFractionArrays=names, **kind)
        assert result.field("VolumeError")[1:] == [-1, 0, -1]
        named = [text for text in result.warnings if "have no element" in text]
        assert len(named) == 1 and "2 materials" in named[0], result.warnings
        assert "'trace' (id 2), 'dust' (id 4)" in named[0], result.warnings


def test_ids_are_positive_and_unique():
    for result in MESHES:
        for ids in (result.cells("GlobalCellIds"), result.points("GlobalPointIds")):
            assert ids.min() >= 1 and len(np.unique(ids)) == len(ids)
        assert set(result.cells("FragmentId")) == set(range(1,
                                                            result.cells("FragmentId").max() + 1))


def test_scaled_jacobian_is_verdicts():
    for result in MESHES + WITH_VOID:
        quality = vtkMeshQuality()
        quality.SetInputData(result.mesh)
        quality.SetHexQualityMeasureToScaledJacobian()
        quality.SetTetQualityMeasureToScaledJacobian()
        quality.Update()
        expected = vtk_to_numpy(quality.GetOutput().GetCellData().GetArray("Quality"))
        assert np.abs(result.cells("ScaledJacobian") - expected).max() < 1e-6
        assert expected.min() > 0


def test_surfaces_are_the_faces_between_materials():
    for result in MESHES + WITH_VOID:
        check_surfaces(result)


def test_domain_sides():
    for result in WITH_VOID:
        corners, side = facet_corners(result), surface_array(result, "DomainSide")
        bounds = result.mesh.GetBounds()
        for s in range(6):
            on_side = np.all(np.abs(corners[:, :, s // 2] - bounds[s]) < 1e-9, axis=1)
            assert np.array_equal(on_side, side == s)
            area = np.linalg.norm(area_vectors(corners[on_side]), axis=1).sum()
            length = [bounds[2 * a + 1] - bounds[2 * a] for a in range(3) if a != s // 2]
            assert abs(area - length[0] * length[1]) < 1e-9


def test_normals_point_from_the_second_material_to_the_first():
    """Facets of a surface have consistent normals and enclose the volume of each material."""
    for result in MESHES:
        corners, pairs = facet_corners(result), surface_array(result, "MaterialPair")
        for material, volume in zip(result.field("MaterialIds"), result.field("MeshVolume")):
            outward = (pairs[:, 1] == material).astype(int) - (pairs[:, 0] == material)
            assert abs((outward * cone_volumes(corners)).sum() - volume) < 1e-9 * volume
        edges = np.stack([facets(result), np.roll(facets(result), -1, axis=1)],
                         axis=2).reshape(-1, 2)
        surface = np.repeat(surface_array(result, "SurfaceId"), corners.shape[1])
        directed = np.column_stack([surface, edges])
        assert len(np.unique(directed, axis=0)) == len(directed)


def test_geometry_of_the_nodes():
    for result in MESHES:
        dimension = result.points("GeometryDimension")
        assert set(dimension) <= {0, 1, 2, 3} and result.points("GeometryId").min() >= 1
        on_surface = np.isin(result.points("GlobalPointIds"),
                             vtk_to_numpy(result.surfaces.GetPointData().GetGlobalIds()))
        assert np.array_equal(on_surface, dimension < 3)
        volume = dimension == 3
        fragment = np.zeros(len(dimension), int)
        fragment[elements(result).T] = result.cells("FragmentId")
        assert np.array_equal(result.points("GeometryId")[volume], fragment[volume])


main(globals())
