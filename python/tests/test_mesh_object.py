"""What a mesh can do: print, pickle, become one of PyVista or meshio, save itself."""

import pickle

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, PLATE, STATE, same

GIVEN = {
    "state": {"T": STATE["temperature"]},
    "density": STATE["density"],
    "velocity": STATE["velocity"],
    "nodal_velocity": True,
}
HEXES = vfm.hexes({"ball": BALL, "plate": PLATE}, mesh_void=True, **GIVEN)
TETS = vfm.tets({"ball": BALL, "plate": PLATE}, **GIVEN)
BOTH = pytest.mark.parametrize("mesh", [HEXES, TETS], ids=["hexes", "tets"])


def test_repr():
    text = repr(HEXES)
    assert (
        text.startswith("Mesh(%d hexahedra, %d points, 3 materials, " % (len(HEXES), len(HEXES.points)))
        and "scaled Jacobian 0." in text
    )
    assert "tetrahedra" in repr(TETS) and "Jacobian" not in repr(vfm.hexes(BALL, compute_quality=False))


@BOTH
def test_pickle(mesh):
    again = pickle.loads(pickle.dumps(mesh))
    assert same(again, mesh) and repr(again) == repr(mesh) and again.roles == mesh.roles
    assert np.array_equal(again.state["T"], mesh.state["T"]) and again.materials["Name"] == mesh.materials["Name"]
    assert np.array_equal(again.surfaces.cells, mesh.surfaces.cells) and set(again.surfaces.fields) == set(
        mesh.surfaces.fields
    )


@BOTH
def test_volumes(mesh):
    for label, volume in zip(mesh.materials["MaterialId"], mesh.materials["MeshVolume"]):
        assert np.isclose(mesh.volumes()[mesh.material == label].sum(), volume, rtol=1e-9)


@BOTH
def test_pyvista(mesh, tmp_path):
    pyvista = pytest.importorskip("pyvista")
    grid = mesh.to_pyvista()
    assert np.array_equal(grid.points, mesh.points) and grid.n_cells == len(mesh)
    assert np.array_equal(next(iter(grid.cells_dict.values())), mesh.cells)
    expected = {"MaterialId", "FragmentId", "GlobalCellIds", "ScaledJacobian", "T", "density", "velocity"}
    assert set(grid.cell_data.keys()) == expected
    assert set(grid.point_data.keys()) == {"GlobalPointIds", "GeometryDimension", "GeometryId", "velocity"}
    assert grid.points.dtype == np.float64 and list(grid.field_data["MaterialNames"])[-2:] == ["ball", "plate"]
    assert np.isclose(grid.compute_cell_sizes().cell_data["Volume"].sum(), mesh.volumes().sum(), rtol=1e-3)
    grid.save(tmp_path / "mesh.vtu")
    again = pyvista.read(tmp_path / "mesh.vtu")
    assert np.array_equal(again.points, mesh.points) and np.array_equal(again.cell_data["T"], mesh.state["T"])
    assert set(again.cell_data.keys()) == expected and "MeshVolume" in again.field_data.keys()


@BOTH
def test_pyvista_parts(mesh):
    pytest.importorskip("pyvista")
    surfaces, curves, vertices = (mesh.to_pyvista(part) for part in ("surfaces", "curves", "vertices"))
    assert surfaces.n_cells == len(mesh.surfaces.cells) and np.array_equal(
        surfaces.cell_data["SurfaceId"], mesh.surfaces.surface_id
    )
    assert (
        np.array_equal(surfaces.cell_data["MaterialPair"], mesh.surfaces.material_pair)
        and "SurfaceAreas" in surfaces.field_data.keys()
    )
    corners = surfaces.regular_faces
    assert np.array_equal(surfaces.point_data["GlobalPointIds"][corners], mesh.point_ids[mesh.surfaces.cells])
    assert curves.n_cells == len(mesh.curves.cells) and vertices.n_cells == len(mesh.vertices.points)
    with pytest.raises(ValueError, match="part is 'volume'"):
        mesh.to_pyvista("volume")
    assert vfm.hexes(BALL).to_pyvista("curves").n_cells == 0


