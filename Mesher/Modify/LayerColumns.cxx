#include "Modify/LayerColumns.h"

#include "Base/DisjointSets.h"
#include "Base/HexNumbering.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/WorkTogether.h"

namespace vfm
{
namespace
{

using Key = std::array<Index, 2>;

void CheckBases(const Mesh& mesh, const std::vector<ColumnBase>& bases)
{
  const auto pair = std::adjacent_find(bases.begin(), bases.end(),
    [](const ColumnBase& a, const ColumnBase& b) { return a.Element == b.Element; });
  if (pair != bases.end())
  {
    throw InputError("The hexahedron " + std::to_string(mesh.ElementIds[pair->Element]) +
      " has two faces on the surface: it cannot be cut into layers.");
  }
}

/// Returns the columns on facets and all their edges.
LayerColumns MakeColumns(const Mesh& mesh, const std::vector<ColumnBase>& bases)
{
  struct Place
  {
    Key Ids;
    LayerColumns::Edge Edge;
  };
  std::vector<Place> places;
  for (const ColumnBase& base : bases)
  {
    const Index* points = mesh.Elements.data() + mesh.Corners * base.Element;
    for (int corner : FaceCorners[base.Side])
    {
      const Index foot = points[VtkCorner[corner]];
      const Index top = points[VtkCorner[OppositeCorner(corner, base.Side)]];
      places.push_back({ { { mesh.PointIds[foot], mesh.PointIds[top] } }, { foot, top } });
    }
  }
  std::vector<Index> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&places](Index a, Index b) { return places[a].Ids < places[b].Ids; });
  LayerColumns found;
  for (const ColumnBase& base : bases)
  {
    found.Columns.push_back({ base.Element, base.Side, {} });
  }
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Place& place = places[order[i]];
    if (i == 0 || places[order[i - 1]].Ids != place.Ids)
    {
      found.Edges.push_back(place.Edge);
    }
    found.Columns[order[i] / 4].Edges[order[i] % 4] = static_cast<Index>(found.Edges.size()) - 1;
  }
  return found;
}

/// Collective. Extends marks of edges to all edges that are connected by columns.
void SpreadMarks(
  const LayerColumns& all, const std::vector<Key>& keys, Ranks& ranks, std::vector<char>& isMarked)
{
  std::vector<Index> sets = MakeSets(all.Edges.size());
  for (const LayerColumns::Column& column : all.Columns)
  {
    for (Index edge : column.Edges)
    {
      Join(sets, column.Edges[0], edge);
    }
  }
  for (bool changes = true; changes;)
  {
    const std::vector<char> before = isMarked;
    for (std::size_t e = 0; e < isMarked.size(); ++e)
    {
      isMarked[FindRoot(sets, static_cast<Index>(e))] |= isMarked[e];
    }
    for (std::size_t e = 0; e < isMarked.size(); ++e)
    {
      isMarked[e] = isMarked[FindRoot(sets, static_cast<Index>(e))];
    }
    isMarked = MergeByKey(
      keys, isMarked, [](char a, char b) { return std::max(a, b); }, ranks);
    changes = ranks.Any(isMarked != before);
  }
}

/// Returns the columns and edges that are marked.
LayerColumns SelectMarked(const LayerColumns& all, const std::vector<char>& isMarked)
{
  LayerColumns chosen;
  std::vector<Index> places(all.Edges.size(), -1);
  for (std::size_t e = 0; e < all.Edges.size(); ++e)
  {
    if (isMarked[e] != 0)
    {
      places[e] = static_cast<Index>(chosen.Edges.size());
      chosen.Edges.push_back(all.Edges[e]);
    }
  }
  for (LayerColumns::Column column : all.Columns)
  {
    if (isMarked[column.Edges[0]] != 0)
    {
      for (Index& edge : column.Edges)
      {
        edge = places[edge];
      }
      chosen.Columns.push_back(column);
    }
  }
  return chosen;
}

std::vector<Key> ListKeys(const std::vector<LayerColumns::Edge>& edges, const Buffer<Index>& ids)
{
  std::vector<Key> keys;
  for (const LayerColumns::Edge& edge : edges)
  {
    keys.push_back({ { ids[edge.Foot], ids[edge.Top] } });
  }
  return keys;
}

} // namespace

std::vector<std::array<Index, 2>> LayerColumns::IdsOfEdges(const Mesh& mesh) const
{
  return ListKeys(this->Edges, mesh.PointIds);
}

std::vector<std::array<Index, 2>> LayerColumns::KeysOfEdges(const Mesh& mesh) const
{
  return ListKeys(this->Edges, mesh.PeriodicPartner.empty() ? mesh.PointIds : mesh.PeriodicPartner);
}

LayerColumns FindLayerColumns(const Mesh& mesh, const std::vector<ColumnBase>& bases, Ranks& ranks)
{
  WorkTogether(ranks, [&] { CheckBases(mesh, bases); });
  const LayerColumns all = MakeColumns(mesh, bases);
  std::vector<char> isMarked(all.Edges.size(), 0);
  for (std::size_t c = 0; c < bases.size(); ++c)
  {
    for (Index edge : all.Columns[c].Edges)
    {
      isMarked[edge] |= bases[c].IsChosen ? 1 : 0;
    }
  }
  SpreadMarks(all, all.KeysOfEdges(mesh), ranks, isMarked);
  return SelectMarked(all, isMarked);
}

} // namespace vfm
