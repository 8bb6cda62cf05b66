#include "BuiltInTest.h"

#include "Base/CartesianGrid.h"
#include "CheckSurface.h"
#include "ChooseArrays.h"
#include "ControllerRanks.h"
#include "MakeMesh.h"
#include "MeshDataOfGrid.h"
#include "Meshes/WriteMesh.h"
#include "PrintSummary.h"
#include "Ranks/WorkTogether.h"
#include "Summary/GatherMesh.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionMeshAlgorithm.h"

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
constexpr double Width = 0.5; // of a cell
/// Where chosen cells are refined each cell is so many along an axis, so that there is room around those.
constexpr Index PartsOfCell = 2;
constexpr double VolumeError = 1e-6; // relative
/// Of hexahedra of two sizes whose nodes stay where transitions have them: those at a surface do not lie in it.
constexpr double UnmovedVolumeError = 1e-5;

const std::vector<IndexBox>& Boxes()
{
  static const std::vector<IndexBox> boxes{ { { { 1, 1, 1 } }, { { 4, 5, 5 } } },
    { { { 6, 1, 2 } }, { { 9, 4, 5 } } } };
  return boxes;
}

/// Of the first box, at a corner, in the finer grid.
const std::vector<Index3>& ChosenCells()
{
  static const std::vector<Index3> cells{ { { 7, 2, 9 } }, { { 7, 3, 9 } }, { { 7, 2, 8 } } };
  return cells;
}

bool IsChosen(const Index3& cell)
{
  return std::find(ChosenCells().begin(), ChosenCells().end(), cell) != ChosenCells().end();
}

/// The cells of the grid with x in [begin, end). parts: of a cell along an axis, as in all that follows.
vtkSmartPointer<vtkImageData> MakeSlab(Index begin, Index end, Index parts)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int cells = static_cast<int>(parts * CellsYZ);
  image->SetExtent(static_cast<int>(begin), static_cast<int>(end), 0, cells, 0, cells);
  const double width = Width / static_cast<double>(parts);
  image->SetSpacing(width, width, width);
  vtkNew<vtkDoubleArray> fractions;
  vtkNew<vtkUnsignedCharArray> chosen;
  fractions->SetName(ArrayName);
  chosen->SetName(ChosenName);
  for (Index k = 0; k < cells; ++k)
  {
    for (Index j = 0; j < cells; ++j)
    {
      for (Index i = begin; i < end; ++i)
      {
        const bool isFull = std::any_of(Boxes().begin(), Boxes().end(),
          [&](const IndexBox& box) {
            return box.Contains({ { i / parts, j / parts, k / parts } });
          });
        fractions->InsertNextValue(isFull ? 1.0 : 0.0);
        chosen->InsertNextValue(IsChosen({ { i, j, k } }) ? 1 : 0);
      }
    }
  }
  image->GetCellData()->AddArray(fractions);
  image->GetCellData()->AddArray(chosen);
  return image;
}

/// Of this rank; without blocks when there are more ranks than slabs.
vtkSmartPointer<vtkMultiBlockDataSet> MakeGrid(Ranks& ranks, Index parts)
{
  const Index begin = parts * CellsX * ranks.Rank() / ranks.Count();
  const Index end = parts * CellsX * (ranks.Rank() + 1) / ranks.Count();
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  if (begin < end)
  {
    blocks->SetBlock(0, MakeSlab(begin, end, parts));
  }
  return blocks;
}

/// Of a box of hexahedra. One a part and one a face of the box, which is the buffer layer; stairs have none.
Index CountHexes(const IndexBox& box, Index parts, bool isStairs)
{
  const Index x = parts * box.Size(0), y = parts * box.Size(1), z = parts * box.Size(2);
  return x * y * z + (isStairs ? 0 : 2 * (x * y + y * z + z * x));
}

/// The nodes of the parts, those of the surface twice where there is a buffer layer.
Index CountNodes(const IndexBox& box, Index parts, bool isStairs)
{
  const Index x = parts * box.Size(0), y = parts * box.Size(1), z = parts * box.Size(2);
  return (x + 1) * (y + 1) * (z + 1) + (isStairs ? 0 : 2 * (x * y + y * z + z * x) + 2);
}

/// Prints what is checked and whether it holds.
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

