"""Material without elements as particles: the output Particles of both filters."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from conserve_cases import CONSERVE, state
from vfmtest import (
    ORIGIN, SPACING, VolumeFractionToTet, ball_and_plate, collect, held_class, image, in_folder,
    main, mesh_of, producer, run, servermanager, table_of)

N = 14
BALL, PLATE = ball_and_plate(N)
# z, y, x: fraction, too little for thin parts
DROPS = {(N - 1, 1, 1): 0.11, (N - 1, N - 2, N - 2): 0.12, (N - 1, 2, 1): 0.0002}
for cell, fraction in DROPS.items():
    BALL[cell] = fraction
PLATE = np.minimum(PLATE, 1 - BALL)
ARRAYS = {"ball": BALL, "plate": PLATE, **state(BALL.shape),
          "mark": np.arange(N ** 3, dtype=np.int32).reshape(BALL.shape)}
DATA = image(ARRAYS)
PARTICLES = {"UnmeshedMaterial": "Particles"}
VOLUME = np.prod(SPACING)
KINDS = ({}, {"make": VolumeFractionToTet, "Method": "Lattice"})


def particles_of(result):
    """Returns positions and {name: values}, in the order of ids."""
    data = result.particles
    arrays = data.GetPointData()
    values = {arrays.GetArrayName(a): vtk_to_numpy(arrays.GetArray(a))
              for a in range(arrays.GetNumberOfArrays())}
    assert data.GetNumberOfVerts() == data.GetNumberOfPoints() == data.GetNumberOfCells()
    order = np.argsort(values["Id"])
    return (vtk_to_numpy(data.GetPoints().GetData())[order],
            {name: own[order] for name, own in values.items()})


def centre(cell):
    return np.array(ORIGIN) + (np.array(cell[::-1]) + 0.5) * SPACING


def test_particles_are_the_cells():
    conserve = {**CONSERVE, "StateArrays": [*CONSERVE["StateArrays"], "mark"]}
    for kind in KINDS:
        result = mesh_of(DATA, **PARTICLES, LeastParticle=0, **conserve, **kind)
        assert not result.warnings, result.warnings
        points, values = particles_of(result)
        cells = sorted(DROPS)
        np.testing.assert_allclose(points, [centre(cell) for cell in cells], rtol=1e-14)
        fractions = np.array([DROPS[cell] for cell in cells])
        np.testing.assert_allclose(values["Volume"], fractions * VOLUME, rtol=1e-13)
        np.testing.assert_allclose(4 / 3 * np.pi * values["Radius"] ** 3, values["Volume"])
        own = lambda name: np.array([ARRAYS[name][cell] for cell in cells])
        for name in ("density", "velocity", "energy", "pressure", "mark"):
            np.testing.assert_array_equal(values[name], own(name))
        np.testing.assert_allclose(values["Mass"], values["Volume"] * own("density"), rtol=1e-13)
        np.testing.assert_allclose(values["inertia"], own("inertia"), rtol=1e-13)
        assert (values["Material"] == 1).all()
        names = result.particles.GetFieldData().GetAbstractArray("MaterialNames")
        assert [names.GetValue(m) for m in range(2)] == ["ball", "plate"]
        table = table_of(result.materials)
        assert table["Particles"] == [3, 0], table
        for quantity in ("Mass", "InternalEnergy"):
            both = np.add(table["Mesh" + quantity], table["Particle" + quantity])
            np.testing.assert_allclose(both, table["Input" + quantity], rtol=1e-13)
        np.testing.assert_allclose(np.add(table["MeshVolume"], table["ParticleVolume"]),
                                   table["InputVolume"], rtol=1e-4)


def test_small_ones_join():
    _, values = particles_of(mesh_of(DATA, **PARTICLES))
    np.testing.assert_allclose(values["Volume"], np.array([0.1102, 0.12]) * VOLUME, rtol=1e-13)
    assert set(values) == {"Id", "Material", "Radius", "Volume"}  # no state
    _, joined = particles_of(mesh_of(DATA, **PARTICLES, ParticleClusters=1))
    np.testing.assert_array_equal(joined["Volume"], values["Volume"])


@in_folder
def test_writers_say_where_they_are(at):
    """A writer has the mesh only: a warning names the output with the particles."""
    for choice, count in (("Particles", 1), ("Give", 0)):
        mesh = mesh_of(DATA, UnmeshedMaterial=choice).mesh
        writer = servermanager.writers.VolumeFractionExodusWriter(
            Input=producer(mesh), FileName=at("mesh.e"))
        errors, warnings = collect(held_class(writer))
        writer.UpdatePipeline()
        assert not errors and len(warnings) == count and all(
            at("mesh.e") + " has no particles: they are the output Particles" in text
            for text in warnings), warnings


def test_larger_drops_have_elements():
    """With Thin Parts, by default on, a drop of 0.4 cells is an element instead of a particle."""
    ball, cell = BALL.copy(), (N - 1, N - 2, N - 2)
    ball[cell] = 0.4
    data = image({"ball": ball, "plate": PLATE})
    off = mesh_of(data, **PARTICLES, ThinParts=0)
    volumes = particles_of(off)[1]["Volume"]
    np.testing.assert_allclose(volumes, np.array([0.1102, 0.4]) * VOLUME, rtol=1e-13)
    for kind in KINDS:
        on = mesh_of(data, **PARTICLES, **kind)
        np.testing.assert_allclose(particles_of(on)[1]["Volume"], 0.1102 * VOLUME, rtol=1e-13)
        fragments = on.field("FragmentTargetVolume")
        assert len(fragments) == len(off.field("FragmentTargetVolume")) + 1 == 3, fragments
        table = table_of(on.materials)
        np.testing.assert_allclose(np.add(table["MeshVolume"], table["ParticleVolume"]),
                                   table["InputVolume"], rtol=1e-6)


def test_empty_without_the_option():
    for choice in ("Give", "Drop"):
        result = run(DATA, UnmeshedMaterial=choice, **CONSERVE)
        assert result.particles.GetNumberOfPoints() == 0
        assert result.particles.GetPointData().GetNumberOfArrays() == 0
        assert not [name for name in table_of(result.materials) if "Particle" in name]


main(globals())
