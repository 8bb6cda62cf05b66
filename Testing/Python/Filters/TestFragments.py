"""Table of fragments: volumes, centroids, bounds, masses and neighbours, checked by numpy."""
import csv
import os
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from mpi_run import mpi_run
from vfmtest import (
    ORIGIN, SPACING, TET_METHODS, VolumeFractionFragments, VolumeFractionToHex, VolumeFractionToTet,
    ball_and_plate, collect, elements,
    fraction_image, image, labels, main, mesh_of, producer, surface_faces, tet_volumes, simple)

SPLASH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data",
                      "splash_3500us.vti")
CORNERS = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1],
                    [1, 1, 1], [-1, 1, 1]])


def table_of(mesh, **properties):
    """Returns {column: values} of the fragments of a mesh, and the error messages."""
    table = VolumeFractionFragments(Input=producer(mesh), **properties)
    algorithm = table.GetClientSideObject()
    errors, _ = collect(algorithm)
    table.UpdatePipeline()
    output = algorithm.GetOutputDataObject(0)
    columns = [output.GetColumn(c) for c in range(output.GetNumberOfColumns())]
    return {column.GetName(): [column.GetValue(row) for row in range(output.GetNumberOfRows())]
            for column in columns}, errors


def moments(result):
    """Returns volume and first moment of each element, by three Gauss points per axis."""
    points, cells = vtk_to_numpy(result.mesh.GetPoints().GetData()), elements(result)
    if cells.shape[1] == 4:
        volumes = tet_volumes(points, cells)
        return volumes, volumes[:, None] * points[cells].mean(axis=1)
    volumes, firsts = np.zeros(len(cells)), np.zeros((len(cells), 3))
    places, weights = np.polynomial.legendre.leggauss(3)
    for (u, wu) in zip(places, weights):
        for (v, wv) in zip(places, weights):
            for (w, ww) in zip(places, weights):
                factors = 1 + CORNERS * (u, v, w)
                shape = factors.prod(axis=1) / 8
                slopes = np.stack([CORNERS[:, a] * factors[:, a - 2] * factors[:, a - 1] / 8
                                   for a in range(3)])
                determinant = np.linalg.det(np.einsum("ac,ecx->eax", slopes, points[cells]))
                volumes += wu * wv * ww * determinant
                firsts += (wu * wv * ww * determinant)[:,
                                                       None] * np.einsum(
                                                           "c,ecx->ex", shape, points[cells])
    return volumes, firsts


def neighbours(result):
    """Returns {fragment: fragments that share a face with it}."""
    found = {}
    for pair in set(surface_faces(result.points("GlobalPointIds")[elements(result)],
                                  result.cells("FragmentId")).values()):
        for one, other in (pair, pair[::-1]):
            if one > 0 and other > 0:
                found.setdefault(one, set()).add(other)
    return found


def check(result, table):
    fragments, points = result.cells("FragmentId"), vtk_to_numpy(result.mesh.GetPoints().GetData())
    volumes, firsts = moments(result)
    touching = neighbours(result)
    assert table["FragmentId"] == list(range(1, result.field("NumberOfFragments")[0] + 1))
    assert table["FractionVolume"] == result.field("FragmentTargetVolume")
    for f in table["FragmentId"]:
        row = {name: values[f - 1] for name, values in table.items()}
        own = fragments == f
        ids = sorted(set(result.cells("MaterialId")[own]))
        assert [row["MaterialId"]] == ids and row["Elements"] == own.sum()
        assert np.isclose(row["MeshVolume"], volumes[own].sum(), rtol=1e-9, atol=0)
        centroid = firsts[own].sum(axis=0) / volumes[own].sum()
        assert np.allclose([row["Centroid" + a] for a in "XYZ"], centroid, rtol=0,
                           atol=1e-8), (row, centroid)
        corners = points[np.unique(elements(result)[own])]
        assert [row["Min" + a] for a in "XYZ"] == corners.min(axis=0).tolist()
        assert [row["Max" + a] for a in "XYZ"] == corners.max(axis=0).tolist()
        assert [int(n) for n in row["Neighbours"].split()] == sorted(touching.get(f, ()))


