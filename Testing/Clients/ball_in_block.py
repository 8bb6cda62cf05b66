"""The case of all clients: a ball in a block that conducts ten times better, cooled on six sides.

-div(k grad u) = 1 with k = 10 in the ball and 1 in the block, and u = 0 on the sides. The sides
have different areas along x, y and z, and the ball is not in the centre.
"""

import functools
import os
import re
import shutil
import subprocess

import numpy as np
import pytest
import volume_fraction_mesh as vfm

SHAPES = "sphere radius=0.5 center=0.2,0.1,-0.1; box size=2,2.4,1.6 material=2"
HALF = np.array([1.0, 1.2, 0.8])  # half widths of the block
SIDES = ("x_min", "x_max", "y_min", "y_max", "z_min", "z_max")
NAMES = {1: "ball", 2: "block"}
CONDUCTIVITY = {1: 10.0, 2: 1.0}
PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "user",
                    "solvers.md")
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```\n", re.DOTALL | re.MULTILINE)
FILE = re.compile(r"(?:\*\*|//|#|\$|!|;) ([\w./-]+\.?\w+)\n")


@functools.lru_cache(maxsize=None)
def make_mesh(kind):
    """Returns the mesh of "hexes" or "tets"."""
    bounds = np.stack([-HALF, HALF], axis=1).ravel()
    return getattr(vfm, kind)(vfm.shapes(SHAPES, (10, 12, 8), bounds=bounds),
                              names=["ball", "block"])


def fixed_points(points):
    """Returns the numbers of the points on the sides."""
    return np.flatnonzero((np.abs(np.abs(points) - HALF) < 1e-9).any(axis=1))


def solve(points, cells, material, fixed):
    """Returns u at the points, by scikit-fem, with two Gauss points per axis of a hexahedron.

    cells: corners in the order of VTK. material: number per cell. fixed: points where u is 0.
    """
    import skfem
    from skfem.helpers import dot, grad
    from volume_fraction_mesh._convert.to_skfem import HEX_ORDER

    tets = np.shape(cells)[1] == 4
    made = (skfem.MeshTet if tets else skfem.MeshHex)(
        np.ascontiguousarray(np.transpose(points), dtype=float),
        np.ascontiguousarray(np.transpose(cells if tets else np.asarray(cells)[:, HEX_ORDER]),
                             dtype=np.int64))
    basis = skfem.Basis(made, made.elem(), intorder=3)
    conductivity = np.array([CONDUCTIVITY[number] for number in np.asarray(material).tolist()])
    at_points = np.repeat(conductivity[:, None], basis.dx.shape[1], axis=1)
    stiffness = skfem.BilinearForm(lambda u, v, w: w.k * dot(grad(u), grad(v))).assemble(
        basis, k=at_points)
    load = skfem.LinearForm(lambda v, w: v).assemble(basis)
    return skfem.solve(*skfem.condense(stiffness, load, D=np.asarray(fixed)))


@functools.lru_cache(maxsize=None)
def elastic_reference(kind):
    """Returns the greatest u_z of an elastic body with fixed sides under the force (0, 0, 1).

    Young's modulus is 10 in the ball and 1 in the block, Poisson's ratio 0.3.
    """
    import skfem
    from skfem.helpers import ddot, sym_grad, trace

    made = make_mesh(kind).to_skfem()
    basis = skfem.Basis(made, skfem.ElementVector(made.elem()), intorder=3)
    young = np.where(make_mesh(kind).material == 1, 10.0, 1.0)[:, None] + np.zeros(basis.dx.shape)
    stiffness = skfem.BilinearForm(lambda u, v, w: w.e / 1.3 * ddot(
        sym_grad(u), sym_grad(v)) + w.e * 0.3 / 1.3 / 0.4 * trace(sym_grad(u)) * trace(
            sym_grad(v))).assemble(basis, e=young)
    load = skfem.LinearForm(lambda v, w: v[2]).assemble(basis)
    found = skfem.solve(*skfem.condense(stiffness, load, D=basis.get_dofs(list(SIDES))))
    return found[basis.nodal_dofs[2]].max()


@functools.lru_cache(maxsize=None)
def reference(kind):
    """Returns the greatest u on the mesh of this kind, from its arrays."""
    mesh = make_mesh(kind)
    fixed = np.unique(np.concatenate([mesh.facets(name).points.ravel() for name in SIDES]))
    return solve(mesh.points, mesh.cells, mesh.material, fixed).max()


def check_maximum(mesh, values, expected_of=reference):
    """Checks the greatest value of a solution on this mesh."""
    kind = "tets" if mesh.kind == "tetra" else "hexes"
    found, expected = np.max(values), expected_of(kind)
    print("greatest u of %s: %.10g, relative difference %.1e" % (
        kind, found, abs(found / expected - 1)))
    assert abs(found / expected - 1) < 1e-6, (found, expected)


def check_volumes(mesh, found, tolerance=1e-9):
    """Checks volumes by name or number of the material."""
    expected = {name: mesh.volumes()[mesh.material == number].sum()
                for number, name in NAMES.items()}
    found = {NAMES.get(key, str(key).lower()): volume for key, volume in found.items()}
    assert sorted(found) == sorted(expected), sorted(found)
    for name, volume in expected.items():
        assert abs(found[name] / volume - 1) < tolerance, (name, found[name], volume)


def volume_of(points, cells):
    """Returns the sum of the exact volumes of elements; cells: corners in the order of VTK."""
    return vfm._core.element_volumes(np.ascontiguousarray(points, np.float64),
                                     np.ascontiguousarray(cells, np.int64), {}).sum()


def side_faces(mesh, name):
    """Returns the number of faces on a side."""
    return len(mesh.facets(name))


def area_of(name):
    """Returns the area of a side of the block."""
    return float(np.prod(np.delete(2 * HALF, "xyz".index(name[0]))))


def check_side(mesh, name, corners):
    """Checks the faces of a side by coordinates of their corners, shape (faces, corners, 3)."""
    corners = np.asarray(corners)
    axis, sign = "xyz".index(name[0]), 1 if name.endswith("max") else -1
    assert len(corners) == side_faces(mesh, name), (name, len(corners))
    assert np.allclose(corners[..., axis], sign * HALF[axis], rtol=0, atol=1e-12), name
    ends = [corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]]
    if corners.shape[1] == 4:
        ends = [corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]]
    area = np.linalg.norm(np.cross(*ends), axis=1).sum() / 2
    assert abs(area / area_of(name) - 1) < 1e-12, (name, area)


def need_program(name, package):
    """Skips a test without this program. package: of Debian."""
    if not shutil.which(name):
        pytest.skip("there is no program %s: install Debian's %s" % (name, package))


def recipe(client):
    """Returns (language, text) of the code blocks in the section of a client on the page."""
    with open(PAGE, encoding="utf-8") as file:
        sections = re.split(r"^## ", file.read(), flags=re.MULTILINE)
    found = [section for section in sections if section.split("\n", 1)[0].strip() == client]
    assert len(found) == 1, "the page has %d sections %s" % (len(found), client)
    return BLOCK.findall(found[0])


def run_recipe(client, mesh, folder):
    """Runs the recipe of a client in a folder, and returns the names that its Python code sets.

    Blocks of Python use the variable `mesh`. A block whose first line is a comment with the name
    of a file becomes this file. Blocks of bash run.
    """
    names, before = {"mesh": mesh, "np": np, "vfm": vfm, "SIDES": list(SIDES)}, os.getcwd()
    os.chdir(folder)
    try:
        blocks = recipe(client)
        assert blocks, "the recipe %s has no code" % client
        for language, text in blocks:
            file = FILE.match(text)
            if language == "python":
                exec(compile(text, "recipe " + client, "exec"), names)
            elif file:
                os.makedirs(os.path.dirname(file[1]) or ".", exist_ok=True)
                with open(file[1], "w", encoding="utf-8") as out:
                    out.write(text)
            elif language == "bash":
                subprocess.run(["bash", "-euc", text], check=True)
            else:
                raise AssertionError("%s: a block of %s without a file" % (client, language))
    finally:
        os.chdir(before)
    return names
