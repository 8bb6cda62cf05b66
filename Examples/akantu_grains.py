"""Breaks a polycrystal along its grains with cohesive elements of Akantu.

usage: python akantu_grains.py [--tets] [--split] [--grains 12] [--cells 10] [--rate 0.3]
       [--steps 1500] [--courant 0.2] [--picture FILE.png]

The Python package meshes grains that fill a block of 2 mm and writes them as .msh, version 2.2. The
block expands by a velocity in proportion to the distance from its middle. Akantu (PyPI) reads the
file and inserts cohesive elements where the traction reaches the strength, but only in the groups
of faces between two grains, which have names such as Grain1_to_Grain2. Without these groups, every
face inside a grain can also open. With --split the mesh has its own cohesive elements, between
all grains: Akantu gets them with the nodes and elements, and inserts none.

Prints the number of faces between grains, of inserted and of broken cohesive elements, the number
of fragments, and the largest relative change of momentum and energy. The energy is the sum of
kinetic, elastic and dissipated energy and of the energy that is stored in cohesive elements. The
picture shows the fragments at three times. Units: mm, microseconds, mg; therefore GPa, km/s, J.
Requires volume_fraction_mesh and akantu, and pyvista and matplotlib for the picture.
"""
import argparse
import os
import tempfile

import akantu as aka
import numpy as np

import volume_fraction_mesh as vfm

# Alumina: its strength and energy of fracture are those of the faces between grains.
DECK = """
material elastic [
  name = grains
  rho = 3.9
  E = 370
  nu = 0.22
]
material cohesive_linear [
  name = faces
  sigma_c = 0.3
  G_c = 5e-5
  beta = 1
]
"""
# Cohesive elements of the mesh have a bilinear law. A box that contains no face prevents others.
SPLIT_DECK = """
model solid_mechanics_model_cohesive [
  cohesive_inserter [
    bounding_box = [[90, 91], [90, 91], [90, 91]]
  ]
%s]
""" % DECK.replace("cohesive_linear [", "cohesive_bilinear [\n  delta_0 = 1e-8")
ENERGIES = ["kinetic", "potential", "dissipated", "reversible"]
PICTURES = 3
VIEW = [(6, -8, 5.5), (0, 0, 0), (0, 0, 1)]  # camera, focal point, up


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tets", action="store_true", help="tetrahedra instead of hexahedra")
    parser.add_argument("--split", action="store_true",
                        help="cohesive elements of the mesh instead of Akantu's")
    parser.add_argument("--grains", type=int, default=12, help="number of grains (default: 12)")
    parser.add_argument("--cells", type=int, default=10, help="cells per side (default: 10)")
    parser.add_argument("--rate", type=float, default=0.3,
                        help="rate of expansion, 1 per microsecond (default: 0.3)")
    parser.add_argument("--steps", type=int, default=1500, help="time steps (default: 1500)")
    parser.add_argument("--courant", type=float, default=0.2,
                        help="time step, relative to the largest stable one (default: 0.2)")
    parser.add_argument("--picture", metavar="FILE", help="save a picture, .png")
    return parser.parse_args()


def make_mesh(grains, cells, tets, **options):
    fractions = vfm.shapes("polycrystal grains=%d seed=4" % grains, cells, bounds=[-1, 1] * 3)
    names = ["Grain%d" % (number + 1) for number in range(grains)]
    if tets:
        return vfm.tets(fractions, names=names, method="cells", **options)
    return vfm.hexes(fractions, names=names, **options)


