"""Input files of LS-DYNA, OpenRadioss and Nastran: ParaView and sculptor write identical files."""
import os

from mpi_run import mpi_run
from vfmtest import (
    VolumeFractionToHex, VolumeFractionToTet, collect, fraction_image, in_folder, main, producer,
    simple, write)

SCULPTOR = os.environ["VFM_SCULPTOR"]
SUFFIXES = (".k", ".key", ".rad", ".bdf", ".nas")


def read(path):
    with open(path, "rb") as file:
        return file.read()


@in_folder
def test_same_bytes(at):
    path = write(fraction_image(), at("in.vti"))
    for arguments, make, options in (([], VolumeFractionToHex, {}),
                                     (["--tetmesh", "Lattice"], VolumeFractionToTet,
                                      {"Method": "Lattice"})):
        mesher = make(Input=producer(fraction_image()), VolumeFractionArrays=["ball", "plate"],
                      **options)
        for suffix in SUFFIXES:
            writer = simple.CreateWriter(at("plugin" + suffix), mesher)
            assert (writer.GetClientSideObject().GetClassName()
                    == "vtkVolumeFractionSolverWriter"), suffix
            simple.SaveData(at("plugin" + suffix), proxy=mesher)
            run = mpi_run(2, [SCULPTOR, "--input", path, "--output", at("program" + suffix),
                              *arguments])
            assert run.returncode == 0, run
            plugin = read(at("plugin" + suffix))
            assert plugin.count(b"\n") > 1000 and plugin == read(at("program" + suffix)), suffix


@in_folder
def test_errors(at):
    """A file that cannot be written gives one message, and nothing is left."""
    mesher = VolumeFractionToHex(Input=producer(fraction_image()),
                                 VolumeFractionArrays=["ball", "plate"])
    for suffix in SUFFIXES:
        writer = simple.CreateWriter(at("missing/mesh" + suffix), mesher)
        errors, warnings = collect(writer.GetClientSideObject())
        writer.UpdateVTKObjects()
        assert writer.GetClientSideObject().Write() == 0 and not warnings
        assert len(errors) == 1 and "No such file" in errors[0], errors
    assert not os.path.exists(at("missing"))


main(globals())
