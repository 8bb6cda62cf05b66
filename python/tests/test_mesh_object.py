"""Tests the methods of a mesh: printing, pickling, conversion to PyVista and meshio, saving."""

import pickle
import re

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import BALL, PLATE, STATE, same
from volume_fraction_mesh._save import BY_MESHIO

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
        text.startswith("Mesh(%d hexahedra, %d points, 3 materials, "
                        % (len(HEXES), len(HEXES.points)))
        and "scaled Jacobian 0." in text
    )
    assert "tetrahedra" in repr(TETS) and "Jacobian" not in repr(
        vfm.hexes(BALL, compute_quality=False))


@BOTH
def test_pickle(mesh):
    again = pickle.loads(pickle.dumps(mesh))
    assert same(again, mesh) and repr(again) == repr(mesh) and again.roles == mesh.roles
    assert np.array_equal(again.state["T"],
                          mesh.state["T"]) and again.materials["Name"] == mesh.materials["Name"]
    assert np.array_equal(again.surfaces.cells,
                          mesh.surfaces.cells) and set(again.surfaces.fields) == set(
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
    expected = {"MaterialId", "FragmentId", "GlobalCellIds", "ScaledJacobian", "T", "density",
                "velocity"}
    assert set(grid.cell_data.keys()) == expected
    assert set(grid.point_data.keys()) == {"GlobalPointIds", "GeometryDimension", "GeometryId",
                                           "velocity"}
    assert grid.points.dtype == np.float64 and list(grid.field_data["MaterialNames"])[-2:] == [
        "ball", "plate"]
    assert np.isclose(grid.compute_cell_sizes().cell_data["Volume"].sum(), mesh.volumes().sum(),
                      rtol=1e-3)
    grid.save(tmp_path / "mesh.vtu")
    again = pyvista.read(tmp_path / "mesh.vtu")
    assert np.array_equal(again.points,
                          mesh.points) and np.array_equal(again.cell_data["T"], mesh.state["T"])
    assert set(again.cell_data.keys()) == expected and "MeshVolume" in again.field_data.keys()


@BOTH
def test_pyvista_parts(mesh):
    pytest.importorskip("pyvista")
    surfaces, curves, vertices = (mesh.to_pyvista(part)
                                  for part in ("surfaces", "curves", "vertices"))
    assert surfaces.n_cells == len(mesh.surfaces.cells) and np.array_equal(
        surfaces.cell_data["SurfaceId"], mesh.surfaces.surface_id
    )
    assert (
        np.array_equal(surfaces.cell_data["MaterialPair"], mesh.surfaces.material_pair)
        and "SurfaceAreas" in surfaces.field_data.keys()
    )
    corners = surfaces.regular_faces
    assert np.array_equal(surfaces.point_data["GlobalPointIds"][corners],
                          mesh.point_ids[mesh.surfaces.cells])
    assert curves.n_cells == len(mesh.curves.cells) and vertices.n_cells == len(
        mesh.vertices.points)
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
    if ending == "e":
        pytest.importorskip("netCDF4")
    path = tmp_path / ("mesh." + ending)
    mesh.save(path)
    again = pyvista.to_meshio(pyvista.read(path)) if ending in ("vtu", "vtk") else meshio.read(path)
    assert np.allclose(again.points, mesh.points, atol=1e-12)
    assert sum(len(block.data) for block in again.cells
               if ending != "msh" or block.type == mesh.kind) == len(mesh)
    counts = {label: int((mesh.material == label).sum()) for label in mesh.materials["MaterialId"]}
    if ending in ("vtu", "vtk", "xdmf"):
        assert np.array_equal(np.concatenate(again.cell_data["MaterialId"]), mesh.material)
    elif ending == "msh":
        assert set(mesh.materials["Name"]) | {"ball_to_plate", "z_min"} < set(again.field_data)
        assert int((again.cell_data_dict["gmsh:physical"][mesh.kind] == 2).sum()) == counts[2]
    elif ending == "inp":
        assert {block.type
                for block in again.cells} == {mesh.kind} and len(again.cells) == len(counts)
        assert np.array_equal(
            np.concatenate([block.data for block in again.cells]),
            mesh.cells[np.argsort(mesh.material, kind="stable")]
        )
        text = path.read_text()
        assert "ELSET=PLATE\n" in text and ("TYPE=C3D8," if mesh is HEXES else "TYPE=C3D4,") in text
        assert "*NSET, NSET=X_MIN\n" in text and (
            "*SURFACE, NAME=BALL_TO_PLATE, TYPE=ELEMENT\n" in text)
        assert "*INITIAL CONDITIONS, TYPE=VELOCITY\n" in text
    else:
        assert sorted(len(block.data) for block in again.cells) == sorted(counts.values())


@BOTH
def test_exodus(mesh, tmp_path):
    netcdf = pytest.importorskip("netCDF4")
    mesh.save(tmp_path / "mesh.e", time=0.25)
    with netcdf.Dataset(tmp_path / "mesh.e") as data:
        data.set_auto_mask(False)
        assert np.array_equal(data["node_num_map"][:], mesh.point_ids)
        assert np.array_equal(np.sort(data["elem_num_map"][:]), np.sort(mesh.cell_ids))
        assert np.array_equal(np.column_stack([data["coord" + axis][:] for axis in "xyz"]),
                              mesh.points)
        assert data["time_whole"][:].tolist() == [0.25] and data["qa_records"][
            0, 0].tobytes().startswith(b"VolumeFr")
        blocks = {bytes(n).rstrip(b"\0").decode(): i
                  for n, i in zip(data["eb_names"][:], data["eb_prop1"][:])}
        assert blocks["ball"] == 1 and blocks["plate"] == 2
        sides = [bytes(n).rstrip(b"\0").decode() for n in data["ss_names"][:]]
        assert {"x_min", "z_min", "ball_to_plate", "plate_to_ball"} <= set(sides), sides
        first = mesh.cells[mesh.material == 1] + 1
        assert np.array_equal(data["connect1"][:], first)
        names = [bytes(n).rstrip(b"\0").decode() for n in data["name_elem_var"][:]]
        place = names.index("T") + 1
        assert np.array_equal(data["vals_elem_var%deb1" % place][0],
                              mesh.state["T"][mesh.material == 1])
        assert {"velocity_X", "velocity_Y", "velocity_Z"} <= {
            bytes(n).rstrip(b"\0").decode() for n in data["name_nod_var"][:]
        }


def test_vtu_has_all(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    HEXES.save(tmp_path / "mesh.vtu", time=0.5)
    grid, wanted = pyvista.read(tmp_path / "mesh.vtu"), HEXES.to_pyvista()
    assert np.array_equal(grid.points, wanted.points) and np.array_equal(grid.cells, wanted.cells)
    for found, arrays in ((grid.cell_data, wanted.cell_data), (grid.point_data, wanted.point_data)):
        assert list(found) == list(arrays)
        for name in arrays:
            assert found[name].dtype == arrays[name].dtype and np.array_equal(
                found[name], arrays[name]), name
    assert list(grid.field_data["MaterialNames"]) == list(wanted.field_data["MaterialNames"])
    assert grid.GetPointData().GetGlobalIds().GetName() == "GlobalPointIds"
    assert grid.GetCellData().GetScalars().GetName() == "MaterialId" and grid.field_data[
        "TimeValue"][0] == 0.5


def test_files_that_cannot_be_written(tmp_path, monkeypatch):
    for ending in ("vtu", "e", "inp", "msh", "xdmf"):
        with pytest.raises(OSError, match="no/mesh.%s: No such file" % ending):
            HEXES.save(tmp_path / "no" / ("mesh." + ending))
    with pytest.raises(TypeError, match="colour"):
        HEXES.save(tmp_path / "mesh.vtu", colour=1)
    from volume_fraction_mesh import _save

    monkeypatch.setattr(_save, "find_spec", lambda name: None)
    with pytest.raises(ImportError, match="pip install meshio"):
        HEXES.save(tmp_path / "mesh.med")
    HEXES.save(tmp_path / "mesh.vtu")
    assert [file.name for file in tmp_path.iterdir()] == ["mesh.vtu"]


def test_names_of_sets(tmp_path):
    def sets_of(mesh):
        mesh.save(tmp_path / "names.inp")
        lines = (tmp_path / "names.inp").read_text().splitlines()
        return [line.split("ELSET=")[1] for line in lines if line.startswith("*ELSET")]

    assert sets_of(vfm.hexes({"a b": BALL, "A_b": PLATE})) == ["A_B", "A_B_2", "EALL, GENERATE"]
    assert sets_of(vfm.hexes(labels=BALL > 0.5, names={1: "7 \u00e9t\u00e9"})) == [
        "S_7_T", "EALL, GENERATE"]


def test_files_without_ending(tmp_path):
    with pytest.raises(ValueError, match="has no ending"):
        HEXES.save(tmp_path / "mesh")


@BOTH
def test_surfaces_of_materials(mesh, tmp_path):
    mesh.save(tmp_path / "parts.stl")
    solids = re.split(r"^endsolid .*\n", (tmp_path / "parts.stl").read_text(), flags=re.M)[:-1]
    assert len(solids) == len(mesh.materials["Name"])
    volumes = dict(zip(mesh.materials["Name"], mesh.materials["MeshVolume"]))
    for text in solids:
        name = text.split("\n")[0][len("solid "):]
        volume = volumes.pop(name)
        corners = np.array(re.findall(r"vertex (\S+) (\S+) (\S+)", text), float).reshape(-1, 3, 3)
        found = np.linalg.det(corners).sum() / 6
        print(name, len(corners), found, volume)
        assert np.isclose(found, volume, rtol=1e-12)
        _, points = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
        edges = np.stack([points.reshape(-1, 3), np.roll(points.reshape(-1, 3), -1, axis=1)], -1)
        edges = edges.reshape(-1, 2)
        assert len(np.unique(edges, axis=0)) == len(edges)
        assert {tuple(edge) for edge in edges} == {tuple(edge) for edge in edges[:, ::-1]}


@pytest.mark.parametrize("ending", ["ply", "off", "su2", "ugrid"])
def test_formats_that_lose_the_mesh(ending, tmp_path):
    with pytest.raises(ValueError, match=r"the ending .%s is not .* Supported: .vtu, .e" % ending):
        HEXES.save(tmp_path / ("mesh." + ending))
    assert not list(tmp_path.iterdir())


@BOTH
@pytest.mark.parametrize("ending", BY_MESHIO)
def test_meshio_keeps_materials(mesh, ending, tmp_path):
    meshio = pytest.importorskip("meshio")
    if ending in (".hmf", ".med", ".xmf"):
        pytest.importorskip("h5py")
    mesh.save(tmp_path / ("mesh" + ending))
    again = meshio.read(tmp_path / ("mesh" + ending))
    cells = np.concatenate([block.data for block in again.cells if block.type == mesh.kind])
    assert cells.shape == mesh.cells.shape
    counts = np.unique(mesh.material, return_counts=True)[1].tolist()
    found = [np.unique(np.concatenate(values), return_counts=True)[1].tolist()
             for values in again.cell_data.values()]
    found += [[len(np.concatenate(parts)) for parts in again.cell_sets.values()]]
    assert any(sorted(some) == sorted(counts) for some in found), found
    assert not [file for file in tmp_path.iterdir() if file.name.startswith(".")]


def test_incomplete_files(tmp_path):
    """A writer that fails leaves nothing, and the file from before."""
    (tmp_path / "mesh.npz").write_text("before")
    with pytest.raises(TypeError, match="colour"):
        HEXES.save(tmp_path / "mesh.npz", colour=1)
    assert (tmp_path / "mesh.npz").read_text() == "before"
    assert [file.name for file in tmp_path.iterdir()] == ["mesh.npz"]
    with pytest.raises(OSError, match="no/mesh.npz: No such file"):
        HEXES.save(tmp_path / "no" / "mesh.npz")


@BOTH
@pytest.mark.parametrize("compress", [False, True])
def test_npz(mesh, compress, tmp_path):
    def check(one, other):
        if isinstance(one, dict):
            assert list(one) == list(other)
            for name in one:
                check(one[name], other[name])
        elif isinstance(one, np.ndarray):
            assert one.dtype == other.dtype and np.array_equal(one, other)
        elif hasattr(one, "__dict__"):
            check(vars(one), vars(other))
        else:
            assert type(one) is type(other) and one == other

    mesh.save(tmp_path / "mesh.npz", compress=compress)
    check(mesh, vfm.load(tmp_path / "mesh.npz"))


def test_npz_of_other_data(tmp_path):
    np.savez(tmp_path / "other.npz", a=[1])
    (tmp_path / "text.npz").write_text("text")
    np.savez(tmp_path / "part.npz", format="volume_fraction_mesh 1", points=[1])
    for name in ("other", "text", "part"):
        with pytest.raises(ValueError, match="%s.npz is not a mesh that Mesh.save wrote" % name):
            vfm.load(tmp_path / (name + ".npz"))
    with pytest.raises(FileNotFoundError):
        vfm.load(tmp_path / "none.npz")


@BOTH
@pytest.mark.parametrize("binary", [False, True])
def test_legacy_vtk(mesh, binary, tmp_path):
    """PyVista and meshio read the same points, cells and arrays."""
    pyvista, meshio = pytest.importorskip("pyvista"), pytest.importorskip("meshio")
    mesh.save(tmp_path / "mesh.vtk", binary=binary)
    head = (tmp_path / "mesh.vtk").read_bytes()
    assert head.startswith(b"# vtk DataFile Version 4.2\n") and b"MaterialNames" not in head
    grid, other = pyvista.read(tmp_path / "mesh.vtk"), meshio.read(tmp_path / "mesh.vtk")
    tags = np.where(mesh.material == 0, 3, mesh.material)
    assert np.array_equal(grid.cell_data["material"], tags)
    assert np.array_equal(other.cell_data["material"][0].ravel(), tags)
    assert np.array_equal(grid.points, mesh.points) and np.array_equal(other.points, mesh.points)
    assert np.array_equal(other.cells[0].data, mesh.cells)
    wanted = mesh.to_pyvista()
    for found, arrays in ((grid.cell_data, wanted.cell_data), (grid.point_data, wanted.point_data)):
        assert set(found) - {"material"} == set(arrays)
        for name in arrays:
            assert np.array_equal(found[name], arrays[name]), name


@BOTH
def test_mfem(mesh, tmp_path):
    mfem = pytest.importorskip("mfem.ser")
    mesh.save(tmp_path / "mesh.vtk")
    read = mfem.Mesh(str(tmp_path / "mesh.vtk"), 1, 1)
    assert [read.GetAttribute(i) for i in range(read.GetNE())] == np.where(
        mesh.material == 0, 3, mesh.material).tolist()


@BOTH
def test_vtu_for_meshio(mesh, tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh.save(tmp_path / "mesh.vtu", texts=False)
    again = meshio.read(tmp_path / "mesh.vtu")
    assert np.array_equal(again.points, mesh.points)
    assert np.array_equal(again.cells[0].data, mesh.cells)
    assert np.array_equal(again.cell_data["MaterialId"][0], mesh.material)
    with pytest.raises(TypeError, match="texts is not an option of .e"):
        mesh.save(tmp_path / "mesh.e", texts=False)
