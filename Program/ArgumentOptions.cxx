#include "ArgumentOptions.h"

#include "Base/ParseText.h"
#include "Meshes/FormatTable.h"
#include "Options/SetOptions.h"
#include "ReadInput.h"
#include "Surfaces/ReadSurface.h"

#include <algorithm>

namespace vfm
{
namespace
{

const std::vector<ArgumentOption> OwnOptions{
  { "--input", "FILE", "file to mesh; repeatable for surfaces, the first has priority", "", true },
  { "--output", "FILE", "file of the mesh" },
  { "--cells", "N",
    "number of cells along the longest side of surfaces, default 64; or --cell-width W" },
  { "--dimensions", "NX,NY,NZ", "numbers of cells of a .spn file" },
  { "--origin", "X,Y,Z", "lower corner of a .spn or .npy file, default 0,0,0" },
  { "--spacing", "X,Y,Z", "cell widths of a .spn or .npy file, default 1,1,1; or of an image" },
  { "--volume", "N", "use image number N of an image file that holds several, from 0" },
  { "--axis-order", "ORDER",
    "axes of the values in the file, xyz (default) to zyx, as spn_xyz_order of Sculpt" },
  { "--fractions", "A,B,..",
    "cell arrays with the volume fractions of one material each; repeatable, then one name each",
    "", true },
  { "--level-set", "A,B,..",
    "cell arrays that are level sets, such as signed distances, negative inside one material each;"
    " where several are negative, the first counts (--set LevelSets=Lowest: the lowest); "
    "repeatable",
    "", true },
  { "--labels", "ARRAY", "integer cell array with the material of each cell" },
  { "--material", "ID,..|all",
    "mesh only these materials, others become void; numbers from 1, or names of arrays;"
    " repeatable",
    "", true },
  { "--state", "A,B,..",
    "cell arrays to transfer to the elements: velocity, temperature; repeatable", "", true },
  { "--bins", "ARRAY,COUNT[,A,B[,V[,C0,C1]]]",
    "divide materials by COUNT intervals of a cell array, such as grey values, into parts of "
    "solvers'"
    " files; E = A rho^B, rho = C0 + C1 value, default the value; V: Poisson's ratio, default "
    "0.3" },
  { "--fragments", "FILE.csv", "also write a table of fragments: volumes, centroids, neighbours" },
  { "--geometry", "FILE.vtm", "also write surfaces, curves and vertices, and their adjacency" },
  { "--surfaces", "FILE|FOLDER",
    "also write the closed surface of each material: .stl, .obj; {} in FILE, or a folder: one file"
    " per material" },
  { "--report", "FILE.html", "also write a quality report: volumes, histogram, worst elements" },
  { "--tetmesh", "[METHOD]", "tetrahedra instead of hexahedra; TetGen, Cells or Lattice",
    "Method" },
  { "--no-smooth", "", "same as --smooth Off" },
  { "--refine", "N", "halve all cells N times before meshing, 0 to 10" },
  { "--refine-cells", "ARRAY", "cell array: number of times to halve each cell, 0 to 10",
    "RefinementArray" },
  { "--refine-box", "BOX",
    "X0,Y0,Z0,X1,Y1,Z1[,N]: halve all cells in it N times, default 1; repeatable",
    "RefinementBoxes", true },
  { "--set", "Option=Value ..", "any option of the mesher, see below", "", true },
  { "--list", "", "print times, grid, cell arrays and materials of the input; no mesh is made" },
  { "--step", "N", "use time number N of the input, from 0" },
  { "--time", "T", "use the time of the input nearest to T" },
  { "--trust-input", "",
    "the input may name files outside of its folder; no limit of lines and compression ratio" },
  { "--quiet", "", "print neither progress nor table" },
  { "--help", "", "print this text; also -h" },
  { "--version", "", "print the version" },
};

constexpr const char* Usage =
  R"(sculptor: makes a conforming mesh of all materials from volume fractions on a grid of cells

usage: [mpiexec -n RANKS] sculptor [--input] FILE [--output] FILE [options]
       [mpiexec -n RANKS] sculptor SURFACE .. [--output] FILE [--cells N] [options]
       [mpiexec -n RANKS] sculptor test [--tetmesh [METHOD]] [--no-smooth] [--stairstep] ..
       [mpiexec -n RANKS] sculptor --list FILE

)";

constexpr const char* MaterialRules =
  R"(Arrays of materials, without --fractions and --labels
  1. the arrays 'Material volume fraction - N'
  2. otherwise fractions with names that say volume fraction (vf_tin, VOLM+1)
  3. otherwise all fractions: cell arrays of float or double in [0, 1], or unsigned char if a
     value exceeds 127; 255 is full
  4. otherwise the array of integers with a name such as MaterialId, FeatureIds, material
  5. otherwise the only array of integers, as labels; or several of 0 and 1, as masks
  6. otherwise the same for real numbers that are integers
  If no cell array of an image qualifies, its point arrays are used; each point is the centre of
  a cell. An array of an image file that holds integers is used as labels. --list prints what
  each array holds. A name with a comma needs double quotes: --fractions '"a,1",b'.

sculptor test: meshes two boxes, checks the mesh and prints PASS or FAIL. It takes --tetmesh,
  --smooth, --no-smooth, --stairstep, --material 1, --refine N, and --refine-cells without an
  array, which refines a few cells of one box.

Options of the mesher, for --set or with a name of their own
)";

