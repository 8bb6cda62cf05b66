#include "CheckCase.h"

#include "CheckPeriods.h"
#include "CurvedNodes.h"
#include "Elements/ResolveCells.h"
#include "GeometryChecks.h"
#include "Labels/LabelCondition.h"
#include "Modify/AddLayers.h"
#include "Modify/AddMidNodes.h"
#include "Modify/SplitInterfaces.h"
#include "OverlapChecks.h"
#include "Phases/MeshOfCells.h"

#include <cmath>
#include <cstdio>
#include <numeric>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

// Relative to the volume of the domain; of a material on ranks and on one.
constexpr double VolumeTolerance = 1e-9, RankTolerance = 1e-13;

std::string Describe(const char* what, double value, Index id)
{
  char text[120];
  std::snprintf(text, sizeof text, "%s %.3g, id %lld", what, value, static_cast<long long>(id));
  return text;
}

/// Returns the first problem, or an empty string.
std::string FirstOf(std::initializer_list<std::string> problems)
{
  const auto at = std::find_if(
    problems.begin(), problems.end(), [](const std::string& text) { return !text.empty(); });
  return at == problems.end() ? "" : *at;
}

double VolumeOf(const CartesianGrid& grid, const IndexBox& box)
{
  double volume = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    volume *= grid.Coordinates(a)[box.Upper[a]] - grid.Coordinates(a)[box.Lower[a]];
  }
  return volume;
}

bool KnowsCells(const FuzzCase& c)
{
  return c.Make == MakeHexMesh || c.Options.Method != TetMethod::TetGen;
}

/// Checks Jacobians, in volumes of the cells from which the elements were made; for TetGen in
/// mean cell volumes of the grid.
std::string FindJacobianProblem(const FuzzCase& c, const Mesh& mesh, FuzzResult& result)
{
  const double mean = std::pow(c.Grid.MeanWidth(), 3.0);
  Index worst = 0;
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    const double volume =
      KnowsCells(c) ? VolumeOf(c.Grid, CellsOfElement(c.Grid, mesh, mesh.ElementIds[e])) : mean;
    const double coefficient = SmallestCoefficient(mesh, e) / volume;
    if (!(coefficient >= result.Coefficient)) // also true for NaN
    {
      result.Coefficient = coefficient;
      worst = mesh.ElementIds[e];
    }
  }
  return mesh.ElementIds.empty() || result.Coefficient > 0.0
    ? ""
    : Describe("smallest coefficient", result.Coefficient, worst);
}

/// Returns how far points lie outside the domain, in widths of the cells at the side. Periodic axes
/// do not count.
std::string FindPlaceProblem(const CartesianGrid& grid, const Mesh& mesh)
{
  double farthest = 0.0;
  Index id = 0;
  for (std::size_t at = 0; at < mesh.Points.size(); ++at)
  {
    const int axis = static_cast<int>(at % 3);
    if (grid.Period(axis) > 0)
    {
      continue;
    }
    const std::vector<double>& x = grid.Coordinates(axis);
    const double below = (x.front() - mesh.Points[at]) / grid.Width(axis, 0);
    const double above =
      (mesh.Points[at] - x.back()) / grid.Width(axis, static_cast<Index>(x.size()) - 2);
    if (!(std::max(below, above) <= farthest))
    {
      farthest = std::max(below, above);
      id = mesh.PointIds[at / 3];
    }
  }
  return farthest == 0.0 ? "" : Describe("outside the domain by", farthest, id);
}

/// Checks that the volumes of materials agree with the report, and fill the
/// domain if all of it is meshed.
std::string FindVolumeProblem(const FuzzCase& c, const Mesh& mesh, const MeshReport& report)
{
  if (c.Options.ElementOrder != InterpolationOrder::Linear)
  {
    return ""; // the report has the volumes of curved elements
  }
  const double domain = VolumeOf(c.Grid, c.Grid.Domain());
  double all = 0.0;
  for (int m = c.Options.MeshVoid ? 0 : 1; m <= c.Fractions.NumberOfMaterials(); ++m)
  {
    const double volume = MeasureVolume(mesh, m);
    all += volume;
    if (!(std::fabs(volume - report.MeshVolume[m]) <= VolumeTolerance * domain))
    {
      return Describe("volume of a material off by", volume / report.MeshVolume[m] - 1.0, m);
    }
  }
  return c.Options.MeshVoid && !(std::fabs(all / domain - 1.0) <= VolumeTolerance)
    ? Describe("volume of the domain off by", all / domain - 1.0, 0)
    : "";
}

