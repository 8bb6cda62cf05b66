"""Gmsh files of the plugin and of sculptor: names, forms, and the same bytes on any ranks."""
import os

from mpi_run import mpi_run
from vfmtest import fraction_image, in_folder, main, mesh_of, producer, simple, write

SCULPTOR = os.environ["VFM_SCULPTOR"]
FORMS = [({}, []), ({"Version": "2.2", "Binary": 1}, ["--msh-version", "2.2", "--binary"]),
         ({"Version": "4.1"}, ["--msh-version", "4.1"]),
         ({"Version": "4.1", "Binary": 1}, ["--msh-version=4.1", "--binary"])]


def read(path):
    with open(path, "rb") as file:
        return file.read()


def names_in(text):
    lines = text.decode().split("$PhysicalNames\n")[1].split("$EndPhysicalNames")[0].splitlines()
    return {(int(line.split()[0]), line.split('"')[1]) for line in lines[1:]}


@in_folder
def test_same_bytes_from_plugin_and_program(at):
    """SaveData and sculptor on 1 and 3 ranks write identical files in each form."""
    path = write(fraction_image(), at("in.vti"))
    mesh = producer(mesh_of(fraction_image()).mesh)
    headers = set()
    for properties, arguments in FORMS:
        simple.SaveData(at("plugin.msh"), proxy=mesh, **properties)
        wanted = read(at("plugin.msh"))
        headers.add(wanted[:20])
        for ranks in (1, 3):
            run = mpi_run(ranks, [SCULPTOR, path, at("%d.msh" % ranks), *arguments])
            assert run.returncode == 0 and run.stderr == "", run
            assert read(at("%d.msh" % ranks)) == wanted, (properties, ranks)
    assert len(headers) == 4, headers


@in_folder
def test_names(at):
    """Version 4.1 also has the groups that overlap others."""
    mesh = producer(mesh_of(fraction_image()).mesh)
    one = {(3, "ball"), (3, "plate"), (2, "ball_to_plate"), (2, "ball_to_Void")}
    more = {(2, "ball_skin"), (2, "plate_skin"), (2, "interfaces")}
    for version, names in (("2.2", one), ("4.1", one | more)):
        simple.SaveData(at("mesh.msh"), proxy=mesh, Version=version)
        found = names_in(read(at("mesh.msh")))
        assert names < found and (2, "plate_to_ball") not in found, found
        assert version == "4.1" or not more & found, found


@in_folder
def test_form_of_other_files(at):
    path = write(fraction_image(), at("in.vti"))
    run = mpi_run(1, [SCULPTOR, path, at("out.vtu"), "--binary"])
    assert run.returncode != 0 and "Formats that have it: .msh" in run.stderr, run
    run = mpi_run(1, [SCULPTOR, path, at("out.msh"), "--msh-version", "3"])
    assert run.returncode != 0 and "--msh-version takes 2.2 or 4.1, not '3'." in run.stderr, run
    assert os.listdir(at(".")) == ["in.vti"]


main(globals())
