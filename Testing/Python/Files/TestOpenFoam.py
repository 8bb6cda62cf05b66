"""OpenFOAM cases of the plugin and of sculptor: the same bytes on any ranks, decomposed cases."""
import os

from mpi_run import mpi_run
from vfmtest import fraction_image, in_folder, main, mesh_of, producer, simple, write

SCULPTOR = os.environ["VFM_SCULPTOR"]


def read_folder(folder):
    """Returns the bytes of all files by path in the folder."""
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, folder)] = file.read()
    return found


@in_folder
def test_same_bytes_from_plugin_and_program(at):
    path = write(fraction_image(), at("in.vti"))
    mesh = producer(mesh_of(fraction_image()).mesh)
    for properties, arguments in (({}, []), ({"Binary": 1}, ["--binary"])):
        name = "binary" if properties else "text"
        os.mkdir(at(name))
        simple.SaveData(at(name + "/mesh.foam"), proxy=mesh, **properties)
        wanted = read_folder(at(name))
        assert len(wanted) == 12 and "constant/polyMesh/faces" in wanted, sorted(wanted)
        for form in (b"format      binary", b"faceCompactList"):
            assert (form in wanted["constant/polyMesh/faces"]) == bool(properties), form
        for word in (b"ball_to_Void", b"plate_to_Void", b"x_min"):
            assert word in wanted["constant/polyMesh/boundary"], word
        for ranks in (1, 3):
            folder = at("%s%d" % (name, ranks))
            os.mkdir(folder)
            run = mpi_run(ranks, [SCULPTOR, path, folder + "/mesh.foam", "--single-file",
                                  *arguments])
            assert run.returncode == 0 and run.stderr == "", run
            assert read_folder(folder) == wanted, (name, ranks)


@in_folder
def test_ranks_write_a_decomposed_case(at):
    path = write(fraction_image(), at("in.vti"))
    run = mpi_run(3, [SCULPTOR, path, at("mesh.foam")])
    assert run.returncode == 0 and run.stderr == "", run
    found = read_folder(at("."))
    assert len(found) == 1 + 5 + 3 * 12, sorted(found)
    for rank in range(3):
        boundary = found["processor%d/constant/polyMesh/boundary" % rank]
        assert b"procBoundary%dto" % rank in boundary, boundary


@in_folder
def test_missing_folder(at):
    path = write(fraction_image(), at("in.vti"))
    run = mpi_run(1, [SCULPTOR, path, at("case/mesh.foam")])
    assert run.returncode != 0 and "No such file or directory" in run.stderr, run
    assert os.listdir(at(".")) == ["in.vti"]


main(globals())
