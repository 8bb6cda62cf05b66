"""Tests input files of solvers: nodes, elements, parts, sets of sides, and state."""

import re

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from decks import read_abaqus, read_keyword_file, read_nastran, read_radioss
from fields import BALL, GRAINS, PLATE, STATE

FRACTIONS = {"ball": BALL, "plate": PLATE}
STRESS = np.stack([(i + 1) * STATE["temperature"] for i in range(6)], axis=-1)
GIVEN = {"density": STATE["density"], "velocity": STATE["velocity"], "energy": STATE["energy"],
         "state": {"stress": STRESS, "plastic_strain": STATE["temperature"]},
         "state_kinds": {"stress": "volume"}}
MESHES = {
    "hexes": vfm.hexes(FRACTIONS),
    "tets": vfm.tets(FRACTIONS),
    "with void": vfm.hexes(FRACTIONS, mesh_void=True),
    "grains": vfm.hexes(labels=GRAINS, names={1: "first grain", 2: "\u00e9t\u00e9 \"2\""}),
    "edges": vfm.hexes(vfm.shapes("box size=1.1,1,0.9", 12, bounds=[-1, 1] * 3),
                       sharp_edges="on"),
    "large": vfm.tets(FRACTIONS, spacing=1e-7, origin=(-900, 0.1, 1e-7)),
}
READERS = {".k": read_keyword_file, ".rad": read_radioss, ".bdf": read_nastran,
           ".inp": read_abaqus}
DIGITS = {".k": 1e-9, ".rad": 1e-13, ".bdf": 1e-10, ".inp": 1e-13}  # of a coordinate


@pytest.fixture(params=READERS)
def suffix(request):
    return request.param


@pytest.fixture(params=MESHES)
def mesh(request):
    return MESHES[request.param]


def save(mesh, suffix, tmp_path):
    path = tmp_path / ("mesh" + suffix)
    mesh.save(path)
    return READERS[suffix](path)


def plain(name, suffix):
    """Returns the name of a set in a file."""
    if suffix != ".inp":
        return re.sub(r"[^ -~]", "_", name.encode().decode("latin-1"))
    return re.sub(r"[^A-Z0-9]+", "_", name.upper().encode("ascii", "replace").decode()).strip("_")


def part_ids(mesh):
    """Returns the id of the part of each element; the void follows the greatest."""
    return np.where(mesh.material == 0, mesh.material.max() + 1, mesh.material)


def test_nodes_and_elements(mesh, suffix, tmp_path):
    deck = save(mesh, suffix, tmp_path)
    assert list(deck.nodes) == list(range(1, len(mesh.points) + 1))
    found = np.array(list(deck.nodes.values()))
    assert (np.abs(found - mesh.points) <= DIGITS[suffix] * np.abs(mesh.points)).all()
    assert sorted(deck.elements) == list(range(1, len(mesh) + 1))
    corners = np.array([deck.elements[number + 1] for number in range(len(mesh))])
    assert np.array_equal(corners - 1, mesh.cells)


def test_parts(mesh, suffix, tmp_path):
    deck = save(mesh, suffix, tmp_path)
    ids = part_ids(mesh)
    names = {0: "Void", **dict(zip(mesh.materials["MaterialId"].tolist(),
                                   mesh.materials["Name"]))}
    expected = {}
    for part in sorted(set(ids.tolist())):
        own = ids == part
        expected[part] = (names[mesh.material[own][0]], (np.flatnonzero(own) + 1).tolist())
    assert {part: elements for part, (_, elements) in deck.parts.items()} == {
        part: elements for part, (_, elements) in expected.items()}
    if suffix == ".inp":
        sets = {plain(name, suffix): elements for name, elements in expected.values()}
        assert deck.element_sets == {**sets, "EALL": list(range(1, len(mesh) + 1))}
    else:
        assert {part: name for part, (name, _) in deck.parts.items()} == {
            part: plain(name, suffix) for part, (name, _) in expected.items()}


