#include "Meshes/OpenFoam/CyclicSides.h"

#include "Meshes/OpenFoam/CellSides.h"
#include "Ranks/Agreement.h"
#include "Report/DomainSides.h"
#include "Report/MatchFaces.h"
#include "Report/Sets/PeriodicPairs.h"

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
  RankSide Of;
  Vector3 First; // position of its first point, which has the lowest partner, in image axes
  bool operator<(const Copy& other) const
  {
    return std::tie(this->Partners, this->Of.Rank, this->Of.Side) <
      std::tie(other.Partners, other.Of.Rank, other.Of.Side);
  }
};

/// Returns the sides of all ranks.
/// @pre Collective
std::vector<Copy> SortByPartners(const MeshData& mesh, const std::vector<Index>& open, Ranks& ranks)
{
  std::vector<Copy> copies;
  const ImageFrame frame = FrameOfDomain(mesh);
  for (Index side : open)
  {
    const FaceIds points = PointsOfSide(mesh, side);
    copies.push_back({ SortedIds(points, mesh.PeriodicPartner), { ranks.Rank(), side },
      frame.ToOwn(mesh.PointAt(points[0])) });
  }
  copies = GatherItems(ranks, copies);
  std::sort(copies.begin(), copies.end());
  return copies;
}

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

CyclicSides FindCyclicSides(const MeshData& mesh, const std::vector<Index>& open, Ranks& ranks)
{
  CyclicSides found;
  if (!ranks.Any(mesh.PeriodicPartner != nullptr))
  {
    found.Others = open;
    return found;
  }
  const std::vector<double> lengths = NumbersOfField(mesh.Fields, "PeriodLengths");
  if (lengths.size() != 3)
  {
    RejectMissing("PeriodLengths");
  }
  const std::vector<Copy> copies = SortByPartners(mesh, open, ranks);
  std::map<Index3, CyclicPatches, std::greater<Index3>> patches; // by the periods to the second
  for (std::size_t c = 0; c < copies.size(); ++c)
  {
    if (c + 1 == copies.size() || copies[c].Partners != copies[c + 1].Partners)
    {
      if (copies[c].Of.Rank == ranks.Rank())
      {
        found.Others.push_back(copies[c].Of.Side);
      }
      continue;
    }
    std::array<RankSide, 2> pair{ { copies[c].Of, copies[c + 1].Of } };
    Index3 count = CountPeriods(copies[c].First, copies[c + 1].First, lengths);
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
