#include "Meshes/OpenFoam/CyclicSides.h"

#include "Meshes/OpenFoam/CellSides.h"
#include "Sets/PeriodicPairs.h"
#include "Summary/DomainSides.h"
#include "Summary/MatchFaces.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace vfm
{
namespace
{

/// A side with the partners of its points in ascending order.
struct Copy
{
  FaceIds Partners;
  Index Side;
  bool operator<(const Copy& other) const
  {
    return std::tie(this->Partners, this->Side) < std::tie(other.Partners, other.Side);
  }
};

std::vector<Copy> SortByPartners(const MeshData& mesh, const std::vector<Index>& open)
{
  std::vector<Copy> copies;
  for (Index side : open)
  {
    copies.push_back({ SortedIds(PointsOfSide(mesh, side), mesh.PeriodicPartner), side });
  }
  std::sort(copies.begin(), copies.end());
  return copies;
}

/// Counts the periods between sides that are copies of each other.
class PeriodCounter
{
public:
  explicit PeriodCounter(const MeshData& mesh) :
    TheMesh(mesh), Lengths(NumbersOfField(mesh.Fields, "PeriodLengths")), Frame(FrameOfDomain(mesh))
  {
    if (this->Lengths.size() != 3)
    {
      RejectMissing("PeriodLengths");
    }
  }

  Index3 Count(Index from, Index to) const
  {
    return CountPeriods(this->FirstPoint(from), this->FirstPoint(to), this->Lengths);
  }

private:
  /// Returns the position of the first point of a side, which has the lowest partner.
  Vector3 FirstPoint(Index side) const
  {
    return this->Frame.ToOwn(this->TheMesh.PointAt(PointsOfSide(this->TheMesh, side)[0]));
  }

  const MeshData& TheMesh;
  const std::vector<double> Lengths;
  const ImageFrame Frame;
};

/// Returns the name of the patch on the side of the domain in a direction.
std::string NameOfPatch(const Index3& direction)
{
  std::string name;
  for (int a = 0; a < 3; ++a)
  {
    if (direction[a] != 0)
    {
      name += (name.empty() ? "" : "_") + std::string(1, "xyz"[a]);
      name += direction[a] < 0 ? "_min" : "_max";
    }
  }
  return name;
}

Index3 Opposite(const Index3& periods)
{
  return { { -periods[0], -periods[1], -periods[2] } };
}

} // namespace

CyclicSides FindCyclicSides(const MeshData& mesh, const std::vector<Index>& open)
{
  CyclicSides found;
  if (!mesh.PeriodicPartner)
  {
    found.Others = open;
    return found;
  }
  const PeriodCounter periods(mesh);
  const std::vector<Copy> copies = SortByPartners(mesh, open);
  std::map<Index3, CyclicPatches, std::greater<Index3>> patches; // by the periods to the second
  for (std::size_t c = 0; c < copies.size(); ++c)
  {
    if (c + 1 == copies.size() || copies[c].Partners != copies[c + 1].Partners)
    {
      found.Others.push_back(copies[c].Side);
      continue;
    }
    std::array<Index, 2> pair{ { copies[c].Side, copies[c + 1].Side } };
    Index3 count = periods.Count(pair[0], pair[1]);
    if (count < Opposite(count))
    {
      std::swap(pair[0], pair[1]);
      count = Opposite(count);
    }
    CyclicPatches& both = patches[count];
    both.Names = { { NameOfPatch(Opposite(count)), NameOfPatch(count) } };
    both.Sides[0].push_back(pair[0]);
    both.Sides[1].push_back(pair[1]);
    ++c;
  }
  for (auto& entry : patches)
  {
    found.Patches.push_back(std::move(entry.second));
  }
  std::sort(found.Others.begin(), found.Others.end());
  return found;
}

} // namespace vfm
