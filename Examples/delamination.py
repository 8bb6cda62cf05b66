"""Pulls a ball off a plate to which it is glued, with cohesive elements of the mesh in Akantu.

usage: python delamination.py [--cells 24] [--speed 0.0015] [--time 6] [--courant 0.4]
       [--picture FILE.png]

The Python package meshes a ball that is flat where it meets a plate. The option split_interfaces
gives both their own nodes on the interface, and split_connection adds cohesive elements between
them. Akantu (PyPI) gets the nodes, the elements and the cohesive elements, which have a bilinear
law. The top of the ball moves upwards, the bottom of the plate is fixed. The glue breaks from its
rim to its centre.

Prints the greatest force on the ball, the force on the plate and the mean opening of the glue at
that time, the number of broken cohesive elements, and three balances. Force: largest sum of the
forces of all nodes, relative to the greatest force. Energy: largest difference between the work at
the top of the ball and the sum of kinetic, elastic, dissipated and reversible energy, relative to
the work at the end. Fracture: dissipated energy, relative to that of the bilinear law for the area
of the glue. The picture shows half of the bodies, the glue, and force and damage over the
displacement. Units: mm, microseconds, mg; therefore GPa, km/s, kN, J.
Requires volume_fraction_mesh and akantu, and pyvista and matplotlib for the picture.
"""
import argparse
import os
import tempfile

import akantu as aka
import numpy as np

import volume_fraction_mesh as vfm
from akantu_grains import ENERGIES, give_split_mesh

SHAPES = "box size=2,2,1 center=0,0,0; sphere radius=0.45 center=0,0,0.75 material=2"
GRIP = 1.0  # height above which the ball is held
RAMP = 2.0  # microseconds until it has its speed
STRENGTH, ENERGY_OF_FRACTURE, OPENING_OF_STRENGTH = 0.03, 5e-5, 1e-4
# Acrylic glass and glue.
DECK = """
model solid_mechanics_model_cohesive [
  cohesive_inserter [
    bounding_box = [[90, 91], [90, 91], [90, 91]]
  ]
  material elastic [
    name = bodies
    rho = 1.2
    E = 3.5
    nu = 0.35
  ]
  material cohesive_bilinear [
    name = glue
    sigma_c = %g
    G_c = %g
    delta_0 = %g
    beta = 1
  ]
]
""" % (STRENGTH, ENERGY_OF_FRACTURE, OPENING_OF_STRENGTH)
SHOWN = 30  # factor of displacements in the picture


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=24, help="cells along x (default: 24)")
    parser.add_argument("--speed", type=float, default=0.0015,
                        help="speed of the top of the ball, km/s (default: 0.0015)")
    parser.add_argument("--time", type=float, default=6, help="microseconds (default: 6)")
    parser.add_argument("--courant", type=float, default=0.4,
                        help="time step, relative to the largest stable one (default: 0.4)")
    parser.add_argument("--picture", metavar="FILE", help="save a picture, .png")
    return parser.parse_args()


def make_mesh(cells):
    size = (cells, cells, cells * 5 // 8)
    fractions = vfm.shapes(SHAPES, size, bounds=[-1, 1, -1, 1, 0, 1.25])
    return vfm.hexes(fractions, names=["plate", "ball"], split_interfaces="plate/ball",
                     split_connection="cohesive")


class Joint:
    """Plate, ball and glue in Akantu."""

    def __init__(self, mesh, top_speed, courant):
        self.source, self.top_speed = mesh, top_speed
        self.glue = mesh.cohesive()["plate_to_ball_cohesive"].cells
        self.mesh = aka.Mesh(3)
        give_split_mesh(mesh, self.mesh)
        with tempfile.TemporaryDirectory() as folder:
            deck = os.path.join(folder, "joint.dat")
            with open(deck, "w", encoding="ascii") as file:
                file.write(DECK)
            aka.parseInput(deck)
        self.model = aka.SolidMechanicsModelCohesive(self.mesh)
        self.model.initFull(_analysis_method=aka._explicit_lumped_mass, _is_extrinsic=False)
        self.model.assembleMassLumped()
        self.time, self.speed = 0.0, 0.0
        self.time_step = courant * self.model.getStableTimeStep()
        self.model.setTimeStep(self.time_step)
        self.grip = mesh.points[:, 2] > GRIP
        self.base = mesh.points[:, 2] < 1e-9
        self.model.getBlockedDOFs()[self.grip | self.base] = True
        self.grip_mass = self.model.getMass()[self.grip, 2].sum()

    def step(self):
        """Moves the grip, with a speed that begins smoothly, and all other nodes."""
        self.time += self.time_step
        self.speed = self.top_speed * np.sin(np.pi / 2 * min(self.time / RAMP, 1)) ** 2
        self.model.getVelocity()[self.grip, 2] = self.speed
        self.model.getDisplacement()[self.grip, 2] += self.speed * self.time_step
        self.model.solveStep()

    def measure(self):
        """Returns displacement of the grip, force on it and on the base, the sum of the forces of
        all nodes, mean opening and mean damage of the glue, and energies, kinetic without grip."""
        forces = self.model.getInternalForce()[:, 2]
        moved = self.model.getDisplacement()[:, 2]
        opening = (moved[self.glue[:, 4:]] - moved[self.glue[:, :4]]).mean()
        energies = [self.model.getEnergy(name) for name in ENERGIES]
        energies[0] -= self.grip_mass * self.speed ** 2 / 2
        return [moved[self.grip][0], -forces[self.grip].sum(), -forces[self.base].sum(),
                forces.sum(), opening, self.damage().mean(), *energies]

    def damage(self):
        """Returns the mean damage of each cohesive element."""
        damage = self.model.getMaterial("glue").getInternalReal("damage")(aka._cohesive_3d_8)
        return damage.reshape(len(self.glue), -1).mean(1)

    def grids(self):
        """Returns the elements, moved, with their vertical stress, and the glue with its damage."""
        import pyvista
        bodies = self.source.to_pyvista()
        bodies.points = bodies.points + SHOWN * self.model.getDisplacement()
        stress = self.model.getMaterial("bodies").getStress(aka._hexahedron_8)
        bodies["stress"] = stress.reshape(len(self.source), -1, 9).mean(1)[:, 8]
        glue = pyvista.PolyData.from_regular_faces(self.source.points, self.glue[:, :4])
        glue["damage"] = self.damage()
        return bodies, glue


def run(joint, duration, watch):
    """Returns measure() and the work at the grip after each step."""
    table = [[*joint.measure(), 0.0]]
    while joint.time < duration:
        joint.step()
        row, before = joint.measure(), table[-1]
        work = before[-1] + (row[0] - before[0]) * (row[1] + before[1]) / 2
        table.append([*row, work])
        watch(row)
    return np.array(table)


def energy_of_damage():
    """Returns what Akantu counts as dissipated per area: opening to the strength is elastic."""
    return ENERGY_OF_FRACTURE - STRENGTH * OPENING_OF_STRENGTH / 2


def area_of(mesh, faces):
    corners = mesh.points[faces]
    return np.linalg.norm(np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]),
                          axis=1).sum() / 2


