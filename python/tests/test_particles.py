"""Tests particles: material without elements, its sums, and its files."""

import re

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from volume_fraction_mesh.__main__ import main
from fields import BALL, N, PLATE, STATE

SPACING, ORIGIN = (0.5, 0.25, 1.0), (-1, 0.5, 2)
CELL = np.prod(SPACING)
# too little for thin parts
DROPS = {(0, 0, N - 1): 0.11, (N - 1, N - 1, N - 1): 0.12, (N - 1, 0, N - 1): 0.06,
         (N - 2, 0, N - 1): 0.05}
WITH_DROPS = BALL.copy()
for cell, part in DROPS.items():
    WITH_DROPS[cell] = part
FRACTIONS = {"ball": WITH_DROPS, "plate": PLATE}
DENSITY, VELOCITY, ENERGY, HEAT = (STATE[name]
                                   for name in ("density", "velocity", "energy", "temperature"))
GIVEN = {"density": DENSITY, "velocity": VELOCITY, "energy": ENERGY, "spacing": SPACING,
         "origin": ORIGIN, "state": {"T": HEAT, "code": STATE["code"]}}
MAKES = [vfm.hexes, vfm.tets]


def make_mesh(make=vfm.hexes, **options):
    return make(FRACTIONS, unmeshed_material="particles", **{**GIVEN, **options})


@pytest.fixture(scope="module")
def mesh():
    return make_mesh()


def close(found, expected, scale):
    return np.abs(np.asarray(found) - expected).max() <= 1e-13 * scale


@pytest.mark.parametrize("make", MAKES)
@pytest.mark.parametrize("clusters", [False, True])
def test_sums(make, clusters):
    """Elements and particles together have mass, momentum and energy of the cells."""
    mesh = make_mesh(make, particle_clusters=clusters, lost_kinetic_energy="internal_energy")
    particles, masses = mesh.particles, mesh.volumes() * mesh.state["density"]
    assert len(particles["Id"]) == len(DROPS) - clusters
    assert repr(mesh).count(", %d particles" % len(particles["Id"])) == 1
    for label, fraction in enumerate(FRACTIONS.values(), 1):
        own, free = mesh.material == label, particles["Material"] == label
        mass, held, loose = fraction * CELL * DENSITY, masses[own], particles["Mass"][free]
        assert close(held.sum() + loose.sum(), mass.sum(), mass.sum())
        both = held @ mesh.state["velocity"][own] + loose @ particles["velocity"][free]
        assert close(both, np.einsum("ijk,ijkc->c", mass, VELOCITY),
                     np.abs(mass[..., None] * VELOCITY).sum())
        energy, total = np.zeros(2), (mass * (ENERGY + 0.5 * (VELOCITY**2).sum(axis=3))).sum()
        for n, (m, state) in enumerate(((held, {k: v[own] for k, v in mesh.state.items()}),
                                        (loose, {k: v[free] for k, v in particles.items()}))):
            energy[n] = (m * (state["energy"] + 0.5 * (state["velocity"]**2).sum(axis=1))).sum()
        assert close(energy.sum(), total, total)
        table = {name: column[label - 1] for name, column in mesh.materials.items()}
        assert table["Particles"] == len(loose)
        assert close(table["ParticleMass"], loose.sum(), mass.sum())
        assert table["UnmeshedMass"] == 0


@pytest.mark.parametrize("make", MAKES)
def test_are_cells(make):
    """A particle of one cell is at its centre and has its values."""
    particles = make_mesh(make).particles
    cells = sorted(DROPS, key=lambda cell: cell[::-1])  # x fastest, as ids
    fractions = np.array([DROPS[cell] for cell in cells])
    assert list(particles)[:6] == ["Position", "Id", "Material", "Radius", "Volume", "Mass"]
    assert (particles["Material"] == 1).all() and (np.diff(particles["Id"]) > 0).all()
    np.testing.assert_allclose(particles["Position"], (np.array(cells) + 0.5) * SPACING + ORIGIN,
                               rtol=1e-14)
    np.testing.assert_allclose(particles["Volume"], fractions * CELL, rtol=1e-13)
    np.testing.assert_allclose(4 / 3 * np.pi * particles["Radius"]**3, particles["Volume"])
    for name, values in (("T", HEAT), ("velocity", VELOCITY), ("code", STATE["code"]),
                         ("density", DENSITY)):
        assert np.array_equal(particles[name], [values[cell] for cell in cells]), name
        assert particles[name].dtype == values.dtype
    np.testing.assert_allclose(particles["Mass"], particles["Volume"] * particles["density"],
                               rtol=1e-13)


def test_thin_parts():
    """By default a drop of 0.4 cells has an element; without thin parts it is a particle."""
    ball = WITH_DROPS.copy()
    ball[N - 1, N - 1, N - 1] = 0.4
    meshes = [vfm.hexes([ball, PLATE], unmeshed_material="particles", **options)
              for options in ({}, {"thin_parts": False})]
    assert [len(mesh.particles["Id"]) for mesh in meshes] == [len(DROPS) - 1, len(DROPS)]
    np.testing.assert_allclose(sum(meshes[0].volumes()) + sum(meshes[0].particles["Volume"]),
                               ball.sum() + PLATE.sum(), rtol=1e-6)


