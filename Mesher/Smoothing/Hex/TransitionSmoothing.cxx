#include "Smoothing/Hex/TransitionSmoothing.h"

#include "Base/Vector3.h"
#include "Elements/Hex/HexCoefficients.h"
#include "Elements/Hex/HexTopology.h"
#include "Elements/PeriodicIds.h"
#include "Geometry/Quality.h"
#include "Ranks/Agreement.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Hex/HexEnergy.h"
#include "Smoothing/Smoother.h"
#include "Smoothing/UntangleEnergy.h"

namespace vfm
{
namespace
{

constexpr double TargetScaledJacobian = 0.6;
constexpr double SmallestDeterminant = 1e-8; // smallest determinant of a corner, in cell volumes
/// Corners below take part in untangling, because the barrier finds poor minima from nearly
/// flat hexes.
constexpr double FlatDeterminant = 1e-3;
constexpr int UntangleSweeps = 24;
constexpr double LargestEps = 0.05, SmallestEps = 1e-3; // halved after each sweep, in cell volumes
constexpr double ShapeWeight = 0.3;                     // weight in untangling

const SmoothingRamp Ramp{ { 1, 0.0, 0.1, 5, 1e-3 }, { 2, 0.0, 0.05, 8, 1e-3 },
  { 8, 0.0, 0.01, 25, 1e-3 } };

/// Lists the free points, in their order.
std::vector<Mover> ListMovers(const OctreeKeys& lattice, const RefinedMesh& mesh)
{
  std::vector<Mover> movers;
  for (const RefinedMesh::FreePoint& point : mesh.FreePoints)
  {
    const OctreeKeys::LevelIndex anchor = lattice.NodeOfKey(point.Anchor);
    movers.push_back({ point.Point, point.Anchor, point.Anchor / OctreeKeys::NodeSlots,
      OwnerNode(anchor), CartesianGrid::Parities(anchor.At) });
  }
  return movers;
}

/// Transition hexes and the points that move, in lattice coordinates or in lengths over the
/// mean width.
struct Work
{
  const OctreeKeys& Lattice;
  RefinedMesh& Refined;
  const Partition& Parts;
  const bool InLattice;
  const double Scale = Lattice.Base().MeanWidth();
  ActiveMesh Active{}; // free points first, in the order of RefinedMesh::FreePoints
  std::vector<unsigned char> IsFree{};
  // Whether this rank counts each hex.
  std::vector<unsigned char> IsOwned{};
};

/// Returns the smallest corner determinant of a hex, in cell volumes.
double SmallestCorner(const Work& work, std::size_t hex)
{
  const Vector3& widths = work.Active.WidthsAt(static_cast<Index>(8 * hex));
  const int* points = work.Active.Elements.data() + 8 * hex;
  double smallest = 1e300;
  for (int c = 0; c < 8; ++c)
  {
    const auto edge = [&](int a)
    {
      return Divided(
        work.Active.X[points[c | 1 << a]] - work.Active.X[points[c & ~(1 << a)]], widths);
    };
    smallest = std::min(smallest, Dot(edge(0), Cross(edge(1), edge(2))));
  }
  return smallest;
}

/// Activates only the free points of flat and inverted hexes; counts these hexes.
void ActivateFlat(Work& work, Index& flat, Index& inverted)
{
  flat = inverted = 0;
  std::fill(work.Active.IsActive.begin(), work.Active.IsActive.end(), 0);
  for (std::size_t h = 0; 8 * h < work.Active.Elements.size(); ++h)
  {
    const double smallest = SmallestCorner(work, h);
    inverted += work.IsOwned[h] && smallest <= SmallestDeterminant;
    if (smallest > FlatDeterminant)
    {
      continue;
    }
    ++flat;
    for (int c = 0; c < 8; ++c)
    {
      const int point = work.Active.Elements[8 * h + c];
      work.Active.IsActive[point] = work.IsFree[point];
    }
  }
}

void Untangle(Work& work, Runtime& runtime, TransitionReport& report)
{
  UntangleEnergy energy;
  Smoother smoother(work.Active, nullptr, energy, runtime);
  double eps = LargestEps;
  for (int sweep = 0; sweep <= UntangleSweeps; ++sweep)
  {
    Index flat, inverted;
    ActivateFlat(work, flat, inverted);
    if (sweep == 0)
    {
      report.InvertedHexes += inverted;
    }
    if (sweep == UntangleSweeps || !runtime.Group().Any(flat > 0))
    {
      break;
    }
    energy.SetRegularisation(eps);
    eps = std::max(0.5 * eps, SmallestEps);
    smoother.RunStage({ 1, 0.0, ShapeWeight, 1, 0.0 }, [](double) {});
    ++report.UntangleSweeps;
  }
  work.Active.IsActive = work.IsFree;
}

void Smooth(Work& work, Runtime& runtime)
{
  const HexEnergy energy(TargetScaledJacobian);
  Smoother(work.Active, nullptr, energy, runtime).RunRamp(Ramp);
}

void CopyBack(const Work& work)
{
  const CartesianGrid& grid = work.Lattice.Base();
  for (std::size_t n = 0; n < work.Refined.FreePoints.size(); ++n)
  {
    const Vector3 x =
      work.InLattice ? work.Lattice.ToPoint(work.Active.X[n]) : work.Scale * work.Active.X[n];
    for (int a = 0; a < 3; ++a)
    {
      if (!(work.Active.Fixed[n] >> a & 1))
      {
        work.Refined.Points[3 * work.Active.MeshPoint[n] + a] =
          work.InLattice ? x[a] : grid.Coordinates(a)[0] + x[a];
      }
    }
  }
}

/// Adds a hex that the owner of its cell counts; returns its widths.
Vector3 AddCell(Work& work, const OctreeKeys::LevelIndex& cell)
{
  work.IsOwned.push_back(work.Parts.OwnsCell(BaseCellOf(cell)));
  const double width = std::ldexp(1.0, -cell.Level);
  return work.InLattice ? Vector3{ { width, width, width } }
                        : (1.0 / work.Scale) * work.Lattice.CellWidths(cell.Level, cell.At);
}

void PlacePoints(Work& work)
{
  for (std::size_t n = 0; n < work.Active.MeshPoint.size(); ++n)
  {
    const Index point = work.Active.MeshPoint[n];
    const double* p = work.Refined.Points.data() + 3 * point;
    work.Active.X[n] = work.InLattice ? work.Lattice.FromPoint({ { p[0], p[1], p[2] } })
                                      : ToGrid(work.Lattice.Base(), p);
    work.Active.Fixed[n] = FixedOnSides(work.Refined.DomainSides[point]) |
      work.Lattice.Base().FlatSeams(Vector3{ { p[0], p[1], p[2] } });
  }
}

/// Returns the unit of positions along each axis, in length units.
Vector3 UnitOf(const Work& work)
{
  const CartesianGrid& base = work.Lattice.Base();
  Vector3 unit{ { work.Scale, work.Scale, work.Scale } };
  for (int a = 0; a < 3; ++a)
  {
    const bool isCells = work.InLattice && base.Period(a) > 0;
    unit[a] = isCells ? base.PeriodLength(a) / static_cast<double>(base.Period(a)) : unit[a];
  }
  return unit;
}

void Activate(Work& work)
{
  const RefinedMesh& mesh = work.Refined;
  ActiveMeshBuilder builder(8, mesh.NumberOfPoints(), ListMovers(work.Lattice, mesh));
  std::vector<Vector3> widths;
  for (Index h = 0; h < mesh.NumberOfHexes(); ++h)
  {
    if (mesh.IsTransition[h])
    {
      builder.Add(mesh.Hexes.data() + 8 * h);
      widths.push_back(AddCell(work, work.Lattice.HexOfKey(mesh.HexKeys[h])));
    }
  }
  work.Active = builder.Finish(work.Parts, CopiesOfAnchors(work.Lattice, UnitOf(work)), 8);
  work.Active.Widths = std::move(widths);
  PlacePoints(work);
  work.IsFree = work.Active.IsActive;
}

/// Quality of the owned transition hexes.
class TransitionQuality
{
public:
  TransitionQuality(const OctreeKeys& lattice, const RefinedMesh& mesh, const Partition& partition)
  {
    for (Index h = 0; h < mesh.NumberOfHexes(); ++h)
    {
      const OctreeKeys::LevelIndex cell = lattice.HexOfKey(mesh.HexKeys[h]);
      if (!mesh.IsTransition[h] || !partition.OwnsCell(BaseCellOf(cell)))
      {
        continue;
      }
      const Index* hex = mesh.Hexes.data() + 8 * h;
      this->Smallest = std::min(this->Smallest, HexScaledJacobian(mesh.Points.data(), hex));
      if (!IsPositive(mesh, hex, lattice.CellWidths(cell.Level, cell.At)))
      {
        this->Bad.push_back(cell);
      }
    }
  }

