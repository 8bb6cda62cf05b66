#include "Report/Sets/MeshSets.h"

#include "Base/Sorted.h"
#include "Ranks/Agreement.h"
#include "Ranks/KeyMerge.h"
#include "Report/MeshFacets.h"
#include "Report/MeshMaterials.h"
#include "Report/Sets/SidePoints.h"
#include "Report/UniqueNames.h"

#include <limits>
#include <map>
#include <set>

namespace vfm
{
namespace
{

constexpr int FirstFreeId = 7; // ids 1 to 6 are the sides of the domain
constexpr const char* SideNames[6] = { "x_min", "x_max", "y_min", "y_max", "z_min", "z_max" };

using Facets = std::vector<MeshFacet>;
using Pair = std::array<int, 2>;     // adjacent materials; faces belong to the first
using PairSide = std::array<int, 3>; // a pair and a surface between its materials

/// Returns the ids of pairs of materials; voidId: number of the void as first material.
std::vector<int> NumberPairs(const std::vector<Pair>& pairs, int voidId)
{
  const auto first = [voidId](const Pair& pair) { return pair[0] == 0 ? voidId : pair[0]; };
  Index factor = 1000, largest = 0;
  for (const Pair& pair : pairs)
  {
    largest = std::max<Index>(largest, first(pair));
    while (factor <= std::max(first(pair), pair[1]))
    {
      factor *= 10;
    }
  }
  std::vector<int> ids;
  const bool fits = largest < std::numeric_limits<int>::max() / factor;
  for (const Pair& pair : pairs)
  {
    ids.push_back(fits ? static_cast<int>(first(pair) * factor) + pair[1]
                       : FirstFreeId + static_cast<int>(ids.size()));
  }
  return ids;
}

/// Returns the ids of smooth sides; pairIds: ids of their pairs; greatest: largest id of all pairs.
std::vector<int> NumberSides(
  const std::vector<PairSide>& sides, const std::vector<int>& pairIds, int greatest)
{
  Index factor = 1000;
  for (const PairSide& side : sides)
  {
    while (factor <= side[2])
    {
      factor *= 10;
    }
  }
  const bool fits = greatest < std::numeric_limits<int>::max() / factor;
  std::vector<int> ids;
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    ids.push_back(fits ? static_cast<int>(pairIds[s] * factor) + sides[s][2]
                       : greatest + 1 + static_cast<int>(s));
  }
  return ids;
}

/// Collective. Returns the keys of a map on all ranks.
template <class Map>
auto UnionOfKeys(Ranks& ranks, const Map& map)
{
  std::vector<std::decay_t<decltype(map.begin()->first)>> list;
  for (const auto& entry : map)
  {
    list.push_back(entry.first);
  }
  return UnionOverRanks(ranks, std::move(list));
}

/// Returns the name of the patch (field PatchNames) to which a surface belongs, or "".
std::string PatchOf(const MeshData& mesh, int surface)
{
  const FieldArray* field = FindField(mesh.Fields, "PatchNames");
  const auto* names = field ? std::get_if<std::vector<std::string>>(&field->Values) : nullptr;
  const std::size_t number = static_cast<std::size_t>(surface);
  return names && number <= names->size() ? (*names)[number - 1] : "";
}

/// Surfaces and faces of one side set.
struct SideGroup
{
  std::vector<int> Surfaces;
  std::vector<ElementSide> Sides;
};

/// Collective. Joins the surfaces of each patch between two materials; keys are their lowest ones.
std::map<PairSide, SideGroup> JoinPatches(
  const MeshData& mesh, std::map<PairSide, std::vector<ElementSide>> ofSides, Ranks& ranks)
{
  std::map<std::pair<Pair, std::string>, int> firsts;
  std::map<PairSide, SideGroup> groups;
  for (const PairSide& side : UnionOfKeys(ranks, ofSides))
  {
    const Pair pair{ { std::min(side[0], side[1]), std::max(side[0], side[1]) } };
    const std::string patch = PatchOf(mesh, side[2]);
    const int first =
      patch.empty() ? side[2] : firsts.emplace(std::pair(pair, patch), side[2]).first->second;
    SideGroup& group = groups[{ { side[0], side[1], first } }];
    group.Surfaces.push_back(side[2]);
    const std::vector<ElementSide>& sides = ofSides[side];
    group.Sides.insert(group.Sides.end(), sides.begin(), sides.end());
  }
  for (auto& [side, group] : groups)
  {
    std::sort(group.Sides.begin(), group.Sides.end());
  }
  return groups;
}

/// Returns the name of a smooth side.
/// @param ofPair  name of its pair of materials
std::string NameOfSide(const MeshData& mesh, const PairSide& side, const std::string& ofPair)
{
  const std::string patch = PatchOf(mesh, side[2]);
  return patch.empty() ? ofPair + "_" + std::to_string(side[2])
    : side[1] == 0     ? patch
                       : patch + "_" + ofPair;
}

/// Collective. Makes the side sets of sides of the domain, pairs and smooth sides.
std::vector<SideSet> MakeSideSets(const MeshData& mesh, const Facets& facets, Ranks& ranks)
{
  std::map<int, std::vector<ElementSide>> ofDomain;
  std::map<Pair, std::vector<ElementSide>> ofPairs;
  std::map<PairSide, std::vector<ElementSide>> ofSides;
  for (const MeshFacet& facet : facets)
  {
    if (facet.DomainSide != NoSide)
    {
      ofDomain[facet.DomainSide].push_back(facet);
      continue;
    }
    const Pair pair{ { mesh.Material[facet.Element], std::max(facet.Behind, 0) } };
    ofPairs[pair].push_back(facet);
    if (facet.Surface > 0)
    {
      ofSides[{ { pair[0], pair[1], facet.Surface } }].push_back(facet);
    }
  }
  std::vector<SideSet> sets;
  for (int side : UnionOfKeys(ranks, ofDomain))
  {
    sets.push_back({ SurfaceKind::DomainSide, side + 1, SideNames[side], side, { { 0, 0 } }, {},
      std::move(ofDomain[side]) });
  }
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  const auto nameOf = [&names](int first, int second)
  { return NameOfMaterial(names, first) + "_to_" + NameOfMaterial(names, second); };
  const std::vector<Pair> pairs = UnionOfKeys(ranks, ofPairs);
  const bool hasVoid = !pairs.empty() && pairs.front()[0] == 0;
  const std::vector<int> ids = NumberPairs(pairs, hasVoid ? FindVoidId(mesh, ranks) : 0);
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    sets.push_back({ SurfaceKind::Interface, ids[p], nameOf(pairs[p][0], pairs[p][1]), NoSide,
      pairs[p], {}, std::move(ofPairs[pairs[p]]) });
  }
  std::map<PairSide, SideGroup> groups = JoinPatches(mesh, std::move(ofSides), ranks);
  std::vector<PairSide> sides;
  std::vector<int> pairIds;
  for (const auto& [side, group] : groups)
  {
    sides.push_back(side);
    const Pair pair{ { side[0], side[1] } };
    pairIds.push_back(ids[std::lower_bound(pairs.begin(), pairs.end(), pair) - pairs.begin()]);
  }
  const int greatest = ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
  const std::vector<int> sideIds = NumberSides(sides, pairIds, greatest);
  for (std::size_t s = 0; s < sides.size(); ++s)
  {
    SideGroup& group = groups[sides[s]];
    sets.push_back({ SurfaceKind::SmoothSide, sideIds[s],
      NameOfSide(mesh, sides[s], nameOf(sides[s][0], sides[s][1])), NoSide,
      { { sides[s][0], sides[s][1] } }, std::move(group.Surfaces), std::move(group.Sides) });
  }
  return sets;
}