/// Checks that the targets of elements and far material together have the volumes of the fractions.
std::string FindFarProblem(const FuzzCase& c, const Mesh& mesh, const MeshReport& report)
{
  std::vector<double> lacks(c.Fractions.NumberOfMaterials() + 1, 0.0);
  ForCells(c.Grid.Owned(),
    [&](const Index3& p)
    {
      c.Fractions.ForParts(c.Grid.Linear(p),
        [&](int material, double fraction) { lacks[material] += fraction * c.Grid.CellVolume(p); });
    });
  std::set<std::pair<Index, int>> far;
  for (const FarMatter& part : mesh.Far)
  {
    lacks[part.Material] -= part.Volume;
    if (!c.Options.LeavesFar || part.Material == 0 ||
      !far.insert({ part.Cell, part.Material }).second)
    {
      return Describe("far material", part.Material, part.Cell);
    }
  }
  const double domain = VolumeOf(c.Grid, c.Grid.Domain());
  for (std::size_t m = 1; m < lacks.size(); ++m)
  {
    const double lack = lacks[m] - report.TargetVolume[m];
    if (!(std::fabs(lack) <= VolumeTolerance * domain))
    {
      return Describe("elements and far material lack", lack / domain, static_cast<Index>(m));
    }
  }
  return "";
}

/// Checks that the labels of the cells meet the condition at all nodes, and that the mesh has one
/// hex for each meshed cell and for each of its faces to another label.
std::string FindLabelProblem(const FuzzCase& c, const Mesh& mesh)
{
  Runtime runtime;
  MeshReport report;
  MeshRun run(c.Grid, runtime, report);
  const LabelArray labels = ResolveCells({ c.Grid, c.Fractions, c.Options }, false, run).Labels;
  for (Index node : FindMixedNodes(c.Grid, labels))
  {
    if (CountViolations(StarOfNode(c.Grid, labels, node)) > 0)
    {
      return "the labels violate the condition at node " + std::to_string(node);
    }
  }
  std::size_t count = 0;
  ForCells(c.Grid.Owned(),
    [&](const Index3& p)
    {
      const int label = labels[c.Grid.Linear(p)];
      const bool isMeshed = label != 0 || c.Options.MeshVoid;
      count += isMeshed;
      for (int face = 0; isMeshed && face < 6; ++face)
      {
        Index3 q = p;
        q[face / 2] += face & 1 ? 1 : -1;
        count += c.Grid.InDomain(q) && labels[c.Grid.Linear(q)] != label;
      }
    });
  return count == mesh.ElementIds.size()
    ? ""
    : std::to_string(mesh.ElementIds.size()) + " hexes instead of " + std::to_string(count);
}

/// Checks that the mesh has the fragments of its cells, that the same pairs of them touch, and that
/// no tet of the lattice has all points on interfaces or sides. If interfaces cross levels, the
/// cells are not known: poor hexes refine them further.
std::string FindTruthProblem(const FuzzCase& c, const Mesh& mesh, Index locked)
{
  const bool mayLock = c.Make == MakeHexMesh || c.Options.Method == TetMethod::TetGen;
  const bool isTetGen = mayLock && c.Make != MakeHexMesh;
  MeshOptions options = c.Options;
  options.Levels.FineInterfaces = options.Levels.FineInterfaces || isTetGen;
  const std::string problem = InterfacesCrossLevels(options)
    ? ""
    : FindCellProblem(c.Grid, mesh, MakeCells(c.Grid, c.Fractions, options));
  const bool hasLaw =
    c.Make == MakeHexMesh && c.Options.Levels.Refinements == 0 && !c.Options.StairStep;
  return FirstOf({ problem, hasLaw ? FindLabelProblem(c, mesh) : "",
    mayLock || locked == 0 ? "" : std::to_string(locked) + " locked elements" });
}

/// Checks that no elements overlap and no points coincide.
std::string FindSpaceProblem(const Mesh& mesh, FuzzResult& result)
{
  const ElementOverlaps overlaps = FindElementOverlaps(mesh);
  result.Overlap = overlaps.Depth;
  const Index coincident = CountCoincidentPoints(mesh);
  return overlaps.Pairs > 0 ? Describe("overlap by", overlaps.Depth, overlaps.Deepest[0])
    : coincident > 0        ? std::to_string(coincident) + " coincident points"
                            : "";
}

