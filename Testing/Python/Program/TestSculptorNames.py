"""Tests that no output of sculptor replaces an input or another output."""
import os

from sculptor_program import mesh_file, refused
from vfmtest import fraction_image, in_folder, main, write


def contents(folder):
    found = {}
    for name in os.listdir(folder):
        with open(os.path.join(folder, name), "rb") as file:
            found[name] = file.read()
    return found


@in_folder
def test_outputs_need_their_own_names(at):
    path, names = write(fraction_image(8), at("in.vti")), at("names.txt")
    with open(names, "w", encoding="ascii") as file:
        file.write("1 one\n")
    for suffix in (".vtu", ".e"):
        mesh_file(path, at("mesh" + suffix))
    os.symlink("mesh.vtu", at("link.vtu"))
    before = contents(at(""))
    os.symlink("new.vtu", at("later.vtu"))
    mesh = (at("mesh.vtu"), "--labels", "MaterialId")
    for words, one, other in (
            ((path, at("new.vtu"), "--fragments", at("new.vtu")), "--fragments", "output"),
            ((path, at("new.vtu"), "--fragments", at("later.vtu")), "--fragments", "output"),
            ((path, at("new.vtu"), "--fragments", path), "--fragments", "input"),
            ((path, at("new.vtu"), "--label-names", names, "--fragments", names), "--fragments",
             "--label-names"),
            ((path, at("new.stl"), "--surfaces", at("new.stl")), "--surfaces", "output"),
            ((path, at("new.vtu"), "--report", at("r.html"), "--fragments", at("r.html")),
             "--report", "--fragments"),
            ((mesh[0], at("mesh.vtu"), *mesh[1:]), "output", "input"),
            ((mesh[0], at("link.vtu"), *mesh[1:]), "output", "input"),
            ((at("mesh.e"), at(".") + "/mesh.e", *mesh[1:]), "output", "input")):
        for ranks in (1, 2):
            refused(1, "The %s %s is the same file as the %s " % (one, words[1 if one == "output"
                    else words.index(one) + 1], other), *words, ranks=ranks)
    os.remove(at("later.vtu"))
    assert contents(at("")) == before


@in_folder
def test_slices_are_inputs(at):
    os.mkdir(at("slices"))
    for number in range(3):
        with open(at("slices/%d.png" % number), "wb") as file:
            file.write(b"slice")
    before = contents(at("slices"))
    for path in (at("slices"), at("slices/*.png")):
        refused(1, "is the same file as the input", path, at("new.vtu"), "--fragments",
                at("slices/1.png"))
    assert contents(at("slices")) == before


@in_folder
def test_devices_are_shared(at):
    path = write(fraction_image(8), at("in.vti"))
    mesh_file(path, at("new.vtu"), "--fragments", os.devnull)


main(globals())
