"""From a topology optimisation to a body, and to a second analysis by CalculiX.

usage: python Examples/topology_body.py [--cells N] [--steps N] [--folder DIR]

Optimises a cantilever by SIMP (Sigmund, Struct. Multidisc. Optim. 21 (2001) 120-127): densities of
hexahedral cells, stiffness E = density^3, 40 % of the volume, the least compliance. The densities
have grey cells; other programs' fields of densities enter at `make_body`.

The body is where the densities, interpolated between the centres of cells, exceed an iso value. The
iso value is moved until the body has the volume of the densities. The Python package meshes the
fractions of the body in cells of half the width. CalculiX then computes its compliance under the
same load, with the full stiffness everywhere. It is below that of the densities, whose grey cells
are weak for their volume, and near that of the fractions as voxels of that stiffness. Prints
volumes, iso value, compliances and the sum of the reactions.

Requires volume_fraction_mesh, scipy, and ccx (Debian package calculix-ccx).
"""
import argparse
import os

import numpy as np
import scipy.ndimage
import scipy.sparse
import scipy.sparse.linalg

import calculix
import volume_fraction_mesh as vfm

SHAPE = (3, 1.5, 0.5)  # lengths along x, y, z
SHARE, POWER, LEAST, POISSON = 0.4, 3, 1e-3, 0.3
FILTER = 0.45  # standard deviation in cells
FINER, SAMPLES = 2, 4  # cells of the body per cell of densities, samples per cell of the body
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                    [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])


def cube_stiffness():
    """Returns the stiffness of a cube of width 1 and Young's modulus 1, (24, 24)."""
    first = POISSON / (1 + POISSON) / (1 - 2 * POISSON)
    shear = 0.5 / (1 + POISSON)
    law = np.diag([2 * shear] * 3 + [shear] * 3)
    law[:3, :3] += first
    total = np.zeros((24, 24))
    signs = 2 * CORNERS - 1
    for point in signs / np.sqrt(3):
        factors = (1 + signs * point) / 2
        slopes = np.stack([signs[:, a] * factors[:, (a + 1) % 3] * factors[:, (a + 2) % 3]
                           for a in range(3)])
        strain = np.zeros((6, 8, 3))
        for row, (a, b) in enumerate(((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))):
            strain[row, :, a] += slopes[b]
            if a != b:
                strain[row, :, b] += slopes[a]
        strain = strain.reshape(6, 24)
        total += strain.T @ law @ strain / 8
    return total


class Cantilever:
    """Cells of unit stiffness between a fixed side, x_min, and a load -y on the side x_max."""

    def __init__(self, cells):
        self.cells = cells
        nodes = np.arange(np.prod(np.add(cells, 1))).reshape(np.add(cells, 1))
        place = np.stack(np.meshgrid(*map(np.arange, cells), indexing="ij"), -1).reshape(-1, 1, 3)
        corners = nodes[tuple(np.moveaxis(place + CORNERS, -1, 0))]
        self.unknowns = (3 * corners[:, :, None] + np.arange(3)).reshape(-1, 24)
        self.free = np.setdiff1d(np.arange(3 * nodes.size), 3 * nodes[0].ravel()[:, None]
                                 + np.arange(3))
        share = np.ones(nodes.shape[1:])
        share[[0, -1]] *= 0.5
        share[:, [0, -1]] *= 0.5
        self.load = np.zeros(3 * nodes.size)
        self.load[3 * nodes[-1].ravel() + 1] = -share.ravel() / share.sum()
        self.stiffness = cube_stiffness()
        self.rows, self.columns = np.repeat(self.unknowns, 24), np.tile(self.unknowns, 24).ravel()

    def energies(self, moduli, width):
        """Returns the energy of each cell at modulus 1, and the compliance."""
        values = (moduli.ravel()[:, None, None] * self.stiffness * width).ravel()
        matrix = scipy.sparse.csc_matrix((values, (self.rows, self.columns)))
        inner = matrix[self.free][:, self.free]
        u = np.zeros(len(self.load))
        u[self.free] = scipy.sparse.linalg.spsolve(inner, self.load[self.free])
        of_cells = u[self.unknowns]
        energies = np.einsum("ci,ij,cj->c", of_cells, self.stiffness * width, of_cells)
        return energies.reshape(self.cells), self.load @ u


