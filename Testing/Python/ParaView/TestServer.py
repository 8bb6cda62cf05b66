"""A client and a server of two ranks: meshes, colour maps and writers.

The plugin is loaded on both sides, only on the server, or only on the client.

usage: pvpython TestServer.py
       pvpython TestServer.py PORT SIDES

The second form is the client, which prints the names in its colour map and the writers.
"""
import os
import re
import subprocess
import sys

from paraview import simple

from mpi_run import OF_THIS_PROCESS, SETTINGS

PLUGIN = os.environ["VFM_PLUGIN"]
FIELD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "Data",
                     "ball_and_plate.vti")
# A client without the plugin prints this message.
MISSED = re.compile("Could not create object of type: vtkSM(Mesh(ArrayList)?|CellCount)Domain")
OURS = "ExodusAndSetsWriter"
LIMIT = 300  # seconds; other users share the machine


def act_as_client(port, sides):
    """Shows a mesh, or an image with an array of the same name if the server lacks the filter."""
    simple.Connect("localhost", port)
    for remote, side in ((True, "server"), (False, "client")):
        if side in sides:
            simple.LoadPlugin(PLUGIN, remote=remote, ns=globals())
    field = simple.OpenDataFile(FIELD)
    if "server" in sides:
        shown = VolumeFractionToHex(Input=field, VolumeFractionArrays=["ball", "plate"],
                                    StairStep=1)
    else:
        shown = simple.Calculator(Input=field, AttributeType="Cell Data",
                                  ResultArrayName="MaterialId", Function="ball")
    view = simple.CreateRenderView()
    simple.ColorBy(simple.Show(shown, view), ("CELLS", "MaterialId"))
    cells = shown.GetDataInformation().GetNumberOfCells()
    print("RESULT", cells > 0, list(simple.GetColorTransferFunction("MaterialId").Annotations))
    other = simple.Tetrahedralize(Input=simple.Wavelet())
    print("WRITERS",
          *(simple.CreateWriter("mesh.e", source).GetXMLName() for source in (shown, other)))


def names_with(sides):
    """Returns what the client printed: names in the colour map, and writers for two data sets.

    The data sets are the one that it shows and another mesh.
    """
    plain = {name: value for name, value in os.environ.items()
             if not name.startswith(OF_THIS_PROCESS)}
    server = subprocess.Popen(["mpiexec", "--oversubscribe", "--bind-to", "none", "-n", "2",
                               "pvserver", "--server-port=0"],
                              env={**plain, **SETTINGS}, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, text=True)
    try:
        port = next(found[1]
                    for found in (re.match(r"Accepting connection\(s\): .*:(\d+)", line)
                                  for line in server.stdout) if found)
        client = subprocess.run(["pvpython", os.path.abspath(__file__), port, sides], env=plain,
                                stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                timeout=LIMIT)
        server.wait(LIMIT)
    finally:
        server.kill()
    errors = [line for line in client.stdout.splitlines() if "ERR|" in line
              and not MISSED.search(line)]
    assert client.returncode == 0 and not errors, client.stdout
    return [re.search("^%s (.*)$" % what, client.stdout, re.MULTILINE)[1]
            for what in ("RESULT", "WRITERS")]


def test_both():
    names, writers = names_with("server and client")
    assert names == "True ['1', 'ball', '2', 'plate']"
    assert [name == OURS for name in writers.split()] == [True, False], writers


def test_the_server_alone():
    assert names_with("server")[0] == "True []"


def test_the_client_alone():
    names, writers = names_with("client")
    assert names == "True []" and OURS not in writers


if len(sys.argv) == 3:
    act_as_client(int(sys.argv[1]), sys.argv[2])
else:
    from vfmtest import main

    main(globals())