  const std::vector<OctreeKeys::LevelIndex>& BadCells() const { return this->Bad; }

  /// Returns whether this mesh has fewer bad cells over all ranks, or as many and better hexes.
  /// @pre Collective.
  bool IsBetterThan(const TransitionQuality& other, Ranks& ranks) const
  {
    std::vector<std::int64_t> bad{ static_cast<std::int64_t>(this->Bad.size()),
      static_cast<std::int64_t>(other.Bad.size()) };
    ranks.Sum(bad);
    const double smallest = ranks.Max(-this->Smallest), others = ranks.Max(-other.Smallest);
    return bad[0] < bad[1] || (bad[0] == bad[1] && smallest < others);
  }

private:
  static bool IsPositive(const RefinedMesh& mesh, const Index* hex, const Vector3& widths)
  {
    std::array<Vector3, 8> corners;
    for (int c = 0; c < 8; ++c)
    {
      const double* x = mesh.Points.data() + 3 * hex[VtkCorner[c]];
      corners[c] = Divided({ { x[0], x[1], x[2] } }, widths);
    }
    return SmallestCoefficient(corners) > SmallestDeterminant;
  }

  double Smallest = 1.0; // scaled Jacobian
  std::vector<OctreeKeys::LevelIndex> Bad;
};

void MovePoints(const OctreeKeys& lattice, RefinedMesh& mesh, const Partition& partition,
  bool inLattice, bool smooth, Runtime& runtime, TransitionReport& report)
{
  Work work{ lattice, mesh, partition, inLattice };
  Activate(work);
  Untangle(work, runtime, report);
  if (smooth)
  {
    Smooth(work, runtime);
  }
  CopyBack(work);
}

/// Smooths by the widths of the cells, starting from the result for cubes. Restores that result if
/// it is better, which can happen at points between cells of high aspect ratio.
void MoveByWidths(const OctreeKeys& lattice, RefinedMesh& mesh, const Partition& partition,
  bool smooth, Runtime& runtime, TransitionReport& report)
{
  TransitionQuality quality(lattice, mesh, partition);
  if (!HasCubes(lattice.Base()))
  {
    const std::vector<double> points = mesh.Points;
    MovePoints(lattice, mesh, partition, false, smooth, runtime, report);
    const TransitionQuality after(lattice, mesh, partition);
    if (quality.IsBetterThan(after, runtime.Group()))
    {
      mesh.Points = points;
    }
    else
    {
      quality = after;
    }
  }
  report.BadCells = quality.BadCells();
}

} // namespace

Index3 OwnerNode(const OctreeKeys::LevelIndex& anchor)
{
  Index3 node;
  for (int a = 0; a < 3; ++a)
  {
    node[a] = (std::max<Index>(anchor.At[a] - 1, 0) >> anchor.Level) + 1;
  }
  return node;
}

TransitionReport SmoothTransitions(
  const OctreeKeys& lattice, RefinedMesh& mesh, Runtime& runtime, bool smooth, bool asCubes)
{
  CheckNumberOfPoints(mesh.NumberOfPoints(), runtime.Group());
  const Partition partition(lattice.Base(), runtime.Group());
  TransitionReport report;
  MovePoints(lattice, mesh, partition, true, smooth, runtime, report);
  if (!asCubes)
  {
    MoveByWidths(lattice, mesh, partition, smooth, runtime, report);
  }
  report.InvertedHexes = SumOverRanks(report.InvertedHexes, runtime.Group());
  return report;
}

} // namespace vfm
