"""Tests what solvers need: neighbours, named facets, separate materials, and scikit-fem."""

import numpy as np
import pytest

import volume_fraction_mesh as vfm
from fields import N

BALL_IN_BLOCK = "sphere radius=0.5; box size=2,2,2 material=2"
SIDES = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"]


def ball_in_block(make, cells=N):
    fractions = vfm.shapes(BALL_IN_BLOCK, cells, bounds=[-1, 1] * 3)
    return make(fractions, names=["ball", "block"])


BLOCKS = [ball_in_block(make) for make in (vfm.hexes, vfm.tets)]
BOTH = pytest.mark.parametrize("mesh", BLOCKS, ids=["hexes", "tets"])


def area_vectors(corners):
    """Returns the areas of faces as vectors along their normals."""
    last = corners[:, 3] if corners.shape[1] == 4 else corners[:, 2]
    diagonals = (corners[:, 2] - corners[:, 0], last - corners[:, 1])
    if corners.shape[1] == 3:
        diagonals = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.cross(*diagonals) / 2


def enclosed_volume(mesh, facets):
    """Returns the volume inside a closed surface, by the divergence theorem, with faces of four
    corners as two triangles in the mean of both ways to cut them."""
    cuts = ([[0, 1, 2]] if facets.points.shape[1] == 3
            else [[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]])
    volumes = [np.einsum("fa,fa->", mesh.points[facets.points[:, cut[0]]], area_vectors(
        mesh.points[facets.points[:, cut]])) / 3 for cut in cuts]
    return sum(volumes) / (2 if len(cuts) > 1 else 1)


@BOTH
def test_neighbours(mesh):
    behind = mesh.neighbours()
    assert behind.dtype == np.int64 and behind.shape == (len(mesh), 6 if mesh is BLOCKS[0] else 4)
    elements, sides = np.nonzero(behind >= 0)
    others = behind[elements, sides]
    assert (behind[others] == elements[:, None]).any(axis=1).all()
    common = [len(set(mesh.cells[a]) & set(mesh.cells[b]))
              for a, b in zip(elements[::7], others[::7])]
    assert set(common) == {4 if mesh is BLOCKS[0] else 3}
    assert (behind < 0).sum() == sum(len(mesh.facets(name)) for name in SIDES)


@BOTH
def test_facets(mesh):
    sets = mesh.facet_sets()
    assert list(sets) == [*SIDES, "ball_to_block", "block_to_ball", "interfaces", "ball_skin",
                          "block_skin"]
    assert np.array_equal(sets["interfaces"].points, sets["ball_to_block"].points)
    for number, name in enumerate(SIDES):
        facets, axis, sign = sets[name], number // 2, 2 * (number % 2) - 1
        assert np.all(mesh.points[facets.points][..., axis] == sign)
        normal = area_vectors(mesh.points[facets.points]).sum(axis=0)
        assert np.allclose(normal, 4 * sign * np.eye(3)[axis])
    one, other = sets["ball_to_block"], sets["block_to_ball"]
    assert set(mesh.material[one.elements]) == {1} and set(mesh.material[other.elements]) == {2}
    assert {tuple(row) for row in np.sort(one.points).tolist()} == {
        tuple(row) for row in np.sort(other.points).tolist()}
    outward = np.einsum("fa,fa->f", area_vectors(mesh.points[one.points]),
                        mesh.points[one.points].mean(axis=1))
    assert (outward > 0).all()
    assert (mesh.neighbours()[one.elements, one.sides] >= 0).all()
    with pytest.raises(ValueError, match="no facets 'x_mid'. Their names: x_min, "):
        mesh.facets("x_mid")


@BOTH
def test_facets_are_the_sets_of_files(mesh, tmp_path):
    netcdf = pytest.importorskip("netCDF4")
    mesh.save(tmp_path / "mesh.e")
    with netcdf.Dataset(tmp_path / "mesh.e") as data:
        data.set_auto_mask(False)
        names = [bytes(n).rstrip(b"\0").decode() for n in data["ss_names"][:]]
        counts = [len(data["elem_ss%d" % (1 + at)]) for at in range(len(names))]
    assert dict(zip(names, counts)) == {
        name: len(facets) for name, facets in mesh.facet_sets().items()}


@BOTH
def test_skin(mesh):
    for name, label in (("ball", 1), ("block", 2)):
        facets = mesh.skin(name)
        assert np.array_equal(facets.points, mesh.skin(label).points)
        assert np.array_equal(facets.points, mesh.facets(name + "_skin").points)
        assert np.isclose(enclosed_volume(mesh, facets),
                          mesh.volumes()[mesh.material == label].sum(), rtol=1e-12)
    with pytest.raises(ValueError, match="no material 'bell'. Its materials: 1 'ball', 2 'block'"):
        mesh.skin("bell")