/// Collective. Makes "interfaces" and the skins, without ids.
std::vector<SideSet> MakeUnions(const MeshData& mesh, const Facets& facets, Ranks& ranks)
{
  SideSet all{ SurfaceKind::AllInterfaces, 0, "interfaces", NoSide, { { 0, 0 } }, {}, {} };
  std::map<int, std::vector<ElementSide>> skins;
  for (const MeshFacet& facet : facets)
  {
    const int material = mesh.Material[facet.Element];
    skins[material].push_back(facet);
    if (facet.Behind != NothingBehind && OwnsFace(material, facet.Behind))
    {
      all.Sides.push_back(facet);
    }
  }
  std::vector<SideSet> sets;
  if (ranks.Any(!all.Sides.empty()))
  {
    sets.push_back(std::move(all));
  }
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  for (int material : UnionOfKeys(ranks, skins))
  {
    sets.push_back({ SurfaceKind::Skin, 0, NameOfMaterial(names, material) + "_skin", NoSide,
      { { material, material } }, {}, std::move(skins[material]) });
  }
  return sets;
}

/// Appends sets without ids, with the lowest free ones.
void AppendNumbered(std::vector<SideSet>& sets, std::vector<SideSet> added)
{
  std::set<int> used;
  for (const SideSet& set : sets)
  {
    used.insert(set.Id);
  }
  int next = FirstFreeId;
  for (SideSet& set : added)
  {
    while (!used.insert(next).second)
    {
      ++next;
    }
    set.Id = next;
    sets.push_back(std::move(set));
  }
}

void SeparateNames(std::vector<SideSet>& sets)
{
  UniqueNames used;
  for (SideSet& set : sets)
  {
    set.Name = used.Add(set.Name);
  }
}

using SurfacePoint = std::array<Index, 2>; // surface and global id of a point

