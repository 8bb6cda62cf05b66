#include "Report/Sets/SplitFaces.h"

#include "Ranks/Agreement.h"
#include "Ranks/NumberKeys.h"
#include "Report/MatchFaces.h"
#include "Report/MeshFacets.h"
#include "Report/MeshMaterials.h"
#include "Report/Sets/MaterialBins.h"

#include <map>
#include <numeric>

namespace vfm
{
namespace
{

using Pair = std::array<int, 2>;

/// Returns the points of a face.
FaceNodes NodesOf(const MeshData& mesh, const ElementSide& side)
{
  FaceNodes nodes;
  nodes.fill(-1);
  const FaceIds corners = PointsOfSide(mesh, side);
  const std::vector<Index> mids = MidsOfFace(mesh, side.Element, side.Side);
  std::copy(mids.begin(), mids.end(), std::copy(corners.begin(), corners.end(), nodes.begin()));
  return nodes;
}

/// Returns the places of the points of a face in ascending order of their ids before the split;
/// those without a point first.
std::array<int, 9> OrderOf(const FaceNodes& points, const Index* ids)
{
  const auto idOf = [&](int place) { return points[place] < 0 ? -1 : ids[points[place]]; };
  std::array<int, 9> order;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return idOf(a) < idOf(b); });
  return order;
}

/// The faces between elements of this rank and elements behind, with their points.
struct InnerFaces
{
  std::vector<MeshFacet> Facets;
  std::vector<FaceNodes> Points;
  std::vector<FaceIds> Keys; ///< sorted ids of corners before the split
  std::vector<std::array<int, 9>> Orders;
};

InnerFaces ListInnerFaces(const MeshData& mesh, const std::vector<MeshFacet>& facets)
{
  InnerFaces faces;
  for (const MeshFacet& facet : facets)
  {
    if (facet.Behind != NothingBehind && facet.DomainSide == NoSide)
    {
      const FaceNodes points = NodesOf(mesh, facet);
      faces.Facets.push_back(facet);
      faces.Points.push_back(points);
      faces.Keys.push_back(SortedIds(PointsOfSide(mesh, facet), mesh.UnsplitPointIds()));
      faces.Orders.push_back(OrderOf(points, mesh.UnsplitPointIds()));
    }
  }
  return faces;
}

/// Returns the values of the points of each face.
std::vector<FaceNodes> ValuesOf(const InnerFaces& faces, const Index* values)
{
  std::vector<FaceNodes> found = faces.Points;
  for (FaceNodes& face : found)
  {
    for (Index& point : face)
    {
      point = point < 0 ? point : values[point];
    }
  }
  return found;
}

/// Returns the values of the points of the element behind each face, in the order of the face.
/// @pre Collective
std::vector<FaceNodes> FindValuesBehind(
  const InnerFaces& faces, const std::vector<FaceNodes>& values, Ranks& ranks)
{
  constexpr std::size_t width = std::tuple_size<FaceNodes>::value;
  std::vector<Index> own; // a point without a value keeps it
  for (std::size_t f = 0; f < values.size(); ++f)
  {
    for (int place : faces.Orders[f])
    {
      own.push_back(std::max<Index>(values[f][place], 0));
    }
  }
  const std::vector<Index> behind = MatchFaces(faces.Keys, own, ranks, width);
  std::vector<FaceNodes> found = values;
  for (std::size_t f = 0; f < values.size(); ++f)
  {
    for (std::size_t c = 0; c < width; ++c)
    {
      Index& value = found[f][faces.Orders[f][c]];
      value = value < 0 ? value : behind[width * f + c];
    }
  }
  return found;
}

/// Returns the blocks of all ranks, without elements.
std::vector<CohesiveBlock> ListBlocks(
  const MeshData& mesh, const std::vector<SplitFace>& faces, Ranks& ranks)
{
  std::vector<Pair> pairs;
  for (const SplitFace& face : faces)
  {
    pairs.push_back(face.Materials);
  }
  const std::map<int, std::string> names = NamesOfMaterials(mesh);
  int id = std::max(FindVoidId(mesh, ranks), FindLastBinId(mesh));
  std::vector<CohesiveBlock> blocks;
  for (const Pair& pair : UnionOverRanks(ranks, std::move(pairs)))
  {
    const std::string name =
      NameOfMaterial(names, pair[0]) + "_to_" + NameOfMaterial(names, pair[1]) + "_cohesive";
    blocks.push_back({ ++id, name, pair, {}, {}, {} });
  }
  return blocks;
}

