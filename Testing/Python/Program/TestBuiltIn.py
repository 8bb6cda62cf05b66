"""The built-in test `sculptor test`, for each kind of mesh on several ranks."""
import itertools

from vtkmodules.util.numpy_support import vtk_to_numpy

from compare_meshes import read_pieces
from sculptor_program import rows, sculptor
from vfmtest import TET_METHODS, in_folder, main

BOXES = [209, 302], [1136, 1450]  # elements and points, original and refined


@in_folder
def test_built_in_test(at):
    for ranks in (1, 4, 12):
        result = sculptor("test", "--output", at("boxes.vtu"), ranks=ranks)
        assert result.returncode == 0 and result.stderr == "" and result.stdout.endswith(
            "\nPASS\n"), result
        assert "WRONG" not in result.stdout and result.stdout.count("right:") == 20
        for text, counts in zip(result.stdout.split("Refined 1"), BOXES):
            assert rows(text)["all"][:2] == counts, text
        mesh = read_pieces(at("boxes.vtu"))[0]
        assert mesh.GetNumberOfCells() == BOXES[1][0]
        assert set(vtk_to_numpy(mesh.GetCellData().GetArray("FragmentId")).tolist()) == {1, 2}
    assert sculptor("test", "--quiet", "--refine", "2", ranks=2).stdout == "PASS\n"


def test_built_in_test_of_every_kind():
    """Combines all elements, smoothing and refinement on one rank, and each also on two or four."""
    kinds = [[], *[["--tetmesh", method] for method in TET_METHODS]]
    smoothings = [[], ["--no-smooth"], ["--smooth", "2"], ["--stairstep"]]
    refinements = [[], ["--refine-cells"]]
    for k, s, r in itertools.product(*[range(len(choices))
                                       for choices in (kinds, smoothings, refinements)]):
        words = kinds[k] + smoothings[s] + refinements[r] + ["--material", "1"]
        outputs = []
        for ranks in (1, (2, 4)[(k + r) % 2]) if s == (k + 2 * r) % len(smoothings) else (1,):
            result = sculptor("test", *words, ranks=ranks)
            assert result.returncode == 0 and result.stderr == "" and result.stdout.endswith(
                "\nPASS\n"), (words, result)
            assert "WRONG" not in result.stdout and result.stdout.count("the elements conform") == 2
            outputs.append(result.stdout)
        assert outputs[0] == outputs[-1] or "TetGen" in words, words


@in_folder
def test_built_in_test_of_chosen_cells(at):
    """Box 1 has fine cells and transitions; box 2 is as without refinement."""
    out = sculptor("test", "--refine-cells", "--output", at("boxes.vtu"), ranks=2).stdout
    plain, refined = out.split("Chosen cells refined\n")
    assert rows(plain)["2 of material 1"][:2] == rows(refined)["2 of material 1"][:2]
    assert rows(refined)["1 of material 1"][0] > 1.5 * rows(plain)["1 of material 1"][0]
    assert "3 chosen cells" in refined and "3 chosen cells" not in plain
    assert read_pieces(at("boxes.vtu"))[0].GetFieldData().GetArray("ChosenCells").GetValue(0) == 3


main(globals())
