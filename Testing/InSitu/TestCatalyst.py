"""Catalyst in a small simulation, CatalystHost.

Examples/catalyst_mesh.py makes the meshes of the filter on any number of ranks, at the selected
steps. A script that fails does not stop the simulation. With --picture, under an X server, the test
renders a picture of the mesh.

Environment: VFM_PLUGIN, the plugin; VFM_CATALYST_HOST, the simulation.
"""
import os
import re
import sys
import tempfile

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkAMRBox, vtkOverlappingAMR, vtkUniformGrid
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader
from vtkmodules.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "Python"))
from amr_cases import set_boxes
from compare_meshes import difference, merge, read_pieces
from mpi_run import mpi_run
from vfmtest import image, main, mesh_of, VolumeFractionToTet

EXAMPLE = os.path.join(HERE, "..", "..", "Examples", "catalyst_mesh.py")
CELLS, ORIGIN, SPACING = (14, 12, 10), (-0.7, 0.3, 2.1), (0.1, 0.125, 0.11)  # values of the host
MIDDLE = ((1, 8), (2, 10), (4, 11))  # refined cells of the host, along z, y, x
MIDDLE_OF_LEVEL_1 = tuple(slice(2 * a, 2 * b) for a, b in MIDDLE)
STEPS, SAMPLES = 4, 4
NO_DISPLAY = "no pictures: no X server"

# Catalyst scripts. The first checks that the array "ball" is the memory of the host, and that
# blocks of other ranks are null.
ZERO_COPY = """
from paraview.simple import TrivialProducer
from vtkmodules.util.numpy_support import vtk_to_numpy
producer = TrivialProducer(registrationName="input")
def catalyst_execute(info):
    grid = producer.GetClientSideObject().GetOutputDataObject(0)
    address = grid.GetFieldData().GetArray("BallAddress").GetValue(0)
    blocks = [grid.GetBlock(b) for b in range(grid.GetNumberOfBlocks())]
    mine = [block for block in blocks if block]
    found = (vtk_to_numpy(mine[0].GetCellData().GetArray("ball")).__array_interface__["data"][0]
             if mine else 0)
    print("rank has %d of %d blocks at %#x, handed over %#x"
          % (len(mine), len(blocks), found, int(address)), flush=True)
    assert found == address
"""
VOLUME = """
from paraview.simple import IntegrateVariables, TrivialProducer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController
producer = TrivialProducer(registrationName="input")
total = IntegrateVariables(Input=producer)
def catalyst_execute(info):
    grid = producer.GetClientSideObject().GetOutputDataObject(0)
    total.UpdatePipeline()
    blocks = [block for block in map(grid.GetBlock, range(grid.GetNumberOfBlocks())) if block]
    types = [block.GetCellData().GetArray("vtkGhostType") for block in blocks]
    mine, hidden = vtkDoubleArray(), vtkDoubleArray()
    mine.InsertNextValue(sum((vtk_to_numpy(array) == 32).sum() for array in types if array))
    hidden.DeepCopy(mine)
    vtkMultiProcessController.GetGlobalController().AllReduce(mine, hidden, vtkCommunicator.SUM_OP)
    volume = total.GetClientSideObject().GetOutputDataObject(0).GetCellData().GetArray("Volume")
    if vtkMultiProcessController.GetGlobalController().GetLocalProcessId() == 0:
        print("volume in cells: %d" % round(volume.GetValue(0) / (0.1 * 0.125 * 0.11)),
              "hidden: %d" % hidden.GetValue(0), flush=True)
"""
WANTS_NOTHING = """
def RequestDataDescription(description):
    pass
def catalyst_execute(info):
    print("executed")
"""
RAISES_AT_STEP_1 = """
def catalyst_execute(info):
    if info.timestep == 1:
        raise ValueError("a script\\n that fails")
    print("executed", info.timestep)
"""
RAISES_ON_LAST_RANK = """
from vtkmodules.vtkParallelCore import vtkMultiProcessController
def catalyst_execute(info):
    ranks = vtkMultiProcessController.GetGlobalController()
    if ranks.GetLocalProcessId() == ranks.GetNumberOfProcesses() - 1:
        raise ValueError("only here")
"""
RAISES_WHILE_OTHERS_MESH = """
import os
from paraview import simple
from vtkmodules.vtkParallelCore import vtkMultiProcessController
simple.LoadPlugin(os.environ["VFM_PLUGIN"], remote=False, ns=globals())
producer = simple.TrivialProducer(registrationName="input")
hexes = VolumeFractionToHex(Input=producer, VolumeFractionArrays=["ball", "plate"])
def catalyst_execute(info):
    ranks = vtkMultiProcessController.GetGlobalController()
    if info.timestep == 1 and ranks.GetLocalProcessId() == 1:
        raise ValueError("only here")
    hexes.UpdatePipeline(info.time)
    cells = hexes.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
    print("rank %d meshed step %d: %s" % (ranks.GetLocalProcessId(), info.timestep, cells > 0),
          flush=True)
"""
RAISES_IN_INITIALIZE = """
def catalyst_initialize():
    raise KeyError("cannot begin")
"""
RAISES_IN_FINALIZE = """
def catalyst_finalize():
    raise KeyError("cannot end")
def catalyst_execute(info):
    pass
"""
EXITS = "import sys\ndef catalyst_execute(info):\n    sys.exit(7)\n"
EXITS_AT_IMPORT = "import sys\nsys.exit(7)\n"
NO_PYTHON = "def catalyst_execute(info:\n"