/// volumeError: of the first box.
void CheckParts(const MeshSummary& summary, double volumeError, Checks& checks)
{
  checks.Check("2 fragments", summary.Fragments.size() == Boxes().size());
  if (summary.Fragments.size() != Boxes().size())
  {
    return;
  }
  for (std::size_t b = 0; b < Boxes().size(); ++b)
  {
    const double volume = static_cast<double>(Boxes()[b].NumberOfCells()) * Width * Width * Width;
    const double error = b == 0 ? volumeError : VolumeError;
    std::ostringstream text;
    text << "volume of box " << b + 1 << ", to " << error;
    checks.Check(text.str(), std::abs(summary.Fragments[b].Volume - volume) <= error * volume);
  }
  checks.Check("all scaled Jacobians are above 0",
    summary.Total.Elements > 0 && summary.Total.MinimumQuality > 0.0);
}

/// Collective.
void CheckElements(vtkUnstructuredGrid* mesh, Ranks& ranks, Checks& checks)
{
  const StoredMesh part = MeshDataOf(mesh);
  const StoredMesh whole = GatherMesh(part.Data, ranks);
  if (ranks.Rank() == 0)
  {
    const SurfaceCheck surface = CheckSurface(whole.Data);
    checks.Check("the elements conform", surface.IsConforming);
    checks.Check("the surface of each box is closed, in one piece and without holes",
      surface.Pieces == 2 && surface.Spheres == 2);
  }
}

/// Of one box of hexahedra that are all of a size.
void CheckCounts(
  const MeshSummary& summary, std::size_t box, Index parts, bool isStairs, Checks& checks)
{
  if (box < summary.Fragments.size())
  {
    const PartSummary& part = summary.Fragments[box];
    const std::string name = " of box " + std::to_string(box + 1);
    checks.Check("elements" + name, part.Elements == CountHexes(Boxes()[box], parts, isStairs));
    checks.Check("points" + name, part.Points == CountNodes(Boxes()[box], parts, isStairs));
  }
}

/// Collective: the least number of elements that have their centroid in one of the chosen cells.
Index CountInChosenCells(vtkUnstructuredGrid* mesh, Ranks& ranks)
{
  constexpr double width = Width / PartsOfCell;
  std::vector<Index> counts(ChosenCells().size(), 0);
  for (vtkIdType e = 0; e < mesh->GetNumberOfCells(); ++e)
  {
    vtkPoints* points = mesh->GetCell(e)->GetPoints();
    Vector3 sum{ { 0.0, 0.0, 0.0 } };
    for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
    {
      for (int a = 0; a < 3; ++a)
      {
        sum[a] += points->GetPoint(p)[a];
      }
    }
    Index3 cell;
    for (int a = 0; a < 3; ++a)
    {
      cell[a] =
        static_cast<Index>(sum[a] / static_cast<double>(points->GetNumberOfPoints()) / width);
    }
    const auto at = std::find(ChosenCells().begin(), ChosenCells().end(), cell);
    if (at != ChosenCells().end())
    {
      ++counts[at - ChosenCells().begin()];
    }
  }
  ranks.Sum(counts);
  return *std::min_element(counts.begin(), counts.end());
}

/// Collective. plain: the mesh without refinement.
void CheckChosen(vtkUnstructuredGrid* mesh, const MeshSummary& summary, const MeshSummary& plain,
  bool isStairs, Ranks& ranks, Checks& checks)
{
  const double chosen = mesh->GetFieldData()->GetArray("ChosenCells")->GetComponent(0, 0);
  checks.Check(std::to_string(ChosenCells().size()) + " chosen cells",
    chosen == static_cast<double>(ChosenCells().size()));
  const Index least = CountInChosenCells(mesh, ranks);
  checks.Check("8 elements or more in each of the chosen cells", least >= 8);
  if (summary.IsTets) // whose interfaces get the finest cells everywhere
  {
    checks.Check(
      "more elements than without refinement", summary.Total.Elements > plain.Total.Elements);
    return;
  }
  checks.Check("more elements in box 1 than without refinement",
    !summary.Fragments.empty() && !plain.Fragments.empty() &&
      summary.Fragments[0].Elements > plain.Fragments[0].Elements);
  CheckCounts(summary, 1, PartsOfCell, isStairs, checks); // far from the chosen cells
}

/// A mesh of the test.
struct Run
{
  std::string Title;
  Arguments How;
};

