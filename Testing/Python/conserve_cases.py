"""State on cells for tests of conservation, and numpy totals over input cells and mesh elements."""
import numpy as np

from vfmtest import (
    SPACING, TET_METHODS, VolumeFractionToTet, ball_and_plate, elements, hex_volumes, image,
    mesh_of, points_of, tet_volumes)

MASS = ["temperature", "heat_capacity"]
STATE = ["pressure", "inertia", "bulk", *MASS]
KINDS = ["pressure=volume", "inertia=extensive", "bulk=cell", "temperature=mass*heat_capacity"]
CONSERVE = {"DensityArrays": ["density"], "VelocityArray": "velocity", "EnergyArray": "energy",
            "StateArrays": STATE, "StateKinds": KINDS}
BOTH = {"NodalVelocity": 1, "LostKineticEnergy": "Internal Energy"}
TOLERANCE = 1e-13


def state(shape, seed=1, jump=10.0):
    """Returns arrays of scalars and vectors on cells: smooth, with noise and a jump along z."""
    random = np.random.default_rng(seed)
    z, y, x = np.meshgrid(*[(np.arange(n) + 0.5) / n for n in shape], indexing="ij")
    noise = lambda: 0.2 * random.random(shape)
    density = np.where(z < 0.35, jump, 1.0) * (1 + 0.5 * x + 0.3 * y * y + noise())
    velocity = np.stack([np.sin(2 * x) + z + 0.3, x * y + noise(), -z + noise()], axis=-1)
    return {"density": density, "velocity": velocity, "energy": 1 + x + noise(),
            "pressure": x * y - 0.2, "inertia": 2 + noise(),
            "bulk": 1 + x + noise(), "temperature": 300 + 10 * z + noise(),
            "heat_capacity": np.where(z < 0.35, 4.0, 1.0) * (1 + y)}


def cells_of(fractions, arrays, volume, density="density"):
    """Returns the totals over the cells: {material: {total: value}}.

    fractions: {material: fraction per cell}; volume: volume
    per cell; density: name of the array, or {material: name}.
    """
    filled = sum(f for material, f in fractions.items() if material != 0)
    result = {}
    for material, fraction in fractions.items():
        own = fraction > 0
        volumes = (fraction * volume)[own]
        mass = volumes * arrays[density[material] if isinstance(density, dict) else density][own]
        share = (fraction / np.where(filled > 0, filled,
                                     1))[own] if material else (filled == 0)[own]
        cell_volume = np.broadcast_to(volume, fraction.shape)[own]
        totals = {"volume": volumes.sum(), "mass": mass.sum()}
        if "velocity" in arrays:
            velocity = arrays["velocity"][own]
            totals["momentum"] = mass @ velocity
            totals["kinetic"] = 0.5 * mass @ (velocity ** 2).sum(axis=1)
        for name, weight in (("energy", mass), ("heat_capacity", mass), ("pressure", volumes),
                             ("inertia", share), ("bulk", share * cell_volume),
                             ("temperature",
                              mass * arrays["heat_capacity"][own] if "heat_capacity" in arrays
                              else mass)):
            if name in arrays:
                totals[name] = (weight * arrays[name][own]).sum()
        result[material] = totals
    return result


def added(parts):
    """Returns the sums of several results of cells_of()."""
    result = {}
    for part in parts:
        for material, totals in part.items():
            own = result.setdefault(material, {})
            for name, value in totals.items():
                own[name] = own.get(name, 0) + value
    return result


def volumes_of(result):
    corners = elements(result)
    return hex_volumes(points_of(result),
                       corners) if corners.shape[1] == 8 else tet_volumes(
                           points_of(result), corners)


def nodal_kinetic(result, mass, name="velocity"):
    """Returns kinetic energy and momentum of the nodes, with the lumped mass of the elements."""
    corners, nodal = elements(result), result.points(name)
    lumped = np.bincount(corners.ravel(), np.repeat(mass / corners.shape[1], corners.shape[1]),
                         len(nodal))
    return 0.5 * lumped @ (nodal ** 2).sum(axis=1), lumped @ nodal