def is_kept(name, names):
    """Returns whether a file with one element per face has a set: of two materials, that of the
    lower one, and of a void that of the material."""
    if name.startswith("Void_to_"):
        return False
    sides = name.split("_to_")
    if len(sides) == 1:
        return True
    other = re.sub(r"_\d+$", "", sides[1])
    return other == "Void" or names.index(sides[0]) < names.index(other)


def faces_of(deck, suffix, name):
    """Returns the corners of the faces of a surface."""
    faces = deck.surfaces[name][1]
    if suffix != ".bdf":
        return faces
    found = []
    for element, first, second in faces:
        corners = deck.elements[element]
        if len(corners) == 4:  # the second corner is not on the face
            found.append(tuple(corner for corner in corners if corner != second))
            assert first in found[-1]
        else:
            [face] = [face for face in hex_faces(corners) if {first, second} <= set(face)]
            found.append(face)
    return found


def hex_faces(corners):
    return [tuple(corners[i] for i in face)
            for face in ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
                         (3, 0, 4, 7))]


def test_surfaces(mesh, suffix, tmp_path):
    """Surfaces have the faces of facet_sets; segments turn as seen from outside."""
    deck = save(mesh, suffix, tmp_path)
    names = ["Void", *mesh.materials["Name"]]
    sets = {name: facets for name, facets in mesh.facet_sets().items()
            if suffix == ".inp" or is_kept(name, names)}
    assert {plain(name, suffix) for name in sets} == set(deck.surfaces)
    ids = [ident for ident, _ in deck.surfaces.values()]
    assert suffix == ".inp" or len(set(ids)) == len(ids)
    for name, facets in sets.items():
        faces = faces_of(deck, suffix, plain(name, suffix))
        assert sorted(map(sorted, (facets.points + 1).tolist())) == sorted(map(sorted, faces))
        if suffix in (".k", ".rad"):
            assert np.allclose(normals(mesh, np.array(faces) - 1).sum(axis=0),
                               normals(mesh, facets.points).sum(axis=0), atol=1e-12 * len(faces))


def normals(mesh, corners):
    x = mesh.points[corners] - mesh.points[0]
    return np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]) + (
        np.cross(x[:, 2] - x[:, 0], x[:, 3] - x[:, 0]) if corners.shape[1] == 4 else 0)


def test_node_sets(mesh, suffix, tmp_path):
    deck = save(mesh, suffix, tmp_path)
    for axis, letter in enumerate("xyz"):
        for end in ("min", "max"):
            name = "%s_%s" % (letter, end)
            if name not in mesh.facet_sets():
                continue
            ident, nodes = deck.node_sets[plain(name, suffix)]
            x = mesh.points[:, axis]
            side = getattr(x[mesh.facets(name).points], end)()
            assert nodes == (np.flatnonzero(x == side) + 1).tolist()
            assert ident in (None, 1 + 2 * axis + (end == "max"))


@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_state(make, suffix, tmp_path):
    """Velocities, energy per volume, density, stresses and plastic strain are those of the mesh."""
    mesh = make(FRACTIONS, nodal_velocity=True, **GIVEN)
    deck = save(mesh, suffix, tmp_path)
    velocities = np.array([deck.velocities[n + 1] for n in range(len(mesh.points))]
                          if suffix != ".bdf" else [])
    if suffix == ".bdf":
        assert not deck.velocities and not deck.states
        return
    error = 1e-4 if suffix == ".k" else 1e-12  # LS-DYNA has 10 characters
    assert np.allclose(velocities, mesh.point_state["velocity"], rtol=error, atol=0)
    state = mesh.state
    columns = [state["energy"] * state["density"], state["density"], *state["stress"].T,
               state["plastic_strain"]]
    if suffix != ".inp":
        found = np.array([deck.states[e + 1] for e in range(len(mesh))])
        expected = np.stack(columns if suffix == ".rad" else columns[2:], axis=1)
        assert np.allclose(found, expected, rtol=1e-8, atol=0) and np.ptp(found, axis=0).min() > 0