def part_in_ball(step, level=0):
    z, y, x = np.meshgrid(*[(np.arange(n * SAMPLES << level) + 0.5) / (SAMPLES << level)
                            for n in CELLS[::-1]], indexing="ij")
    centre = (5.5 + 0.5 * step, 6.0, 6.5 - 0.25 * step)
    inside = (x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2 < 10.5625
    shape = [n for size in CELLS[::-1] for n in (size << level, SAMPLES)]
    return inside.reshape(shape).mean(axis=(1, 3, 5))


def arrays(step, level=0):
    """Returns the fields of the host at a step."""
    ball = part_in_ball(step, level)
    plate = np.where(np.arange(CELLS[2] << level)[:, None, None] < 3 << level, 1.0 - ball, 0.0)
    labels = np.where(ball + plate < 0.5, 0, np.where(ball >= plate, 1, 2))
    return {"ball": ball, "plate": plate.astype(np.float32), "id": labels.astype(np.int32)}


def field(step):
    """Returns the fields of level 0 as one image."""
    data = image(arrays(step))
    data.SetOrigin(ORIGIN)
    data.SetSpacing(SPACING)
    return data


def refined_field(step):
    """Returns the fields of both levels as AMR."""
    fine = {name: np.ascontiguousarray(values[MIDDLE_OF_LEVEL_1])
            for name, values in arrays(step, 1).items()}
    grids = [image(arrays(step), kind=vtkUniformGrid), image(fine, kind=vtkUniformGrid)]
    data = vtkOverlappingAMR()
    set_boxes(data, [1, 1])
    data.SetOrigin(ORIGIN)
    data.SetGridDescription(8)  # VTK_XYZ_GRID
    for level, grid in enumerate(grids):
        spacing = [h / 2 ** level for h in SPACING]
        grid.SetOrigin([ORIGIN[a] + level * MIDDLE[2 - a][0] * SPACING[a] for a in range(3)])
        grid.SetSpacing(spacing)
        data.SetSpacing(level, spacing)
        data.SetRefinementRatio(level, 2)
        data.SetAMRBox(level, 0, vtkAMRBox(grid.GetOrigin(), grid.GetDimensions(), spacing, ORIGIN))
        data.SetDataSet(level, 0, grid)
    return data


def run_host(ranks, scripts, *options, **settings):
    return mpi_run(ranks, [os.environ["VFM_CATALYST_HOST"], *options, *scripts],
                   without=() if PICTURE else ("DISPLAY",),
                   **{"VFM_" + key: value for key, value in settings.items()})


def run_code(ranks, *codes, options=()):
    """Runs the host with these scripts, which are named script0.py and so on."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, "script%d.py" % i) for i in range(len(codes))]
        for path, code in zip(paths, codes):
            with open(path, "w") as file:
                file.write("# script-version: 2.0\n" + code)
        return run_host(ranks, paths, *options)


def run_example(ranks, out, *options, **settings):
    """Runs the host with the example; returns the meshed steps and the completed process."""
    result = run_host(ranks, [EXAMPLE], *options, OUT=out, **settings)
    assert result.returncode == 0, result
    assert "Traceback" not in result.stderr and "ERR|" not in result.stderr, result.stderr
    assert result.stdout.count("host: step") == STEPS, result.stdout
    steps = sorted(int(re.sub(r"\D", "", name)) for name in os.listdir(out)
                   if name.endswith(".pvtu"))
    assert steps == [int(step)
                     for step in re.findall(r"mesh_(\d+).pvtu: \d+ elements",
                                            result.stdout)], result.stdout
    return steps, result


def expect_mesh(out, step, ranks, gold):
    """Checks that the files of a step hold the mesh of the filter, in one piece per rank."""
    pieces = read_pieces(os.path.join(out, "mesh_%06d.pvtu" % step))
    assert len(pieces) == ranks
    for piece in pieces:
        assert piece.GetFieldData().GetArray("Fragments").GetValue(0) == (2.0 if step < 2 else 1.0)
        # field data of the input
        for name in ("Fragments", "BallAddress", "__CatalystChannel__", "TimeValue"):
            piece.GetFieldData().RemoveArray(name)
    differs = difference(merge(pieces), merge([gold]))
    assert not differs, differs


def test_meshes_are_those_of_the_filter():
    """Meshes equal the filter's meshes on 1, 2 and 4 ranks, for any number of blocks."""
    golds = [mesh_of(field(step)).mesh for step in range(STEPS)]
    assert len({gold.GetNumberOfCells() for gold in golds}) > 1  # the ball moves
    for ranks, boxes in ((1, 3), (2, 1), (4, 7)):  # with two ranks and one box, rank 1 has no cells
        with tempfile.TemporaryDirectory() as out:
            steps, result = run_example(ranks, out, "--boxes", str(boxes))
            assert steps == list(range(STEPS))
            assert result.stdout.count(
                NO_DISPLAY) == 1 and "4 steps made" in result.stdout, result.stdout
            for step in steps:
                expect_mesh(out, step, ranks, golds[step])
            times = re.findall(r'timestep="([^"]*)" file="([^"]*)"',
                               open(os.path.join(out, "mesh.pvd")).read())
            assert times == [(repr(0.125 * s), "mesh_%06d.pvtu" % s) for s in steps], times


def test_refined_grids():
    """Refined grids give the meshes of AMR data."""
    tets = {"TETS": "Lattice"}
    # in the last case, one rank has no cells
    for ranks, boxes, kind, steps in ((1, 2, {}, [1]), (3, 2, {}, [1, 3]), (3, 1, tets, [2])):
        with tempfile.TemporaryDirectory() as out:
            settings = {**kind, "STEPS": ",".join(map(str, steps))}
            assert run_example(ranks, out, "--boxes", str(boxes), "--refined",
                               **settings)[0] == steps
            for step in steps:
                data = refined_field(step)
                gold = mesh_of(data, VolumeFractionToTet,
                               Method="Lattice") if kind else mesh_of(data)
                expect_mesh(out, step, ranks, gold.mesh)


def test_what_scripts_see_of_refined_grids():
    """Coarse cells below finer ones are hidden, and sums count each place once.

    The sums are in units of level-0 cells.
    """
    coarse, fine = part_in_ball(0), part_in_ball(0, 1)
    ball = coarse.sum() - coarse[tuple(slice(*span)
                                       for span in MIDDLE)].sum() + fine[
                                           MIDDLE_OF_LEVEL_1].sum() / 8
    result = run_code(2, VOLUME, options=("--refined",))
    assert result.returncode == 0, result
    assert result.stdout.count("volume in cells: %d" % np.prod(CELLS)) == STEPS, result.stdout
    hidden = np.prod([b - a for a, b in MIDDLE])
    assert result.stdout.count("hidden: %d" % hidden) == STEPS, result.stdout
    triggers = ["sum ball > %r" % limit for limit in (ball - 1e-9, ball + 1e-9)]
    with tempfile.TemporaryDirectory() as out:
        text = run_example(2, out, "--refined", TRIGGER=";".join(triggers))[1].stdout
        assert re.search(r"mesh_000000.pvtu: .*\(%s\)" % re.escape(triggers[0]), text), text


def test_labels_tets_and_exodus():
    gold = mesh_of(field(2), VolumeFractionToTet, MaterialIdArray="id", Method="Cells").mesh
    with tempfile.TemporaryDirectory() as out:
        steps, result = run_example(2, out, LABELS="id", TETS="Cells", STEPS="2", EXODUS="1",
                                    PICTURE="0")
        assert steps == [2] and NO_DISPLAY not in result.stdout
        # The host hands over this step and always the last one.
        assert "2 steps made" in result.stdout, result.stdout
        expect_mesh(out, 2, 2, gold)
        exodus = sorted(name for name in os.listdir(out) if ".e." in name)
        assert exodus == ["mesh_000002.e.2.0", "mesh_000002.e.2.1"], exodus


def test_state():
    """State is copied, or conserved to first order with the labels as densities."""
    copied = mesh_of(field(1), StateArrays=["ball", "id"]).mesh
    conserved = mesh_of(field(2), StateArrays=["ball"], DensityArrays=["id"],
                        StateKinds=["ball=volume"], StateOrder=1).mesh
    more = {"DENSITY": "id", "STATE_KINDS": "ball=volume", "STATE_ORDER": "1",
            "STATE_TRANSFER": "conserve", "LOST_KINETIC_ENERGY": "InternalEnergy"}
    for step, gold, settings in ((1, copied, {"STATE": "ball,id"}),
                                 (2, conserved, {"STATE": "ball", **more})):
        with tempfile.TemporaryDirectory() as out:
            assert run_example(2, out, STEPS=str(step), PICTURE="0", **settings)[0] == [step]
            expect_mesh(out, step, 2, gold)


def test_particles():
    """Particles are those of the filter, in a file beside the mesh."""
    data = field(1)
    vtk_to_numpy(data.GetCellData().GetArray("ball"))[-1] = 0.1
    gold = mesh_of(data, UnmeshedMaterial="Particles", StateArrays=["id"])
    assert gold.particles.GetNumberOfPoints() == 1
    with tempfile.TemporaryDirectory() as out:
        assert run_example(2, out, "--drop", STEPS="1", PICTURE="0", STATE="id",
                           UNMESHED="particles")[0] == [1]
        expect_mesh(out, 1, 2, gold.mesh)
        reader = vtkXMLPPolyDataReader()
        reader.SetFileName(os.path.join(out, "mesh_particles_000001.pvtp"))
        reader.Update()
        found = reader.GetOutput()
        assert found.GetPoint(0) == gold.particles.GetPoint(0)
        for name in ("Id", "Material", "Radius", "Volume", "id"):
            own, other = (part.GetPointData().GetArray(name) for part in (found, gold.particles))
            assert own.GetNumberOfTuples() == 1 and own.GetTuple(0) == other.GetTuple(0), name


def test_triggers():
    # the ball enters the plate
    """Triggers select the expected steps."""
    plate = [3 * CELLS[0] * CELLS[1] - part_in_ball(step)[:3].sum() for step in range(STEPS)]
    limit = 0.5 * (plate[-2] + plate[-1])
    assert plate[0] > limit > plate[-1] and plate == sorted(plate)[::-1], plate
    expected = {"Fragments changes": [0, 2], "Fragments < 1.5": [2], "sum plate < %r" % limit: [3],
                "max velocity > 0.1": [0], "max velocity > 100": [], "min ball < 0": []}
    with tempfile.TemporaryDirectory() as out:
        steps, result = run_example(2, out, TRIGGER=";".join(expected))
        assert steps == [0, 2, 3]
        lines = re.findall(r"mesh_(\d+).pvtu: .* \((.*)\)", result.stdout)
        reasons = {int(step): text.split("; ") for step, text in lines}
        for trigger, fired in expected.items():
            assert [step for step in steps if trigger in reasons[step]] == fired, (trigger, reasons)
    with tempfile.TemporaryDirectory() as out:
        assert run_example(1, out, TRIGGER="Fragments < 1.5", EVERY="3")[0] == [0, 2, 3]


def test_arrays_are_the_hosts_memory():
    """Catalyst receives the memory of the host without a copy."""
    for ranks, options in ((1, ()), (2, ()), (2, ("--boxes", "1"))):
        result = run_code(ranks, ZERO_COPY, options=options)
        # only rank 0 prints
        assert result.returncode == 0 and result.stdout.count("handed over") == STEPS, result


def test_nothing_is_made_that_nobody_wants():
    """If the script requests no step, no grid is made, except at the last step."""
    result = run_code(2, WANTS_NOTHING, options=("--bad-step", "1"))
    # The last step is always handed over. The invalid grid at an earlier step is not checked.
    assert result.returncode == 0 and "host: 1 steps made" in result.stdout, result


def expect_failure(result, text, failed, made, others=()):
    """Checks the output of the host, which must run to the end.

    Exactly the steps in `failed` report the text on all
    ranks; steps in `others` fail for another reason.
    """
    assert result.returncode == 3, result
    for step in range(STEPS):
        told = re.search(r"host: step %d (.*?)\n(?=host:|executed|catalyst_mesh|$)" % step,
                         result.stdout, re.DOTALL)
        line = told.group(1)
        assert (text in line) == (step in failed), (step, line)
        assert line.startswith("failed" if step in failed or step in others
                               else "done"), (step, line)
    assert "host: %d steps made" % made in result.stdout, result.stdout


def test_failing_scripts_leave_the_host_alive():
    """Scripts that raise an exception or exit are reported, and all steps are run."""
    every = list(range(STEPS))
    expect_failure(run_code(2, RAISES_ON_LAST_RANK), "script0.py: ValueError: only here", every, 4)
    result = run_code(2, RAISES_AT_STEP_1, EXITS)
    expect_failure(result, "script0.py: ValueError: a script that fails", [1], 4, others=every)
    expect_failure(result, "script1.py: SystemExit: 7", every, 4)
    # only rank 0 prints
    assert "Traceback" in result.stderr and result.stdout.count("executed") == 3, result
    result = run_code(2, EXITS_AT_IMPORT, NO_PYTHON, RAISES_IN_INITIALIZE)
    for text in ("script0.py: SystemExit: 7", "script1.py: SyntaxError",
                 "script2.py: KeyError: 'cannot begin'"):
        expect_failure(result, text, every, 0)
    result = run_code(2, RAISES_IN_FINALIZE)
    assert result.returncode == 0 and "cannot end" in result.stderr, result


def test_script_that_fails_while_others_wait_in_a_filter():
    """If a script fails on one rank, a filter that waits on the other ranks ends."""
    result = run_code(3, RAISES_WHILE_OTHERS_MESH)
    expect_failure(result, "script0.py: ValueError: only here", [1], 4)
    assert "ValueError: only here" in result.stderr, result.stderr
    for step in range(STEPS):  # only rank 0 prints
        assert "rank 0 meshed step %d: %s" % (step, step != 1) in result.stdout, result.stdout


def test_missing_script():
    every = list(range(STEPS))
    expect_failure(run_host(2, ["/no/such/script.py"]), "Script /no/such/script.py cannot be read",
                   every, 0)
    # Other scripts run.
    with tempfile.TemporaryDirectory() as out:
        result = run_host(1, ["/no/such/script.py", EXAMPLE], OUT=out, STEPS="1", PICTURE="0")
        expect_failure(result, "Script /no/such/script.py cannot be read", every, 2)
        expect_mesh(out, 1, 1, mesh_of(field(1)).mesh)


def test_wrong_grids_and_settings():
    """Wrong grids and settings are reported at the step."""
    folder = tempfile.TemporaryDirectory()
    result = run_host(2, [EXAMPLE], "--bad-step", "2", OUT=folder.name, PICTURE="0")
    expect_failure(result, "[3, 15) x [0, 12) x [0, 10) leaves the grid along x", [2], 3)
    for settings, text in (
            ({"ARRAYS": "ball,steel"}, "no mesh of step 0: "),
            ({"TRIGGER": "Holes changes"}, "no number 'Holes'"),
            ({"TRIGGER": "sum steel > 1"}, "no cell array 'steel'"),
            ({"TRIGGER": "more fragments"}, "cannot read 'more"),
            ({"PLUGIN": "/no/plugin.so"}, "")):
        result = run_host(1, [EXAMPLE], OUT=folder.name, **settings)
        assert result.returncode == 3 and "host: step 0 failed: Script " in result.stdout, result
        assert text in result.stdout and result.stdout.count("host: step") == STEPS, result


def check_picture():
    for ranks in (1, 2):
        with tempfile.TemporaryDirectory() as out:
            steps, result = run_example(ranks, out, STEPS="0,3")
            assert NO_DISPLAY not in result.stdout, result.stdout
            pictures = []
            for step in steps:
                reader = vtkPNGReader()
                reader.SetFileName(os.path.join(out, "mesh_%06d.png" % step))
                reader.Update()
                pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)[
                    :, :3]
                blue, brown = pixels[:, 2] - pixels[:, 0] > 40, pixels[:, 0] - pixels[:, 2] > 40
                share = blue.mean(), brown.mean()  # ball and plate, under any light
                print("%d ranks, step %d: %.4f of the picture blue, %.4f brown"
                      % (ranks, step, *share))
                assert 0.01 < share[0] < 0.3 and 0.05 < share[1] < 0.6, share
                pictures.append(pixels)
            assert (pictures[0] != pictures[1]).any()


PICTURE = "--picture" in sys.argv
main({"test_picture": check_picture} if PICTURE else globals())
