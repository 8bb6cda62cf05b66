#include "Tet/CoarseTetsImprove.h"

#include "Mesh/PeriodicIds.h"
#include "Mesh/TetQuality.h"
#include "Octree/RefinedGrid.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Smoother.h"
#include "Tet/TetImprove.h"

namespace vfm
{
namespace
{

constexpr double PoorAngle = 20.0; // distance of a dihedral angle from 0 or 180, degrees

/// Returns whether a tet has a dihedral angle near 0 or 180 degrees. Like the energy, angles are
/// measured in widths of the tet's cell. position: in active.Elements.
bool HasPoorAngle(const ActiveMesh& active, std::size_t position)
{
  const Index corners[4] = { 0, 1, 2, 3 };
  double points[12], angles[6];
  for (int c = 0; c < 4; ++c)
  {
    const Vector3 x = Divided(
      active.X[active.Elements[position + c]], active.WidthsAt(static_cast<Index>(position)));
    std::copy(x.begin(), x.end(), points + 3 * c);
  }
  DihedralAngles(points, corners, angles);
  return std::any_of(
    angles, angles + 6, [](double angle) { return std::min(angle, 180.0 - angle) < PoorAngle; });
}

/// Restricts the active points of this rank to the movers of poor tets. Returns whether there are
/// poor tets.
bool ActivatePoor(ActiveMesh& active)
{
  std::vector<unsigned char> isPoor(active.X.size(), 0);
  bool found = false;
  for (std::size_t t = 0; t < active.Elements.size(); t += 4)
  {
    if (HasPoorAngle(active, t))
    {
      found = true;
      std::for_each(active.Elements.begin() + t, active.Elements.begin() + t + 4,
        [&](int point) { isPoor[point] = 1; });
    }
  }
  for (const MoveOrder::Group& group : active.Order.Groups())
  {
    std::copy(isPoor.begin() + group.First, isPoor.begin() + group.Last,
      active.IsActive.begin() + group.First);
  }
  return found;
}

} // namespace

void ImproveCoarseTets(std::vector<Mover> movers, const TetList& tets, const CartesianGrid& finest,
  const Partition& partition, const ElementEnergy& energy, Runtime& runtime, Mesh& mesh)
{
  ActiveMeshBuilder builder(4, mesh.Points.size() / 3, std::move(movers));
  std::vector<Vector3> widths;
  tets(
    [&](const std::array<int, 4>& tet, const Vector3& widthsOfTet)
    {
      if (builder.HasMover(tet.data()))
      {
        builder.Add(tet.data());
        widths.push_back(widthsOfTet);
      }
    });
  ActiveMesh active =
    builder.Finish(partition, CopiesOfMovers(mesh, mesh.Levels->NumberOfRefinements()), 8);
  active.Widths = std::move(widths);
  active.PlacePoints(finest, mesh);
  if (runtime.Group().Any(ActivatePoor(active)))
  {
    Smoother(active, nullptr, energy, runtime).RunRamp(TetRamp());
    active.CopyTo(mesh, finest);
  }
}

} // namespace vfm
