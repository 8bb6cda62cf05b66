"""Computes effective stiffnesses of periodic cells by CalculiX: a laminate, spheres, grains; and
the effective conductivity of the spheres by scikit-fem.

usage: python Examples/homogenise.py [--quick] [--folder DIR] [--picture homogenise.png]

The Python package meshes one period of a material, and writes the mesh and the equations between
points on opposite sides as .inp. In six steps, a force at a reference node (REF_X, REF_Y, REF_Z)
applies a mean stress of 1. The displacements of these nodes are the mean strains times the periods:
the effective compliance. Prints its inverse, the stiffness, as a 6 x 6 matrix (xx, yy, zz, yz, xz,
xy).

Laminate: two layers. The exact stiffness has a closed form.
Spheres: a cubic array, 20 % by volume, ten times and a tenth as stiff as the matrix, on two grids.
The reference is computed by Examples/voxel_stiffness.py on 128^3 voxels. The conductivity of the
same array, with the same contrasts, is compared with a published series (conductivity_of_series).
Grains: 50 Voronoi cells of copper that continue across the sides, each with its own orientation.
The bulk modulus of such a polycrystal is exactly that of the crystal (Hill, Proc. Phys. Soc. A 65
(1952) 349-354); its shear modulus is between the bounds of Reuss and Voigt.

The picture shows the grains of one cell and of eight. Requires volume_fraction_mesh and ccx (Debian
package calculix-ccx), scikit-fem for the conductivity, and pyvista for the picture. --quick uses
smaller meshes.
"""
import argparse
import os
import tempfile

import numpy as np

import calculix
import volume_fraction_mesh as vfm

# Components xx, yy, zz, yz, xz, xy: the direction of a force or displacement, and the axis of its
# reference node.
PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
PLACES = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])  # of the components in PAIRS
ABAQUS = (0, 1, 2, 5, 4, 3)  # xx, yy, zz, xy, xz, yz
# Node 1, which no equation eliminates, and the rotation of the cell.
FIXED = ("1, 1, 3", "REF_X, 2, 3", "REF_Y, 3, 3")
LAYERS = {"stiff": (10.0, 0.2, 0.3), "soft": (1.0, 0.4, 0.7)}  # modulus, Poisson's ratio, share
SPHERES, POISSON = 0.2, 0.3  # volume fraction, Poisson's ratio of both materials
# C11, C12, C44 relative to the modulus of the matrix: voxel_stiffness.py --cells 128 --contrast ..
REFERENCES = {10.0: (1.88041, 0.72316, 0.52418), 0.1: (0.94977, 0.36802, 0.26919)}
COPPER = (168.4, 121.4, 75.4)  # C11, C12, C44, GPa
GRAINS, PARTS = 50, 3  # PARTS: points per cell and axis, for fractions of grains


def isotropic(young, poisson):
    """Returns the stiffness of a material."""
    shear = young / 2 / (1 + poisson)
    first = young * poisson / (1 + poisson) / (1 - 2 * poisson)
    return cubic(first + 2 * shear, first, shear)


def cubic(c11, c12, c44):
    stiffness = np.diag([c11 - c12] * 3 + [c44] * 3)
    stiffness[:3, :3] += c12
    return stiffness


def rotated(stiffness, axes):
    """Returns the stiffness of a crystal. axes: matrix with its axes as columns."""
    tensor = stiffness[PLACES][:, :, PLACES]
    tensor = np.einsum("ai,bj,ck,dl,ijkl->abcd", axes, axes, axes, axes, tensor)
    first, second = np.transpose(PAIRS)
    return tensor[first, second][:, first, second]


