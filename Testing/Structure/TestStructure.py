"""The sources follow the rules of the structure, and each rule detects a violation."""
import os
import unittest

from structure_rules import (
    LONGEST, MOST_AT_ROOT, MOST_IN_FOLDER, PUBLIC, find_problems, place_of, read_tree)

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


class ThisTree(unittest.TestCase):
    def test_keeps_the_rules(self):
        tree = read_tree(ROOT)
        self.assertLessEqual({"Grid/Base", "Mesher", "Mesher/Elements/Tet", "Shapes", "Filters",
                              "InSitu", "python"}, set(map(place_of, tree)))
        self.assertLessEqual(set(PUBLIC), set(tree))
        problems = find_problems(tree)
        self.assertFalse(problems, "\n" + "\n".join(problems))


class WrongTrees(unittest.TestCase):
    """A small tree without a problem; each test adds one violation."""

    def setUp(self):
        self.tree = {
            "Grid/CMakeLists.txt": ["vfm_install_library(vfm_grid Cells .\n", "  Base/Ranks.h)\n"],
            "Mesher/CMakeLists.txt": ["vfm_install_library(vfm_mesher Mesher .\n",
                                      "  Mesher.h TetGen/Fill.h Elements/Mesh.h)\n"],
            "Grid/Base/Ranks.h": ["#include <vector>\n"],
            "Grid/Base/Ranks.cxx": ['#include "Base/Ranks.h"\n'],
            "Mesher/Elements/Mesh.h": ['#include "Base/Ranks.h"\n'],
            "Mesher/TetGen/Fill.h": ['#include "Elements/Mesh.h"\n', "#include <tetgen.h>\n"],
            "Mesher/Mesher.h": ['#include "TetGen/Fill.h"\n'],
            "Mesher/Mesher.cxx": ['#include "Mesher.h"\n'],
            "Shapes/Shapes.h": ['#include "Base/Ranks.h"\n'],
            "Parallel/Vtk/Controller.h": ['#include "Base/Ranks.h"\n', "#include <vtkObject.h>\n"],
            "IO/Meshes/Writer.h": ['#include "Base/Ranks.h"\n'],
            "Filters/vtkFilter.h": ['#include "Mesher.h"\n', '#include "Shapes/Shapes.h"\n',
                                    '#include "vtkFilterModule.h"\n'],
            "InSitu/Sculptor.h": ['#include "Base/Ranks.h"\n', "#include <mpi.h>\n"],
            "Examples/impact/Options.h": [],
            "Examples/impact/main.cxx": ['#include "Options.h"\n', '#include "Sculptor.h"\n'],
            "Testing/Support/Cases.h": ['#include "Mesher.h"\n'],
            "Testing/Grid/CasesTest.cxx": ['#include "Cases.h"\n'],
        }

    def expect(self, problem, path, *lines):
        """Adds lines to a file and checks that this is the only problem of the tree."""
        self.tree.setdefault(path, []).extend(line + "\n" for line in lines)
        found = find_problems(self.tree)
        self.assertEqual(len(found), 1, found)
        self.assertIn(problem, found[0])

    def test_nothing_is_wrong_at_first(self):
        self.assertEqual(find_problems(self.tree), [])

    def test_include_upwards(self):
        self.expect("Grid/Base must not include Elements/Mesh.h of Mesher/Elements",
                    "Grid/Base/Other.h",
                    '#include "Elements/Mesh.h"')

    def test_include_of_the_root(self):
        self.expect("Mesher/TetGen must not include Mesher.h of Mesher", "Mesher/TetGen/Other.h",
                    '#include "Mesher.h"')

    def test_position_and_spaces(self):
        self.expect("Grid/Base/Other.h:2: ", "Grid/Base/Other.h", "#include <map>",
                    '  #  include "TetGen/Fill.h"')

    def test_room_not_named(self):
        self.expect("Ranks.h does not name its module", "Grid/Base/Other.h", '#include "Ranks.h"')

    def test_room_not_named_elsewhere(self):
        self.expect("../Elements/Mesh.h does not name its module", "Mesher/TetGen/Other.h",
                    '#include "../Elements/Mesh.h"')

    def test_no_such_file(self):
        self.expect("there is no Base/Gone.h", "Mesher/TetGen/Other.h", '#include "Base/Gone.h"')

    def test_grid_with_vtk(self):
        self.expect("does not know VTK: vtkObject.h", "Grid/Labels/Other.h",
                    "#include <vtkObject.h>")

    def test_grid_with_mpi(self):
        self.expect("does not know MPI: mpi.h", "Mesher/Other.h", '#include "mpi.h"')

    def test_shapes_with_vtk(self):
        self.expect("does not know VTK: vtkObject.h", "Shapes/Shapes.h", "#include <vtkObject.h>")

    def test_c_interface_with_vtk(self):
        self.expect("InSitu does not know VTK: vtkObject.h", "InSitu/Other.cxx",
                    "#include <vtkObject.h>")

    def test_transport_knows_mpi(self):
        self.tree["Parallel/Mpi/Transport.cxx"] = ["#include <mpi.h>\n"]
        self.expect("Parallel/Mpi does not know VTK: vtkMPI.h", "Parallel/Mpi/Transport.cxx",
                    "#include <vtkMPI.h>")

    def test_wrong_folders(self):
        wrong = {
            "Mesher/Elements/Hex/Other.h": "Shapes/Shapes.h",
            "Shapes/Other.h": "Elements/Mesh.h",
            "Parallel/Vtk/Other.h": "Writer.h",
            "IO/Other.h": "Controller.h",
            "Filters/Other.h": "Writer.h",
            "InSitu/Other.h": "Shapes/Shapes.h",
            "Program/Other.h": "CasesTest.cxx",
            "Plugin/Other.h": "Base/Ranks.h",
            "Examples/Other.h": "Controller.h",
            "Filters/Test.h": "Cases.h",
            "Testing/Support/Other.h": "CasesTest.cxx",
        }
        tree = self.tree
        for path, name in wrong.items():
            with self.subTest(path):
                self.tree = dict(tree)
                self.expect("%s must not include %s" % (place_of(path), name), path,
                            '#include "%s"' % name)

    def test_circle(self):
        self.tree["IO/A.h"] = ['#include "B.h"\n']
        self.expect("circle: IO/A.h > IO/B.h > IO/A.h", "IO/B.h", '#include "A.h"')

    def test_circle_of_modules(self):
        folder = "python/volume_fraction_mesh/"
        self.tree[folder + "_a.py"] = ["from ._b import b\n"]
        tree = dict(self.tree)
        circle = "circle: {0}_a.py > {0}_b.py > {0}_a.py".format(folder)
        for text in ("from . import _a", "def b():\n    from ._a import a\n    return a",
                     "if TYPE_CHECKING:\n    from ._a import A"):
            with self.subTest(text):
                self.tree = dict(tree)
                self.expect(circle, folder + "_b.py", text)

    def test_type_twice(self):
        self.tree["Grid/Base/One.h"] = ["namespace vfm\n", "{\n", "class Later;\n",
                                        "template <class T, class U>\n", "struct Box\n", "{\n",
                                        "};\n", "template <>\n",
                                        "struct Box<int, int> // struct Box {\n", "{\n", "};\n",
                                        "}\n"]
        self.tree["Grid/Base/Two.h"] = ["namespace vfm\n", "{\n", "namespace\n", "{\n",
                                        "struct Box\n", "{\n", "};\n", "}\n", "struct Outer\n",
                                        "{\n", "struct Box\n", "{\n", "};\n", "};\n",
                                        "Box f(class Box b) { return b; }\n", "}\n"]
        self.expect("vfm::Box is in Grid/Base/One.h and Grid/Base/Three.h", "Grid/Base/Three.h",
                    "namespace vfm { class Box final : public Outer", "{", "}; }")

    def test_source_without_header(self):
        self.tree["Grid/Base/tool.cxx"] = ["int main()\n"]
        self.expect("Grid/Base/Other.cxx has no header of its name", "Grid/Base/Other.cxx", "")

    def test_crowded_folder(self):
        for number in range(MOST_IN_FOLDER):
            self.tree["Grid/Octree/File%d.h" % number] = []
        self.expect("Grid/Octree has %d files" % (MOST_IN_FOLDER + 1), "Grid/Octree/File.h", "")

    def test_new_folder(self):
        self.expect("Grid/Attic is not in the table", "Grid/Attic/Other.h", "// nothing")

    def test_root_fills_up(self):
        for number in range(MOST_AT_ROOT - 3):
            self.tree["Mesher/File%d.h" % number] = []
        self.expect("Mesher's root has %d files" % (MOST_AT_ROOT + 1), "Mesher/README", "")

    def test_header_not_installed(self):
        self.tree["Mesher/Elements/Mesh.h"].append('#include "Base/Other.h"\n')
        self.expect("Grid/Base/Other.h is not installed", "Grid/Base/Other.h", "")

    def test_header_installed_in_vain(self):
        self.tree["Grid/CMakeLists.txt"] = ["vfm_install_library(vfm_grid Cells .\n",
                                            "  Base/Ranks.h Labels/Gone.h)\n"]
        self.expect("Grid/Labels/Gone.h is installed, but no public", "Grid/Labels/Gone.h", "")

    def test_long_file(self):
        self.expect("IO/Long.py has %d lines" % (LONGEST + 1), "IO/Long.py",
                    *["pass"] * (LONGEST + 1))


if __name__ == "__main__":
    unittest.main()