def three_parts(n=12):
    """Returns labels of a ball on a plate, and of a small part away from both."""
    ids = labels(n)
    ids[-2:, :2, :2] = 1
    return ids


def test_hexes_and_tets():
    data = image({"id": three_parts()})
    for kind in [{}] + [{"make": VolumeFractionToTet, "Method": method} for method in TET_METHODS]:
        result = mesh_of(data, MaterialIdArray="id", **kind)
        table, errors = table_of(result.mesh)
        assert not errors and "Mass" not in table
        assert len(table["FragmentId"]) == 3 and sorted(table["Neighbours"]) == [
            "", "1", "2"], table["Neighbours"]
        assert set(table["Material"]) == {"Material 1", "Material 2"}
        check(result, table)


def test_fraction_volumes():
    """Both volumes of the fragments, of fractions and mesh, add up to the materials' volumes."""
    ball, plate = ball_and_plate(16)
    result = mesh_of(image({"ball": ball, "plate": plate}))
    table, _ = table_of(result.mesh)
    check(result, table)
    assert table["Material"] == ["plate", "ball"] or table["Material"] == ["ball", "plate"]
    for name, target in zip(["ball", "plate"], result.field("TargetVolume")):
        place = table["Material"].index(name)
        assert np.isclose(table["FractionVolume"][place], target, rtol=1e-9)
        assert np.isclose(table["MeshVolume"][place], target, rtol=1e-6)


def test_drops_of_a_splash():
    """Each drop, also one of a single cell, has the volume of its fractions.

    Thin parts join drops: five on the floor by the film there, three by threads.
    """
    reader = vtkXMLImageDataReader()
    reader.SetFileName(SPLASH)
    reader.Update()
    result = mesh_of(reader.GetOutput(), VolumeFractionArrays=["water"])
    table, _ = table_of(result.mesh)
    assert len(table["FragmentId"]) == 16
    errors = np.array(table["MeshVolume"]) / table["FractionVolume"] - 1
    print("largest relative error of a fragment: %.1e" % abs(errors).max())
    assert abs(errors).max() < 1e-6, errors


def test_void_has_neighbours():
    result = mesh_of(image({"id": three_parts()}), MaterialIdArray="id", MeshVoid=1)
    table, _ = table_of(result.mesh)
    check(result, table)
    void = table["Material"].index("Void")
    assert len(table["Neighbours"][void].split()) == len(table["Material"]) - 1


def box():
    """Returns a bar of 4 x 3 x 2 cells in a larger grid, with densities that grow along x."""
    ids = np.zeros((6, 7, 8), np.int32)
    ids[1:3, 2:5, 3:7] = 4
    density = np.broadcast_to(1.0 + np.arange(8.0), ids.shape)
    return image({"id": ids, "density": density, "two": 2 * density})


def test_exact():
    """Volume, centroid, bounds and mass of a bar are exact."""
    mesh = mesh_of(box(), MaterialIdArray="id", StairStep=1, StateArrays=["density", "two"]).mesh
    table, _ = table_of(mesh, DensityArrays=["density"])
    cell = np.prod(SPACING)
    assert table["MaterialId"] == [4] and table["Elements"] == [24]
    assert np.isclose(table["MeshVolume"][0], 24 * cell, rtol=1e-12)
    centre = np.array(ORIGIN) + np.array(SPACING) * (5, 3.5, 2)
    assert np.allclose([table["Centroid" + a][0] for a in "XYZ"], centre, rtol=0, atol=1e-10)
    assert [table["Min" + a][0]
            for a in "XYZ"] == (np.array(ORIGIN) + np.array(SPACING) * (3, 2, 1)).tolist()
    assert np.isclose(table["Mass"][0], cell * 6 * (4 + 5 + 6 + 7), rtol=1e-12)