def write_deck(path, mesh, stiffnesses):
    """Writes the mesh, and a deck with a step per component of the mean stress.

    stiffnesses: one per material, in the order of their ids."""
    mesh.save(os.path.join(os.path.dirname(path), "cell.inp"))
    lines = ["*INCLUDE, INPUT=cell.inp"]
    for number, stiffness in enumerate(stiffnesses, 1):
        ordered = stiffness[np.ix_(ABAQUS, ABAQUS)]
        constants = [calculix.number(ordered[i, j]) for j in range(6) for i in range(j + 1)]
        lines += ["*MATERIAL, NAME=M%d" % number, "*ELASTIC, TYPE=ANISO"]
        lines += [", ".join(constants[at:at + 8]) for at in range(0, 21, 8)]
        lines += ["*SOLID SECTION, ELSET=EB%d, MATERIAL=M%d" % (number, number)]
    lengths = mesh.fields["PeriodLengths"]
    for direction, axis in PAIRS:
        force = lengths.prod() / lengths[axis]
        lines += ["*STEP", "*STATIC", "*BOUNDARY", *FIXED, "*CLOAD, OP=NEW", "REF_%s, %d, %s" % (
            "XYZ"[axis], direction + 1, calculix.number(force))]
        for name in "XYZ":
            lines += ["*NODE PRINT, NSET=REF_" + name, "U"]
        lines += ["*END STEP"]
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines + [""]))


def effective_stiffness(mesh, stiffnesses, folder):
    """Returns the effective stiffness, and the asymmetry of its inverse relative to the largest
    value."""
    path = os.path.join(folder, "load.inp")
    write_deck(path, mesh, stiffnesses)
    calculix.run(path, seconds=3600, threads=os.cpu_count())
    moved = np.reshape([rows[0, 1:] for _, _, rows in calculix.read_tables(path)], (6, 3, 3))
    directions, axes = np.transpose(PAIRS)
    strains = moved[:, axes, directions] / mesh.fields["PeriodLengths"][axes]
    compliance = (strains + strains.T) / 2
    return np.linalg.inv(compliance), abs(strains - strains.T).max() / compliance.max()


def print_stiffness(title, mesh, stiffness, asymmetry):
    print("%s: %d hexahedra, asymmetry %.0e" % (title, len(mesh), asymmetry))
    for row in stiffness:
        print("  " + "".join("%12.6f" % (value + 0.0) for value in np.round(row, 6)))


def laminate_mesh(cells):
    """Returns layers across z; the interface is inside cells, and the soft layer repeats."""
    ends = np.arange(cells + 1) / cells
    stiff = np.clip((LAYERS["stiff"][2] + 0.25 - ends[:-1]) * cells, 0, 1)
    stiff -= np.clip((0.25 - ends[:-1]) * cells, 0, 1)
    stiff = np.broadcast_to(stiff, (4, 4, cells))
    return vfm.hexes({"stiff": stiff, "soft": 1 - stiff}, periodic="xyz", spacing=1 / cells)


def laminate_stiffness():
    """Returns the closed form: strains in the layers and tractions across them are uniform."""
    young, poisson, share = np.transpose(list(LAYERS.values()))
    shear = young / 2 / (1 + poisson)
    first = young * poisson / (1 + poisson) / (1 - 2 * poisson)
    across = first + 2 * shear

    def mean(values):
        return (share * values).sum()

    c33, ratio = 1 / mean(1 / across), mean(first / across)
    exact = np.diag([mean(across - first ** 2 / across) + c33 * ratio ** 2] * 2
                    + [c33] + [1 / mean(1 / shear)] * 2 + [mean(shear)])
    exact[0, 1] = exact[1, 0] = mean(first - first ** 2 / across) + c33 * ratio ** 2
    exact[:2, 2] = exact[2, :2] = c33 * ratio
    return exact


