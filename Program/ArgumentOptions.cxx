#include "ArgumentOptions.h"

#include "Base/ParseText.h"
#include "Meshes/WriteMesh.h"
#include "Options/SetOptions.h"
#include "ReadInput.h"

#include <algorithm>

namespace vfm
{
namespace
{

const std::vector<ArgumentOption> OwnOptions{
  { "--input", "FILE", "what to mesh" },
  { "--output", "FILE", "where the mesh goes" },
  { "--dimensions", "NX,NY,NZ", "numbers of cells of a .spn file" },
  { "--origin", "X,Y,Z", "lower corner of a .spn or .npy file, default 0,0,0" },
  { "--spacing", "X,Y,Z", "edges of its cells, default 1,1,1" },
  { "--axis-order", "ORDER",
    "its array's indices, xyz (default) to zyx, as Sculpt's spn_xyz_order" },
  { "--fractions", "A,B,..", "cell arrays, the volume fraction of one material each" },
  { "--labels", "ARRAY", "instead: integer cell array that names the material of each cell" },
  { "--material", "ID,..|all",
    "mesh only these, the others count as void; numbers from 1, or names of arrays" },
  { "--state", "A,B,..", "cell arrays that the elements carry along: velocity, temperature" },
  { "--fragments", "FILE.csv", "a table of the fragments too: volumes, centroids, neighbours" },
  { "--geometry", "FILE.vtm", "surfaces, curves and vertices too, and what bounds what" },
  { "--tetmesh", "[METHOD]", "tetrahedra instead of hexahedra; TetGen, Cells or Lattice",
    "Method" },
  { "--no-smooth", "", "the same as --smooth Off" },
  { "--refine", "N", "halve all cells N times before they are meshed, 0 to 10" },
  { "--refine-cells", "ARRAY",
    "refine the cells that a cell array names: how many times each is to be halved, 0 to 10",
    "RefinementArray" },
  { "--refine-box", "BOX",
    "and all in the box X0,Y0,Z0,X1,Y1,Z1 or X0,..,Z1,N, N times (1); as often as there are "
    "boxes",
    "RefinementBoxes", true },
  { "--set", "Option=Value ..", "any option of the mesher, see below", "", true },
  { "--list", "", "what the input holds: times, grid, cell arrays, materials; nothing is meshed" },
  { "--step", "N", "which time of the input, from 0" },
  { "--time", "T", "the time of the input nearest to T" },
  { "--single-file", "", "Exodus from several ranks as one file, which the first rank gathers" },
  { "--quiet", "", "no progress and no table" },
  { "--help", "", "this text; also -h" },
  { "--version", "", "the version" },
};

constexpr const char* Usage =
  R"(sculptor: a conforming mesh of every material from volume fractions on a grid of cells

usage: [mpiexec -n RANKS] sculptor [--input] FILE [--output] FILE [options]
       [mpiexec -n RANKS] sculptor test [--tetmesh [METHOD]] [--no-smooth] [--stairstep] [--refine N] ..
       [mpiexec -n RANKS] sculptor --list FILE

)";

constexpr const char* Materials =
  R"(Without --fractions and --labels: the arrays 'Material volume fraction - N', else all cell arrays of float,
double or unsigned char with values in [0, 1] (unsigned char: 0..255), else the labels 'MaterialId';
of images, if cells have none, arrays of points likewise, each point the centre of a cell; whole numbers of an image file are labels.
sculptor test: meshes two boxes, checks the mesh and prints PASS or FAIL; takes --tetmesh, --smooth, --no-smooth, --stairstep,
--material 1, --refine N, --refine-cells (without an array: a few cells of one box).

Options of the mesher, by --set or a name of their own
)";

constexpr const char* ExitCodes = R"(
Exit codes
  0  all went well
  1  wrong arguments
  2  the input cannot be read, or holds no fitting arrays
  3  the mesher refuses the input, its message tells why; of sculptor test: a check failed
  4  the output cannot be written
  5  not enough memory, or an internal error

Examples
  sculptor impact.spcth impact.e
  mpiexec -n 8 sculptor --input splash.vti --fractions water --output splash.pvtu
  sculptor --input grains.vti --labels grain --tetmesh Lattice --output grains.e
  sculptor --input grains.spn --dimensions 20,20,20 --spacing 0.1,0.1,0.1 --output grains.e
  sculptor --input parts.vti --material 2 --set TargetScaledJacobian=0.4 --output second.vtu
  sculptor --input scan.vti --labels tissue --label-smoothing 3 --aspect 1.5 --output scan.e
)";

std::vector<ArgumentOption> ListOptions()
{
  std::vector<ArgumentOption> options = OwnOptions;
  for (const Option& option : GetOptionTable())
  {
    const std::string& argument = option.Argument;
    if (!argument.empty())
    {
      const std::size_t space = argument.find(' ');
      const std::string value = space == std::string::npos ? "" : argument.substr(space + 1);
      options.push_back({ argument.substr(0, space), value, "", option.Name });
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
  for (const ArgumentOption& option : OwnOptions)
  {
    text += "  " + Padded(option.Name + " " + option.Value, 26) + option.Help + "\n";
  }
  text += "\nInput: " + JoinTexts(GetInputSuffixes()) +
    "\n  Exodus: hexahedra that form a Cartesian grid, with element variables; of FILE.N.RANK any "
    "one stands for all, with any FILE\n  AMReX: the folder of a plotfile\n"
    "Output: " +
    JoinTexts(GetOutputSuffixes()) +
    "\n  .vtu and .inp (Abaqus, CalculiX) are one file, also from several ranks; Exodus from N "
    "ranks is one file a rank,\n  FILE.N.RANK\n" +
    Materials;
  for (const std::string& line : DescribeOptions(ElementKind::Tets))
  {
    text += "  " + line + "\n";
  }
  return text + ExitCodes;
}

} // namespace vfm