/// Numbers the elements of all blocks after the elements of the mesh.
void NumberElements(const MeshData& mesh, Ranks& ranks, std::vector<CohesiveBlock>& blocks)
{
  std::vector<std::array<Index, 3>> keys;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    for (const ElementSide& side : blocks[b].Sides)
    {
      keys.push_back({ { static_cast<Index>(b), mesh.ElementIds[side.Element], side.Side } });
    }
  }
  const Index* ids = mesh.ElementIds;
  const Index largest =
    mesh.NumberOfElements > 0 ? *std::max_element(ids, ids + mesh.NumberOfElements) : 0;
  const Index greatest = MaximumOverRanks(largest, ranks);
  const ValueInGroup value(greatest);
  const KeyNumbers numbers = NumberItems(
    keys, [&value](const std::array<Index, 3>& key) { return value(key[0], key[1]); }, ranks);
  for (std::size_t k = 0; k < keys.size(); ++k)
  {
    blocks[keys[k][0]].Ids.push_back(greatest + 1 + numbers.Numbers[k]);
  }
}

/// Finds points by their global ids.
class PointFinder
{
public:
  explicit PointFinder(const MeshData& mesh)
  {
    for (Index point = 0; point < mesh.NumberOfPoints; ++point)
    {
      this->Places.push_back({ { mesh.PointIds[point], point } });
    }
    std::sort(this->Places.begin(), this->Places.end());
  }

  Index Find(Index id) const
  {
    const auto found = std::lower_bound(
      this->Places.begin(), this->Places.end(), std::array<Index, 2>{ { id, -1 } });
    if (found == this->Places.end() || (*found)[0] != id)
    {
      throw InputError("The node " + std::to_string(id) +
        " of a cohesive element is not in the part of the mesh with its first side.");
    }
    return (*found)[1];
  }

private:
  std::vector<std::array<Index, 2>> Places; // id and point, ascending
};

void FillBlocks(
  const MeshData& mesh, const std::vector<SplitFace>& faces, std::vector<CohesiveBlock>& blocks)
{
  const PointFinder finder(mesh);
  for (const SplitFace& face : faces)
  {
    CohesiveBlock& block = *std::find_if(blocks.begin(), blocks.end(),
      [&face](const CohesiveBlock& one) { return one.Materials == face.Materials; });
    block.Sides.push_back(face.First);
    for (const FaceNodes& side : face.Points)
    {
      for (Index id : side)
      {
        if (id >= 0)
        {
          block.Points.push_back(finder.Find(id));
        }
      }
    }
  }
}

} // namespace

ConnectionKind ConnectionOf(const MeshData& mesh)
{
  const std::vector<double> values = NumbersOfField(mesh.Fields, SplitConnectionField);
  const double largest = static_cast<double>(ConnectionKind::Tied);
  const bool isKnown = values.size() == 1 && values[0] >= 0.0 && values[0] <= largest;
  return isKnown ? static_cast<ConnectionKind>(values[0]) : ConnectionKind::None;
}

std::vector<SplitFace> FindSplitFaces(const MeshData& mesh, Ranks& ranks)
{
  if (!ranks.Any(mesh.OriginalPointIds != nullptr))
  {
    return {};
  }
  const InnerFaces inner = ListInnerFaces(mesh, FindMeshFacets(mesh, ranks));
  const std::vector<FaceNodes> first = ValuesOf(inner, mesh.PointIds);
  const std::vector<FaceNodes> second = FindValuesBehind(inner, first, ranks);
  const bool isPeriodic = ranks.Any(mesh.PeriodicPartner != nullptr);
  const std::vector<FaceNodes> partners =
    isPeriodic ? FindValuesBehind(inner, ValuesOf(inner, mesh.PeriodicPartner), ranks) : second;
  std::vector<SplitFace> split;
  for (std::size_t f = 0; f < inner.Facets.size(); ++f)
  {
    const MeshFacet& facet = inner.Facets[f];
    const int material = mesh.Material[facet.Element];
    if (OwnsFace(material, facet.Behind) && first[f] != second[f])
    {
      split.push_back(
        { facet, { { material, facet.Behind } }, { { first[f], second[f] } }, partners[f] });
    }
  }
  return split;
}

std::vector<CohesiveBlock> FindCohesiveBlocks(const MeshData& mesh, Ranks& ranks)
{
  if (!ranks.Any(ConnectionOf(mesh) == ConnectionKind::Cohesive))
  {
    return {};
  }
  const std::vector<SplitFace> faces = FindSplitFaces(mesh, ranks);
  std::vector<CohesiveBlock> blocks = ListBlocks(mesh, faces, ranks);
  WorkTogether(ranks,
    [&]
    {
      Require(mesh.ElementIds, "GlobalCellIds", mesh);
      FillBlocks(mesh, faces, blocks);
    });
  NumberElements(mesh, ranks, blocks);
  return blocks;
}

CohesiveElements JoinBlocks(const std::vector<CohesiveBlock>& blocks)
{
  CohesiveElements all;
  for (const CohesiveBlock& block : blocks)
  {
    all.Points.insert(all.Points.end(), block.Points.begin(), block.Points.end());
    all.Ids.insert(all.Ids.end(), block.Ids.begin(), block.Ids.end());
    for (std::size_t e = 0; e < block.Ids.size(); ++e)
    {
      all.Materials.insert(all.Materials.end(), block.Materials.begin(), block.Materials.end());
    }
  }
  return all;
}

} // namespace vfm