bool IsOfRefinement(const std::pair<std::string, std::string>& option)
{
  const std::vector<std::string> names{ "Refinement", "MaximumLevel", "ThinCells",
    "FineInterfaces" }; // by the options of the test
  return std::find(names.begin(), names.end(), option.first) != names.end();
}

/// The grid as it is, and refined: as the arguments ask, else once.
std::vector<Run> PlanRuns(const Arguments& given)
{
  Run plain{ "As it is", given }, refined{ "Refined 1", given };
  auto& options = plain.How.Options;
  options.erase(std::remove_if(options.begin(), options.end(), IsOfRefinement), options.end());
  plain.How.RefinesCells = false;
  if (given.RefinesCells)
  {
    refined.Title = "Chosen cells refined";
    refined.How.Options.emplace_back("RefinementArray", ChosenName);
  }
  else if (options.size() == given.Options.size())
  {
    refined.How.Options.insert(
      refined.How.Options.end(), { { "Refinement", "Uniform" }, { "MaximumLevel", "1" } });
  }
  else
  {
    refined.Title = "Refined " + std::to_string(MakeMesher(given)->GetMaximumLevel());
  }
  return { plain, refined };
}

/// Meshes the boxes and checks what comes out.
class BoxTest
{
public:
  BoxTest(const Arguments& given, vtkMultiProcessController* controller) :
    Given(given),
    Controller(controller),
    Group(controller),
    Result(this->Stream()),
    Parts(given.RefinesCells ? PartsOfCell : 1)
  {
  }

  bool Do()
  {
    const std::vector<Run> runs = PlanRuns(this->Given);
    const MeshSummary plain = this->MakeAndCheck(runs[0], {});
    if (this->Stream())
    {
      *this->Stream() << "\n";
    }
    this->MakeAndCheck(runs[1], plain);
    if (!this->Given.Output.empty())
    {
      WorkInStage(this->Group, ErrorCode::UnwritableOutput,
        [this] { WriteMesh(MeshDataOf(this->Mesh).Data, this->Given.Output, this->Group); });
    }
    if (this->Group.Rank() == 0)
    {
      std::cout << (this->Result.AllHold() ? "PASS" : "FAIL") << "\n";
    }
    return !this->Group.Any(!this->Result.AllHold());
  }

private:
  std::ostream* Stream()
  {
    return this->Group.Rank() == 0 && !this->Given.Quiet ? &std::cout : nullptr;
  }

  /// plain: the mesh without refinement, for one where chosen cells are refined.
  MeshSummary MakeAndCheck(const Run& run, const MeshSummary& plain)
  {
    const auto mesher = MakeMesher(run.How);
    const auto grid = MakeGrid(this->Group, this->Parts);
    const ChosenArrays arrays{ { ArrayName }, "", {}, "", "" };
    KeepMaterials(grid, arrays, run.How.Materials, this->Group);
    this->Mesh = MakeMesh(*mesher, grid, arrays, run.How.Quiet, this->Controller);
    const MeshSummary summary = Summarise(MeshDataOf(this->Mesh).Data, this->Group);
    if (std::ostream* to = this->Stream())
    {
      *to << run.Title << "\n";
      PrintSummary(summary, {}, *to);
    }
    const bool moves = !mesher->GetStairStep() &&
      mesher->GetSmoothing() != vtkVolumeFractionMeshAlgorithm::SMOOTHING_OFF;
    CheckParts(summary,
      run.How.RefinesCells && !summary.IsTets && !moves ? UnmovedVolumeError : VolumeError,
      this->Result);
    CheckElements(this->Mesh, this->Group, this->Result);
    if (run.How.RefinesCells)
    {
      CheckChosen(this->Mesh, summary, plain, mesher->GetStairStep(), this->Group, this->Result);
    }
    else if (!summary.IsTets)
    {
      for (std::size_t b = 0; b < Boxes().size(); ++b)
      {
        CheckCounts(summary, b, this->Parts << std::max(mesher->GetMaximumLevel(), 0),
          mesher->GetStairStep(), this->Result);
      }
    }
    return summary;
  }

  const Arguments& Given;
  vtkMultiProcessController* Controller;
  ControllerRanks Group;
  Checks Result;
  const Index Parts;
  vtkSmartPointer<vtkUnstructuredGrid> Mesh;
};

} // namespace

bool RunBuiltInTest(const Arguments& arguments, vtkMultiProcessController* controller)
{
  return BoxTest(arguments, controller).Do();
}

} // namespace vfm
