"""Computes the effective stiffness of a cubic array of spheres on voxels, by Fourier transforms.

usage: python Examples/voxel_stiffness.py [--cells 64] [--contrast 10] [--volume 0.2]

A reference for Examples/homogenise.py that has neither its mesh nor its solver: conjugate gradients
for the Lippmann-Schwinger equation (Zeman, Vondrejc, Novak and Marek, J. Comput. Phys. 229 (2010)
8065-8071) with the rotated scheme of Willot, C. R. Mecanique 343 (2015) 232-245. A voxel that the
sphere cuts has the stiffness of a laminate of both materials across the normal of the sphere.
Spheres and matrix have Poisson's ratio 0.3. Prints C11, C12 and C44 relative to Young's modulus of
the matrix. Requires NumPy and SciPy.
"""
import argparse

import numpy as np
import scipy.fft

POISSON = 0.3
PARTS = 6  # points per voxel and axis, for volume fractions
PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
DOUBLED = np.array([1, 1, 1, 2, 2, 2])[:, None, None, None]  # times a pair is in a tensor


def lame(young):
    """Returns Lame's constants."""
    return young * POISSON / (1 + POISSON) / (1 - 2 * POISSON), young / 2 / (1 + POISSON)


def sphere_fractions(cells, volume):
    """Returns the volume fraction of the sphere in each voxel, and unit vectors from its centre."""
    radius = cells * (volume * 3 / 4 / np.pi) ** (1 / 3)
    axis = np.arange(cells) + 0.5 - cells / 2
    place = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"))
    distance = np.linalg.norm(place, axis=0)
    fractions = (distance < radius).astype(float)
    cut = abs(distance - radius) < 1
    steps = (np.arange(PARTS) + 0.5) / PARTS - 0.5
    inside = np.zeros(np.count_nonzero(cut))
    for step in np.stack(np.meshgrid(steps, steps, steps), axis=-1).reshape(-1, 3):
        inside += np.linalg.norm(place[:, cut] + step[:, None], axis=0) < radius
    fractions[cut] = inside / PARTS ** 3
    return fractions, place / np.maximum(distance, 0.5)


def times(tensor, normal):
    """Returns the product of symmetric tensors (six components) and vectors."""
    xx, yy, zz, yz, xz, xy = tensor
    x, y, z = normal
    return np.stack([xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z])


def symmetric(a, b):
    """Returns the symmetric part of the product of vectors."""
    return np.stack([(a[i] * b[j] + a[j] * b[i]) / 2 for i, j in PAIRS])


class Voxels:
    """Stresses of strains in voxels."""

    def __init__(self, cells, contrast, volume):
        share, normal = sphere_fractions(cells, volume)
        self.cut = (share > 0) & (share < 1)
        self.share, self.normal = share[self.cut], normal[:, self.cut]
        self.sphere, self.matrix = lame(contrast), lame(1.0)
        inside = share > 0.5
        self.constants = [np.where(inside, a, b) for a, b in zip(self.sphere, self.matrix)]

    def isotropic(self, constants, strain):
        stress = 2 * constants[1] * strain
        stress[:3] += constants[0] * strain[:3].sum(0)
        return stress

    def laminate(self, strain):
        """Returns the mean stress of two layers: the jump of the strain keeps tractions equal."""
        jump = times(self.isotropic(self.matrix, strain) - self.isotropic(self.sphere, strain),
                     self.normal)
        # The traction of the jump a is (m a + (l + m) n (n.a)) by constants weighted by shares.
        first, second = ((1 - self.share) * s + self.share * m
                         for s, m in zip(self.sphere, self.matrix))
        along = (jump * self.normal).sum(0) * self.normal
        vector = (jump - along) / second + along / (first + 2 * second)
        tensor = symmetric(vector, self.normal)
        return (self.share * self.isotropic(self.sphere, strain + (1 - self.share) * tensor)
                + (1 - self.share) * self.isotropic(self.matrix, strain - self.share * tensor))

    def stress(self, strain):
        stress = self.isotropic(self.constants, strain)
        stress[:, self.cut] = self.laminate(strain[:, self.cut])
        return stress


class Projection:
    """Green's operator of a homogeneous medium: the compatible strain of a stress."""

    def __init__(self, cells, constants):
        full = np.exp(2j * np.pi * np.fft.fftfreq(cells))
        half = np.exp(2j * np.pi * np.fft.rfftfreq(cells))
        x, y, z = full[:, None, None], full[None, :, None], half[None, None, :]
        self.k = np.stack([(x - 1) * (y + 1) * (z + 1), (x + 1) * (y - 1) * (z + 1),
                           (x + 1) * (y + 1) * (z - 1)])
        square = (abs(self.k) ** 2).sum(0)
        square[square < 1e-20] = np.inf  # the mean, and modes without strain
        first, second = constants
        self.along = (first + second) / (first + 2 * second) / square
        self.factor = 1 / second / square

    def __call__(self, stress):
        force = times(scipy.fft.rfftn(stress, axes=(1, 2, 3)), self.k.conj())
        vector = self.factor * (force - self.along * self.k * (self.k.conj() * force).sum(0))
        return scipy.fft.irfftn(symmetric(vector, self.k), s=stress.shape[1:], axes=(1, 2, 3))


def mean_stress(voxels, project, mean, tolerance=1e-7):
    """Returns the mean stress for a mean strain."""
    strain = np.zeros((6, *voxels.constants[0].shape)) + np.reshape(mean, (6, 1, 1, 1))
    residual = -project(voxels.stress(strain))
    direction, square = residual.copy(), (DOUBLED * residual ** 2).sum()
    limit = tolerance ** 2 * (DOUBLED * strain ** 2).sum()
    while square > limit:
        image = project(voxels.stress(direction))
        step = square / (DOUBLED * direction * image).sum()
        strain += step * direction
        residual -= step * image
        before, square = square, (DOUBLED * residual ** 2).sum()
        direction = residual + square / before * direction
    return voxels.stress(strain).mean(axis=(1, 2, 3))


def cubic_stiffness(cells, contrast, volume):
    """Returns C11, C12 and C44."""
    voxels = Voxels(cells, contrast, volume)
    project = Projection(cells, [np.sqrt(a * b) for a, b in zip(voxels.sphere, voxels.matrix)])
    pulled = mean_stress(voxels, project, [1, 0, 0, 0, 0, 0])
    sheared = mean_stress(voxels, project, [0, 0, 0, 0.5, 0, 0])
    return pulled[0], pulled[1], sheared[3]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=64, help="voxels per side (default: 64)")
    parser.add_argument("--contrast", type=float, default=10,
                        help="Young's modulus of the spheres (default: 10)")
    parser.add_argument("--volume", type=float, default=0.2,
                        help="volume fraction of the spheres (default: 0.2)")
    arguments = parser.parse_args()
    print("%d voxels, contrast %g: C11 %.5f, C12 %.5f, C44 %.5f" % (
        arguments.cells ** 3, arguments.contrast,
        *cubic_stiffness(arguments.cells, arguments.contrast, arguments.volume)))


if __name__ == "__main__":
    main()