def take_picture(grid, scalars, limits, camera, zoom):
    import pyvista
    plotter = pyvista.Plotter(off_screen=True, window_size=(800, 760))
    plotter.add_mesh(grid, scalars=scalars, cmap="viridis", clim=limits, show_edges=True,
                     line_width=0.5, show_scalar_bar=False, lighting=False)
    plotter.camera_position = camera
    plotter.camera.zoom(zoom)
    return plotter.screenshot(return_img=True)


def draw(mesh, shots, table, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, 4, figsize=(14, 3.6), layout="constrained")
    side, above = [(0.3, -5, 0.8), (0, 0, 0.65), (0, 0, 1)], [(0, 0, 4), (0, 0, 0.5), (0, 1, 0)]
    behind = mesh.points[mesh.cells].mean(1)[:, 1] > 0
    (before, _), (_, glue), (after, _) = shots
    for place, title, picture in (
            (axes[0], "glue opens", take_picture(before.extract_cells(behind), "stress",
                                                (-0.01, 0.03), side, 1.35)),
            (axes[1], "damage of the glue", take_picture(glue, "damage", (0, 1), above, 2.3)),
            (axes[2], "glue is broken", take_picture(after.extract_cells(behind), "stress",
                                                 (-0.01, 0.03), side, 1.35))):
        place.imshow(picture)
        place.set_title(title)
        place.axis("off")
    moved = 1000 * table[:, 0]
    axes[3].plot(moved, 1000 * table[:, 1], label="force on the ball [N]")
    axes[3].plot(moved, 1000 * table[:, 2], ":", label="force on the plate [N]")
    axes[3].plot(moved, 10 * table[:, 5], label="mean damage x 10")
    axes[3].set_xlabel("displacement of the ball's top [µm]")
    axes[3].legend(loc="lower center", bbox_to_anchor=(0.5, 1))
    figure.savefig(path, dpi=80)


def main():
    arguments = parse_arguments()
    mesh = make_mesh(arguments.cells)
    joint = Joint(mesh, arguments.speed, arguments.courant)
    shots, limits = [], [0.1, 0.5, 2]  # mean damages at the times of pictures; 2 is the end

    def watch(row):
        if arguments.picture and row[5] >= limits[len(shots)]:
            shots.append(joint.grids())

    table = run(joint, arguments.time, watch)
    greatest, work = table[:, 1].argmax(), table[-1, -1]
    print("%d hexahedra, %d cohesive elements, %d of them broken" % (
        len(mesh), len(joint.glue), np.count_nonzero(joint.damage() >= 1)))
    print("greatest force %.2f N on the ball, %.2f N on the plate, opening %.3f µm" % (
        1000 * table[greatest, 1], -1000 * table[greatest, 2], 1000 * table[greatest, 4]))
    print("balances: force %.1e, energy %.1e, fracture %.4f" % (
        np.abs(table[:, 3]).max() / table[greatest, 1],
        np.abs(table[:, 6:10].sum(1) - table[:, -1]).max() / work,
        table[-1, 8] / (energy_of_damage() * area_of(mesh, joint.glue[:, :4]))))
    if arguments.picture:
        draw(mesh, [*shots, joint.grids()], table, arguments.picture)


if __name__ == "__main__":
    main()