std::string FindMeshProblem(
  const FuzzCase& c, const Mesh& mesh, const MeshReport& report, FuzzResult& result)
{
  result.Locked = CountLocked(mesh);
  const auto findInBox = [&]
  {
    return FirstOf({ FindTopologyProblem(mesh), FindFragmentProblem(mesh), FindFacetProblem(mesh),
      FindTruthProblem(c, mesh, result.Locked) });
  };
  return FirstOf({ FindJacobianProblem(c, mesh, result),
    c.Grid.IsPeriodic() ? FindSideProblem(c, mesh) : findInBox(), FindPlaceProblem(c.Grid, mesh),
    FindVolumeProblem(c, mesh, report), FindFarProblem(c, mesh, report),
    FindSpaceProblem(mesh, result) });
}

bool IsModified(const FuzzCase& c)
{
  return c.Layers > 1 || !c.Split.empty() || c.Options.ElementOrder != InterpolationOrder::Linear;
}

/// Cuts layers, splits interfaces and adds mid nodes. Returns the counts of mid nodes. Collective.
FieldArrays Modify(const FuzzCase& c, Runtime& runtime, Mesh& mesh, MeshReport& report)
{
  std::vector<int> labels(c.Fractions.NumberOfMaterials() + 1);
  std::iota(labels.begin(), labels.end(), 0);
  MesherOptions options;
  options.Layers = c.Layers;
  options.FirstLayer = c.FirstLayer;
  options.FirstLayerUnit = ThicknessUnit::Length;
  OutputState none;
  AddLayers(
    options, { c.Grid.MeanWidth(), Vector3{}, labels, nullptr }, runtime, mesh, none, report);
  if (!c.Split.empty())
  {
    std::map<int, std::string> names;
    for (int label : labels)
    {
      names[label] = std::to_string(label);
    }
    std::vector<FieldArray> fields;
    SplitInterfaces(MaterialPairs("SplitInterfaces", c.Split, names), ConnectionKind::Cohesive,
      runtime, fields, mesh, none);
  }
  return c.Options.ElementOrder == InterpolationOrder::Linear
    ? FieldArrays()
    : AddMidNodes(c.Options.ElementOrder, {}, runtime, mesh, none);
}

/// Adds mid nodes to a mesh of one rank. Checks that all elements are positive, and the volumes of
/// materials, if no mid node was moved back.
std::string FindCurvedProblem(const FuzzCase& c, Mesh& mesh, MeshReport& report)
{
  Runtime runtime;
  const FieldArrays counts = Modify(c, runtime, mesh, report);
  const CurvedElement& shape = GetCurvedElement(mesh.Corners);
  std::vector<double> volumes(c.Fractions.NumberOfMaterials() + 1, 0.0);
  for (Index e = 0; e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    const CurvedElement::Nodes nodes = NodesOf(mesh, e);
    volumes[mesh.Material[e]] += shape.Volume(nodes);
    const double smallest = shape.SmallestCoefficient(nodes);
    if (!(smallest > 0.0))
    {
      return Describe("smallest coefficient of a curved element", smallest, mesh.ElementIds[e]);
    }
  }
  const bool isMovedBack = std::get<std::vector<Index>>(counts[1].Values)[0] > 0;
  const double domain = VolumeOf(c.Grid, c.Grid.Domain());
  for (int m = c.Options.MeshVoid ? 0 : 1; !isMovedBack && m <= c.Fractions.NumberOfMaterials();
       ++m)
  {
    if (!(std::fabs(volumes[m] - report.MeshVolume[m]) <= VolumeTolerance * domain))
    {
      return Describe("curved volume off by", volumes[m] / report.MeshVolume[m] - 1.0, m);
    }
  }
  return FindPlaceProblem(c.Grid, mesh);
}

/// Cuts and splits a mesh of one rank. Checks that its layers are positive, and the volumes.
std::string FindModifiedProblem(const FuzzCase& c, Mesh& mesh, MeshReport& report)
{
  Runtime runtime;
  Modify(c, runtime, mesh, report);
  for (Index e = 0; c.Layers > 1 && e < static_cast<Index>(mesh.ElementIds.size()); ++e)
  {
    const double smallest = SmallestCoefficient(mesh, e);
    if (!(smallest > 0.0))
    {
      return Describe("smallest coefficient of a layer", smallest, mesh.ElementIds[e]);
    }
  }
  const bool isWhole = c.Split.empty() && !c.Grid.IsPeriodic();
  return FirstOf(
    { c.Split.empty() ? FindTopologyProblem(mesh) : "", isWhole ? FindFragmentProblem(mesh) : "",
      isWhole ? FindFacetProblem(mesh) : "", FindVolumeProblem(c, mesh, report) });
}