def test_full_tensors(tmp_path):
    """Of a stress with nine components by row, files have xx yy zz xy yz xz."""
    full = STRESS[..., [0, 3, 5, 3, 1, 4, 5, 4, 2]]
    for suffix in (".k", ".rad"):
        decks = [save(vfm.hexes(FRACTIONS, density=1, state={"stress": stress}), suffix, tmp_path)
                 for stress in (STRESS, full)]
        assert decks[0].states and decks[0].states == decks[1].states


def test_no_state(tmp_path):
    mesh = vfm.hexes(FRACTIONS, state={"velocity gradient": STRESS[..., 0]})
    for suffix in READERS:
        deck = save(mesh, suffix, tmp_path)
        assert not deck.velocities and not deck.states


def test_energy_without_density(tmp_path):
    mesh = vfm.hexes(FRACTIONS, state={"energy": STATE["energy"]})
    with pytest.raises(OSError, match="OpenRadioss requires it per volume"):
        mesh.save(tmp_path / "mesh.rad")
    assert not list(tmp_path.iterdir())


def test_large_ids(tmp_path):
    """A material of nine digits is an error where it does not fit; long ids of sets of Nastran
    become consecutive numbers."""
    labels = np.where(GRAINS == 1, 123456789, GRAINS)
    mesh = vfm.hexes(labels=labels)
    assert 123456789 in save(mesh, ".rad", tmp_path).parts
    for suffix in (".k", ".key", ".bdf", ".nas"):
        path = tmp_path / ("large" + suffix)
        with pytest.raises(OSError, match=r"material id 123456789 .*Formats that can hold it: \.r"):
            mesh.save(path)
        assert not path.exists()
    deck = save(vfm.hexes(labels=np.where(GRAINS > 0, 12000 + GRAINS, 0)), ".bdf", tmp_path)
    ids = [ident for table in (deck.node_sets, deck.surfaces) for ident, _ in table.values()]
    assert ids == list(range(1, len(ids) + 1))


def test_suffixes(tmp_path):
    """The other suffixes of a format give the same file."""
    mesh = MESHES["tets"]
    for one, other in ((".k", ".key"), (".bdf", ".nas")):
        mesh.save(tmp_path / ("mesh" + one))
        mesh.save(tmp_path / ("mesh" + other))
        assert (tmp_path / ("mesh" + one)).read_bytes() == (tmp_path / (
            "mesh" + other)).read_bytes()


def test_nastran_by_other_readers(mesh, tmp_path):
    """pyNastran reads the mesh, its sets, and the faces with their areas and outward normals."""
    bdf = pytest.importorskip("pyNastran.bdf.bdf")
    mesh.save(tmp_path / "mesh.bdf")
    model = bdf.read_bdf(str(tmp_path / "mesh.bdf"), xref=False, debug=None)
    points = np.array([model.nodes[n + 1].xyz for n in range(len(mesh.points))])
    assert np.allclose(points, mesh.points, rtol=1e-9, atol=0)
    cells = np.array([model.elements[e + 1].nodes for e in range(len(mesh))])
    assert np.array_equal(cells - 1, mesh.cells)
    parts = [model.elements[e + 1].pid for e in range(len(mesh))]
    assert np.array_equal(parts, part_ids(mesh)) and set(model.properties) == set(parts)
    deck = read_nastran(tmp_path / "mesh.bdf")
    assert {ident: nodes for ident, nodes in deck.node_sets.values()} == {
        ident: sorted(group.ids) for ident, group in model.sets.items()}
    for name, (ident, faces) in deck.surfaces.items():
        found = [faces_of_load(model, load) for load in model.loads[ident]]
        expected = faces_of(deck, ".bdf", name)
        assert sorted(map(sorted, found)) == sorted(map(sorted, expected))


def faces_of_load(model, load):
    """Returns the corners of the face of a PLOAD4, as pyNastran finds them."""
    element = model.elements[load.eids[0]]
    face = element.get_face(load.g1, load.g34) if len(element.nodes) == 8 else None
    if face is None:
        return tuple(n for n in element.nodes if n != load.g34)
    return tuple(element.nodes[i] for i in face)
