"""The material of Examples/impact (MaterialPoints.h) at many points, for solvers in Python.

Mie-Grueneisen pressure, J2 plasticity with hardening and softening, failure, and viscosity in
shocks. Units: mm, microseconds, mg; therefore GPa, km/s, J. Used by lagrangian.py and
akantu_material.py.
"""
import numpy as np

# One entry per material: aluminium, steel. Meanings: struct Material of
# Examples/impact/MaterialPoints.h.
MATERIALS = {
    "density": [2.785, 7.83], "sound": [5.328, 4.569], "slope": [1.338, 1.49],
    "grueneisen": [2.0, 1.93], "shear": [27.6, 80.0],
    "yield0": [0.4, 1.6], "hardening": [0.0, 0.5], "exponent": [1.0, 0.3], "melt": [1.0, 0.7],
    "failure": [0.1, 0.8], "spall": [1.0, 3.0]}

LINEAR_VISCOSITY, QUADRATIC_VISCOSITY = 0.15, 1.5
TRIAXIALITY_FACTOR, TRIAXIALITY_LIMIT = 1.5, 1.5


def contract(a, b):
    """Returns the double contraction of symmetric tensors xx yy zz xy yz xz."""
    return (a[:3] * b[:3]).sum(0) + 2 * (a[3:] * b[3:]).sum(0)


def totals_of(body, mass, at_corners, internal):
    """Returns a row per body: mass, momentum (3), kinetic and internal energy. body, mass, internal
    (energy): of each element. at_corners: velocities (3, 8, elements)."""
    rows = []
    for number in range(len(MATERIALS["density"])):
        mine = body == number
        share, velocity = mass[mine], at_corners[:, :, mine]
        rows.append([share.sum(), *(share * velocity.mean(1)).sum(1),
                     (share * (velocity ** 2).sum(0).mean(0)).sum() / 2, internal[mine].sum()])
    return np.array(rows)


class MaterialPoints:
    """State of the material at points, and its change by a deformation.

    Parameters
    ----------
    materials : array, shape (points,)
        Numbers of the materials, from 1.
    state : dict
        Arrays over points: energy (specific internal), ratio (volume over volume at rest), deviator
        (points, 6; xx yy zz xy yz xz), plastic_strain, damage, toughness.
    volume : array, shape (points,)
        Volume of each point at the start. The caller changes `volume` before each deformation."""

    def __init__(self, materials, state, volume):
        self.body = materials - 1
        self.m = {name: np.array(values)[self.body] for name, values in MATERIALS.items()}
        self.energy, self.deviator = (
            state["energy"].copy(), np.ascontiguousarray(state["deviator"].T))
        # A transferred strain of 0 can be negative by rounding.
        self.strain = np.maximum(state["plastic_strain"], 0)
        self.damage, self.toughness = (state[name].copy() for name in ("damage", "toughness"))
        self.volume, self.rest_volume = volume, volume / state["ratio"]
        self.lives = np.ones(len(materials), bool)
        self.rate = np.zeros(len(materials))
        self.pressure = self.pressure_of(self.energy)

    def pressure_of(self, energy):
        """Returns the pressure of the equation of state, without tension in failed elements."""
        m, ratio = self.m, self.volume / self.rest_volume
        bulk = m["density"] * m["sound"] ** 2
        strain = np.clip(1 - ratio, 0, 0.8 / m["slope"])
        cold = np.where(ratio >= 1, bulk * (1 / ratio - 1),
                        bulk * strain * (1 - m["grueneisen"] * strain / 2)
                        / (1 - m["slope"] * strain) ** 2)
        pressure = cold + m["grueneisen"] * m["density"] * energy
        return np.where(self.damage >= 1, np.maximum(pressure, 0), pressure)

    def wave_speed(self, size):
        """Returns the speed that limits time steps. size: length of each point, for viscosity."""
        m, closing = self.m, np.maximum(0, -self.rate * size)
        return (np.sqrt(m["sound"] ** 2 + 4 / 3 * m["shear"] / m["density"])
                + 2 * m["slope"] * np.maximum(0, 1 - self.volume / self.rest_volume) * m["sound"]
                + 2 * (LINEAR_VISCOSITY * m["sound"] + QUADRATIC_VISCOSITY * closing))

    def deform(self, l, dt, energy):
        """Updates the stress with the velocity gradient l (3, 3, elements) over a step. energy:
        estimate of the internal energy at the end of the step."""
        m, s = self.m, self.deviator
        self.rate = np.where(self.lives, l[0, 0] + l[1, 1] + l[2, 2], 0)
        d = np.array([l[0, 0] - self.rate / 3, l[1, 1] - self.rate / 3, l[2, 2] - self.rate / 3,
                      (l[0, 1] + l[1, 0]) / 2, (l[1, 2] + l[2, 1]) / 2, (l[0, 2] + l[2, 0]) / 2])
        xy, yz, xz = (l[0, 1] - l[1, 0]) / 2, (l[1, 2] - l[2, 1]) / 2, (l[0, 2] - l[2, 0]) / 2
        spin = np.array([2 * (xy * s[3] + xz * s[5]), 2 * (yz * s[4] - xy * s[3]),
                         -2 * (xz * s[5] + yz * s[4]),
                         xy * (s[1] - s[0]) + xz * s[4] + yz * s[5],
                         yz * (s[2] - s[1]) - xy * s[5] - xz * s[3],
                         xz * (s[2] - s[0]) + xy * s[4] - yz * s[3]])
        s = s + dt * (2 * m["shear"] * d + spin)
        stress = np.sqrt(1.5 * contract(s, s))
        limit = self.yield_stress(energy)
        flows = stress > limit
        plastic = np.where(flows, (stress - limit) / (3 * m["shear"]), 0)
        self.deviator = s * np.where(flows, limit / np.maximum(stress, 1e-30), 1)
        intact = self.damage < 1
        self.strain = self.strain + np.where(intact, plastic, 0)
        self.pressure = self.pressure_of(energy)
        self.wear(np.where(intact, plastic, 0), energy)

    def yield_stress(self, energy):
        m = self.m
        return (np.clip(1 - energy / m["melt"], 0, 1)
                * (m["yield0"] + m["hardening"] * self.strain ** m["exponent"]))

    def wear(self, plastic, energy):
        m = self.m
        limit = np.maximum(self.yield_stress(energy), 1e-3 * m["yield0"])
        triaxiality = np.clip(-self.pressure / limit, -TRIAXIALITY_LIMIT, TRIAXIALITY_LIMIT)
        grown = self.damage + plastic / (self.toughness * m["failure"]
                                         * np.exp(-TRIAXIALITY_FACTOR * triaxiality))
        self.damage = np.where(self.pressure < -self.toughness * m["spall"], 1,
                               np.minimum(grown, 1))
        failed = self.damage >= 1
        self.deviator = np.where(failed, 0, self.deviator)
        self.pressure = np.where(failed, np.maximum(self.pressure, 0), self.pressure)

    def stress(self, density, size):
        """Returns the stress (3, 3, points). density and size of a point determine its
        viscosity."""
        m, s = self.m, self.deviator
        closing = np.maximum(0, -self.rate * size)
        p = self.pressure + density * closing * (
            LINEAR_VISCOSITY * m["sound"] + QUADRATIC_VISCOSITY * closing)
        return np.array([[s[0] - p, s[3], s[5]], [s[3], s[1] - p, s[4]], [s[5], s[4], s[2] - p]])
