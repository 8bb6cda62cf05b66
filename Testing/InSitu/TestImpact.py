"""Examples/impact, meshed by the C interface and by Catalyst on 1, 2 and 4 ranks.

usage: pvpython TestImpact.py IMPACT FOLDER [catalyst]
       without VFM_PLUGIN, the path of the plugin, vtk_simple.py replaces ParaView

The meshes are bitwise identical to the filter's meshes of the dumped fields. The fragments
are the connected components of the fields. The test also prints the number of fragments over time,
and the time of meshing and of a step of the simulation.
"""
import glob
import os
import re
import shutil
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "Testing", "Python"))
from compare_meshes import difference, merge, read_pieces
from mpi_run import mpi_run
from vfmtest import VolumeFractionToHex, simple

RANKS = (1, 2, 4)
CELLS, END_TIME, EVERY = "32", "3.2", "50"
STATES = ["velocity", "damage"]


def run_impact(impact, folder, ranks, catalyst):
    """Runs the simulation and returns what it printed."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(os.path.join(folder, "catalyst"))  # impact makes the other folders
    command = [impact, "--cells", CELLS, "--time", END_TIME, "--every", EVERY, "--dump",
               os.path.join(folder, "dump"), "--sculptor", os.path.join(folder, "sculptor")]
    if catalyst:
        command += ["--catalyst", os.path.join(ROOT, "Examples", "catalyst_mesh.py")]
    run = mpi_run(ranks, command, VFM_ARRAYS="ball,plate", VFM_NAME="impact", VFM_PICTURE="0",
                  VFM_OUT=os.path.join(folder, "catalyst"))
    if run.returncode != 0:
        sys.exit("impact on %d ranks failed:\n%s%s" % (ranks, run.stdout, run.stderr))
    return run.stdout


def check_refused(impact, catalyst):
    """Checks that each error is reported once and gives exit status 1."""
    cases = [(["--sculptor"], "--sculptor needs a value: DIR"),
             (["--dump", "/dev/null"], "cannot make the folder /dev/null"),
             (["--sculptor", "/dev/null"], "cannot make the folder /dev/null"),
             (["--cells", "8"], "--cells takes a number from 16")]
    if catalyst:
        cases += [(["--catalyst", "none.py"], "Script none.py cannot be read.")]
    for arguments, text in cases:
        for ranks in (1, 3):
            run = mpi_run(ranks, [impact, *arguments])
            assert run.returncode == 1 and run.stderr.startswith(
                "impact: ") and text in run.stderr, (arguments, run)
            assert run.stdout == "" and len(run.stderr.splitlines()) == 1, (arguments, run)


def check_failing_script(impact, folder):
    """Checks that a failing script does not stop the simulation, which exits with status 1."""
    script = os.path.join(folder, "failing.py")
    os.makedirs(folder, exist_ok=True)
    with open(script, "w", encoding="utf-8") as file:
        file.write("def catalyst_execute(info):\n    raise ValueError('no mesh')\n")
    run = mpi_run(2,
                  [impact, "--cells", "16", "--steps", "2", "--every", "1", "--catalyst", script])
    assert run.returncode == 1 and "step     2" in run.stdout, run
    assert ("ValueError: no mesh" in run.stderr
            and "impact: an output failed; see the messages above" in run.stderr), run


def step_of(path):
    return int(re.search(r"_(\d+)\.\w+$", path).group(1))


def files_by_step(folder, ending):
    return {step_of(path): path for path in glob.glob(os.path.join(folder, "impact_*" + ending))}


def mesh_of(dump):
    """Returns the filter's mesh of a dump with state, as a separate data set."""
    source = simple.XMLPartitionedImageDataReader(FileName=[dump])
    mesher = VolumeFractionToHex(Input=source, VolumeFractionArrays=["ball", "plate"],
                                 StateArrays=STATES)
    mesher.UpdatePipeline()
    output = mesher.GetClientSideObject().GetOutputDataObject(0)
    mesh = output.NewInstance()
    mesh.DeepCopy(output)
    simple.Delete(mesher)
    simple.Delete(source)
    return mesh


