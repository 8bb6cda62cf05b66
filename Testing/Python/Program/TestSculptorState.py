"""State that `sculptor` (VFM_SCULPTOR) transfers: same as the filters; tables and errors."""
import csv
import re

import numpy as np

from sculptor_program import check_same, mesh_file, refused
from vfmtest import SPACING, ball_and_plate, image, in_folder, main, mesh_of, write


def arrays_of_impact():
    """Returns ball and plate with a density each, and a common velocity, energy and stress."""
    ball, plate = ball_and_plate()
    x = np.linspace(0, 1, 12)
    ramp = x[:, None, None] + 0 * ball
    velocity = np.stack([ramp, -2 * ramp, 1 + ramp ** 2], -1)
    return {"ball": ball, "plate": plate, "rho - 1": 2 + ramp, "rho - 2": 7 + 0 * ball,
            "velocity": velocity, "energy": 0.3 + ramp,
            "stress": 4 - 8 * ramp, "mark": np.arange(12 ** 3, dtype=np.int32).reshape(ball.shape)}


@in_folder
def test_conserved_state(at):
    """Options are properties; the printed table and the table of fragments give the sums."""
    arrays = arrays_of_impact()
    path = write(image(arrays), at("in.vti"))
    words = ["--fractions", "ball,plate", "--density", "rho - 1,rho - 2", "--state", "stress,mark",
             "--state-kinds",
             "stress=volume", "--velocity", "velocity", "--energy", "energy", "--nodal-velocity",
             "--lost-kinetic-energy", "internalenergy",
             "--unmeshed", "drop", "--state-order", "1", "--fragments", at("table.csv")]
    mesh = mesh_of(image(arrays), DensityArrays=["rho - 1", "rho - 2"],
                   StateArrays=["stress", "mark"], StateKinds=["stress=volume"],
                   VelocityArray="velocity", EnergyArray="energy", NodalVelocity=1,
                   LostKineticEnergy="Internal Energy", UnmeshedMaterial="Drop", StateOrder=1).mesh
    assert mesh.GetPointData().HasArray("velocity") and mesh.GetCellData().HasArray("rho")
    printed = [mesh_file(path, at("out.vtu"), *words, ranks=ranks) for ranks in (1, 3)]
    check_same(at("out.vtu"), mesh)
    state = [re.search(r"state .*?\n\n", text, re.S).group() for text in printed]
    assert state[0] == state[1], state
    sums = {name: [float(x) for x in numbers.split()]
            for name, numbers in re.findall(r"^(\w+(?: \w+)?)((?: +[-\d.e+]+){3})$", state[0],
                                            re.M)}
    cell = np.prod(SPACING)
    masses = [(arrays[name] * arrays["rho - %d" % (i + 1)] * cell)
              for i, name in enumerate(("ball", "plate"))]
    mass = sum(masses)
    speeds = (arrays["velocity"] ** 2).sum(-1)
    wanted = {"mass": mass.sum(), "momentum x": (mass * arrays["velocity"][..., 0]).sum(),
              "momentum z": (mass * arrays["velocity"][..., 2]).sum(),
              "kinetic energy": (mass * speeds).sum() / 2,
              "internal energy": (mass * arrays["energy"]).sum()}
    for name, value in wanted.items():
        assert np.isclose(sums[name][0], value, rtol=1e-8), (name, sums[name], value)
    for name in ("mass", "momentum x", "momentum z"):
        assert np.isclose(sums[name][1] + sums[name][2], wanted[name],
                          rtol=1e-8), (name, sums[name])
    energy = np.sum([sums["kinetic energy"], sums["internal energy"]], 0)
    lost = [float(x)
            for x in re.search(r"averaging: ([\d.e+-]+) in elements, ([\d.e+-]+) more at nodes",
                               state[0]).groups()]
    assert np.isclose(energy[0], energy[1] + energy[2] - lost[1],
                      rtol=1e-6) and min(lost) > 0, (energy, lost)
    with open(at("table.csv"), newline="", encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    assert np.isclose(sum(float(row["Mass"]) for row in table), mass.sum(), rtol=1e-9)


@in_folder
def test_masses_of_fragments(at):
    """Masses by densities whose names contain the material in the middle.

    The name of another array is the start of both names.
    """
    arrays = arrays_of_impact()
    names = ["rho of %s (g)" % body for body in ("ball", "plate")]
    path = write(image({**{body: arrays[body] for body in ("ball", "plate")},
                        names[0]: arrays["rho - 1"], names[1]: arrays["rho - 2"],
                        "r": arrays["energy"]}), at("in.vti"))
    mesh_file(path, at("out.vtu"), "--fractions", "ball,plate", "--density", ",".join(names),
              "--state", "r", "--fragments", at("table.csv"))
    mass = sum((arrays[body] * arrays["rho - %d" % (i + 1)]).sum()
               for i, body in enumerate(("ball", "plate"))) * np.prod(SPACING)
    with open(at("table.csv"), newline="", encoding="utf-8") as file:
        assert np.isclose(sum(float(row["Mass"]) for row in csv.DictReader(file)), mass, rtol=1e-9)


@in_folder
def test_state_is_copied_where_asked(at):
    """With --state-transfer copy, state is copied and no table is printed."""
    path = write(image(arrays_of_impact()), at("in.vti"))
    words = ["--fractions", "ball,plate", "--state", "velocity", "--density", "rho - 2"]
    out = mesh_file(path, at("out.vtu"), *words, "--state-transfer", "copy")
    check_same(at("out.vtu"),
               mesh_of(image(arrays_of_impact()), StateArrays=["velocity", "rho - 2"]).mesh)
    assert not re.search(r"^state ", out, re.M)
    for code, text, more in ((2, "no numeric array 'weight' (--density)", ["--density", "weight"]),
                             (3, "'velocity=heavy'",
                              ["--state", "velocity", "--density", "energy", "--state-kinds",
                               "velocity=heavy"])):
        refused(code, text, path, at("no.vtu"), "--fractions", "ball,plate", *more, ranks=2)


@in_folder
def test_particles(at):
    """The program prints the number and mass of particles, the files beside meshes that hold them,
    and their sums in the table of state."""
    arrays = arrays_of_impact()
    arrays["ball"][11, 11, 11], arrays["plate"][11, 11, 11] = 0.1, 0.0
    path = write(image(arrays), at("in.vti"))
    words = ["--fractions", "ball,plate", "--unmeshed", "particles"]
    volume = 0.1 * np.prod(SPACING)
    for more, mass in (([], None), (["--density", "rho - 1,rho - 2", "--velocity", "velocity"],
                                    volume * arrays["rho - 1"][11, 11, 11])):
        printed = [mesh_file(path, at("out.vtu"), *words, *more, ranks=ranks) for ranks in (1, 3)]
        found = [re.search(r"^particles: (\d+), volume ([\d.e+-]+)(?:, mass ([\d.e+-]+))?"
                           ", in %s$" % re.escape(at("out_particles.vtp")), text,
                           re.M).groups() for text in printed]
        assert found[0] == found[1] and found[0][0] == "1", found
        assert np.isclose(float(found[0][1]), volume, rtol=1e-5)
        assert (found[0][2] is None) == (mass is None)
        if mass is not None:
            assert np.isclose(float(found[0][2]), mass, rtol=1e-5)
            assert "in particles" in printed[0]
            sums = re.search(r"^mass((?: +[-\d.e+]+){4})$", printed[0], re.M).group(1).split()
            assert np.isclose(float(sums[1]) + float(sums[3]), float(sums[0]), rtol=1e-8), sums
            assert float(sums[2]) == 0
    assert "articles" not in mesh_file(path, at("out.vtu"), *words[:2])
    in_file = mesh_file(path, at("out.e"), *words)  # holds particles
    assert re.search(r"^particles: 1, volume [\d.e+-]+$", in_file, re.M), in_file
    both = mesh_file(path, at("out.msh"), *words, "--surfaces", at("skin_{}.stl"))
    beside = "%s, %s" % (at("out_particles.vtp"), at("skin_particles.vtp"))
    assert re.search(r"^particles: 1, .*, in %s$" % re.escape(beside), both, re.M), both


main(globals())
