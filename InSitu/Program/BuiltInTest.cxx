#include "BuiltInTest.h"

#include "Base/CartesianGrid.h"
#include "ControllerRanks.h"
#include "MakeMesh.h"
#include "Stage.h"
#include "Summary.h"
#include "WriteMesh.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionMeshAlgorithm.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace vfm
{
namespace
{

constexpr const char* ArrayName = "boxes";
constexpr Index CellsX = 10, CellsYZ = 6;
constexpr double Width = 0.5;        // of a cell
constexpr double VolumeError = 1e-6; // relative

const std::vector<IndexBox>& Boxes()
{
  static const std::vector<IndexBox> boxes{ { { { 1, 1, 1 } }, { { 4, 5, 5 } } },
    { { { 6, 1, 2 } }, { { 9, 4, 5 } } } };
  return boxes;
}

/// The cells of the grid with x in [begin, end).
vtkSmartPointer<vtkImageData> MakeSlab(Index begin, Index end)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(static_cast<int>(begin), static_cast<int>(end), 0, CellsYZ, 0, CellsYZ);
  image->SetSpacing(Width, Width, Width);
  vtkNew<vtkDoubleArray> fractions;
  fractions->SetName(ArrayName);
  for (Index k = 0; k < CellsYZ; ++k)
  {
    for (Index j = 0; j < CellsYZ; ++j)
    {
      for (Index i = begin; i < end; ++i)
      {
        const bool isFull = std::any_of(Boxes().begin(), Boxes().end(),
          [&](const IndexBox& box) {
            return box.Contains({ { i, j, k } });
          });
        fractions->InsertNextValue(isFull ? 1.0 : 0.0);
      }
    }
  }
  image->GetCellData()->AddArray(fractions);
  return image;
}

/// Of this rank; without blocks when there are more ranks than slabs.
vtkSmartPointer<vtkMultiBlockDataSet> MakeGrid(Ranks& ranks)
{
  const Index begin = CellsX * ranks.Rank() / ranks.Count();
  const Index end = CellsX * (ranks.Rank() + 1) / ranks.Count();
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  if (begin < end)
  {
    blocks->SetBlock(0, MakeSlab(begin, end));
  }
  return blocks;
}

/// parts: of a cell along an axis. A hexahedron a part and one a face of the boxes, which is the buffer layer.
Index CountHexes(const IndexBox& box, Index parts)
{
  const Index x = parts * box.Size(0), y = parts * box.Size(1), z = parts * box.Size(2);
  return x * y * z + 2 * (x * y + y * z + z * x);
}

/// The nodes of the parts, those of the surface twice.
Index CountNodes(const IndexBox& box, Index parts)
{
  const Index x = parts * box.Size(0), y = parts * box.Size(1), z = parts * box.Size(2);
  return (x + 1) * (y + 1) * (z + 1) + 2 * (x * y + y * z + z * x) + 2;
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

void CheckParts(const MeshSummary& summary, Checks& checks)
{
  checks.Check("2 fragments", summary.Fragments.size() == Boxes().size());
  if (summary.Fragments.size() != Boxes().size())
  {
    return;
  }
  for (std::size_t b = 0; b < Boxes().size(); ++b)
  {
    const double volume = static_cast<double>(Boxes()[b].NumberOfCells()) * Width * Width * Width;
    checks.Check("volume of box " + std::to_string(b + 1),
      std::abs(summary.Fragments[b].Volume - volume) <= VolumeError * volume);
  }
  checks.Check("all scaled Jacobians are above 0",
    summary.Total.Elements > 0 && summary.Total.MinimumQuality > 0.0);
}

/// refinement: how often the cells were halved.
void CheckCounts(const MeshSummary& summary, int refinement, Checks& checks)
{
  for (std::size_t b = 0; b < std::min(Boxes().size(), summary.Fragments.size()); ++b)
  {
    const PartSummary& part = summary.Fragments[b];
    const std::string name = " of box " + std::to_string(b + 1);
    checks.Check(
      "elements" + name, part.Elements == CountHexes(Boxes()[b], Index(1) << refinement));
    checks.Check("points" + name, part.Points == CountNodes(Boxes()[b], Index(1) << refinement));
  }
}

/// The grid as it is, and refined: as the arguments ask, else once.
std::vector<Arguments> PlanRuns(const Arguments& given)
{
  Arguments plain;
  plain.Quiet = given.Quiet;
  Arguments refined = given;
  if (given.Options.empty())
  {
    refined.Options = { { "Refinement", "Uniform" }, { "MaximumLevel", "1" } };
  }
  return { plain, refined };
}

} // namespace

bool RunBuiltInTest(const Arguments& arguments, vtkMultiProcessController* controller)
{
  ControllerRanks ranks(controller);
  std::ostream* to = ranks.Rank() == 0 && !arguments.Quiet ? &std::cout : nullptr;
  Checks checks(to);
  vtkSmartPointer<vtkUnstructuredGrid> mesh;
  for (const Arguments& run : PlanRuns(arguments))
  {
    const auto mesher = MakeMesher(run);
    mesh =
      MakeMesh(*mesher, MakeGrid(ranks), { { ArrayName }, "", {}, "", "" }, run.Quiet, controller);
    const MeshSummary summary = Summarise(mesh, ranks);
    if (to)
    {
      *to << (run.Options.empty() ? "As it is"
                                  : "\nRefined " + std::to_string(mesher->GetMaximumLevel()))
          << "\n";
      PrintSummary(summary, {}, *to);
    }
    CheckParts(summary, checks);
    CheckCounts(summary, std::max(mesher->GetMaximumLevel(), 0), checks);
  }
  if (!arguments.Output.empty())
  {
    WriteMesh(mesh, arguments.Output, controller);
  }
  if (ranks.Rank() == 0)
  {
    std::cout << (checks.AllHold() ? "PASS" : "FAIL") << "\n";
  }
  return checks.AllHold();
}

} // namespace vfm
