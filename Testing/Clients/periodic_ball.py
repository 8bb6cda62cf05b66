"""The periodic case: a ball across the sides of a cube, heated, in a matrix that is cooled.

-div(k grad u) = f on the torus, with k = 10 in the ball and 1 in the block, f = 1 in the ball,
and f such in the block that its integral over the cell is 0.
"""

import os

import numpy as np
import scipy.sparse
import volume_fraction_mesh as vfm

from ball_in_block import BLOCK, PAGE


def make_cell(kind, sides="flat"):
    """Returns the mesh of "hexes" or "tets" in a cell of length 1."""
    fractions = vfm.shapes("sphere radius=0.35 center=0.5,0.5,0.5", 3 * [8],
                           bounds=(0, 1, 0, 1, 0, 1))
    ball = np.roll(next(iter(fractions.values())), (4, 3, 2), (0, 1, 2))
    return getattr(vfm, kind)({"ball": ball, "block": 1 - ball}, periodic="xyz",
                              periodic_sides=sides, spacing=1 / 8)


def sources(mesh):
    """Returns f in the ball and in the block."""
    ball, block = (mesh.volumes()[mesh.material == number].sum() for number in (1, 2))
    return 1.0, -ball / block


def range_on_torus(mesh):
    """Returns max u - min u by scikit-fem, with points replaced by their partners."""
    import skfem
    from skfem.helpers import dot, grad

    solid, inside = mesh.to_skfem(), mesh.material == 1
    basis = skfem.Basis(solid, solid.elem(), intorder=3)
    conductivity, source = (np.where(inside, *values)[:, None] + np.zeros(basis.dx.shape)
                            for values in ((10.0, 1.0), sources(mesh)))
    stiffness = skfem.BilinearForm(lambda u, v, w: w.k * dot(grad(u), grad(v))).assemble(
        basis, k=conductivity)
    load = skfem.LinearForm(lambda v, w: w.f * v).assemble(basis, f=source)
    partners, families = np.unique(mesh.partner, return_inverse=True)
    join = scipy.sparse.csr_matrix((np.ones(len(families)), (np.arange(len(families)), families)))
    u = skfem.solve(*skfem.condense(join.T @ stiffness @ join, join.T @ load, D=np.array([0])))
    return np.ptp(u)


def check_range(mesh, values):
    """Checks max u - min u of a solution on this mesh."""
    found, expected = np.ptp(values), range_on_torus(mesh)
    print("range of u: %.10g, relative difference %.1e" % (found, abs(found / expected - 1)))
    assert abs(found / expected - 1) < 1e-6, (found, expected)


def run_cell_recipe(client, names):
    """Runs the Python code of the page of periodic cells that imports `client`, in `names`."""
    with open(os.path.join(os.path.dirname(PAGE), "periodic.md"), encoding="utf-8") as file:
        blocks = [code for language, code in BLOCK.findall(file.read())
                  if language == "python" and "import %s" % client in code]
    assert len(blocks) == 1, "the page has %d recipes for %s" % (len(blocks), client)
    exec(compile(blocks[0], "recipe " + client, "exec"), names)