@BOTH
def test_separate(mesh):
    parts = mesh.separate()
    assert np.array_equal(parts.original[parts.cells], mesh.cells)
    assert np.array_equal(parts.points, mesh.points[parts.original])
    assert (parts.material[parts.cells] == mesh.material[:, None]).all()
    common = np.intersect1d(mesh.cells[mesh.material == 1], mesh.cells[mesh.material == 2])
    assert len(parts.points) == len(mesh.points) + len(common) and len(common) > 0
    facets = mesh.facets("ball_to_block")
    corners = parts.corners(facets)
    assert np.array_equal(parts.original[corners], facets.points)
    assert set(parts.material[corners].ravel()) == {1}


@BOTH
def test_skfem_mesh(mesh):
    """Volumes show the order of corners: VTK's order gives another sum."""
    skfem = pytest.importorskip("skfem")
    made = mesh.to_skfem()
    basis = skfem.Basis(made, made.elem(), intorder=4)
    volumes = basis.dx.sum(axis=1)
    assert np.allclose(volumes, mesh.volumes(), rtol=1e-10)
    assert {name: set(mesh.material[cells]) for name, cells in made.subdomains.items()} == {
        "ball": {1}, "block": {2}}
    assert list(made.boundaries) == list(mesh.facet_sets())
    for name, facets in mesh.facet_sets().items():
        side = skfem.FacetBasis(made, made.elem(), facets=name, intorder=4)
        normals = np.einsum("afq,fq->a", side.normals, side.dx)
        assert np.allclose(normals, area_vectors(mesh.points[facets.points]).sum(axis=0),
                           atol=1e-10), name
        assert np.array_equal(side.tind, facets.elements), name
    flux = skfem.FacetBasis(made, made.elem(), facets="ball_to_block", intorder=4)
    volume = np.einsum("afq,afq,fq->", flux.normals, flux.global_coordinates(),
                       flux.dx) / 3
    assert np.isclose(volume, mesh.volumes()[mesh.material == 1].sum(), rtol=1e-6)


def solve_poisson(mesh):
    """Returns the L2 error of -div(k grad u) = f with u of the six sides, for a solution whose
    gradient jumps at the ball: k is 10 in it, 1 around it."""
    import skfem
    from skfem.helpers import dot, grad

    made = mesh.to_skfem()
    basis = skfem.Basis(made, made.elem(), intorder=4)
    inside = basis.with_element(skfem.ElementTetP0() if mesh.kind == "tetra"
                                else skfem.ElementHex0())
    conductivity = inside.zeros() + 1.0
    conductivity[inside.get_dofs(elements="ball").flatten()] = 10.0

    def exact(x):
        square = (x * x).sum(axis=0)
        return np.where(square < 0.25, square / 10, square - 0.225)

    stiffness = skfem.BilinearForm(lambda u, v, w: w.k * dot(grad(u), grad(v))).assemble(
        basis, k=inside.interpolate(conductivity))
    load = skfem.LinearForm(lambda v, w: -6.0 * v).assemble(basis)
    on_sides = np.unique(np.concatenate([basis.get_dofs(name).flatten() for name in SIDES]))
    values = basis.zeros()
    values[on_sides] = exact(basis.doflocs[:, on_sides])
    solution = skfem.solve(*skfem.condense(stiffness, load, x=values, D=on_sides))
    return np.sqrt(skfem.Functional(lambda w: (w.u - exact(w.x)) ** 2).assemble(
        basis, u=basis.interpolate(solution)))


@pytest.mark.parametrize("make", [vfm.hexes, vfm.tets])
def test_poisson_converges(make):
    """Halving the cells divides the error by about 4."""
    pytest.importorskip("skfem")
    coarse, fine = (solve_poisson(ball_in_block(make, cells)) for cells in (8, 16))
    assert fine < 0.03 and 3.0 < coarse / fine < 5.5, (coarse, fine)


@BOTH
def test_plot(mesh, tmp_path):
    pyvista = pytest.importorskip("pyvista")
    mesh.plot(clip="x", path=tmp_path / "mesh.png")
    pixels = pyvista.read(tmp_path / "mesh.png").active_scalars
    assert len(np.unique(pixels, axis=0)) > 10
    with pytest.raises(ValueError, match="no array 'pressure'. Its arrays: MaterialId, "):
        mesh.plot("pressure", path=tmp_path / "other.png")
    assert not (tmp_path / "other.png").exists()