/// Returns the points of this rank on the edges of its smooth sides (not inside a surface).
std::vector<SurfacePoint> FindOwnRims(const MeshData& mesh, const Facets& facets)
{
  const Index* ids = mesh.UnsplitPointIds();
  std::vector<SurfacePoint> rims;
  for (const MeshFacet& facet : facets)
  {
    if (facet.Surface == 0)
    {
      continue;
    }
    const auto add = [&](Index point)
    {
      if (point >= 0 && mesh.GeometryDimension[point] != DimensionOfSurfaces)
      {
        rims.push_back({ { facet.Surface, ids[point] } });
      }
    };
    const FaceIds corners = PointsOfSide(mesh, facet);
    std::for_each(corners.begin(), corners.end(), add);
    const std::vector<Index> mids = MidsOfFace(mesh, facet.Element, facet.Side);
    std::for_each(mids.begin(), mids.end(), add);
  }
  SortUnique(rims);
  return rims;
}

/// Returns the ids of the points of this rank that may be on edges of smooth sides, ascending.
/// @param own  those that are on edges of smooth sides of this rank
std::vector<Index> ListRimPoints(const MeshData& mesh, const std::vector<SurfacePoint>& own)
{
  std::vector<Index> ids;
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    if (mesh.GeometryDimension[point] < DimensionOfSurfaces)
    {
      ids.push_back(mesh.UnsplitPointIds()[point]);
    }
  }
  for (const auto& [surface, id] : own)
  {
    ids.push_back(id);
  }
  SortUnique(ids);
  return ids;
}

/// Collective. Returns the points of this rank on the edges of smooth sides of any rank, ascending.
/// Each round finds the next higher surface at each point.
std::vector<SurfacePoint> FindRims(const MeshData& mesh, const Facets& facets, Ranks& ranks)
{
  const std::vector<SurfacePoint> own = FindOwnRims(mesh, facets);
  std::vector<SurfacePoint> rims;
  bool hasMore = ranks.Any(!own.empty());
  if (!hasMore)
  {
    return rims;
  }
  constexpr Index none = std::numeric_limits<Index>::max();
  const std::vector<Index> ids = ListRimPoints(mesh, own);
  const KeyMerge<Index> ways(ids, ranks);
  std::vector<Index> last(ids.size(), 0);
  while (hasMore)
  {
    std::vector<Index> next(ids.size(), none);
    for (const auto& [surface, id] : own)
    {
      const Index at = FindSorted(ids, id);
      next[at] = surface > last[at] ? std::min(next[at], surface) : next[at];
    }
    ways.Merge(next, 1, [](Index& a, Index b) { a = std::min(a, b); });
    for (std::size_t p = 0; p < ids.size(); ++p)
    {
      if (next[p] < none)
      {
        rims.push_back({ { next[p], ids[p] } });
        last[p] = next[p];
      }
    }
    hasMore = ranks.Any(
      std::any_of(next.begin(), next.end(), [](Index surface) { return surface < none; }));
  }
  std::sort(rims.begin(), rims.end());
  return rims;
}

/// Returns the points on some surfaces.
std::vector<Index> FindSurfacePoints(
  const MeshData& mesh, const std::vector<int>& surfaces, const std::vector<SurfacePoint>& rims)
{
  const Index* ids = mesh.UnsplitPointIds();
  std::vector<Index> points;
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    const auto isOn = [&](int surface)
    {
      return mesh.GeometryDimension[point] == DimensionOfSurfaces
        ? mesh.GeometryId[point] == surface
        : std::binary_search(rims.begin(), rims.end(), SurfacePoint{ { surface, ids[point] } });
    };
    if (std::any_of(surfaces.begin(), surfaces.end(), isOn))
    {
      points.push_back(point);
    }
  }
  return points;
}

/// Collective. Makes the node sets of sides of the domain and smooth sides.
std::vector<NodeSet> MakeNodeSets(
  const MeshData& mesh, const Facets& facets, const std::vector<SideSet>& sideSets, Ranks& ranks)
{
  std::vector<NodeSet> sets;
  const auto add = [&](int id, const std::string& name, std::vector<Index> points)
  {
    if (ranks.Any(!points.empty()))
    {
      sets.push_back({ id, name, std::move(points) });
    }
  };
  std::array<std::vector<Index>, 6> sidePoints = FindSidePoints(mesh, facets);
  for (int side = 0; side < 6; ++side)
  {
    add(side + 1, SideNames[side], std::move(sidePoints[side]));
  }
  const std::vector<SurfacePoint> rims = FindRims(mesh, facets, ranks);
  for (const SideSet& sides : sideSets)
  {
    if (!sides.Surfaces.empty())
    {
      add(sides.Id, sides.Name, FindSurfacePoints(mesh, sides.Surfaces, rims));
    }
  }
  return sets;
}

} // namespace

MeshSets FindMeshSets(const MeshData& mesh, Ranks& ranks)
{
  const Facets facets = FindMeshFacets(mesh, ranks);
  std::vector<SideSet> sides = MakeSideSets(mesh, facets, ranks);
  AppendNumbered(sides, MakeUnions(mesh, facets, ranks));
  SeparateNames(sides);
  std::vector<NodeSet> nodes = MakeNodeSets(mesh, facets, sides, ranks);
  return { std::move(sides), std::move(nodes) };
}

} // namespace vfm
