"""Meshes of a plane for clients: a disc in a square and in void, and exact solutions on them."""

import numpy as np
import volume_fraction_mesh as vfm

SIDES = ("x_min", "x_max", "y_min", "y_max")
RADIUS, CENTRE = 0.31, (0.48, 0.53)
NAMES = ["disc", "square"]


def disc_fractions(cells, samples=16):
    """Returns the part of each cell of the unit square that is in the disc."""
    x = (np.arange(cells * samples) + 0.5) / (cells * samples)
    inside = np.hypot(x[:, None] - CENTRE[0], x - CENTRE[1]) < RADIUS
    return inside.reshape(cells, samples, cells, samples).mean(axis=(1, 3))


def make_square(kind, cells):
    """Returns the unit square of both materials, as "hexes" or "tets"."""
    disc = disc_fractions(cells)
    return getattr(vfm, kind)([disc, 1 - disc], names=NAMES, spacing=(1 / cells, 1 / cells))


def make_disc(kind, cells):
    return getattr(vfm, kind)([disc_fractions(cells)], names=NAMES[:1],
                              spacing=(1 / cells, 1 / cells))


def wave(x):
    """Returns u with -div(grad u) = 2 pi^2 u, and u = 0 on the sides of the square."""
    return np.sin(np.pi * x[0]) * np.sin(np.pi * x[1])


def bump(x):
    """Returns u with -div(grad u) = 1 in the disc, and u = 0 on its boundary."""
    return (RADIUS ** 2 - (x[0] - CENTRE[0]) ** 2 - (x[1] - CENTRE[1]) ** 2) / 4


def orders(errors):
    """Returns the orders of convergence of errors on meshes of cells of half the width each."""
    return np.log2(np.array(errors[:-1]) / errors[1:])
