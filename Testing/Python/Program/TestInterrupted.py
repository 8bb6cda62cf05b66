"""Outputs of `sculptor` when a signal or a full disk interrupts it: the earlier or the new ones.

VFM_MOMENTS: moments per format, fault and number of ranks; 10 before a release. By default, two of
the most important cases. A table of the outcomes is printed.
"""
import os
import resource
import shutil
import subprocess
import tempfile
import unittest

from file_faults import FULL, KILL, SIGNALS, Case, interrupt_all, read_tree
from mpi_run import mpi_run
from sculptor_program import SCULPTOR, refused, sculptor
from vfmtest import in_folder, main

MOMENTS = int(os.environ.get("VFM_MOMENTS", "0"))
SUFFIXES = (".vtu", ".pvtu", ".e", ".ex2", ".exo", ".inp", ".k", ".key", ".rad", ".bdf", ".nas",
            ".msh", ".xdmf", ".foam")
LINE = "sculptor: ended by %s; unfinished files are removed."
SIZE = 6  # cells along each axis


def write_labels(at):
    """Writes two fields of labels and returns their paths."""
    paths = []
    for name, labels in (("old.spn", (1, 2)), ("new.spn", (1, 2, 3, 3, 3))):
        paths.append(at(name))
        with open(paths[-1], "w", encoding="ascii") as file:
            file.write(" ".join(str(labels[cell // (SIZE * SIZE) % len(labels)])
                                for cell in range(SIZE ** 3)))
    return paths


def make_case(at, output, outputs, ranks, *options):
    """options: further arguments; {} is replaced by the folder of the outputs."""
    def command(path):
        return lambda folder: [
            SCULPTOR, path, os.path.join(folder, output), "--dimensions",
            "%d,%d,%d" % (3 * (SIZE,)), "--quiet",
            *(option.replace("{}", folder) for option in options)]

    old, new = write_labels(at)
    return Case(at, command(old), command(new), outputs, ranks, LINE)


def interrupt(at, output, outputs, ranks, options=(), faults=(*SIGNALS, FULL), moments=3):
    interrupt_all(" ".join((output, *(word for word in options if word.startswith("--")))),
                  make_case(at, output, outputs, ranks, *options), faults, MOMENTS or moments)


@in_folder
def test_each_format(at):
    for turn, suffix in enumerate(SUFFIXES):
        faults = (*SIGNALS, FULL) if MOMENTS else (SIGNALS[turn % 3],)
        interrupt(at, "mesh" + suffix, (".*",), 1, faults=faults)


@in_folder
def test_full_disk(at):
    for suffix in (".vtu", ".pvtu", ".e", ".foam"):
        interrupt(at, "mesh" + suffix, (".*",), 1, faults=(FULL,))


@in_folder
def test_ranks(at):
    for suffix in SUFFIXES if MOMENTS else (".pvtu", ".e", ".foam"):
        faults = (*SIGNALS, FULL) if MOMENTS else (SIGNALS[0], FULL)
        interrupt(at, "mesh" + suffix, (".*",), 3, faults=faults, moments=2)


@in_folder
def test_killed(at):
    """A program that is killed before its files have names leaves none."""
    if "linkat" not in make_case(at, "mesh.vtu", (".*",), 1).list_calls(0, True):
        raise unittest.SkipTest("the file system has no files without names")
    for suffix in SUFFIXES if MOMENTS else (".vtu", ".pvtu", ".e", ".foam"):
        for ranks in (1, 3) if MOMENTS else (1,):
            interrupt(at, "mesh" + suffix, (".*",), ranks, faults=(KILL,))


@in_folder
def test_further_files(at):
    """The table, the geometry and the report; equations of a periodic mesh."""
    options = ("--fragments", "{}/f.csv", "--geometry", "{}/g.vtm", "--report", "{}/r.html")
    outputs = (r"mesh\.vtu", r"f\.csv", r"g(\.vtm|/.*)", r"r\.html")
    for ranks in (1, 3) if MOMENTS else (1,):
        faults = (*SIGNALS, FULL) if MOMENTS else (SIGNALS[0], FULL)
        interrupt(at, "mesh.vtu", outputs, ranks, options, faults, moments=4)
        interrupt(at, "mesh.inp", (".*",), ranks, ("--periodic", "Z"), faults)


@in_folder
def test_one_of_several_programs_wins(at):
    """Six programs that write one name at once leave one of their meshes."""
    inputs = write_labels(at)
    size = ("--dimensions", "%d,%d,%d" % (3 * (SIZE,)), "--quiet")
    for suffix in (".e", ".pvtu", ".xdmf", ".foam"):
        trees = []
        for path in inputs:
            folder = at("alone" + suffix + os.path.basename(path))
            os.mkdir(folder)
            assert sculptor(path, os.path.join(folder, "same" + suffix), *size).returncode == 0
            trees.append(read_tree(folder))
        os.mkdir(at(suffix))
        programs = []
        for path in 3 * inputs:
            # Programs that end remove the folder of Open MPI while others create it.
            own = tempfile.mkdtemp(dir=os.path.dirname(path))
            programs.append(subprocess.Popen(
                [SCULPTOR, path, at(suffix + "/same" + suffix), *size],
                env={**os.environ, "TMPDIR": own, "OMPI_MCA_orte_tmpdir_base": own}))
        assert [program.wait() for program in programs] == 6 * [0]
        assert trees[0] != trees[1] and read_tree(at(suffix)) in trees, suffix


@in_folder
def test_links_modes_and_pipes(at):
    """The target of a link is replaced, permissions stay, and a pipe is written."""
    size = ("--dimensions", "%d,%d,%d" % (3 * (SIZE,)), "--quiet")
    path = write_labels(at)[0]
    os.mkdir(at("far"))
    for name in ("far/old.vtu", "plain.vtu"):
        with open(at(name), "wb"):
            os.chmod(at(name), 0o640)
    for target, link in (("far/old.vtu", "link.vtu"), ("link.vtu", "chain.vtu"),
                         ("far/new.vtu", "dangling.vtu")):
        os.symlink(target, at(link))
    for name in ("plain.vtu", "chain.vtu", "dangling.vtu"):
        assert sculptor(path, at(name), *size).returncode == 0, name
    assert os.path.islink(at("chain.vtu")) and os.path.islink(at("dangling.vtu"))
    meshes = [at(name) for name in ("plain.vtu", "far/old.vtu", "far/new.vtu")]
    content = [open(mesh, "rb").read() for mesh in meshes]
    assert content[0] == content[1] == content[2] and content[0]
    modes = [os.stat(mesh).st_mode & 0o777 for mesh in meshes]
    mask = os.umask(0)
    os.umask(mask)
    assert modes == [0o640, 0o640, 0o666 & ~mask], modes
    os.mkfifo(at("pipe.vtu"))
    with open(at("read"), "wb") as read, subprocess.Popen(["cat", at("pipe.vtu")], stdout=read):
        assert sculptor(path, at("pipe.vtu"), *size).returncode == 0
    with open(at("read"), "rb") as file:
        assert file.read() == content[0]
    os.mkdir(at("folder.vtu"))
    refused(4, "Is a directory", path, at("folder.vtu"), *size)


@in_folder
def test_limit_of_file_size(at):
    """A file beyond the limit of the process is an error; the earlier file stays."""
    path = write_labels(at)[0]
    with open(at("mesh.vtu"), "w", encoding="ascii") as file:
        file.write("earlier")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, limits[1]))
    try:
        refused(4, "File too large", path, at("mesh.vtu"), "--dimensions", "6,6,6", "--quiet")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    with open(at("mesh.vtu"), encoding="ascii") as file:
        assert file.read() == "earlier"
    assert sorted(os.listdir(at(""))) == ["mesh.vtu", "new.spn", "old.spn"]


