#include "BuiltInTest.h"

#include "Base/CartesianGrid.h"
#include "CheckSurface.h"
#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "MakeMesh.h"
#include "Meshes/WriteMesh.h"
#include "PrintSummary.h"
#include "Ranks/WorkTogether.h"
#include "Report/Gather/GatherMesh.h"
#include "State/ViewMesh.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace vfm
{
namespace
{

constexpr const char* ArrayName = "boxes";
constexpr const char* ChosenName = "chosen";
constexpr Index CellsX = 10, CellsYZ = 6;
constexpr double Width = 0.5; // width of a cell
/// Number of parts of each cell along an axis if chosen cells are refined, so that coarse cells
/// remain around them.
constexpr Index PartsOfCell = 2;
constexpr double VolumeError = 1e-6; // relative error
/// Relative error of hexahedra of two sizes without smoothing. Nodes of transitions at a surface
/// are then not exactly on it.
constexpr double UnmovedVolumeError = 1e-5;

const std::vector<IndexBox>& Boxes()
{
  static const std::vector<IndexBox> boxes{ { { { 1, 1, 1 } }, { { 4, 5, 5 } } },
    { { { 6, 1, 2 } }, { { 9, 4, 5 } } } };
  return boxes;
}

/// Returns the cells to refine: cells of the finer grid at a corner of the first box.
const std::vector<Index3>& ChosenCells()
{
  static const std::vector<Index3> cells{ { { 7, 2, 9 } }, { { 7, 3, 9 } }, { { 7, 2, 8 } } };
  return cells;
}

bool IsChosen(const Index3& cell)
{
  return std::find(ChosenCells().begin(), ChosenCells().end(), cell) != ChosenCells().end();
}

/// Adds an array with a value in the cells for which holds is true, and 0 in others.
template <class Holds>
void AddValues(const std::string& name, unsigned char value, const IndexBox& cells,
  const Holds& holds, PlainArrays& to)
{
  std::vector<unsigned char> values;
  ForCells(cells, [&](const Index3& cell) { values.push_back(holds(cell) ? value : 0); });
  to.Store(name, ValueType::UnsignedChar, std::move(values));
}

/// Makes the slab of this rank; without blocks if there are more ranks than slabs.
/// @param parts  number of parts of each cell along an axis, also below
Input MakeGrid(Index parts, const Ranks& ranks)
{
  const IndexBox cells = FindSlab({ { parts * CellsX, parts * CellsYZ, parts * CellsYZ } }, ranks);
  if (cells.NumberOfCells() == 0)
  {
    return MakeInput({}, false);
  }
  InputBlock block;
  const double width = Width / static_cast<double>(parts);
  block.Coordinates = EvenCoordinates({}, { { width, width, width } }, cells);
  FinishBlock(block, 0, ranks);
  const auto arrays = std::make_shared<PlainArrays>(cells.NumberOfCells());
  const auto isFull = [parts](const Index3& cell)
  {
    return std::any_of(Boxes().begin(), Boxes().end(),
      [&](const IndexBox& box) {
        return box.Contains({ { cell[0] / parts, cell[1] / parts, cell[2] / parts } });
      });
  };
  AddValues(ArrayName, 255, cells, isFull, *arrays); // 255 is the fraction 1
  AddValues(ChosenName, 1, cells, IsChosen, *arrays);
  block.Arrays = arrays;
  return MakeInput({ { block }, {} }, false);
}

/// Counts the hexahedra of a box: one per part, and one per face at the surface for the buffer
/// layer. Stairs have no buffer layer.
Index CountHexes(const IndexBox& box, Index parts, bool isStairs)
{
  const Index x = parts * box.Size(0), y = parts * box.Size(1), z = parts * box.Size(2);
  return x * y * z + (isStairs ? 0 : 2 * (x * y + y * z + z * x));
}

/// Counts the nodes of a box. Nodes at the surface count twice if there is a buffer layer.
Index CountNodes(const IndexBox& box, Index parts, bool isStairs)
{
  const Index x = parts * box.Size(0), y = parts * box.Size(1), z = parts * box.Size(2);
  return (x + 1) * (y + 1) * (z + 1) + (isStairs ? 0 : 2 * (x * y + y * z + z * x) + 2);
}

/// List of checks, which prints each of them and its result.
class Checks
{
public:
  explicit Checks(std::ostream* to) : To(to) {}
  void Check(const std::string& what, bool holds)
  {
    this->Good = this->Good && holds;
    if (this->To)
    {
      *this->To << (holds ? "  right: " : "  WRONG: ") << what << "\n";
    }
  }
  bool AllHold() const { return this->Good; }

private:
  std::ostream* To;
  bool Good = true;
};

/// Returns the fragment of a box, from 0, or null.
const FragmentSizes* FindBox(const MeshSummary& summary, std::size_t box)
{
  const std::vector<FragmentSizes>& all = summary.LargestFragments;
  const auto at = std::find_if(all.begin(), all.end(),
    [box](const FragmentSizes& one) { return one.Id == static_cast<int>(box + 1); });
  return at == all.end() ? nullptr : &*at;
}

/// Checks the number of fragments, their volumes and the quality.
/// @param volumeError  relative error of the first box
void CheckParts(const MeshSummary& summary, double volumeError, Checks& checks)
{
  const bool areAll = summary.NumberOfFragments == static_cast<Index>(Boxes().size());
  checks.Check("2 fragments", areAll);
  if (!areAll)
  {
    return;
  }
  for (std::size_t b = 0; b < Boxes().size(); ++b)
  {
    const double volume = static_cast<double>(Boxes()[b].NumberOfCells()) * Width * Width * Width;
    const double error = b == 0 ? volumeError : VolumeError;
    std::ostringstream text;
    text << "volume of box " << b + 1 << ", to " << error;
    const FragmentSizes* part = FindBox(summary, b);
    checks.Check(text.str(), part && std::abs(part->Volume - volume) <= error * volume);
  }
  checks.Check("all scaled Jacobians are above 0",
    summary.Total.Elements > 0 && summary.Total.MinimumQuality > 0.0);
}

/// Checks that the elements conform.
/// @pre Collective
void CheckElements(const MeshData& mesh, Ranks& ranks, Checks& checks)
{
  const StoredMesh whole = GatherMesh(mesh, ranks);
  if (ranks.Rank() == 0)
  {
    const SurfaceCheck surface = CheckSurface(whole.Data);
    checks.Check("the elements conform", surface.IsConforming);
    checks.Check("the surface of each box is closed, in one piece and without holes",
      surface.Pieces == 2 && surface.Spheres == 2);
  }
}

/// Checks the numbers of elements and points of a box whose hexahedra have equal size.
void CheckCounts(
  const MeshSummary& summary, std::size_t box, Index parts, bool isStairs, Checks& checks)
{
  if (const FragmentSizes* part = FindBox(summary, box))
  {
    const std::string name = " of box " + std::to_string(box + 1);
    checks.Check("elements" + name, part->Elements == CountHexes(Boxes()[box], parts, isStairs));
    checks.Check("points" + name, part->Points == CountNodes(Boxes()[box], parts, isStairs));
  }
}

/// Returns the least number of elements with their centroid in a chosen cell.
/// @pre Collective
Index CountInChosenCells(const MeshData& mesh, Ranks& ranks)
{
  const double widths = mesh.Corners * Width / PartsOfCell; // width of a cell times corners
  std::vector<Index> counts(ChosenCells().size(), 0);
  for (Index element = 0; element < mesh.NumberOfElements; ++element)
  {
    Vector3 sum{};
    for (int c = 0; c < mesh.Corners; ++c)
    {
      for (int a = 0; a < 3; ++a)
      {
        sum[a] += mesh.Point(mesh.Element(element)[c])[a];
      }
    }
    Index3 cell;
    std::transform(sum.begin(), sum.end(), cell.begin(),
      [widths](double x) { return static_cast<Index>(x / widths); });
    const auto at = std::find(ChosenCells().begin(), ChosenCells().end(), cell);
    if (at != ChosenCells().end())
    {
      ++counts[at - ChosenCells().begin()];
    }
  }
  ranks.Sum(counts);
  return *std::min_element(counts.begin(), counts.end());
}

/// Checks the mesh in which chosen cells are refined.
/// @param plain  summary of the mesh without refinement
/// @pre Collective
void CheckChosen(const MeshData& mesh, const MeshSummary& summary, const MeshSummary& plain,
  bool isStairs, Ranks& ranks, Checks& checks)
{
  checks.Check(std::to_string(ChosenCells().size()) + " chosen cells",
    NumbersOfField(mesh.Fields, "ChosenCells")[0] == static_cast<double>(ChosenCells().size()));
  const Index least = CountInChosenCells(mesh, ranks);
  checks.Check("8 elements or more in each of the chosen cells", least >= 8);
  if (summary.IsTets) // all interfaces of tetrahedra get the finest cells
  {
    checks.Check(
      "more elements than without refinement", summary.Total.Elements > plain.Total.Elements);
    return;
  }
  const FragmentSizes *box = FindBox(summary, 0), *plainBox = FindBox(plain, 0);
  checks.Check("more elements in box 1 than without refinement",
    box && plainBox && box->Elements > plainBox->Elements);
  CheckCounts(summary, 1, PartsOfCell, isStairs, checks); // far from the chosen cells
}

/// Mesh of the test.
struct Run
{
  std::string Title;
  Arguments How;
};

/// Plans a mesh without refinement, and one refined as the arguments request, by default once.
std::array<Run, 2> PlanRuns(const Arguments& given)
{
  Run plain{ "As it is", given }, refined{ "Refined 1", given };
  const MesherOptions defaults;
  MesherOptions& options = plain.How.Mesher;
  options.Refinement = defaults.Refinement;
  options.MaximumLevel = defaults.MaximumLevel;
  options.ThinCells = defaults.ThinCells;
  options.FineInterfaces = defaults.FineInterfaces;
  plain.How.RefinesCells = false;
  if (given.RefinesCells)
  {
    refined.Title = "Chosen cells refined";
    refined.How.Mesher.RefinementArray = ChosenName;
  }
  else if (given.Mesher.Refinement == RefinementMode::Uniform)
  {
    refined.Title = "Refined " + std::to_string(given.Mesher.MaximumLevel);
  }
  else
  {
    refined.How.Mesher.Refinement = RefinementMode::Uniform;
    refined.How.Mesher.MaximumLevel = 1;
  }
  return { plain, refined };
}

/// Checks a mesh.
/// @param plain  summary of the mesh without refinement, used if chosen cells are refined
/// @pre Collective
void CheckMesh(const MeshData& mesh, const MeshSummary& summary, const MeshSummary& plain,
  const Arguments& how, Index parts, Ranks& ranks, Checks& checks)
{
  const MesherOptions& options = how.Mesher;
  const bool moves = !options.StairStep && options.Smoothing != SmoothingMethod::Off;
  CheckParts(summary,
    how.RefinesCells && !summary.IsTets && !moves ? UnmovedVolumeError : VolumeError, checks);
  CheckElements(mesh, ranks, checks);
  if (how.RefinesCells)
  {
    CheckChosen(mesh, summary, plain, options.StairStep, ranks, checks);
    return;
  }
  for (std::size_t b = 0; !summary.IsTets && b < Boxes().size(); ++b)
  {
    CheckCounts(summary, b, parts << std::max(options.MaximumLevel, 0), options.StairStep, checks);
  }
}

} // namespace

bool RunBuiltInTest(const Arguments& arguments, Ranks& ranks)
{
  const Index parts = arguments.RefinesCells ? PartsOfCell : 1;
  std::ostream* to = ranks.Rank() == 0 && !arguments.Quiet ? &std::cout : nullptr;
  Checks checks(to);
  const Input input = MakeGrid(parts, ranks);
  ChosenArrays arrays;
  arrays.Fractions = { ArrayName };
  MesherResult result;
  MeshData mesh;
  MeshSummary plain;
  const std::array<Run, 2> runs = PlanRuns(arguments);
  for (const Run& run : runs)
  {
    result = MakeMesh(run.How, input, arrays, ranks);
    mesh = ViewMesh(result.TheMesh, result.State, result.Fields);
    const MeshSummary summary = Summarise(mesh, ranks);
    if (to)
    {
      *to << (&run == &runs[0] ? "" : "\n") << run.Title << "\n";
      PrintSummary(summary, {}, {}, *to);
    }
    CheckMesh(mesh, summary, plain, run.How, parts, ranks, checks);
    plain = summary;
  }
  if (!arguments.Output.empty())
  {
    WorkInStage(
      ranks, ErrorCode::UnwritableOutput, [&] { WriteMesh(mesh, arguments.Output, ranks); });
  }
  if (ranks.Rank() == 0)
  {
    std::cout << (checks.AllHold() ? "PASS" : "FAIL") << "\n";
  }
  return !ranks.Any(!checks.AllHold());
}

} // namespace vfm