def spheres_mesh(cells):
    """Returns a sphere at the corner of the cell."""
    radius = (SPHERES * 3 / 4 / np.pi) ** (1 / 3)
    sphere = vfm.shapes("sphere radius=%.15g center=0.5,0.5,0.5" % radius, cells,
                        bounds=[0, 1] * 3)["Material1"]
    sphere = np.roll(sphere, cells // 2, axis=(0, 1, 2))
    return vfm.hexes({"sphere": sphere, "matrix": 1 - sphere}, periodic="xyz",
                     periodic_sides="free", spacing=1 / cells)


def grains_mesh(cells):
    """Returns Voronoi cells of random points and of their copies."""
    points = np.random.default_rng(5).random((GRAINS, 3))
    axis = (np.arange(cells * PARTS) + 0.5) / (cells * PARTS)
    nearest = np.full((len(axis),) * 3, np.inf)
    labels = np.zeros(nearest.shape, int)
    for grain, point in enumerate(points):
        x, y, z = (((axis - own + 0.5) % 1 - 0.5) ** 2 for own in point)
        distance = x[:, None, None] + y[:, None] + z
        labels[distance < nearest] = grain
        nearest = np.minimum(nearest, distance)
    shape = (cells, PARTS) * 3
    fractions = [(labels == grain).reshape(shape).mean(axis=(1, 3, 5)) for grain in range(GRAINS)]
    return vfm.hexes(fractions, periodic="xyz", periodic_sides="free", spacing=1 / cells)


def moduli(stiffness):
    """Returns the bulk and shear modulus of the average over all orientations (Voigt)."""
    bulk = stiffness[:3, :3].sum() / 9
    return bulk, (stiffness[:3, :3].trace() - 3 * bulk) / 10 + stiffness[3:, 3:].trace() / 5


def run_laminate(cells, folder):
    mesh = laminate_mesh(cells)
    found, asymmetry = effective_stiffness(
        mesh, [isotropic(young, poisson) for young, poisson, _ in LAYERS.values()], folder)
    print_stiffness("laminate", mesh, found, asymmetry)
    exact = laminate_stiffness()
    print("  largest error, relative to the largest value: %.1e\n" % (
        abs(found - exact).max() / exact.max()))


def run_spheres(cells, contrast, folder):
    mesh = spheres_mesh(cells)
    found, asymmetry = effective_stiffness(
        mesh, [isotropic(contrast, POISSON), isotropic(1.0, POISSON)], folder)
    print_stiffness("spheres %g : 1, %d cells" % (contrast, cells), mesh, found, asymmetry)
    c11, c12, c44 = found[:3, :3].trace() / 3, found[0, 1:3].mean(), found[3:, 3:].trace() / 3
    print("  C11 %.5f, C12 %.5f, C44 %.5f; errors %s\n" % (c11, c12, c44, ", ".join(
        "%+.2f %%" % (100 * (value / known - 1))
        for value, known in zip((c11, c12, c44), REFERENCES[contrast]))))


def conductivity_of_series(share, contrast):
    """Returns the conductivity of a simple cubic array of spheres relative to that of the matrix.

    A. S. Sangani and A. Acrivos, Proc. R. Soc. Lond. A 386 (1983) 263-275."""
    first, second, third, fourth, fifth = (
        (contrast - 1) / (contrast + 2 * i / (2 * i - 1)) for i in range(1, 6))
    pole = 1.305 * second * share ** (10 / 3) * (1 + 0.231 * third * share ** (11 / 3)) / (
        1 - 0.405 * second * share ** (7 / 3))
    return 1 + 3 * share / (1 / first - share - pole - 0.0723 * third * share ** (14 / 3)
                            - 0.153 * fourth * share ** 6 - 0.0105 * fifth * share ** (22 / 3))


def effective_conductivity(mesh, conductivities):
    """Returns the mean flux along x for a mean gradient of 1. conductivities: one per material."""
    import scipy.sparse
    import scipy.sparse.linalg
    import skfem
    from skfem.helpers import dot, grad
    solid = mesh.to_skfem()
    basis = skfem.Basis(solid, solid.elem(), intorder=3)
    k = np.asarray(conductivities)[mesh.material - 1][:, None] + np.zeros(basis.dx.shape)
    matrix = skfem.BilinearForm(lambda u, v, w: w.k * dot(grad(u), grad(v))).assemble(basis, k=k)
    load = skfem.LinearForm(lambda v, w: -w.k * grad(v)[0]).assemble(basis, k=k)
    partners, numbers = np.unique(mesh.partner, return_inverse=True)  # copies have one value
    join = scipy.sparse.csr_matrix((np.ones(len(numbers)), (np.arange(len(numbers)), numbers)))
    matrix, load = (join.T @ matrix @ join).tocsr(), join.T @ load
    scale = scipy.sparse.diags(1 / matrix.diagonal())
    u, failed = scipy.sparse.linalg.cg(matrix, load, rtol=1e-10, M=scale)
    if failed:
        raise RuntimeError("no convergence")
    return ((k * basis.dx).sum() - u @ load) / mesh.fields["PeriodLengths"].prod()


def run_conduction(cells, contrast):
    found = effective_conductivity(spheres_mesh(cells), (contrast, 1.0))
    known = conductivity_of_series(SPHERES, contrast)
    print("spheres %g : 1, %d cells: conductivity %.5f, series %.5f, error %+.2f %%\n" % (
        contrast, cells, found, known, 100 * (found / known - 1)))


def run_grains(cells, folder):
    """Returns the mesh."""
    mesh = grains_mesh(cells)
    turns, _ = np.linalg.qr(np.random.default_rng(6).normal(size=(GRAINS, 3, 3)))
    crystal = cubic(*COPPER)
    found, asymmetry = effective_stiffness(mesh, [rotated(crystal, turn) for turn in turns], folder)
    print_stiffness("%d grains, GPa" % mesh.fragment.max(), mesh, found, asymmetry)
    (bulk, shear), (exact, upper) = moduli(found), moduli(crystal)
    lower = 5 / (4 / (COPPER[0] - COPPER[1]) + 3 / COPPER[2])
    print("  bulk modulus %.5f GPa, error %.1e; shear modulus %.2f GPa, bounds %.2f and %.2f" % (
        bulk, abs(bulk / exact - 1), shear, lower, upper))
    return mesh


def draw(mesh, path):
    """Saves a picture of a cell, and of two by two by two cells."""
    import pyvista
    from PIL import Image
    plotter = pyvista.Plotter(off_screen=True, shape=(1, 2), window_size=(860, 420), border=False)
    surface = mesh.to_pyvista().extract_surface(algorithm="dataset_surface")
    steps = np.stack(np.meshgrid(*[[0, 1]] * 3), axis=-1).reshape(-1, 3)
    for column, places in enumerate((steps[:1], steps)):
        plotter.subplot(0, column)
        for place in places:
            plotter.add_mesh(surface.translate(place * mesh.fields["PeriodLengths"]),
                             scalars="MaterialId", cmap="tab20", show_edges=column == 0,
                             line_width=0.5, ambient=0.25, show_scalar_bar=False)
        plotter.camera_position = "iso"
        plotter.camera.zoom(1.05)
    image = Image.fromarray(plotter.screenshot(return_img=True))
    image.quantize(96, dither=Image.Dither.NONE).save(path, optimize=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="smaller meshes")
    parser.add_argument("--folder", help="keep the files of CalculiX for the grains")
    parser.add_argument("--picture", metavar="FILE", help="save a picture of the grains, .png")
    arguments = parser.parse_args()
    spheres, grains = ((8, 12), 12) if arguments.quick else ((12, 24), 20)
    with tempfile.TemporaryDirectory() as folder:
        run_laminate(10, folder)
        for contrast in REFERENCES:
            for cells in spheres:
                run_spheres(cells, contrast, folder)
                run_conduction(cells, contrast)
        if arguments.folder:
            os.makedirs(arguments.folder, exist_ok=True)
        mesh = run_grains(grains, arguments.folder or folder)
    if arguments.picture:
        draw(mesh, arguments.picture)


if __name__ == "__main__":
    main()