@BOTH
def test_meshio(mesh):
    pytest.importorskip("meshio")
    data = mesh.to_meshio()
    assert (
        np.array_equal(data.points, mesh.points)
        and data.cells[0].type == mesh.kind
        and np.array_equal(data.cells[0].data, mesh.cells)
    )
    assert np.array_equal(data.cell_data["MaterialId"][0], mesh.material)
    assert np.array_equal(data.cell_sets["ball"][0], np.flatnonzero(mesh.material == 1))
    blocks = mesh.to_meshio(blocks=True)
    assert [len(block.data) for block in blocks.cells] == [
        (mesh.material == label).sum() for label in mesh.materials["MaterialId"]
    ]
    assert all(len(set(part.tolist())) == 1 for part in blocks.cell_data["MaterialId"])


@BOTH
@pytest.mark.parametrize("ending", ["vtu", "vtk", "msh", "inp", "xdmf", "e"])
def test_files(mesh, ending, tmp_path):
    meshio, pyvista = pytest.importorskip("meshio"), pytest.importorskip("pyvista")
    for module in {"xdmf": ["h5py"], "e": ["netCDF4"]}.get(ending, []):
        pytest.importorskip(module)
    path = tmp_path / ("mesh." + ending)
    mesh.save(path)
    again = pyvista.to_meshio(pyvista.read(path)) if ending in ("vtu", "vtk") else meshio.read(path)
    assert np.allclose(again.points, mesh.points, atol=1e-12)
    assert sum(len(block.data) for block in again.cells) == len(mesh)
    counts = {label: int((mesh.material == label).sum()) for label in mesh.materials["MaterialId"]}
    if ending in ("vtu", "vtk", "xdmf"):
        assert np.array_equal(np.concatenate(again.cell_data["MaterialId"]), mesh.material)
    elif ending == "msh":
        assert set(again.field_data) == set(mesh.materials["Name"])
        assert int((np.concatenate(again.cell_data["gmsh:physical"]) == 2).sum()) == counts[2]
    elif ending == "inp":
        assert {block.type for block in again.cells} == {mesh.kind} and len(again.cells) == len(counts)
        assert np.array_equal(
            np.concatenate([block.data for block in again.cells]), mesh.cells[np.argsort(mesh.material, kind="stable")]
        )
        assert set(again.point_sets["SURFACE_1"]) == set(mesh.surfaces.cells[mesh.surfaces.surface_id == 1].ravel())
        text = path.read_text()
        assert "ELSET=PLATE\n" in text and ("TYPE=C3D8," if mesh is HEXES else "TYPE=C3D4,") in text
    else:
        assert sorted(len(block.data) for block in again.cells) == sorted(counts.values())


def test_files_without_pyvista(tmp_path, monkeypatch):
    meshio = pytest.importorskip("meshio")
    from volume_fraction_mesh import _save

    monkeypatch.setattr(_save, "find_spec", lambda name: None if name == "pyvista" else name)
    HEXES.save(str(tmp_path / "mesh.vtu"))
    assert np.array_equal(meshio.read(tmp_path / "mesh.vtu").points, HEXES.points)
    monkeypatch.setattr(_save, "find_spec", lambda name: None)
    with pytest.raises(ImportError, match="PyVista or meshio"):
        HEXES.save(tmp_path / "mesh.vtu")


def test_names_of_sets():
    from volume_fraction_mesh._abaqus import set_names

    mesh = vfm.hexes({"a b": BALL, "A_b": PLATE})
    assert list(set_names(mesh).values()) == ["A_B", "A_B_2"]
    assert list(set_names(vfm.hexes(labels=BALL > 0.5, names={1: "7 \u00e9t\u00e9"})).values()) == ["S_7_T"]


def test_files_without_ending(tmp_path):
    with pytest.raises(ValueError, match="has no ending"):
        HEXES.save(tmp_path / "mesh")
    pytest.importorskip("meshio")
    with pytest.raises(ValueError, match="no files with the ending .foam"):
        HEXES.save(tmp_path / "mesh.foam")
