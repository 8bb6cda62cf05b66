"""A small explicit Lagrangian solver for hexahedra, used by restart.py and akantu_restart.py.

The solver can start from any state: positions and velocities of nodes, and density, specific
internal energy, stress and history of elements. A mesh of VolumeFractionMesh transfers this state
from an Eulerian code.

Elements have uniform strain, one stress, and viscosity against hourglass modes (Flanagan and
Belytschko 1981). Each node has an equal share of the mass of its elements. Velocities and positions
are integrated by velocity Verlet. The internal energy of an element changes by the work of the
forces on its corners (compatible discretisation, Caramana, Burton, Shashkov and Whalen 1998). Mass,
momentum and total energy are therefore conserved to rounding. impact_material.py has the material
and the units.

There is no contact. Bodies that share nodes stay tied there; others would pass through each other.
Elements that failed and expanded, or are crushed flat, are removed: they exert no forces, but their
mass stays on their nodes and their energy in the sums. Material without elements may be particles:
point masses that fly freely, through each other and through elements.
"""
import numpy as np

from impact_material import MaterialPoints, totals_of

COURANT_NUMBER, LARGEST_COMPRESSION = 0.6, 0.1  # limits of a time step
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


class PointMasses:
    """Particles without forces.

    Parameters
    ----------
    particles : dict
        Arrays over particles: Position, velocity (particles, 3), Material, Mass, energy."""

    def __init__(self, particles):
        self.x, self.v = (np.array(particles[name].T, float) for name in ("Position", "velocity"))
        self.body, self.mass = particles["Material"] - 1, particles["Mass"]
        self.energy = particles["energy"]

    def move(self, dt):
        self.x = self.x + dt * self.v

    def totals(self):
        return totals_of(self.body, self.mass, self.v[:, None], self.mass * self.energy)


class Lagrangian(MaterialPoints):
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
        Default: means of ``state["velocity"]`` weighted by mass.
    hourglass : float
        Viscosity against hourglass modes.
    particles : dict, optional
        Particles (PointMasses)."""

    def __init__(self, points, hexahedra, materials, state, velocities=None, hourglass=0.1,
                 particles=None):
        self.x, self.corners = np.ascontiguousarray(points.T), np.ascontiguousarray(hexahedra.T)
        self.gradients, volume = volume_gradients(self.x[:, self.corners])
        super().__init__(materials, state, volume)
        self.length = length_of(self.gradients, volume)
        self.first_length = self.length.copy()
        self.mass = state["density"] * volume
        self.node_mass = self.to_nodes(np.broadcast_to(self.mass / 8, self.corners.shape))
        self.v = (np.ascontiguousarray(velocities.T) if velocities is not None
                  else self.to_mean_velocities(state["velocity"].T))
        self.time, self.steps, self.hourglass = 0.0, 0, hourglass
        self.particles = PointMasses(particles) if particles else None
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

    def step_size(self):
        """Returns the largest time step that is stable and changes no volume by much."""
        speed = self.wave_speed(np.cbrt(self.volume))
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
        if self.particles:
            self.particles.move(dt)
        self.time, self.steps = self.time + dt, self.steps + 1

    def give_up(self):
        """Removes elements that failed and expanded, or are crushed flat: they exert no force."""
        apart = (self.damage >= 1) & (self.volume > GIVEN_UP_RATIO * self.rest_volume)
        crushed = ~(self.length > GIVEN_UP_LENGTH * self.first_length)
        self.lives &= ~(apart | crushed)
        gone = ~self.lives
        self.volume = np.where(gone, self.rest_volume, self.volume)
        self.gradients = np.where(gone, 0, self.gradients)

    def find_forces(self, velocity):
        """Returns the forces of each element on its corners (3, 8, elements)."""
        size, density = np.cbrt(self.volume), self.mass / self.volume
        forces = -np.einsum("ijn,jan->ian", self.stress(density, size), self.gradients)
        x = self.x[:, self.corners]
        modes = HOURGLASSES.T[:, :, None] - np.einsum(
            "kjn,jan->kan", np.einsum("jan,ak->kjn", x - x[:, :1], HOURGLASSES),
            self.gradients) / self.volume
        amounts = np.einsum("kan,ian->kin", modes, velocity[:, self.corners])
        drag = self.hourglass / 4 * density * self.m["sound"] * size ** 2
        return np.where(self.lives, forces - drag * np.einsum("kan,kin->ian", modes, amounts), 0)

    def run(self, duration, watch):
        """Advances the state by a duration. Calls watch(self) at the start and after each step."""
        watch(self)
        end = self.time + duration
        while end - self.time > 1e-12 * end:
            self.step(end - self.time)
            watch(self)

    def totals(self):
        """Returns the totals of the bodies. The sums include removed elements and particles."""
        own = totals_of(self.body, self.mass, self.v[:, self.corners], self.mass * self.energy)
        return own + self.particles.totals() if self.particles else own
