"""Images of labels, uint8, 0 is not meshed, in voxels of width 1, with the true surfaces if they
are known.

Each class has `labels`, `fills_box` (whether all of the box is meshed), and `distance(points,
materials)`, which returns distances of interface points to the true surface between two materials,
or None where the truth is not known.
"""
import os
import sys

import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples"))
import porous_flow

ATLAS = "/usr/share/mricron/templates/AICHAmc.nii.gz"  # of Debian's mricron-data
RADIUS = 0.7  # of the sphere, relative to half the box


def find_centres(cells):
    return np.stack(np.meshgrid(*3 * [np.arange(cells) + 0.5], indexing="ij"), axis=-1)


class Grains:
    """An image of the nearest of random seeds, and distances to the planes between them."""

    fills_box = True

    def __init__(self, arguments):
        cells, random = arguments.cells, np.random.default_rng(arguments.seed)
        self.seeds = random.uniform(0, cells, (arguments.grains, 3))
        self.labels = (cKDTree(self.seeds).query(find_centres(cells))[1] + 1).astype(np.uint8)

    def distance(self, points, materials):
        a, b = self.seeds[materials[:, 0] - 1], self.seeds[materials[:, 1] - 1]
        difference = ((points - a) ** 2).sum(1) - ((points - b) ** 2).sum(1)
        return np.abs(difference) / (2 * np.linalg.norm(a - b, axis=1))


class Pores:
    """An image of pores, and distances to the level of the noise that it samples."""

    fills_box = False

    def __init__(self, arguments):
        noise = porous_flow.make_noise(arguments.cells, arguments.seed)
        level = np.quantile(noise, porous_flow.PORES)
        self.labels = porous_flow.make_pores(arguments.cells, arguments.seed).astype(np.uint8)
        self.spline = ndimage.spline_filter(noise - level, order=5, mode="grid-wrap")

    def evaluate(self, points):
        return ndimage.map_coordinates(self.spline, points.T - 0.5, order=5, mode="grid-wrap",
                                       prefilter=False)

    def distance(self, points, _):
        """Returns how far Newton's steps along the gradient move points to the level."""
        at, width = points, 1e-3
        for _ in range(5):
            slope = np.column_stack([self.evaluate(at + step) - self.evaluate(at - step)
                                     for step in width * np.eye(3)]) / (2 * width)
            at = at - self.evaluate(at)[:, None] * slope / (slope ** 2).sum(1, keepdims=True)
        return np.linalg.norm(at - points, axis=1)


class Sphere:
    """An image of the voxels whose centres are in a sphere, in a box of 4/3 of the cells."""

    fills_box = False

    def __init__(self, arguments):
        cells = arguments.cells * 4 // 3
        self.centre, self.radius = cells / 2, RADIUS * cells / 2
        far = np.linalg.norm(find_centres(cells) - self.centre, axis=-1)
        self.labels = (far < self.radius).astype(np.uint8)

    def distance(self, points, _):
        return np.abs(np.linalg.norm(points - self.centre, axis=1) - self.radius)


class Atlas:
    """An atlas of the brain with 192 labels. The true surfaces are not known."""

    fills_box, distance = False, None

    def __init__(self, _):
        import nibabel
        self.labels = np.asarray(nibabel.load(ATLAS).dataobj).astype(np.uint8)


IMAGES = {"grains": Grains, "pores": Pores, "sphere": Sphere, "atlas": Atlas}