def test_ids_are_no_densities():
    """Ids of the mesh are not offered as densities."""
    result = mesh_of(fraction_image(), StateArrays=["ball"], StairStep=1)
    table = VolumeFractionFragments(Input=producer(result.mesh))
    offered = table.SMProxy.GetProperty("DensityArrays").FindDomain("vtkSMStringListDomain")
    names = [offered.GetString(i) for i in range(offered.GetNumberOfStrings())]
    assert sorted(names) == ["ScaledJacobian", "ball"], names


def test_density_of_each_material():
    data = image({"id": three_parts(), "light": np.full((12, 12, 12), 2.0),
                  "heavy": np.full((12, 12, 12), 7.0)})
    mesh = mesh_of(data, MaterialIdArray="id", StateArrays=["light", "heavy"]).mesh
    table, _ = table_of(mesh, DensityArrays=["light", "heavy"])
    for mass, volume, material in zip(table["Mass"], table["MeshVolume"], table["MaterialId"]):
        assert np.isclose(mass, volume * {1: 2.0, 2: 7.0}[material], rtol=1e-9)


def test_errors():
    result = mesh_of(image({"id": three_parts(), "light": np.ones((12, 12, 12))}),
                     MaterialIdArray="id", StateArrays=["light"])
    for densities, text in ((["heavy"], "no array heavy"),
                            (["light"] * 3, "3 density arrays and 2 materials")):
        table, errors = table_of(result.mesh, DensityArrays=densities)
        assert not table and len(errors) == 1 and text in errors[0], errors
    result.mesh.GetCellData().RemoveArray("FragmentId")
    assert "no array FragmentId" in table_of(result.mesh)[1][0]


def test_file():
    """The filter and a mesh read from a file give the same table as CSV."""
    mesher = VolumeFractionToHex(Input=producer(box()), MaterialIdArray="id",
                                 StateArrays=["density"])
    with tempfile.TemporaryDirectory() as folder:
        simple.SaveData(os.path.join(folder, "mesh.vtu"), proxy=mesher, DataMode="Binary")
        rows = []
        for place, source in enumerate((mesher,
                                        simple.OpenDataFile(os.path.join(folder, "mesh.vtu")))):
            path = os.path.join(folder, "fragments%d.csv" % place)
            simple.SaveData(path,
                            proxy=VolumeFractionFragments(Input=source, DensityArrays=["density"]))
            with open(path, newline="") as file:
                rows.append(list(csv.DictReader(file)))
    assert rows[0] == rows[1] and len(rows[0]) == 1
    assert rows[0][0]["Material"] == "Material 4" and rows[0][0]["Neighbours"] == ""
    assert float(rows[0][0]["Mass"]) > 0 and float(rows[0][0]["CentroidX"]) > ORIGIN[0]


def test_sculptor():
    """sculptor writes the same table on one and two ranks."""
    ball, plate = ball_and_plate()
    data = image({"ball, hot": ball, "plate": plate, "density": 2.0 + ball})
    mesh = mesh_of(data, VolumeFractionArrays=["ball, hot", "plate"],
                   DensityArrays=["density"]).mesh
    expected, _ = table_of(mesh, DensityArrays=["density"])
    with tempfile.TemporaryDirectory() as folder:
        path, output = os.path.join(folder, "in.vti"), os.path.join(folder, "fragments.csv")
        simple.SaveData(path, proxy=producer(data), DataMode="Binary")
        command = [os.environ["VFM_SCULPTOR"], "--input", path, "--output",
                   os.path.join(folder, "out.vtu")]
        for ranks in (1, 2):
            result = mpi_run(ranks, command + ["--fragments", output, "--density", "density"])
            assert result.returncode == 0, result.stderr
            with open(output, newline="") as file:
                rows = list(csv.DictReader(file))
            assert {name: [type(expected[name][0])(row[name]) for row in rows]
                    for name in rows[0]} == expected
        for extra, code, text in (
                (["--fragments", os.path.join(folder, "none", "f.csv")], 4,
                 "Cannot write the output"),
                (["--fragments", folder], 4, "Cannot write the table"),
                (["--fragments", output, "--density", "nothing"], 2, "'nothing' (--density)")):
            result = mpi_run(2, command + extra)
            assert result.returncode == code and result.stderr.count(text) == 1, result


main(globals())