def give_split_mesh(mesh, target):
    """Gives Akantu the nodes, elements and cohesive elements of a split mesh.

    For Akantu, the thickness direction of a cohesive element points from its second half of nodes
    to its first, in the mesh from the first to the second.
    """
    tets = mesh.kind == "tetra"
    cohesive = np.concatenate([block.cells for block in mesh.cohesive().values()])
    cohesive = np.roll(cohesive, cohesive.shape[1] // 2, axis=1)
    accessor = aka.MeshAccessor(target)
    accessor.resizeNodes(len(mesh.points))
    target.getNodes()[:] = mesh.points
    for kind, cells in ((aka._tetrahedron_4 if tets else aka._hexahedron_8, mesh.cells),
                        (aka._cohesive_3d_6 if tets else aka._cohesive_3d_8, cohesive)):
        accessor.resizeConnectivity(len(cells), kind)
        target.getConnectivity(kind)[:] = cells
    accessor.makeReady()


class Grains:
    """The grains in Akantu. The types of elements are those of tets or hexes."""

    def __init__(self, mesh, rate, courant):
        self.mesh = aka.Mesh(3)
        self.is_split = bool(mesh.cohesive())
        self.grain = mesh.material  # of each element; Akantu may reorder those of a file
        self.kind, self.facets, self.cohesive = (
            (aka._tetrahedron_4, aka._triangle_3, aka._cohesive_3d_6) if mesh.kind == "tetra"
            else (aka._hexahedron_8, aka._quadrangle_4, aka._cohesive_3d_8))
        with tempfile.TemporaryDirectory() as folder:
            self.read(mesh, folder)
        self.model = aka.SolidMechanicsModelCohesive(self.mesh)
        self.model.initFull(_analysis_method=aka._explicit_lumped_mass,
                            _is_extrinsic=not self.is_split)
        self.faces = self.inserted() if self.is_split else self.allow_cracks()
        self.model.assembleMassLumped()  # before getMass()
        self.model.getVelocity()[:] = rate * self.mesh.getNodes()
        self.time_step = courant * self.model.getStableTimeStep()
        self.model.setTimeStep(self.time_step)

    def read(self, mesh, folder):
        """Gives Akantu the mesh and the materials."""
        if self.is_split:
            give_split_mesh(mesh, self.mesh)
        else:
            path = os.path.join(folder, "grains.msh")
            mesh.save(path, version="2.2")
            self.mesh.read(path)
        deck = os.path.join(folder, "grains.dat")
        with open(deck, "w", encoding="ascii") as file:
            file.write(SPLIT_DECK if self.is_split else DECK)
        aka.parseInput(deck)

    def allow_cracks(self):
        """Selects the groups of faces between grains. Returns the number of faces."""
        inserter = self.model.getElementInserter()
        for name in [group.getName() for group in self.mesh.iterateElementGroups()]:
            if "_to_" in name:
                inserter.addPhysicalSurface(name)
        self.model.updateAutomaticInsertion()
        return np.count_nonzero(inserter.getCheckFacets(self.facets))

    def step(self):
        if not self.is_split:
            self.model.checkCohesiveStress()
        self.model.solveStep()

    def momentum(self):
        """Returns the momentum and the sum of its lengths at the nodes."""
        shares = self.model.getMass() * self.model.getVelocity()
        return shares.sum(0), np.linalg.norm(shares, axis=1).sum()

    def energies(self):
        return [self.model.getEnergy(name) for name in ENERGIES]

    def inserted(self):
        """Returns the number of cohesive elements."""
        return self.mesh.getNbElement(type=self.cohesive)

    def broken(self):
        """Returns the number of cohesive elements that transfer no traction any more."""
        if self.inserted() == 0:
            return 0
        damage = self.model.getMaterial("faces").getInternalReal("damage")(self.cohesive)
        return np.count_nonzero(damage.reshape(self.inserted(), -1).min(1) >= 1)

    def fragments(self):
        found = aka.FragmentManager(self.model)
        found.buildFragments()
        return found.getNbFragment()

    def grid(self):
        """Returns the elements where they are, with the number of their grain."""
        import pyvista
        cells = np.array(self.mesh.getConnectivity(self.kind))
        grain = self.grain.copy()
        for group in self.mesh.iterateElementGroups():
            if "_to_" not in group.getName() and group.getName().startswith("Grain"):
                grain[group.getElements()(self.kind).ravel()] = int(group.getName()[5:])
        shape = pyvista.CellType.TETRA if cells.shape[1] == 4 else pyvista.CellType.HEXAHEDRON
        found = pyvista.UnstructuredGrid(
            {shape: cells}, self.mesh.getNodes() + self.model.getDisplacement())
        found["grain"] = grain
        return found


def run(grains, steps, watch):
    """Returns the momentum, the sum of its lengths, and the energies after each step."""
    table = []
    for step in range(steps + 1):
        if step > 0:
            grains.step()
        momentum, length = grains.momentum()
        table.append([*momentum, length, *grains.energies()])
        watch(step)
    return np.array(table)


def draw(shots, path):
    import matplotlib
    import pyvista
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, len(shots), figsize=(11, 3.9), layout="constrained")
    for place, (title, grid) in zip(axes, shots):
        plotter = pyvista.Plotter(off_screen=True, window_size=(800, 760))
        plotter.add_mesh(grid, scalars="grain", cmap="Set3", show_edges=True, line_width=0.5,
                         show_scalar_bar=False)
        plotter.camera_position = VIEW
        plotter.camera.zoom(1.45)
        place.imshow(plotter.screenshot(return_img=True))
        place.set_title(title)
        place.axis("off")
    figure.savefig(path, dpi=80)


def main():
    arguments = parse_arguments()
    options = {"split_interfaces": "all", "split_connection": "cohesive"}
    mesh = make_mesh(arguments.grains, arguments.cells, arguments.tets,
                     **options if arguments.split else {})
    grains = Grains(mesh, arguments.rate, arguments.courant)
    shots, between = [], max(arguments.steps // (PICTURES - 1), 1)

    def watch(step):
        if arguments.picture and step % between == 0:
            shots.append(("%.2f µs" % (step * grains.time_step), grains.grid()))

    table = run(grains, arguments.steps, watch)
    momentum, energy = table[:, :3], table[:, 4:].sum(1)
    print("%d %s, %d faces between grains" % (
        len(mesh), "tetrahedra" if arguments.tets else "hexahedra", grains.faces))
    print("%d opened, %d of them broken: %d fragments" % (
        grains.inserted(), grains.broken(), grains.fragments()))
    print("momentum %.1e, energy %.1e" % (
        np.linalg.norm(momentum - momentum[0], axis=1).max() / table[0, 3],
        np.abs(energy / energy[0] - 1).max()))
    print("energy [J]: " + ", ".join("%s %.4g" % pair for pair in zip(ENERGIES, table[-1, 4:])))
    if arguments.picture:
        draw(shots, arguments.picture)


if __name__ == "__main__":
    main()
