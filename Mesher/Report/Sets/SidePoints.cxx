#include "Report/Sets/SidePoints.h"

#include "Report/DomainSides.h"
#include "Report/ElementCorners.h"
#include "Report/MatchFaces.h"

#include <map>

namespace vfm
{
namespace
{

/// Returns the sides of the domain (bits) on which each point has a facet. Sides of periodic meshes
/// need not be plane.
std::vector<unsigned char> FindSidesOfFacets(
  const MeshData& mesh, const std::vector<MeshFacet>& facets)
{
  std::vector<unsigned char> sides(mesh.NumberOfPoints, 0);
  for (const MeshFacet& facet : facets)
  {
    const auto mark = [&](Index point)
    {
      if (point >= 0 && facet.DomainSide != NoSide)
      {
        sides[point] = static_cast<unsigned char>(sides[point] | 1 << facet.DomainSide);
      }
    };
    const FaceIds corners = PointsOfSide(mesh, facet);
    std::for_each(corners.begin(), corners.end(), mark);
    const std::vector<Index> mids = MidsOfFace(mesh, facet.Element, facet.Side);
    std::for_each(mids.begin(), mids.end(), mark);
  }
  return sides;
}

/// Returns the points of a side in the order of their partners, copies of one point by position.
std::vector<Index> SortByPartners(const MeshData& mesh, int side, std::vector<Index> points)
{
  const ImageFrame frame = FrameOfDomain(mesh);
  const auto positionOf = [&](Index point)
  {
    Vector3 own = frame.ToOwn(mesh.PointAt(point));
    own[side / 2] = 0.0;
    return own;
  };
  const Index* partners = mesh.PeriodicPartner;
  std::sort(points.begin(), points.end(),
    [&](Index a, Index b) {
      return partners[a] != partners[b] ? partners[a] < partners[b] : positionOf(a) < positionOf(b);
    });
  return points;
}

/// Finds the copies of points on the opposite side.
class OppositePoints
{
public:
  OppositePoints(const MeshData& mesh, int axis, const std::vector<Index>& points) :
    TheMesh(mesh), Axis(axis), Places(mesh)
  {
    for (Index point : points)
    {
      this->PlacesOf[mesh.PeriodicPartner[point]].push_back(this->PlaceOf(point));
    }
  }

  /// Returns whether a point of the other side has a copy here: whole periods only along the axis.
  bool HasCopyOf(Index point) const
  {
    const auto copies = this->PlacesOf.find(this->TheMesh.PeriodicPartner[point]);
    const auto isOpposite = [&](Index place)
    {
      Index3 periods = FacePlaces::PeriodsBetween(place, this->PlaceOf(point));
      periods[this->Axis] = 0;
      return periods == Index3{ { 0, 0, 0 } };
    };
    return copies != this->PlacesOf.end() &&
      std::any_of(copies->second.begin(), copies->second.end(), isOpposite);
  }

private:
  Index PlaceOf(Index point) const { return this->Places.Of({ this->TheMesh.PointAt(point) }); }

  const MeshData& TheMesh;
  const int Axis;
  const FacePlaces Places;
  std::map<Index, std::vector<Index>> PlacesOf; // by partner
};

/// Moves the points of two opposite sides that have no copy on the other one to the end. Sides next
/// to void that is not meshed can have such points.
void SeparateUnpaired(
  const MeshData& mesh, int axis, std::vector<Index>& lower, std::vector<Index>& upper)
{
  const OppositePoints below(mesh, axis, lower), above(mesh, axis, upper);
  std::stable_partition(
    lower.begin(), lower.end(), [&above](Index point) { return above.HasCopyOf(point); });
  std::stable_partition(
    upper.begin(), upper.end(), [&below](Index point) { return below.HasCopyOf(point); });
}

} // namespace

std::array<std::vector<Index>, 6> FindSidePoints(
  const MeshData& mesh, const std::vector<MeshFacet>& facets)
{
  const DomainSides domain(mesh);
  const std::vector<unsigned char> sidesOfFacets = FindSidesOfFacets(mesh, facets);
  std::array<std::vector<Index>, 6> points;
  for (int side = 0; side < 6; ++side)
  {
    for (Index point = 0; point < mesh.NumberOfPoints; ++point)
    {
      if (domain.IsOnSide(point, side) || (sidesOfFacets[point] >> side & 1) != 0)
      {
        points[side].push_back(point);
      }
    }
    if (mesh.PeriodicPartner && domain.IsPeriodic(side))
    {
      points[side] = SortByPartners(mesh, side, std::move(points[side]));
    }
    if (mesh.PeriodicPartner && domain.IsPeriodic(side) && side % 2 == 1)
    {
      SeparateUnpaired(mesh, side / 2, points[side - 1], points[side]);
    }
  }
  return points;
}

} // namespace vfm