def count_components(labels):
    """Counts face-connected components of ball and plate, by labels 0 void, 1 ball, 2 plate.

    Each cell takes the greatest number of its neighbours until no number changes.
    """
    numbers, before = np.arange(1, labels.size + 1).reshape(labels.shape), None
    while before is None or (numbers != before).any():
        before = numbers.copy()
        for axis in range(3):
            own, values = np.moveaxis(labels, axis, 0), np.moveaxis(numbers, axis, 0)
            same = own[1:] == own[:-1]
            for here, beside in ((values[1:], values[:-1]), (values[:-1], values[1:])):
                here[same] = np.maximum(here, beside)[same]
    return [len(np.unique(numbers[labels == material])) for material in (1, 2)]


def labels_of_field(dump):
    """Returns the material with the largest fraction per cell (z, y, x)."""
    source = simple.XMLPartitionedImageDataReader(FileName=[dump])
    source.UpdatePipeline()
    image = source.GetClientSideObject().GetOutputDataObject(0)
    size = [n - 1 for n in reversed(image.GetDimensions())]
    ball, plate = (vtk_to_numpy(image.GetCellData().GetArray(name)).reshape(size)
                   for name in ("ball", "plate"))
    labels = np.where(ball + plate < 0.5, 0, np.where(ball >= plate, 1, 2))
    simple.Delete(source)
    return labels


def labels_of_mesh(mesh, size):
    """Returns the material that each cell was meshed as: that of the hexahedron in its middle."""
    ids, materials = (vtk_to_numpy(mesh.GetCellData().GetArray(name))
                      for name in ("GlobalCellIds", "MaterialId"))
    cells, slots = np.divmod(ids - 1, 7)
    labels = np.zeros(np.prod(size), int)
    labels[cells[slots == 0]] = materials[slots == 0]
    return labels.reshape(size)


def fragments_of(mesh):
    """Returns the numbers of fragments of ball and plate."""
    materials, fragments = (vtk_to_numpy(mesh.GetCellData().GetArray(name))
                            for name in ("MaterialId", "FragmentId"))
    return [len(np.unique(fragments[materials == material])) for material in (1, 2)]


def check_same(path, expected, what):
    mesh = merge(read_pieces(path))
    if what == "Catalyst":
        mesh["field"] = expected["field"]  # Catalyst adds field data
    problem = difference(mesh, expected)
    assert not problem, "%s, %s: %s" % (what, path, problem)


def check_fragments(mesh, dump, step):
    """Checks that the fragments are the connected components of the cells as meshed.

    The components of the field may differ: cells are flipped to keep surfaces manifold, and thin
    parts get cells.
    """
    field = labels_of_field(dump)
    meshed = labels_of_mesh(mesh, field.shape)
    fragments, components, raw = fragments_of(mesh), count_components(meshed), count_components(
        field)
    flips, thin = (mesh.GetFieldData().GetArray(name).GetValue(0)
                   for name in ("FlippedCells", "ThinPartCells"))
    print("step %5d: fragments %3d ball, %3d plate; components of the cells as meshed %3d, %3d; "
          "of the field %3d, %3d; %d cells flipped, %d of thin parts"
          % (step, *fragments, *components, *raw, flips, thin))
    assert fragments == components, (fragments, components)
    assert (field != meshed).sum() <= flips + thin, ((field != meshed).sum(), flips, thin)
    return fragments


def main(impact, folder, catalyst):
    check_refused(impact, catalyst)
    if catalyst:
        check_failing_script(impact, folder)
    outputs = {ranks: run_impact(impact, os.path.join(folder, str(ranks)), ranks, catalyst)
               for ranks in RANKS}
    first = os.path.join(folder, str(RANKS[0]))
    dumps = files_by_step(os.path.join(first, "dump"), ".pvti")
    assert len(dumps) >= 4, dumps
    series = []
    for step, dump in sorted(dumps.items()):
        mesh = mesh_of(dump)
        series.append(check_fragments(mesh, dump, step))
        with_states = merge([mesh])
        for name in STATES:  # the Catalyst script transfers no state
            mesh.GetCellData().RemoveArray(name)
        without = merge([mesh])
        for ranks in RANKS:
            here = os.path.join(folder, str(ranks))
            check_same(files_by_step(os.path.join(here, "sculptor"), ".pvtu")[step], with_states,
                       "C interface")
            if catalyst:
                check_same(files_by_step(os.path.join(here, "catalyst"), ".pvtu")[step], without,
                           "Catalyst")
    assert series[0] == [1,
                         1] and series[-1][
                             0] > 1, "the ball does not go from one piece to several: %s" % series
    for ranks, text in outputs.items():
        print("-- %d rank(s)\n%s" % (ranks, text))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:3], len(sys.argv) > 3)
