"""Files of meshes of a plane, read back: the points, elements, sets and areas of the mesh."""

import re

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from decks import read_abaqus, read_keyword_file, read_nastran, read_radioss


def make_labels(cells=16):
    """Returns a disc of material 2, cut by a side, in material 1, with a void corner."""
    x = np.arange(cells) + 0.5
    labels = 1 + (np.hypot(x[:, None] - 11, x - 7) < 5.5).astype(int)
    labels[:5, 11:] = 0
    return labels


LABELS, NAMES = make_labels(), {1: "matrix", 2: "fibre"}
HEAT = np.arange(256.0).reshape(16, 16)
STATE = {"density": 1.0 + HEAT, "energy": 2.0 + HEAT,
         "velocity": np.stack([HEAT, -HEAT, 0 * HEAT], -1),
         "state": {"stress": np.stack([(i + 1) * HEAT for i in range(6)], -1)},
         "state_kinds": {"stress": "volume"}}
WORDS = {"names": NAMES, "label_smoothing": 3, "origin": (1, 2)}
MESHES = {"quads": vfm.hexes(labels=LABELS, **WORDS), "triangles": vfm.tets(labels=LABELS, **WORDS)}
READERS = {".k": read_keyword_file, ".rad": read_radioss, ".bdf": read_nastran, ".inp": read_abaqus}


@pytest.fixture(params=MESHES)
def mesh(request):
    return MESHES[request.param]


def save(mesh, suffix, tmp_path, **options):
    path = tmp_path / ("mesh" + suffix)
    mesh.save(path, **options)
    return READERS[suffix](path)


def plain(name, suffix):
    return name.upper() if suffix == ".inp" else name


def is_kept(name):
    """Returns whether files with one side per edge have a set."""
    return name != "fibre_to_matrix" and not name.startswith("Void_to_")


def area_of(x, corners):
    x = x[corners]
    following = np.roll(x, -1, axis=1)
    return 0.5 * (x[..., 0] * following[..., 1] - x[..., 1] * following[..., 0]).sum(axis=1)


@pytest.mark.parametrize("suffix", READERS)
def test_decks(mesh, suffix, tmp_path):
    if suffix == ".rad" and mesh.kind == "triangle":
        with pytest.raises(OSError, match="OpenRadioss has triangles of a plane for one law"):
            mesh.save(tmp_path / "mesh.rad")
        return
    deck = save(mesh, suffix, tmp_path)
    found = np.array([deck.nodes[n + 1] for n in range(len(mesh.points))])
    if suffix == ".rad":
        assert deck.analysis[0] == "2" and (found[:, 0] == 0).all()
        found = found[:, [1, 2, 0]]
    np.testing.assert_allclose(found, mesh.points, rtol=1e-9)
    cells = np.array([deck.elements[e + 1] for e in range(len(mesh))]) - 1
    assert np.array_equal(cells, mesh.cells)
    np.testing.assert_allclose(area_of(found, cells).sum(), mesh.materials["MeshVolume"].sum())
    for ident, name in NAMES.items():
        part = deck.parts[ident]
        assert part[0] in (None, name)
        assert np.array_equal(np.array(part[1]) - 1, np.flatnonzero(mesh.material == ident))


@pytest.mark.parametrize("suffix", READERS)
def test_edges(suffix, tmp_path):
    mesh = MESHES["quads" if suffix == ".rad" else "triangles"]
    deck = save(mesh, suffix, tmp_path)
    sets = {name: facets for name, facets in mesh.facet_sets().items()
            if suffix == ".inp" or is_kept(name)}
    assert {"x_min", "y_max", "matrix_to_fibre", "matrix_to_Void", "fibre_skin"} <= set(sets)
    assert not any(name.startswith("z_") for name in sets)
    for name, facets in sets.items():
        expected = facets.points + 1
        if suffix == ".bdf":
            assert deck.node_sets[name][1] == np.unique(expected).tolist()
        else:
            assert sorted(deck.surfaces[plain(name, suffix)][1]) == sorted(map(tuple, expected))
    x = mesh.points[:, 0]
    nodes = deck.node_sets[plain("x_min", suffix)][1]
    assert nodes == (np.flatnonzero(x == x.min()) + 1).tolist()


@pytest.mark.parametrize("suffix, strain, stress", [
    (".inp", {"CPE4"}, {"CPS4"}), (".k", [1, 13], [1, 12]), (".bdf", "strain", "stress")])