@in_folder
def test_ignored_hangup(at):
    """A program that nohup started, which ignores SIGHUP, is not ended by it."""
    case = make_case(at, "mesh.vtu", (".*",), 1)
    command = case.new
    case.new = lambda folder: ["nohup", *command(folder)]
    case.restore(True)
    result = case.run(0, fault=int(SIGNALS[2]), fault_at=4)
    assert result.returncode == 0 and read_tree(case.folder) == case.trees[1], result


@in_folder
def test_first_process(at):
    """The first process of a container, which no signal ends by default, ends as well."""
    contain = ["unshare", "--pid", "--fork", "--kill-child"]
    if subprocess.run([*contain, "true"], check=False, stderr=subprocess.DEVNULL).returncode != 0:
        contain[1:1] = ["--user", "--map-root-user"]
        if subprocess.run([*contain, "true"], check=False).returncode != 0:
            raise unittest.SkipTest("this user cannot make containers")
    case = make_case(at, "mesh.vtu", (".*",), 1)
    command = case.new
    case.new = lambda folder: [*contain, *command(folder)]
    for fault in SIGNALS:
        case.restore(True)
        result = case.run(0, fault=int(fault), fault_at=4)
        # The kernel lets it end the process while the handler of its main thread still runs.
        assert result.returncode in (128 + fault, -fault), result
        assert result.stderr == LINE % fault.name + "\n", result
        assert read_tree(case.folder) == case.trees[0]


@in_folder
def test_closed_streams(at):
    """Without standard streams, warnings and the summary are printed nowhere."""
    path = at("void.spn")
    with open(path, "w", encoding="ascii") as file:
        file.write(" ".join(str(cell // SIZE ** 2 % 4) for cell in range(SIZE ** 3)))
    contents = []
    for closed in ("", "<&-", ">&-", "2>&-", "<&- >&-", "<&- 2>&-", "<&- >&- 2>&-"):
        os.mkdir(at("out"))
        command = [SCULPTOR, path, at("out/mesh.vtu"), "--dimensions", "%d,%d,%d" % (3 * (SIZE,)),
                   "--fragments", at("out/f.csv"), "--report", at("out/r.html")]
        result = mpi_run(1, ["sh", "-c", 'exec "$@" ' + closed, "sh", *command])
        assert result.returncode == 0, (closed, result)
        contents.append(read_tree(at("out")))
        assert len(contents[-1]) == 3 and contents[-1] == contents[0], closed
        shutil.rmtree(at("out"))


main(globals())