def elements_hold(result, density="density"):
    """Returns the totals over the elements: {material: {total: value}}."""
    arrays = {result.mesh.GetCellData().GetArrayName(i)
              for i in range(result.mesh.GetCellData().GetNumberOfArrays())}
    volume = volumes_of(result)
    mass = volume * result.cells(density)
    totals = {}
    for material in result.field("MaterialIds"):
        own = result.cells("MaterialId") == material
        held = totals[material] = {"volume": volume[own].sum(), "mass": mass[own].sum()}
        if "velocity" in arrays:
            velocity = result.cells("velocity")[own]
            held["momentum"] = mass[own] @ velocity
            held["kinetic"] = 0.5 * mass[own] @ (velocity ** 2).sum(axis=1)
        for name, weight in (("energy", mass), ("heat_capacity", mass), ("pressure", volume),
                             ("inertia", 1 + 0 * mass), ("bulk", volume),
                             ("temperature",
                              mass * result.cells("heat_capacity") if "heat_capacity" in arrays
                              else mass)):
            if name in arrays:
                held[name] = (weight * result.cells(name))[own].sum()
    return totals


def close(one, other, scale):
    return np.all(np.abs(np.asarray(one) - other) <= TOLERANCE * scale)


def check_balance(result, cells, skipped=("volume", "kinetic"), unmeshed=None):
    """Checks that the totals of the elements equal those over the cells, minus `unmeshed`.

    unmeshed: {material: totals} of the material that was reported as not meshed.
    """
    mesh = elements_hold(result)
    assert mesh.keys() <= cells.keys() and mesh, (mesh.keys(), cells.keys())
    for material, held in mesh.items():
        for name, value in held.items():
            if name in skipped:
                continue
            expected = cells[material][name] - (unmeshed[material][name] if unmeshed else 0)
            scale = np.abs(cells[material][name]).max()
            if name == "momentum":
                scale = np.sqrt(2 * cells[material]["mass"] * cells[material]["kinetic"])
            if name == "pressure":
                scale = cells[material]["volume"]
            assert close(value, expected, scale), (material, name, (value - expected) / scale)
    return mesh


def check_energy(result, cells, name="energy", lost=0.0):
    """Checks that internal plus kinetic energy of the mesh equals the energy of the cells.

    The kinetic energy is summed over the nodes if
    they have velocities, otherwise over the elements.
    """
    volume = volumes_of(result)
    mass = volume * result.cells("density")
    internal = mass @ result.cells(name)
    if result.mesh.GetPointData().HasArray("velocity"):
        kinetic, momentum = nodal_kinetic(result, mass)
        assert close(momentum, mass @ result.cells("velocity"), np.sqrt(2 * mass.sum() * kinetic))
    else:
        kinetic = 0.5 * mass @ (result.cells("velocity") ** 2).sum(axis=1)
    total = sum(cells[material]["energy"] + cells[material]["kinetic"]
                for material in result.field("MaterialIds"))
    assert close(internal + kinetic + lost, total, total), (internal + kinetic + lost) / total - 1


N = 12
VOLUME = SPACING[0] * SPACING[1] * SPACING[2]
FRACTIONS = dict(zip((1, 2), ball_and_plate(N)))
ARRAYS = state((N, N, N))
DATA = image({"ball": FRACTIONS[1], "plate": FRACTIONS[2], **ARRAYS})
CELLS = cells_of(FRACTIONS, ARRAYS, VOLUME)
MAKES = [{}] + [{"make": VolumeFractionToTet, "Method": method} for method in TET_METHODS]


def conserved(data=DATA, **properties):
    """Returns the mesh with its state and checks that there was no warning."""
    result = mesh_of(data, **{**CONSERVE, **properties})
    assert not result.warnings, result.warnings
    return result
