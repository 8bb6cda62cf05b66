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

/// Positions in which hexes are smoothed: lattice coordinates, in which cells are cubes, or lengths
/// over the mean width of the grid.
class SmoothingSpace
{
public:
  SmoothingSpace(const OctreeKeys& lattice, bool inLattice) :
    Lattice(lattice), InLattice(inLattice), Scale(lattice.Base().MeanWidth())
  {
  }

  /// Returns the position of a point of the mesh.
  Vector3 From(const double* p) const
  {
    return this->InLattice ? this->Lattice.FromPoint({ { p[0], p[1], p[2] } })
                           : ToGrid(this->Lattice.Base(), p);
  }
  /// Returns the point of the mesh at a position.
  Vector3 ToPoint(const Vector3& x) const
  {
    if (this->InLattice)
    {
      return this->Lattice.ToPoint(x);
    }
    const CartesianGrid& grid = this->Lattice.Base();
    const Vector3 offset = this->Scale * x;
    return { { grid.Coordinates(0)[0] + offset[0], grid.Coordinates(1)[0] + offset[1],
      grid.Coordinates(2)[0] + offset[2] } };
  }
  /// Returns the widths of a cell.
  Vector3 CellWidths(const OctreeKeys::LevelIndex& cell) const
  {
    const double width = std::ldexp(1.0, -cell.Level);
    return this->InLattice ? Vector3{ { width, width, width } }
                           : (1.0 / this->Scale) * this->Lattice.CellWidths(cell.Level, cell.At);
  }
  /// Returns the unit along each axis, in length units.
  Vector3 Unit() const
  {
    const CartesianGrid& base = this->Lattice.Base();
    Vector3 unit{ { this->Scale, this->Scale, this->Scale } };
    for (int a = 0; a < 3; ++a)
    {
      const bool isCells = this->InLattice && base.Period(a) > 0;
      unit[a] = isCells ? base.PeriodLength(a) / static_cast<double>(base.Period(a)) : unit[a];
    }
    return unit;
  }

private:
  const OctreeKeys& Lattice;
  const bool InLattice;
  const double Scale;
};

/// Transition hexes and the points that move.
struct ActiveTransitions
{
  ActiveMesh Active; ///< free points first, in the order of RefinedMesh::FreePoints
  std::vector<unsigned char> IsFree;
  std::vector<unsigned char> IsOwned; ///< whether this rank counts each hex
};

/// Returns the smallest corner determinant of a hex, in cell volumes.
double SmallestCorner(const ActiveMesh& active, std::size_t hex)
{
  const Vector3& widths = active.WidthsAt(static_cast<Index>(8 * hex));
  const int* points = active.Elements.data() + 8 * hex;
  double smallest = 1e300;
  for (int c = 0; c < 8; ++c)
  {
    const auto edge = [&](int a)
    { return Divided(active.X[points[c | 1 << a]] - active.X[points[c & ~(1 << a)]], widths); };
    smallest = std::min(smallest, Dot(edge(0), Cross(edge(1), edge(2))));
  }
  return smallest;
}

/// Activates only the free points of flat and inverted hexes; counts these hexes.
void ActivateFlat(ActiveTransitions& hexes, Index& flat, Index& inverted)
{
  flat = inverted = 0;
  std::fill(hexes.Active.IsActive.begin(), hexes.Active.IsActive.end(), 0);
  for (std::size_t h = 0; 8 * h < hexes.Active.Elements.size(); ++h)
  {
    const double smallest = SmallestCorner(hexes.Active, h);
    inverted += hexes.IsOwned[h] && smallest <= SmallestDeterminant;
    if (smallest > FlatDeterminant)
    {
      continue;
    }
    ++flat;
    for (int c = 0; c < 8; ++c)
    {
      const int point = hexes.Active.Elements[8 * h + c];
      hexes.Active.IsActive[point] = hexes.IsFree[point];
    }
  }
}

void Untangle(ActiveTransitions& hexes, Runtime& runtime, TransitionReport& report)
{
  UntangleEnergy energy;
  Smoother smoother(hexes.Active, nullptr, energy, runtime);
  double eps = LargestEps;
  for (int sweep = 0; sweep <= UntangleSweeps; ++sweep)
  {
    Index flat, inverted;
    ActivateFlat(hexes, flat, inverted);
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
  hexes.Active.IsActive = hexes.IsFree;
}

void Smooth(ActiveMesh& active, Runtime& runtime)
{
  const HexEnergy energy(TargetScaledJacobian);
  Smoother(active, nullptr, energy, runtime).RunRamp(Ramp);
}

void CopyBack(const ActiveMesh& active, const SmoothingSpace& space, RefinedMesh& mesh)
{
  for (std::size_t n = 0; n < mesh.FreePoints.size(); ++n)
  {
    const Vector3 x = space.ToPoint(active.X[n]);
    for (int a = 0; a < 3; ++a)
    {
      if (!(active.Fixed[n] >> a & 1))
      {
        mesh.Points[3 * static_cast<Index>(active.MeshPoint[n]) + a] = x[a];
      }
    }
  }
}

void PlacePoints(const RefinedMesh& mesh, const CartesianGrid& base, const SmoothingSpace& space,
  ActiveMesh& active)
{
  for (std::size_t n = 0; n < active.MeshPoint.size(); ++n)
  {
    const Index point = active.MeshPoint[n];
    const double* p = mesh.Points.data() + 3 * point;
    active.X[n] = space.From(p);
    active.Fixed[n] =
      FixedOnSides(mesh.DomainSides[point]) | base.FlatSeams(Vector3{ { p[0], p[1], p[2] } });
  }
}

ActiveTransitions Activate(const OctreeKeys& lattice, const RefinedMesh& mesh,
  const Partition& partition, const SmoothingSpace& space)
{
  ActiveMeshBuilder builder(8, mesh.NumberOfPoints(), ListMovers(lattice, mesh));
  std::vector<Vector3> widths;
  std::vector<unsigned char> isOwned;
  for (Index h = 0; h < mesh.NumberOfHexes(); ++h)
  {
    if (mesh.IsTransition[h])
    {
      const OctreeKeys::LevelIndex cell = lattice.HexOfKey(mesh.HexKeys[h]);
      builder.Add(mesh.Hexes.data() + 8 * h);
      isOwned.push_back(partition.OwnsCell(BaseCellOf(cell)));
      widths.push_back(space.CellWidths(cell));
    }
  }
  ActiveMesh active = builder.Finish(partition, CopiesOfAnchors(lattice, space.Unit()), 8);
  active.Widths = std::move(widths);
  PlacePoints(mesh, lattice.Base(), space, active);
  std::vector<unsigned char> isFree = active.IsActive;
  return { std::move(active), std::move(isFree), std::move(isOwned) };
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
  const SmoothingSpace space(lattice, inLattice);
  ActiveTransitions hexes = Activate(lattice, mesh, partition, space);
  Untangle(hexes, runtime, report);
  if (smooth)
  {
    Smooth(hexes.Active, runtime);
  }
  CopyBack(hexes.Active, space, mesh);
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
  const OctreeKeys& lattice, RefinedMesh& mesh, Runtime& runtime, bool smooth)
{
  CheckNumberOfPoints(mesh.NumberOfPoints(), runtime.Group());
  const Partition partition(lattice.Base(), runtime.Group());
  TransitionReport report;
  MovePoints(lattice, mesh, partition, true, smooth, runtime, report);
  MoveByWidths(lattice, mesh, partition, smooth, runtime, report);
  report.InvertedHexes = SumOverRanks(report.InvertedHexes, runtime.Group());
  return report;
}

} // namespace vfm