def test_plane_strain_or_stress(suffix, strain, stress, tmp_path):
    mesh = MESHES["quads"]
    of = {".inp": "types", ".k": "form", ".bdf": "planes"}[suffix]
    assert getattr(save(mesh, suffix, tmp_path), of) == strain
    assert getattr(save(mesh, suffix, tmp_path, plane="strain"), of) == strain
    assert getattr(save(mesh, suffix, tmp_path, plane="stress"), of) == stress
    with pytest.raises((ValueError, OSError), match="plane is 'bent': it must be strain or stress"):
        mesh.save(tmp_path / ("mesh" + suffix), plane="bent")


def test_plane_is_an_option_of_some_formats(tmp_path):
    with pytest.raises(TypeError, match="plane is not an option of .rad"):
        MESHES["quads"].save(tmp_path / "mesh.rad", plane="stress")


@pytest.mark.parametrize("suffix", [".k", ".rad"])
def test_state(suffix, tmp_path):
    mesh = vfm.hexes(labels=LABELS, nodal_velocity=True, **WORDS, **STATE)
    deck, state = save(mesh, suffix, tmp_path), mesh.state
    velocities = np.array([deck.velocities[n + 1] for n in range(len(mesh.points))])
    expected = mesh.point_state["velocity"]
    np.testing.assert_allclose(
        velocities[:, [1, 2, 0]] if suffix == ".rad" else velocities, expected, rtol=1e-4)
    states = [deck.states[e + 1] for e in range(len(mesh))]
    if suffix == ".k":
        np.testing.assert_allclose([row[:6] for row in states], state["stress"], rtol=1e-8)
        return
    for name, values in (("DENS", state["density"][:, None]),
                         ("ENER", (state["energy"] * state["density"])[:, None]),
                         ("STRESS", state["stress"][:, [0, 1, 2, 3]])):  # xx yy zz xy
        np.testing.assert_allclose([row[name] for row in states], values, rtol=1e-12)


@pytest.mark.parametrize("axis", [0, 1])
def test_planes_across_other_axes(axis, tmp_path):
    mesh = vfm.hexes(labels=np.expand_dims(LABELS, axis), names=NAMES, flat=True)
    for suffix in (".inp", ".k"):
        with pytest.raises(OSError, match="has elements of the plane of x and y only"):
            mesh.save(tmp_path / ("mesh" + suffix))
    axes = [(axis + 1) % 3, (axis + 2) % 3]
    deck = save(mesh, ".rad", tmp_path)
    found = np.array([deck.nodes[n + 1] for n in range(len(mesh.points))])
    np.testing.assert_allclose(found[:, 1:], mesh.points[:, axes], rtol=1e-12)
    cells = np.array([deck.elements[e + 1] for e in range(len(mesh))]) - 1
    assert (area_of(found[:, 1:], cells) > 0).all()
    deck = save(mesh, ".bdf", tmp_path)
    found = np.array([deck.nodes[n + 1] for n in range(len(mesh.points))])
    np.testing.assert_allclose(found, mesh.points, rtol=1e-9)


def test_pynastran(mesh, tmp_path):
    bdf = pytest.importorskip("pyNastran.bdf.bdf")
    mesh.save(tmp_path / "mesh.bdf")
    model = bdf.read_bdf(str(tmp_path / "mesh.bdf"), xref=False, debug=None)
    cells = np.array([model.elements[e + 1].nodes for e in range(len(mesh))]) - 1
    assert np.array_equal(cells, mesh.cells)
    assert np.array_equal([model.elements[e + 1].pid for e in range(len(mesh))], mesh.material)
    assert {entry.type for entry in model.properties.values()} == {"PSHELL"}


@pytest.mark.parametrize("version", ["2.2", "4.1"])
@pytest.mark.parametrize("binary", [False, True])
def test_gmsh(mesh, version, binary, tmp_path):
    gmsh = pytest.importorskip("gmsh")
    path = str(tmp_path / "mesh.msh")
    mesh.save(path, version=version, binary=binary)
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(path)
        model = gmsh.model
        groups = {model.getPhysicalName(*group): group for group in model.getPhysicalGroups()}
        for number, name in NAMES.items():
            size, tag = groups[name]
            found = [model.mesh.getElements(2, entity)[1]
                     for entity in model.getEntitiesForPhysicalGroup(size, tag)]
            count = sum(len(ids) for lists in found for ids in lists)
            assert size == 2 and count == (mesh.material == number).sum()
        for name in ("x_min", "y_max", "matrix_to_fibre", "matrix_to_Void"):
            size, tag = groups[name]
            nodes, _ = model.mesh.getNodesForPhysicalGroup(size, tag)
            assert size == 1 and len(nodes) == len(np.unique(mesh.facets(name).points))
        ids, coordinates, _ = model.mesh.getNodes()
        assert len(ids) == len(mesh.points)
        quality = model.mesh.getElementQualities(
            np.concatenate(model.mesh.getElements(2)[1]), "volume")
        np.testing.assert_allclose(np.sum(quality), mesh.volumes().sum())
    finally:
        gmsh.finalize()