/// Checks the tets of TetGen on several ranks, which fills the part of each rank separately.
std::string FindPartsProblem(const FuzzCase& c, const RankMesh& made, const RankMesh& alone)
{
  const Mesh merged = made.Merged.Join();
  const std::string geometry = FindGeometryDifference(made.Merged, alone.Merged);
  FuzzResult unused;
  if (c.Grid.IsPeriodic()) // the elements of joined sides have no volume
  {
    const bool isJoined = c.PeriodicSides == Sides::Joined;
    return FirstOf({ geometry, isJoined ? std::string() : FindJacobianProblem(c, merged, unused),
      FindTorusProblem(c, merged, made.Reports[0]) });
  }
  for (const MeshReport& report : made.Reports)
  {
    for (std::size_t m = 0; m < report.MeshVolume.size(); ++m)
    {
      const double volume = alone.Reports[0].MeshVolume[m];
      if (!(std::fabs(report.MeshVolume[m] - volume) <= RankTolerance * volume))
      {
        return Describe("volume differs by", report.MeshVolume[m] / volume - 1.0, Index(m));
      }
    }
  }
  return FirstOf({ geometry, FindJacobianProblem(c, merged, unused), FindTopologyProblem(merged),
    FindFragmentProblem(merged), FindGeometryProblem(made.Merged),
    FindVolumeProblem(c, merged, made.Reports[0]) });
}

std::string FindRanksProblem(
  const FuzzCase& c, const std::vector<IndexBox>& boxes, const RankMesh& alone)
{
  const MeshMaker make = c.Grid.IsPeriodic() ? MakerOfTorus(c) : c.Make;
  const RankMeshChange modify = [&c](Runtime& runtime, Mesh& mesh, MeshReport& report)
  {
    if (IsModified(c))
    {
      Modify(c, runtime, mesh, report);
    }
  };
  const RankMesh made = MakeOnRanks(c.Grid, c.Fractions, boxes, c.Options, make, modify);
  return KnowsCells(c) ? FindDifference(made, alone) : FindPartsProblem(c, made, alone);
}

} // namespace

FuzzResult CheckCase(const FuzzCase& c)
{
  return CheckCase(c, c.Boxes.empty() ? Cuts() : Cuts{ c.Boxes });
}

FuzzResult CheckCase(const FuzzCase& c, const Cuts& cuts)
{
  FuzzResult result;
  Runtime runtime;
  RankMesh alone;
  alone.Reports.resize(1);
  Mesh mesh = c.Make(c.Grid, c.Fractions, c.Options, runtime, alone.Reports[0]);
  result.Elements = static_cast<Index>(mesh.ElementIds.size());
  result.Problem = FindMeshProblem(c, mesh, alone.Reports[0], result);
  if (c.Grid.IsPeriodic())
  {
    const std::string problem = LeaveTorus(c, mesh);
    result.Problem =
      FirstOf({ result.Problem, problem, FindTorusProblem(c, mesh, alone.Reports[0]) });
  }
  alone.Merged.Add(mesh);
  // Surfaces continue across the sides of a periodic mesh that are not joined.
  const bool isClosed = !c.Grid.IsPeriodic() || c.PeriodicSides == Sides::Joined;
  result.Problem =
    FirstOf({ result.Problem, isClosed ? FindGeometryProblem(alone.Merged) : std::string() });
  if (c.Options.ElementOrder != InterpolationOrder::Linear)
  {
    const std::string problem = FindCurvedProblem(c, mesh, alone.Reports[0]);
    result.Problem += problem.empty() ? "" : " curved: " + problem;
    alone.Merged = {};
    alone.Merged.Add(mesh);
  }
  else if (IsModified(c))
  {
    const std::string problem = FindModifiedProblem(c, mesh, alone.Reports[0]);
    result.Problem += problem.empty() ? "" : " modified: " + problem;
    alone.Merged = {};
    alone.Merged.Add(mesh);
  }
  if (result.Elements > 0)
  {
    result.ScaledJacobian = alone.Reports[0].MinimumScaledJacobian;
  }
  for (const std::vector<IndexBox>& boxes : cuts)
  {
    const std::string problem = FindRanksProblem(c, boxes, alone);
    result.Problem +=
      problem.empty() ? "" : " " + std::to_string(boxes.size()) + " ranks: " + problem;
  }
  result.Report = std::move(alone.Reports[0]);
  return result;
}

} // namespace testing
} // namespace vfm
