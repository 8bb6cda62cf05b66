"""AMReX plotfiles (folders) with `sculptor`: meshes, and truncated or damaged files."""
import os
import shutil

from amr_files import make_amr, vtk_amr, write_plotfile, write_vthb
from compare_meshes import difference, merge, read_pieces
from sculptor_program import check_same, mesh_file, refused
from vfmtest import in_folder, main, mesh_of

FLAT = make_amr(levels=1, roots=(2, 2, 2))


@in_folder
def test_mesh(at):
    """The mesh is that of the VTK data set, on 1 to 3 ranks and for selected fractions."""
    folder = write_plotfile(at("plt00000"), FLAT, time=0.25)
    mesh = mesh_of(vtk_amr(FLAT), VolumeFractionArrays=["ball", "rest"]).mesh
    for ranks in (1, 2, 3):
        text = mesh_file(folder, at("out.vtu"), ranks=ranks)
        assert "time 0.25\n" in text and "materials from ball, rest (all cell arrays" in text, text
        check_same(at("out.vtu"), mesh, 0.25)
    text = mesh_file(folder + "/", at("one.vtu"), "--fractions", "ball")
    assert "rest" not in text
    mesh_file(write_vthb(at("one.vthb"), FLAT), at("vthb.vtu"), "--fractions", "ball")
    problem = difference(merge(read_pieces(at("vthb.vtu"))),
                         merge(without_time(read_pieces(at("one.vtu")))))
    assert not problem, problem


def without_time(pieces):
    for piece in pieces:
        piece.GetFieldData().RemoveArray("TimeValue")
    return pieces


@in_folder
def test_refused(at):
    """Missing arrays and folders without a valid Header are reported."""
    folder = write_plotfile(at("plt"), FLAT)
    refused(2, "no numeric array 'x' (--fractions). Its cell arrays: "
            "ball (double, 0 to 1), rest (double",
            "--input", folder, "--fractions", "x", "--output", at("no.vtu"), ranks=2)
    os.mkdir(at("empty"))
    refused(2, "contains no file of a slice", "--input", at("empty"), "--output", at("no.vtu"))
    open(at("empty/Header"), "w").close()
    refused(2, "the file is empty", "--input", at("empty"), "--output", at("no.vtu"), ranks=2)


def line(number, text):
    """Returns a function that replaces a line of a text."""
    def change(content):
        lines = content.split(b"\n")
        lines[number] = text
        return b"\n".join(lines)
    return change


def cut(size):
    return lambda content: content[:size]


def replace(old, new):
    def change(content):
        assert old in content
        return content.replace(old, new, 1)
    return change


@in_folder
def test_damaged(at):
    """Each damage gives one message with the file and the expected contents."""
    whole = write_plotfile(at("whole"), FLAT)
    size = os.path.getsize(at("whole/Level_0/Cell_D_00000"))
    cases = [
        ("Header", cut(16), "should have the names of 2 arrays"),
        ("Header", cut(14), "should have a number of arrays"),
        ("Header", line(1, b"-1"), "a number of arrays"),
        ("Header", line(1, b"99999999999"), "a number of arrays"),
        ("Header", line(4, b"2"), "is not three-dimensional"),
        ("Header", line(4, b"7"), "a number of dimensions"),
        ("Header", line(5, b"nan"), "a time"),
        ("Header", line(6, b"1000"), "the finest level"),
        ("Header", line(6, b"1"), "the ratio of each level"),
        ("Header", line(7, b"0 0"), "Header is truncated, damaged or of another format"),
        ("Header", line(10, b"((0,0,0) (7,-7,7) (0,0,0))"), "the cells of the domain"),
        ("Header", line(12, b"0.25 0 0.5"), "sizes of cells above 0"),
        ("Header", line(13, b"1"), "is not on Cartesian coordinates"),
        ("Header", line(15, b"0 9 0.5"), "the corners of all boxes of level 0"),
        ("Header", line(15, b"0 0 0.5"), "the number of boxes of level 0"),
        ("Header", cut(-12), "the folder and the name of the files of level 0"),
        ("Header", replace(b"Level_0/Cell", b"Level_7/Cell"),
         "Level_7/Cell_H cannot be read: No such file"),
        ("Level_0/Cell_H", None, "Level_0/Cell_H cannot be read: No such file"),
        ("Level_0/Cell_H", line(0, b"2"), "version 1 of its format"),
        ("Level_0/Cell_H", line(2, b"3"), "as many arrays as Header, 2"),
        ("Level_0/Cell_H", line(3, b"1"), "no ghost cells"),
        ("Level_0/Cell_H", line(4, b"(7 0"), "as many boxes as Header, 8"),
        ("Level_0/Cell_H", line(5, b"((0,0,0) (3,3,3)"), "as many boxes as Header, 8"),
        ("Level_0/Cell_H", line(15, b""), "the files of all boxes"),
        ("Level_0/Cell_H", line(15, b"FabOnDisk: Cell_D_00000 -5"), "positions in files"),
        ("Level_0/Cell_H", line(15, b"FabOnDisk: Cell_D_00009 0"),
         "Cell_D_00009 cannot be read: No such file"),
        ("Level_0/Cell_H", line(15, b"FabOnDisk: Cell_D_00000 %d" % size),
         "a box at byte %d" % size),
        ("Level_0/Cell_H", line(15, b"FabOnDisk: Cell_D_00000 7"), "a box at byte 7"),
        ("Level_0/Cell_H", line(5, b"((0,0,0) (3,3,2) (0,0,0))"),
         "the same box at byte 0 as the list of its level"),
        ("Level_0/Cell_D_00000", None, "Cell_D_00000 cannot be read: No such file"),
        ("Level_0/Cell_D_00000", cut(size - 1), "bytes up to %d, it has %d" % (size, size - 1)),
        ("Level_0/Cell_D_00000", cut(size // 2), "Cell_D_00000 is truncated"),
        ("Level_0/Cell_D_00000", cut(20), "numbers of 32 or 64 bits at byte 0"),
        ("Level_0/Cell_D_00000", replace(b"(64 11", b"(48 11"),
         "numbers of 32 or 64 bits at byte 0"),
        ("Level_0/Cell_D_00000", replace(b"(8, (8 7", b"(8, (9 7"),
         "numbers of 32 or 64 bits at byte 0"),
        ("Level_0/Cell_D_00000", replace(b"(0,0,0)) 2\n", b"(0,0,0)) 1\n"), "2 arrays at byte 0"),
    ]
    for number, (name, change, text) in enumerate(cases):
        shutil.rmtree(at("plt"), ignore_errors=True)
        shutil.copytree(whole, at("plt"))
        path = os.path.join(at("plt"), name)
        if change:
            with open(path, "rb") as file:
                content = file.read()
            with open(path, "wb") as file:
                file.write(change(content))
        else:
            os.remove(path)
        refused(2, text, "--input", at("plt"), "--output", at("no.vtu"), ranks=1 + number % 5 // 4)


main(globals())
