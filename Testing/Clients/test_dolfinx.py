"""Tests dolfinx: the recipe, and tags and solutions by both routes, files and to_dolfinx().

This file is also the program that runs on the ranks: see the function main.
"""

import json
import os
import shutil
import subprocess
import sys

import numpy as np
import pytest

pytest.importorskip("dolfinx", reason="dolfinx is missing: install Debian's python3-dolfinx")

import ufl  # noqa: E402
from dolfinx import fem  # noqa: E402
from dolfinx.io import XDMFFile  # noqa: E402
from mpi4py import MPI  # noqa: E402
from petsc4py import PETSc  # noqa: E402

from ball_in_block import (CONDUCTIVITY, SIDES, area_of, check_maximum, check_volumes,  # noqa: E402
                           make_mesh, run_recipe)
import flat_cases as flat  # noqa: E402
from periodic_ball import check_range, make_cell, run_cell_recipe, sources  # noqa: E402


def total(form, comm):
    return comm.allreduce(fem.assemble_scalar(fem.form(form)), op=MPI.SUM)


def solve(made, cells, fixed):
    """Returns the greatest u of the case, with u = 0 on the facets with a tag above 0."""
    k = fem.Function(fem.FunctionSpace(made, ("DG", 0)))
    for material, value in CONDUCTIVITY.items():
        k.x.array[cells.find(material)] = value
    space = fem.FunctionSpace(made, ("Lagrange", 1))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    dx = ufl.Measure("dx", made, metadata={"quadrature_degree": 3})
    sides = fem.dirichletbc(PETSc.ScalarType(0),
                            fem.locate_dofs_topological(space, 2, fixed), space)
    found = fem.petsc.LinearProblem(
        k * ufl.dot(ufl.grad(u), ufl.grad(v)) * dx, v * dx, bcs=[sides], petsc_options={
            "ksp_type": "cg", "pc_type": "jacobi", "ksp_rtol": 1e-12}).solve()
    return made.comm.allreduce(found.x.array.max(), op=MPI.MAX)


def measure(made, cells, facets, materials, surfaces):
    """Returns volumes of the materials, areas of the surfaces by name, and the greatest u."""
    dx = ufl.Measure("dx", made, subdomain_data=cells, metadata={"quadrature_degree": 3})
    ds = ufl.Measure("ds", made, subdomain_data=facets)
    dS = ufl.Measure("dS", made, subdomain_data=facets)
    one = fem.Constant(made, PETSc.ScalarType(1))
    fixed = np.concatenate([facets.find(surfaces[name]) for name in SIDES])
    return {
        "volumes": {name: total(one * dx(tag), made.comm) for name, tag in materials.items()},
        "areas": {name: total(one * ds(tag), made.comm) + total(one("+") * dS(tag), made.comm)
                  for name, tag in surfaces.items()},
        "u": solve(made, cells, fixed),
    }


def read_files(path):
    """Returns what to_dolfinx() returns, from the two files."""
    text = XDMFFile.Encoding.ASCII
    with XDMFFile(MPI.COMM_WORLD, path, "r", encoding=text) as file:
        made = file.read_mesh()
        cells = file.read_meshtags(made, "mesh")
        materials = json.loads(file.read_information("MaterialNames", "/Xdmf/Domain/Grid"))
    size = made.topology.dim
    made.topology.create_connectivity(size - 1, size)
    with XDMFFile(MPI.COMM_WORLD, path.replace(".xdmf", "_facets.xdmf"), "r",
                  encoding=text) as file:
        facets = file.read_meshtags(made, "facets")
        surfaces = json.loads(file.read_information("SurfaceNames", "/Xdmf/Domain/Grid"))
    return made, cells, facets, materials, surfaces


def main(route, kind, path):
    """Measures the mesh on all ranks; rank 0 writes the result to a file."""
    import volume_fraction_mesh as vfm

    comm = MPI.COMM_WORLD
    mesh = make_mesh(kind) if comm.rank == 0 else None
    if route == "file" and comm.rank == 0:
        mesh.save(path + ".xdmf")
    comm.barrier()
    made = read_files(path + ".xdmf") if route == "file" else vfm.Mesh.to_dolfinx(mesh, comm)
    found = measure(*made)
    if comm.rank == 0:
        with open(path + ".json", "w", encoding="utf-8") as file:
            json.dump(found, file)


def area_between(mesh, name):
    """Returns the area of facets as dolfinx integrates it: bilinear facets of hexahedra, by two
    Gauss points per axis."""
    corners = mesh.points[mesh.facets(name).points]
    if corners.shape[1] == 3:
        return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0],
                                       corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
    area = 0
    for s in (0.5 - 12**-0.5, 0.5 + 12**-0.5):
        for t in (0.5 - 12**-0.5, 0.5 + 12**-0.5):
            a = (1 - t) * (corners[:, 1] - corners[:, 0]) + t * (corners[:, 2] - corners[:, 3])
            b = (1 - s) * (corners[:, 3] - corners[:, 0]) + s * (corners[:, 2] - corners[:, 1])
            area += np.linalg.norm(np.cross(a, b), axis=1).sum() / 4
    return area


