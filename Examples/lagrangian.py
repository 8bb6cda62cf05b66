"""A small explicit Lagrangian solver for hexahedra, used by restart.py.

The solver can start from any state: positions and velocities of nodes, and density, specific
internal energy, stress and history of elements. A mesh of VolumeFractionMesh transfers this state
from an Eulerian code.

Elements have uniform strain, one stress, and viscosity against hourglass modes (Flanagan and
Belytschko 1981). Each node has an equal share of the mass of its elements. Velocities and positions
are integrated by velocity Verlet. The internal energy of an element changes by the work of the
forces on its corners (compatible discretisation, Caramana, Burton, Shashkov and Whalen 1998). Mass,
momentum and total energy are therefore conserved to rounding. The material is the one of
Examples/impact (MaterialPoints.h): Mie-Grueneisen pressure, J2 plasticity with hardening and
softening, failure. Units: mm, microseconds, mg; therefore GPa, km/s, J.

There is no contact. Bodies that share nodes stay tied there; others would pass through each other.
Elements that failed and expanded, or are crushed flat, are removed: they exert no forces, but their
mass stays on their nodes and their energy in the sums.
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
HOURGLASS_VISCOSITY = 0.1
COURANT_NUMBER, LARGEST_COMPRESSION = 0.6, 0.1  # limits of a time step
TRIAXIALITY_FACTOR, TRIAXIALITY_LIMIT = 1.5, 1.5
# Limits of removed elements: volume over volume at rest, if failed; length over initial length.
GIVEN_UP_RATIO, GIVEN_UP_LENGTH = 3.0, 0.15

CORNERS = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1],
                    [1, 1, 1], [-1, 1, 1]])
# Hourglass modes (corner, mode).
HOURGLASSES = np.array([[c[1] * c[2], c[0] * c[2], c[0] * c[1], c[0] * c[1] * c[2]]
                        for c in CORNERS], float)
# Rotations of the hexahedron that move each corner to the place of corner 0: the corners that then
# take the places 0 to 7.
VIEWS = [(0, 1, 2, 3, 4, 5, 6, 7), (1, 2, 3, 0, 5, 6, 7, 4), (2, 3, 0, 1, 6, 7, 4, 5),
         (3, 0, 1, 2, 7, 4, 5, 6),
         (4, 7, 6, 5, 0, 3, 2, 1), (5, 4, 7, 6, 1, 0, 3, 2), (6, 5, 4, 7, 2, 1, 0, 3),
         (7, 6, 5, 4, 3, 2, 1, 0)]


def volume_gradients(x):
    """Returns the volume of trilinear hexahedra, and its derivatives (3, 8, elements) by the corner
    positions x (3, 8, elements)."""
    x = x - x[:, :1]
    gradients = np.empty_like(x)
    for corner, view in enumerate(VIEWS):
        for axis in range(3):
            y, z = ([x[(axis + turn) % 3, n] for n in view] for turn in (1, 2))
            gradients[axis, corner] = (
                y[1] * ((z[5] - z[2]) + (z[4] - z[3])) + y[2] * (z[1] - z[3])
                + y[3] * ((z[2] - z[7]) + (z[1] - z[4]))
                + y[4] * ((z[7] - z[5]) + (z[3] - z[1])) + y[5] * (z[4] - z[1])
                + y[7] * (z[3] - z[4])) / 12
    return gradients, (x * gradients).sum((0, 1)) / 3


def length_of(gradients, volume):
    """Returns a lower bound of the distance that a wave travels across each element."""
    return volume / np.sqrt(2 * (gradients ** 2).sum((0, 1)))


def contract(a, b):
    """Returns the double contraction of symmetric tensors xx yy zz xy yz xz."""
    return (a[:3] * b[:3]).sum(0) + 2 * (a[3:] * b[3:]).sum(0)


class Lagrangian:
    """State of the bodies and its integration in time.

    Parameters
    ----------
    points : array, shape (nodes, 3)
    hexahedra : array, shape (elements, 8)
        Corners of each element, in VTK's order.
    materials : array, shape (elements,)
        Numbers of the materials, from 1.
    state : dict
        Arrays over elements: density, energy (specific internal), ratio (volume over volume at
        rest), deviator (elements, 6; xx yy zz xy yz xz), plastic_strain, damage, toughness.
    velocities : array, shape (nodes, 3), optional
        Default: means of ``state["velocity"]`` weighted by mass."""

    def __init__(self, points, hexahedra, materials, state, velocities=None):
        self.x = np.ascontiguousarray(points.T)
        self.corners, self.body = np.ascontiguousarray(hexahedra.T), materials - 1
        self.m = {name: np.array(values)[self.body] for name, values in MATERIALS.items()}
        self.energy, self.deviator = (
            state["energy"].copy(), np.ascontiguousarray(state["deviator"].T))
        # A transferred strain of 0 can be negative by rounding.
        self.strain = np.maximum(state["plastic_strain"], 0)
        self.damage, self.toughness = (state[name].copy() for name in ("damage", "toughness"))
        self.gradients, self.volume = volume_gradients(self.x[:, self.corners])
        self.length = length_of(self.gradients, self.volume)
        self.first_length = self.length.copy()
        self.mass = state["density"] * self.volume
        self.rest_volume = self.volume / state["ratio"]
        self.node_mass = self.to_nodes(np.broadcast_to(self.mass / 8, self.corners.shape))
        self.v = (np.ascontiguousarray(velocities.T) if velocities is not None
                  else self.to_mean_velocities(state["velocity"].T))
        self.lives = np.ones(len(self.mass), bool)
        self.time, self.steps = 0.0, 0
        self.pressure = self.pressure_of(self.energy)
        self.rate = np.zeros_like(self.mass)
        self.forces = self.find_forces(self.v)

    def to_nodes(self, values):
        return np.bincount(self.corners.ravel(), values.ravel(), self.x.shape[1])

    def to_mean_velocities(self, velocities):
        """Returns node velocities that conserve the momentum of the elements."""
        shares = [self.to_nodes(np.broadcast_to(self.mass / 8 * v, self.corners.shape))
                  for v in velocities]
        return np.array(shares) / self.node_mass

    def accelerations(self):
        return np.array([self.to_nodes(f) for f in self.forces]) / self.node_mass

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

    def step_size(self):
        """Returns the largest time step that is stable and changes no volume by much."""
        m, closing = self.m, np.maximum(0, -self.rate * np.cbrt(self.volume))
        speed = (np.sqrt(m["sound"] ** 2 + 4 / 3 * m["shear"] / m["density"])
                 + 2 * m["slope"] * np.maximum(0, 1 - self.volume / self.rest_volume) * m["sound"]
                 + 2 * (LINEAR_VISCOSITY * m["sound"] + QUADRATIC_VISCOSITY * closing))
        wave = COURANT_NUMBER * (self.length / speed)[self.lives].min()
        fastest = np.abs(self.rate[self.lives]).max()
        return min(wave, LARGEST_COMPRESSION / max(fastest, 1e-30))

    def step(self, most):
        """Advances the state by one time step of at most `most`."""
        dt = min(self.step_size(), most)
        half = self.v + dt / 2 * self.accelerations()
        old_forces, old_gradients, old_volume = self.forces, self.gradients, self.volume
        self.x = self.x + dt * half
        self.gradients, self.volume = volume_gradients(self.x[:, self.corners])
        self.length = length_of(self.gradients, self.volume)
        at_corners = half[:, self.corners]
        velocity_gradient = np.einsum("ian,jan->ijn", at_corners,
                                      old_gradients + self.gradients) / (old_volume + self.volume)
        self.give_up()
        expected = self.energy - dt * (old_forces * at_corners).sum((0, 1)) / self.mass
        self.deform(velocity_gradient, dt, expected)
        self.forces = self.find_forces(half)
        new = half + dt / 2 * self.accelerations()
        mean = ((self.v + new) / 2)[:, self.corners]
        self.energy = self.energy - dt / 2 * ((old_forces + self.forces)
                                              * mean).sum((0, 1)) / self.mass
        self.v = new
        self.time, self.steps = self.time + dt, self.steps + 1

    def give_up(self):
        """Removes elements that failed and expanded, or are crushed flat: they exert no force."""
        apart = (self.damage >= 1) & (self.volume > GIVEN_UP_RATIO * self.rest_volume)
        crushed = ~(self.length > GIVEN_UP_LENGTH * self.first_length)
        self.lives &= ~(apart | crushed)
        gone = ~self.lives
        self.volume = np.where(gone, self.rest_volume, self.volume)
        self.gradients = np.where(gone, 0, self.gradients)

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

    def find_forces(self, velocity):
        """Returns the forces of each element on its corners (3, 8, elements)."""
        m, s = self.m, self.deviator
        size, density = np.cbrt(self.volume), self.mass / self.volume
        closing = np.maximum(0, -self.rate * size)
        p = self.pressure + density * closing * (
            LINEAR_VISCOSITY * m["sound"] + QUADRATIC_VISCOSITY * closing)
        stress = np.array([[s[0] - p, s[3], s[5]], [s[3], s[1] - p, s[4]], [s[5], s[4], s[2] - p]])
        forces = -np.einsum("ijn,jan->ian", stress, self.gradients)
        x = self.x[:, self.corners]
        modes = HOURGLASSES.T[:, :, None] - np.einsum(
            "kjn,jan->kan", np.einsum("jan,ak->kjn", x - x[:, :1], HOURGLASSES),
            self.gradients) / self.volume
        amounts = np.einsum("kan,ian->kin", modes, velocity[:, self.corners])
        drag = HOURGLASS_VISCOSITY / 4 * density * m["sound"] * size ** 2
        return np.where(self.lives, forces - drag * np.einsum("kan,kin->ian", modes, amounts), 0)

    def run(self, duration, watch):
        """Advances the state by a duration. Calls watch(self) at the start and after each step."""
        watch(self)
        end = self.time + duration
        while end - self.time > 1e-12 * end:
            self.step(end - self.time)
            watch(self)

    def totals(self):
        """Returns a row per body: mass, momentum (3), kinetic and internal energy. The sums include
        removed elements."""
        at_corners = self.v[:, self.corners]
        rows = []
        for body in range(len(MATERIALS["density"])):
            mine = self.body == body
            mass, velocity = self.mass[mine], at_corners[:, :, mine]
            rows.append([mass.sum(), *(mass * velocity.mean(1)).sum(1),
                         (mass * (velocity ** 2).sum(0).mean(0)).sum() / 2,
                         (mass * self.energy[mine]).sum()])
        return np.array(rows)
