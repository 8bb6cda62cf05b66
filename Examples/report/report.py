"""Functions shared by the scripts of figures: fields of shapes, meshes made by sculptor on MPI
ranks, and the table of a figure.

"The report" is SAND2010-6400 (Owen, Staten: Parallel octree-based hexahedral mesh generation for
Eulerian to Lagrangian conversion)."""
import os
import subprocess
import sys

from paraview import simple

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
BUILD = os.environ.get("BUILD_DIR", os.path.join(ROOT, "build"))
PLUGIN, SCULPTOR, IMPACT = (os.path.join(BUILD, name)
                            for name in ("lib/VolumeFractionMesh.so", "bin/sculptor", "bin/impact"))
sys.path.insert(0, os.path.dirname(HERE))
from load_plugin import load_plugin
from need_files import need_files

import rank_meshes

# pvpython is an MPI program itself. The programs that it starts must not use its variables.
OF_THIS_PROCESS = ("PMIX_", "PMI_", "ORTE_", "OMPI_")


def run(figure):
    """Makes a figure: calls figure(out) with the folder of the figure, which is the only argument
    of the command line. Prints and writes the table of the rows that it returns: (name, our value,
    value of the report or empty)."""
    script = sys.modules["__main__"]
    if len(sys.argv) != 2:
        sys.exit(script.__doc__)
    need_files(PLUGIN, SCULPTOR)
    out = sys.argv[1]
    os.makedirs(out, exist_ok=True)
    load_plugin(PLUGIN, vars(simple))
    simple._DisableFirstRenderCameraReset()
    lines = ["| | ours | report |", "|---|---|---|"] + [
        "| %s | %s | %s |" % row for row in figure(out)]
    print("\n".join(lines))
    name = os.path.splitext(os.path.basename(script.__file__))[0]
    with open(os.path.join(out, name + ".md"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def number(value):
    return "{:,}".format(value)


def quality_row(meshes, label=""):
    quality = rank_meshes.values(meshes, "ScaledJacobian")
    return (label + "smallest, mean scaled Jacobian",
            "%.3f, %.3f" % (quality.min(), quality.mean()), "")


def positive_row(meshes, theirs=""):
    return ("not positive",
            number(int((rank_meshes.values(meshes, "ScaledJacobian") <= 0).sum())), theirs)


def angles_row(meshes):
    ends = [rank_meshes.field_value(meshes, name + "DihedralAngle")
            for name in ("Minimum", "Maximum")]
    return "dihedral angles", "%.1f to %.1f degrees" % tuple(ends), ""


def counts_row(label, meshes):
    """Returns a row with the number of elements of each rank."""
    return label, ", ".join(number(mesh.GetNumberOfCells()) for mesh in meshes), ""


def shared_row(meshes, label=""):
    counts = rank_meshes.shared_points(meshes)
    return label + "points shared by ranks, of these not at one position", "%s, %s" % tuple(
        map(number, counts)), ""


def same_row(label, meshes, one):
    """Returns a row that compares a mesh with `one`, the mesh made on one rank."""
    same = rank_meshes.digest(meshes) == rank_meshes.digest(one)
    return label, "bitwise identical to one rank" if same else "DIFFERS from one rank", ""


def boxes_row(meshes, label=""):
    """Returns a row with the numbers of elements in the two boxes of the built-in test."""
    fragments = rank_meshes.values(meshes, "FragmentId")
    return (label + "hexahedra of the boxes",
            "%d, %d" % tuple((fragments == box).sum() for box in (1, 2)), "")


def run_program(program, *arguments, ranks=1):
    """Runs a program on MPI ranks, if necessary more than there are cores. Returns its standard
    output."""
    variables = {name: value for name, value in os.environ.items()
                 if not name.startswith(OF_THIS_PROCESS)}
    if os.geteuid() == 0:
        variables.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    variables["OMPI_MCA_mpi_yield_when_idle"] = "1"
    launcher = (["mpiexec", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)]
                if ranks > 1 else [])
    command = launcher + [program, *arguments]
    result = subprocess.run(command, env=variables, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if result.returncode != 0:
        sys.exit("%s failed with exit status %d: %s%s" % (
            " ".join(command), result.returncode, result.stdout, result.stderr))
    return result.stdout


def make_field(path, **properties):
    """Saves the output of the source Volume Fraction Shapes. Returns the path."""
    source = simple.VolumeFractionShapes(**properties)
    simple.SaveData(path, proxy=source, DataMode="Binary", CompressorType="ZLib")
    simple.Delete(source)
    return path


def eight_shapes(out):
    """Saves a field with one shape of each kind that CTH has, each a material. Returns the path."""
    return make_field(os.path.join(out, "eight_shapes.vti"), Preset="Eight Shapes",
                      Dimensions=[46, 46, 46], Bounds=[0, 46, 0, 46, 0, 46])


def mesh_field(field, path, *options, ranks=1):
    """Meshes a field with sculptor and returns the meshes of the ranks. path: .pvtu file to
    write."""
    run_program(SCULPTOR, field, path, "--quiet", *options, ranks=ranks)
    return rank_meshes.read_ranks(path)


def built_in_test(path, *options):
    """Runs sculptor test. Returns the last line that it prints, and the meshes of the ranks."""
    printed = run_program(SCULPTOR, "test", "--output", path, *options)
    return printed.splitlines()[-1], rank_meshes.read_ranks(path)