@pytest.mark.parametrize("ranks", [1, 2])
@pytest.mark.parametrize("route", ["file", "arrays"])
def test_tags_and_poisson(mesh, route, ranks, tmp_path):
    mpiexec = shutil.which("mpiexec")
    if not mpiexec:
        pytest.skip("there is no program mpiexec: install Debian's openmpi-bin")
    kind = "tets" if mesh.kind == "tetra" else "hexes"
    path = str(tmp_path / "mesh")
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    subprocess.run([mpiexec, "--oversubscribe", "-n", str(ranks), sys.executable, __file__, route,
                    kind, path], check=True, env=environment)
    with open(path + ".json", encoding="utf-8") as file:
        found = json.load(file)
    check_volumes(mesh, found["volumes"])
    assert sorted(found["areas"]) == sorted([*SIDES, "ball_to_block"])
    for name in SIDES:
        assert abs(found["areas"][name] / area_of(name) - 1) < 1e-12, name
    expected = area_between(mesh, "ball_to_block")
    assert abs(found["areas"]["ball_to_block"] / expected - 1) < 1e-3, (found, expected)
    check_maximum(mesh, found["u"])


def test_recipe(mesh, tmp_path):
    check_maximum(mesh, run_recipe("dolfinx", mesh, tmp_path)["u"].x.array)


@pytest.mark.parametrize("kind, sides", [("hexes", "flat"), ("hexes", "free"), ("tets", "flat")])
def test_periodic(kind, sides):
    """dolfinx_mpc, with a constraint for each copy of a point."""
    pytest.importorskip("dolfinx_mpc",
                        reason="dolfinx_mpc is missing: install Debian's python3-dolfinx-mpc")
    mesh = make_cell(kind, sides)
    solid, cells, _, materials, _ = mesh.to_dolfinx(MPI.COMM_WORLD)
    constant = fem.FunctionSpace(solid, ("DG", 0))
    k, f = fem.Function(constant), fem.Function(constant)
    for name, conductivity, source in zip(("ball", "block"), (10.0, 1.0), sources(mesh)):
        k.x.array[cells.find(materials[name])] = conductivity
        f.x.array[cells.find(materials[name])] = source
    space = fem.FunctionSpace(solid, ("Lagrange", 1))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    dx = ufl.Measure("dx", metadata={"quadrature_degree": 3})
    names = {"mesh": mesh, "np": np, "space": space, "options": {
        "ksp_type": "cg", "pc_type": "jacobi", "ksp_rtol": 1e-12},
             "a": k * ufl.dot(ufl.grad(u), ufl.grad(v)) * dx, "b": f * v * dx}
    run_cell_recipe("dolfinx_mpc", names)
    assert names["periodic"].num_local_slaves == len(mesh.points) - len(np.unique(mesh.partner))
    check_range(mesh, names["u"].x.array)


def error_in_plane(made, fixed):
    """Returns the error in L2 of u of the case of flat_cases, with u = 0 on facets."""
    space = fem.FunctionSpace(made, ("Lagrange", 1))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    x = ufl.SpatialCoordinate(made)
    exact = ufl.sin(np.pi * x[0]) * ufl.sin(np.pi * x[1])
    dx = ufl.Measure("dx", made, metadata={"quadrature_degree": 4})
    sides = fem.dirichletbc(PETSc.ScalarType(0),
                            fem.locate_dofs_topological(space, 1, fixed), space)
    found = fem.petsc.LinearProblem(
        ufl.dot(ufl.grad(u), ufl.grad(v)) * dx, 2 * np.pi ** 2 * exact * v * dx, bcs=[sides],
        petsc_options={"ksp_type": "cg", "pc_type": "jacobi", "ksp_rtol": 1e-12}).solve()
    return np.sqrt(total((found - exact) ** 2 * dx, made.comm))


@pytest.mark.parametrize("kind", ["hexes", "tets"])
@pytest.mark.parametrize("route", ["file", "arrays"])
def test_planes(route, kind, tmp_path):
    """Tags, areas and lengths in a plane; the error in L2 falls by the square of the width."""
    errors = []
    for cells in (8, 16, 32):
        mesh = flat.make_square(kind, cells)
        mesh.save(tmp_path / "mesh.xdmf")
        made, tags, facets, materials, surfaces = (
            read_files(str(tmp_path / "mesh.xdmf")) if route == "file"
            else mesh.to_dolfinx(MPI.COMM_WORLD))
        assert made.geometry.dim == made.topology.dim == 2
        dx = ufl.Measure("dx", made, subdomain_data=tags)
        ds = ufl.Measure("ds", made, subdomain_data=facets)
        dS = ufl.Measure("dS", made, subdomain_data=facets)
        one = fem.Constant(made, PETSc.ScalarType(1))
        disc = flat.disc_fractions(cells).mean()
        for name, expected in zip(flat.NAMES, (disc, 1 - disc)):
            assert np.isclose(total(one * dx(materials[name]), made.comm), expected, rtol=1e-6)
        for name in flat.SIDES:
            assert np.isclose(total(one * ds(surfaces[name]), made.comm), 1.0, rtol=1e-12)
        ends = np.diff(mesh.points[mesh.facets("disc_to_square").points], axis=1)[:, 0]
        length = total(one("+") * dS(surfaces["disc_to_square"]), made.comm)
        assert np.isclose(length, np.linalg.norm(ends, axis=1).sum(), rtol=1e-12)
        errors.append(error_in_plane(
            made, np.concatenate([facets.find(surfaces[name]) for name in flat.SIDES])))
    found = flat.orders(errors)
    print("%s, %s: errors %s, orders %s" % (
        route, kind, " ".join("%.3g" % error for error in errors),
        " ".join("%.2f" % order for order in found)))
    assert (np.abs(found - 2) < 0.25).all(), found


if __name__ == "__main__":
    main(*sys.argv[1:])