def optimise(cells, steps, width):
    """Returns the densities and their compliance."""
    problem, density = Cantilever(cells), np.full(cells, SHARE)
    density[-1] = 1  # the side of the load stays full
    for _ in range(steps):
        energies, _ = problem.energies(np.maximum(density, LEAST) ** POWER, width)
        gain = POWER * density ** (POWER - 1) * energies
        gain = scipy.ndimage.gaussian_filter(density * gain, FILTER) / np.maximum(density, 0.01)
        low, high = 0.0, gain.max() * 1e3
        for _ in range(100):
            middle = 0.5 * (low + high)
            changed = np.clip(density * np.sqrt(gain / middle), density - 0.2, density + 0.2)
            changed = np.clip(changed, LEAST, 1.0)
            changed[-1] = 1
            low, high = (middle, high) if changed.mean() > SHARE else (low, middle)
        density = changed
    return density, problem.energies(np.maximum(density, LEAST) ** POWER, width)[1]


def make_body(density, width):
    """Returns the fractions of the body in finer cells, their width, and the iso value."""
    count = FINER * SAMPLES
    places = [(np.arange(n * count) + 0.5) / count - 0.5 for n in density.shape]
    fine = scipy.ndimage.map_coordinates(density, np.meshgrid(*places, indexing="ij"), order=1,
                                         mode="nearest")
    inside = int(round(density.sum() * count ** 3))  # samples that the body has
    iso = np.partition(fine.ravel(), -inside)[-inside]
    shape = [length for n in density.shape for length in (n * FINER, SAMPLES)]
    body = (fine >= iso).reshape(shape).mean(axis=(1, 3, 5))
    return body, width / FINER, iso


def analyse(mesh, folder):
    """Returns the compliance of the mesh under the load, and the sum of the reactions."""
    mesh.save(os.path.join(folder, "body.inp"))
    faces = mesh.facets("x_max").points
    a, b, c, d = np.moveaxis(mesh.points[faces], 1, 0)
    areas = 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)
    forces = np.bincount(faces.ravel(), np.repeat(areas / 4, 4), len(mesh.points)) / areas.sum()
    lines = ["*INCLUDE, INPUT=body.inp", "*MATERIAL, NAME=BODY", "*ELASTIC",
             "1, %s" % POISSON, "*SOLID SECTION, ELSET=EALL, MATERIAL=BODY", "*STEP", "*STATIC",
             "*BOUNDARY", "X_MIN, 1, 3", "*CLOAD"]
    lines += ["%d, 2, %s" % (node + 1, calculix.number(-forces[node]))
              for node in np.flatnonzero(forces)]
    lines += ["*NODE PRINT, NSET=NALL", "U", "*NODE PRINT, NSET=X_MIN, TOTALS=ONLY", "RF",
              "*END STEP", ""]
    path = os.path.join(folder, "load.inp")
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines))
    calculix.run(path, seconds=3600)
    results = calculix.read_results(path)
    return -forces @ results.displacements[:, 1], results.reactions["X_MIN"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=8, help="cells per unit length, default 8")
    parser.add_argument("--steps", type=int, default=30, help="steps of SIMP, default 30")
    parser.add_argument("--folder", default="out/topology", help="folder for the files")
    arguments = parser.parse_args()
    os.makedirs(arguments.folder, exist_ok=True)
    width = 1 / arguments.cells
    cells = tuple(int(round(length * arguments.cells)) for length in SHAPE)
    density, compliance = optimise(cells, arguments.steps, width)
    body, fine, iso = make_body(density, width)
    # Loose cells carry nothing, and CalculiX needs one body.
    mesh = vfm.hexes({"body": body}, spacing=fine, minimum_region_cells=50)
    volume = density.sum() * width ** 3
    print("densities: volume %.6f, compliance %.4f" % (volume, compliance))
    print("body: volume %.6f, iso value %.4f, %d hexahedra in %d piece(s), scaled Jacobian at "
          "least %.2f" % (mesh.volumes().sum(), iso, len(mesh), mesh.fragment.max(),
                          mesh.quality.min()))
    found, reaction = analyse(mesh, arguments.folder)
    _, voxels = Cantilever(body.shape).energies(np.maximum(body, LEAST ** POWER), fine)
    print("compliance of the body %.4f, of its fractions as voxels %.4f; reactions %s" % (
        found, voxels, ", ".join("%.6f" % (value + 0.0) for value in np.round(reaction, 6))))


if __name__ == "__main__":
    main()