def test_without():
    assert vfm.hexes(FRACTIONS).particles == {}
    none = vfm.hexes(np.ones((3, 3, 3)), unmeshed_material="particles").particles
    assert {name: values.shape for name, values in none.items()} == {
        "Position": (0, 3), "Id": (0,), "Material": (0,), "Radius": (0,), "Volume": (0,)}
    bare = vfm.hexes(FRACTIONS, unmeshed_material="particles").particles
    assert "Mass" not in bare and len(bare["Id"]) == len(DROPS)


def test_state_with_the_name_of_another_array():
    mesh = vfm.hexes(FRACTIONS, unmeshed_material="particles", state={"Volume": HEAT})
    np.testing.assert_allclose(sorted(mesh.particles["Volume"]), sorted(DROPS.values()))
    assert mesh.state["Volume"].min() >= HEAT.min()


def test_modified(mesh):
    """Split interfaces and layers keep the particles."""
    for other in (mesh.split(), mesh.cut_layers(2)):
        assert other.particles.keys() == mesh.particles.keys()
        assert all(np.array_equal(other.particles[name], mesh.particles[name])
                   for name in mesh.particles)


def test_npz(mesh, tmp_path):
    mesh.save(tmp_path / "mesh.npz")
    again = vfm.load(tmp_path / "mesh.npz")
    assert list(again.particles) == list(mesh.particles)
    assert all(np.array_equal(again.particles[name], mesh.particles[name])
               and again.particles[name].dtype == mesh.particles[name].dtype
               for name in mesh.particles)


def numbers_after(text, keyword):
    """Returns the lines of numbers after a keyword of a deck."""
    rows = []
    for line in text[text.index(keyword):].splitlines()[1:]:
        if line.startswith("*"):
            break
        if not line.startswith("$"):
            rows.append(line.split())
    return rows


def test_decks_and_lammps(mesh, tmp_path):
    masses = mesh.particles["Mass"]
    mesh.save(tmp_path / "mesh.k")
    rows = numbers_after((tmp_path / "mesh.k").read_text(), "*ELEMENT_SPH")
    np.testing.assert_allclose([float(row[2]) for row in rows], masses, rtol=1e-8)
    mesh.save(tmp_path / "mesh.data")
    text = (tmp_path / "mesh.data").read_text()
    assert "%d atoms" % len(masses) in text
    atoms = re.search(r"Atoms[^\n]*\n\n(.*?)\n\n", text, re.S).group(1).split("\n")
    atoms = np.array([[float(word) for word in line.split()] for line in atoms])
    np.testing.assert_array_equal(atoms[:, 4:7], mesh.particles["Position"])
    np.testing.assert_allclose(np.pi / 6 * atoms[:, 2]**3 * atoms[:, 3], masses, rtol=1e-14)


def test_exodus(mesh, tmp_path):
    netcdf = pytest.importorskip("netCDF4")
    mesh.save(tmp_path / "mesh.e")
    with netcdf.Dataset(tmp_path / "mesh.e") as file:
        assert len(file.dimensions["num_nodes"]) == len(mesh.points) + len(DROPS)
        names = list(netcdf.chartostring(file["eb_names"][:]))
        assert "ball_particles" in names


@pytest.mark.parametrize("suffix", [".vtu", ".msh", ".xdmf", ".stl", ".vtk", ".vtp"])
def test_beside(mesh, suffix, tmp_path):
    """Formats without particles get a second file."""
    pyvista = pytest.importorskip("pyvista")
    path = tmp_path / ("mesh" + suffix)
    with pytest.warns(vfm.VolumeFractionMeshWarning) as caught:
        mesh.save(path)
    assert [str(warning.message) for warning in caught] == [
        "Files as %s hold no particles: they are in %s." % (path, tmp_path / "mesh_particles.vtp")]
    assert caught[0].filename == __file__
    assert not list(tmp_path.glob(".*"))  # no unfinished files
    found, own = (pyvista.read(tmp_path / "mesh_particles.vtp"), mesh.to_pyvista("particles"))
    for data in (found, own):
        assert np.array_equal(data.points, mesh.particles["Position"])
        assert data.n_verts == len(DROPS)
        assert list(data.field_data["MaterialNames"]) == ["ball", "plate"]
        for name in set(mesh.particles) - {"Position"}:
            assert np.array_equal(data.point_data[name], mesh.particles[name]), name


def test_command_says_where(tmp_path, capsys):
    given, out = tmp_path / "in.npz", tmp_path / "out.vtu"
    np.savez(given, **FRACTIONS)
    assert main([str(given), str(out), "--unmeshed-material", "particles", "--quiet"]) == 0
    assert capsys.readouterr().err == (
        "warning: Files as %s hold no particles: they are in %s.\n"
        % (out, tmp_path / "out_particles.vtp"))


def test_no_second_file(tmp_path):
    vfm.hexes(FRACTIONS).save(tmp_path / "mesh.vtk")
    assert [path.name for path in tmp_path.iterdir()] == ["mesh.vtk"]
    with pytest.raises(OSError, match="without particles"):
        vfm.hexes(FRACTIONS).save(tmp_path / "mesh.data")


@pytest.mark.parametrize("change, message", [
    (lambda p: p.pop("Volume"), "no array 'Volume'"),
    (lambda p: p.update(Radius=p["Radius"][1:]), "'Radius'.* another length"),
    (lambda p: p.update(Mass=np.stack([p["Mass"]] * 2, axis=1)), "'Mass'.* another type"),
])
def test_wrong_arrays(change, message, tmp_path):
    mesh = make_mesh()
    change(mesh.particles)
    with pytest.raises(ValueError, match=message):
        mesh.save(tmp_path / "mesh.vtu")
    assert not list(tmp_path.iterdir())
