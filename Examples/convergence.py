"""Compares hexahedra, tetrahedra and voxels by solving on them: errors against exact solutions.

usage: python3 Examples/convergence.py [--quick] [--picture convergence.png]

A ball of radius 0.5 in the cube [-1, 1]^3, solved by scikit-fem with the exact solution on the six
sides. Voxels are the cells of the grid, each of the material with the larger fraction.

Heat: the conductivity is 10 in the ball and 1 around it. The gradient of the solution jumps at the
ball. The table lists the L2 error on grids that are halved.

Tension: Young's modulus is 10 in the ball and 1 around it, Poisson's ratio 0.3, and the body is
pulled along z. The exact solution is that of Goodier, J. Appl. Mech. 55-7 (1933) 39-44. The table
lists the error of the stress at the centroids of elements between 0.75 and 1.25 radii, relative to
the load: the norm of the difference of the tensors.

Needs volume_fraction_mesh, scikit-fem and, for the picture, matplotlib.
"""
import argparse

import numpy as np
import scipy.sparse
import scipy.sparse.linalg
import skfem
import volume_fraction_mesh as vfm
from skfem.helpers import ddot, dot, grad, sym_grad, trace

RADIUS, CONTRAST, POISSON = 0.5, 10.0, 0.3
KINDS = ("hexahedra", "tetrahedra", "voxels")
COLOURS = dict(zip(KINDS, ("tab:blue", "tab:orange", "tab:gray")))


def make_mesh(kind, cells):
    """Returns the mesh for scikit-fem: subdomains ball and block, boundaries x_min to z_max."""
    fractions = vfm.shapes("sphere radius=%g; box size=2,2,2 material=2" % RADIUS, cells,
                           bounds=[-1, 1] * 3)
    make = vfm.tets if kind == "tetrahedra" else vfm.hexes
    choices = {"stair_step": True} if kind == "voxels" else {}
    return make(fractions, names=["ball", "block"], **choices).to_skfem()


def in_ball(mesh, basis):
    """Returns 1 in the ball and 0 around it, at the integration points."""
    inside = np.zeros(basis.dx.shape)
    inside[mesh.subdomains["ball"]] = 1.0
    return inside


def solve(stiffness, load, basis, exact):
    """Solves with the exact values on the sides, by conjugate gradients."""
    sides = basis.get_dofs(["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"]).flatten()
    values = basis.zeros()
    values[sides] = exact[sides]
    matrix, right, values, inner = skfem.condense(stiffness, load, x=values, D=sides)
    scale = scipy.sparse.diags(1 / matrix.diagonal())
    found, failed = scipy.sparse.linalg.cg(matrix, right, M=scale, rtol=1e-9, maxiter=5000)
    if failed:
        raise RuntimeError("conjugate gradients did not converge")
    values[inner] = found
    return values


def heat_error(kind, cells):
    """Returns the L2 error of div(k grad u) = 6, whose solution is kinked at the ball."""

    def exact(x):
        square = (x * x).sum(axis=0)
        jump = RADIUS ** 2 * (1 - 1 / CONTRAST)
        return np.where(square < RADIUS ** 2, square / CONTRAST, square - jump)

    mesh = make_mesh(kind, cells)
    basis = skfem.Basis(mesh, mesh.elem(), intorder=4)
    conductivity = 1 + (CONTRAST - 1) * in_ball(mesh, basis)
    stiffness = skfem.BilinearForm(lambda u, v, w: w.k * dot(grad(u), grad(v))).assemble(
        basis, k=conductivity)
    load = skfem.LinearForm(lambda v, w: -6.0 * v).assemble(basis)
    found = solve(stiffness, load, basis, exact(basis.doflocs))
    return np.sqrt(skfem.Functional(lambda w: (w.u - exact(w.x)) ** 2).assemble(
        basis, u=basis.interpolate(found)))


def moduli(young):
    """Returns Lame's first parameter and the shear modulus."""
    return young * POISSON / (1 + POISSON) / (1 - 2 * POISSON), young / 2 / (1 + POISSON)


class Tension:
    """Displacement and stress of a stiff ball in an infinite body under the stress 1 along z.

    The remote strain is the sum of a volumetric part and a deviator E. Around the ball the
    displacement is (p + b / r^3) x + f E x + g (x . E x) x with functions f and g of r; in the
    ball it is linear."""

    def __init__(self):
        lame, shear = moduli(1.0)
        bulk, ball_bulk = lame + 2 / 3 * shear, CONTRAST * (lame + 2 / 3 * shear)
        self.volumetric = 1 / (9 * bulk)
        self.ball_volumetric = self.volumetric * (3 * bulk + 4 * shear) / (
            3 * ball_bulk + 4 * shear)
        self.deviator = np.diag([-1, -1, 2]) / (6 * shear)
        share = 2 * (4 - 5 * POISSON) / (15 * (1 - POISSON))  # Eshelby's beta
        self.ball_deviator = 1 / (1 + (CONTRAST - 1) * share)
        self.outer = self.ball_deviator * (1 - CONTRAST) / (6 * (1 - POISSON))

    def functions(self, r):
        """Returns f, its derivative, g, its derivative, and the factor of x and its derivative."""
        a, b, c = RADIUS, self.outer, 1 - 2 * POISSON
        f = 1 + b * (1.2 * (a / r) ** 5 + 2 * c * (a / r) ** 3)
        df = -b * (6 * (a / r) ** 5 + 6 * c * (a / r) ** 3) / r
        g = 3 * b * ((a / r) ** 3 - (a / r) ** 5) / r ** 2
        dg = 3 * b * (-5 * (a / r) ** 3 + 7 * (a / r) ** 5) / r ** 3
        h = (self.ball_volumetric - self.volumetric) * (a / r) ** 3
        return f, df, g, dg, self.volumetric + h, -3 * h / r

    def displacement(self, x):
        """Returns the displacement around the ball; x: (3, n)."""
        r = np.maximum(np.sqrt((x * x).sum(axis=0)), RADIUS)
        f, _, g, _, h, _ = self.functions(r)
        pulled = self.deviator @ x
        return h * x + f * pulled + g * (x * pulled).sum(axis=0) * x

    def stress(self, x):
        """Returns the stress, shape (3, 3, ...), at x, shape (3, n)."""
        distance = np.sqrt((x * x).sum(axis=0))
        r = np.maximum(distance, RADIUS)
        f, df, g, dg, h, dh = self.functions(r)
        unit = np.eye(3)[:, :, None]
        pulled = self.deviator @ x
        work = (x * pulled).sum(axis=0)
        gradient = (h * unit + dh / r * x[:, None] * x + f * self.deviator[:, :, None]
                    + df / r * pulled[:, None] * x + dg / r * work * x[:, None] * x
                    + g * (2 * x[:, None] * pulled + work * unit))
        inside = (self.ball_volumetric * np.eye(3) + self.ball_deviator * self.deviator)[:, :, None]
        stiff = distance < RADIUS
        strain = np.where(stiff, inside, (gradient + gradient.transpose(1, 0, 2)) / 2)
        lame, shear = (np.where(stiff, CONTRAST, 1.0) * number for number in moduli(1.0))
        return lame * np.trace(strain) * unit + 2 * shear * strain