constexpr const char* ExitCodes = R"(
Exit codes
  0  success
  1  wrong arguments
  2  the input cannot be read, or has no suitable arrays
  3  the mesher rejects the input with a message; sculptor test: a check failed
  4  the output cannot be written
  5  not enough memory, or an internal error

Examples
  sculptor impact.spcth impact.e
  mpiexec -n 8 sculptor --input splash.vti --fractions water --output splash.pvtu
  sculptor --input grains.vti --labels grain --tetmesh Lattice --output grains.e
  sculptor --input grains.spn --dimensions 20,20,20 --spacing 0.1,0.1,0.1 --output grains.e
  sculptor --input parts.vti --material 2 --set TargetScaledJacobian=0.4 --output second.vtu
  sculptor shaft.stl housing.stl gear.e --cells 100 --edge-angle 30
  sculptor --input scan.vti --labels tissue --label-smoothing 3 --aspect 1.5 --output scan.e
)";

/// Returns the options of sculptor itself, with those of the formats.
std::vector<ArgumentOption> ListOwnOptions()
{
  std::vector<ArgumentOption> options = OwnOptions;
  for (const FormatOption& option : GetFormatOptions())
  {
    if (*option.Argument)
    {
      options.push_back({ option.Argument, option.Value, option.Help });
    }
  }
  return options;
}

std::vector<ArgumentOption> ListOptions()
{
  std::vector<ArgumentOption> options = ListOwnOptions();
  for (const Option& option : GetOptionTable())
  {
    const std::string& argument = option.Argument;
    if (!argument.empty())
    {
      const std::size_t space = argument.find(' ');
      const std::string value = space == std::string::npos ? "" : argument.substr(space + 1);
      options.push_back({ argument.substr(0, space), value, "", option.Name,
        option.Kind == OptionKind::Arrays || option.Kind == OptionKind::Ranges });
    }
  }
  return options;
}

std::string Padded(std::string text, std::size_t width)
{
  text.resize(std::max(width, text.size() + 2), ' ');
  return text;
}

} // namespace

const std::vector<ArgumentOption>& GetArgumentOptions()
{
  static const std::vector<ArgumentOption> options = ListOptions();
  return options;
}

std::string GetHelp()
{
  std::string text = Usage;
  for (const ArgumentOption& option : ListOwnOptions())
  {
    text += "  " + Padded(option.Name + " " + option.Value, 26) + option.Help + "\n";
  }
  text += "\nInput: " + JoinTexts(GetInputSuffixes()) +
    "\n  Exodus: hexahedra that form a Cartesian grid, with element variables; any one of the\n"
    "    files FILE.N.RANK selects all of them\n  AMReX: folder of a plotfile\n"
    "  Surfaces, closed: " +
    JoinTexts(GetSurfaceSuffixes()) +
    "\n    Each file is a material with its name; where they overlap, the first has priority.\n"
    "    An output that is a surface, too, needs --output.\n"
    "Output:\n";
  for (const FormatRow& format : GetFormatTable())
  {
    text +=
      "  " + Padded(JoinTexts(format.Suffixes), 16) + format.Name + ": " + format.Content + "\n";
  }
  text += std::string("\n") + MaterialRules;
  for (const std::string& line : DescribeOptions(ElementKind::Tets))
  {
    text += "  " + line + "\n";
  }
  return text + ExitCodes;
}

} // namespace vfm
