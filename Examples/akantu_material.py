"""The material of impact_material.py as a material of Akantu, for akantu_restart.py.

Akantu's hexahedra have eight integration points, each with its own state. Akantu integrates over
the mesh at the start, so that its stress array holds first Piola-Kirchhoff stresses.
"""
import akantu as aka
import numpy as np

from impact_material import MaterialPoints
from lagrangian import GIVEN_UP_RATIO

POINTS = 8  # integration points per hexahedron


class ImpactMaterial(aka.Material):
    """The material of impact at the integration points of all elements. start() must be called
    before the first step; dt is the time step."""

    def start(self, mesh, volumes):
        state = {name: np.repeat(values, POINTS, axis=0) for name, values in mesh.state.items()}
        self.first_volume, self.first_density = np.repeat(volumes, POINTS), state["density"]
        self.points = MaterialPoints(np.repeat(mesh.material, POINTS), state, self.first_volume)
        self.deformation = np.broadcast_to(np.eye(3), (len(self.first_volume), 3, 3))
        self.piola, self.dt = self.find_piola(), 0.0

    def getPushWaveSpeed(self, element):
        return self.points.m["sound"].max()

    def computeStress(self, kind, ghost):
        """Akantu calls this once per step. Its matrices are stored by columns."""
        gradient = self.getGradU(kind, ghost)
        if len(gradient) and self.dt > 0:
            self.advance(gradient.reshape(-1, 3, 3).transpose(0, 2, 1) + np.eye(3))
        if len(gradient):
            self.getStress(kind, ghost)[:] = self.piola.transpose(0, 2, 1).reshape(-1, 9)

    def advance(self, deformation):
        """Changes the state to a deformation. The energy changes by the work of the mean stress."""
        points, old = self.points, self.piola
        change = deformation - self.deformation
        mean = (deformation + self.deformation) / 2
        self.deformation = deformation
        points.volume = np.linalg.det(deformation) * self.first_volume
        points.lives &= (points.damage < 1) | (points.volume < GIVEN_UP_RATIO * points.rest_volume)
        points.volume = np.where(points.lives, points.volume, points.rest_volume)
        rates = change @ np.linalg.inv(mean) / self.dt
        points.deform(np.moveaxis(rates, 0, -1), self.dt, points.energy + self.work(old, change))
        self.piola = self.find_piola()
        points.energy = points.energy + self.work((old + self.piola) / 2, change)

    def work(self, piola, change):
        """Returns the work of a stress per mass."""
        return (piola * change).sum((1, 2)) / self.first_density

    def find_piola(self):
        """Returns det(F) S F^-T of the stress S (points, 3, 3), 0 at removed points."""
        ratio = np.linalg.det(self.deformation)
        stress = self.points.stress(self.first_density / ratio, np.cbrt(self.points.volume))
        piola = np.moveaxis(stress, -1, 0) @ np.linalg.inv(self.deformation).transpose(0, 2, 1)
        return np.where(self.points.lives[:, None, None], piola * ratio[:, None, None], 0)


def allocate(_dimension, _option, model, name):
    """Makes the material. Akantu keeps this function until its end, so that it must be global."""
    return ImpactMaterial(model, name)


aka.MaterialFactory.getInstance().registerAllocator("impact", allocate)