def stress_errors(kind, cells):
    """Returns the number of elements, and errors and volumes of the elements near the ball."""
    mesh, exact = make_mesh(kind, cells), Tension()
    element = skfem.ElementVector(mesh.elem())
    basis = skfem.Basis(mesh, element, intorder=3)
    lame, shear = (number * (1 + (CONTRAST - 1) * in_ball(mesh, basis)) for number in moduli(1.0))
    stiffness = skfem.BilinearForm(
        lambda u, v, w: w.l * trace(sym_grad(u)) * trace(sym_grad(v))
        + 2 * w.m * ddot(sym_grad(u), sym_grad(v))).assemble(basis, l=lame, m=shear)
    wanted = basis.zeros()
    wanted[basis.nodal_dofs] = exact.displacement(mesh.p)
    found = solve(stiffness, basis.zeros(), basis, wanted)
    centre = np.full((3, 1), 0.25 if kind == "tetrahedra" else 0.5)
    middle = skfem.Basis(mesh, element, quadrature=(centre, np.ones(1)))
    strain = sym_grad(middle.interpolate(found))[..., 0]
    stress = lame[:, 0] * np.trace(strain) * np.eye(3)[:, :, None] + 2 * shear[:, 0] * strain
    x = middle.global_coordinates().value[..., 0]
    difference = np.sqrt(((stress - exact.stress(x)) ** 2).sum(axis=(0, 1)))
    near = np.abs(np.sqrt((x * x).sum(axis=0)) / RADIUS - 1) < 0.25
    return mesh.t.shape[1], difference[near], basis.dx.sum(axis=1)[near]


def print_heat(grids):
    """Prints the table of L2 errors and returns it as {kind: errors}."""
    print("L2 error of a kinked solution, conductivities 10 : 1")
    print("%-12s" % "cells" + "".join("%10d" % cells for cells in grids) + "    ratios")
    table = {}
    for kind in KINDS:
        errors = table[kind] = np.array([heat_error(kind, cells) for cells in grids])
        print("%-12s" % kind + "".join("%10.2e" % error for error in errors) + "    "
              + ", ".join("%.1f" % ratio for ratio in errors[:-1] / errors[1:]))
    return table


def print_stress(grids):
    """Prints the table of stress errors and returns {kind: errors of elements}."""
    print("error of the stress near a stiff ball in tension, relative to the load")
    print("%-12s%8s%10s%8s%8s" % ("", "cells", "elements", "rms", "worst"))
    table = {}
    for kind in KINDS:
        elements, errors, volumes = stress_errors(kind, grids[kind])
        rms = np.sqrt((errors ** 2 * volumes).sum() / volumes.sum())
        print("%-12s%8d%10d%8.3f%8.2f" % (kind, grids[kind], elements, rms, errors.max()))
        table[kind] = errors
    return table


def draw(path, grids, heat, stress):
    """Draws both tables."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for kind in KINDS:
        left.loglog(grids, heat[kind], "o-", color=COLOURS[kind], label=kind)
        errors = np.sort(stress[kind])
        right.plot(errors, 100 * (1 - np.arange(len(errors)) / len(errors)),
                   color=COLOURS[kind], label=kind)
    slope = np.array([grids[0], grids[-1]], dtype=float)
    left.loglog(slope, 0.6 * heat["tetrahedra"][0] * (slope[0] / slope) ** 2, "k:",
                label="second order")
    left.set(xlabel="cells along an edge", ylabel="L2 error", title="Heat, 10 : 1",
             xticks=grids, xticklabels=grids)
    left.minorticks_off()
    right.set(xlabel="error of the stress, relative to the load", yscale="log", xscale="log",
              xlim=(1e-3, None), ylabel="% of elements near the ball above it",
              title="Stiff ball in tension")
    left.legend()
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--quick", action="store_true", help="small meshes: seconds")
    parser.add_argument("--picture", help="picture to write, .png")
    choices = parser.parse_args()
    grids = (6, 12) if choices.quick else (8, 16, 32)
    sizes = (14, 7, 15) if choices.quick else (32, 14, 33)
    heat = print_heat(grids)
    stress = print_stress(dict(zip(KINDS, sizes)))
    if choices.picture:
        draw(choices.picture, grids, heat, stress)


if __name__ == "__main__":
    main()