def test_meshio(mesh, tmp_path):
    """meshio 5.3.5 does not know elements of plane strain."""
    meshio = pytest.importorskip("meshio")
    for name, options in (("a.vtu", {"texts": False}), ("a.msh", {}), ("a.msh", {"version": "4.1"}),
                          ("a.inp", {"plane": "stress"}), ("a.e", {}), ("a.bdf", {}),
                          ("a.xdmf", {}), ("a.vtk", {}), ("a.npz", {})):
        mesh.save(tmp_path / name, **options)
        if name == "a.npz":
            again = vfm.load(tmp_path / name)
            assert again.kind == mesh.kind and np.array_equal(again.cells, mesh.cells)
            continue
        if name == "a.bdf":
            path = tmp_path / name
            path.write_text("BEGIN BULK\n%sENDDATA\n" % path.read_text())
        read = meshio.read(tmp_path / name)
        blocks = [block.data for block in read.cells if block.type == mesh.kind]
        areas = [area_of(read.points, np.asarray(block)) for block in blocks]
        assert sum(map(len, areas)) == len(mesh), name
        np.testing.assert_allclose(np.concatenate(areas).sum(), mesh.volumes().sum(), rtol=1e-6,
                                   err_msg=name)


def test_vtk(mesh, tmp_path):
    pyvista = pytest.importorskip("pyvista")
    for name in ("a.vtu", "a.vtk"):
        mesh.save(tmp_path / name)
        read = pyvista.read(tmp_path / name)
        kind = pyvista.CellType.QUAD if mesh.kind == "quad" else pyvista.CellType.TRIANGLE
        assert set(read.celltypes) == {kind} and read.n_cells == len(mesh)
        areas = read.compute_cell_sizes()["Area"]
        np.testing.assert_allclose(areas, mesh.volumes(), rtol=1e-6)


def test_exodus(mesh, tmp_path):
    netcdf = pytest.importorskip("netCDF4")
    mesh.save(tmp_path / "a.e")
    with netcdf.Dataset(tmp_path / "a.e") as file:
        def texts(name):
            return [b"".join(row.compressed()).decode() for row in file.variables[name][:]]

        assert file.dimensions["num_dim"].size == 2 and "coordz" not in file.variables
        assert texts("eb_names") == list(NAMES.values())
        for place, number in enumerate(NAMES, 1):
            block = file.variables["connect%d" % place]
            assert block.elem_type == ("QUAD4" if mesh.kind == "quad" else "TRI3")
            assert np.array_equal(block[:] - 1, mesh.cells[mesh.material == number])
        numbers = np.argsort(np.argsort(mesh.material, kind="stable"))  # of elements, by block
        sets = mesh.facet_sets()
        assert set(texts("ss_names")) == set(sets)
        for place, name in enumerate(texts("ss_names"), 1):
            found = np.stack([file.variables["elem_ss%d" % place][:],
                              file.variables["side_ss%d" % place][:]], axis=1)
            facets = sets[name]
            expected = np.stack([numbers[facets.elements] + 1, facets.sides + 1], axis=1)
            assert sorted(found.tolist()) == sorted(expected.tolist()), name


def test_openfoam_is_a_layer_of_prisms(mesh, tmp_path):
    """The numbers of OpenFOAM are checked by Testing/Clients and Testing/IO."""
    mesh.save(tmp_path / "mesh.foam")
    text = (tmp_path / "constant" / "polyMesh" / "boundary").read_text()
    patches = {name: (kind, int(count)) for name, kind, count in re.findall(
        r"    (\w+)\n    \{\n        type +(\w+);[^}]*?nFaces +(\d+);", text)}
    assert patches["z_min"] == patches["z_max"] == ("empty", len(mesh))
    assert patches["x_max"] == ("patch", len(mesh.facets("x_max")))
    assert patches["matrix_to_Void"] == ("wall", len(mesh.facets("matrix_to_Void")))
    zones = (tmp_path / "constant" / "polyMesh" / "cellZones").read_text()
    assert re.findall(r"\n(\w+)\n\{\n", zones) == list(NAMES.values())


def test_formats_without_planes(tmp_path):
    for suffix in (".feb", ".stl", ".obj"):
        with pytest.raises((ValueError, OSError), match="not written for meshes of a plane"):
            MESHES["quads"].save(tmp_path / ("mesh" + suffix))
    assert not list(tmp_path.iterdir())
