#include "Modify/LayerPulls.h"

#include "Base/Sorted.h"
#include "Smoothing/EdgePulls.h"

namespace vfm
{
namespace
{

/// Two edges of a column at neighbouring corners of its base, ascending.
using EdgePair = std::array<Index, 2>;

std::vector<EdgePair> ListPairs(const LayerColumns& columns)
{
  std::vector<EdgePair> pairs;
  for (const LayerColumns::Column& column : columns.Columns)
  {
    for (int c = 0; c < 4; ++c)
    {
      const Index first = column.Edges[c], second = column.Edges[(c + 1) % 4];
      pairs.push_back({ { std::min(first, second), std::max(first, second) } });
    }
  }
  SortUnique(pairs);
  return pairs;
}

/// Returns where a layer begins on an edge: from 0, the foot, to 1.
double PlaceOn(const LayerParts& parts, Index edge, int layer, const Mesh& mesh)
{
  const LayerColumns::Edge& ends = parts.Columns.Edges[edge];
  const Vector3 foot = mesh.PointAt(ends.Foot);
  const double length = Norm(mesh.PointAt(ends.Top) - foot);
  return length > 0.0 ? Norm(mesh.PointAt(parts.PointAt(edge, layer)) - foot) / length : 0.0;
}

/// Adds the pulls of the edges between layers that connect two edges of columns.
void AddPulls(const LayerParts& parts, const EdgePair& pair, const EdgeMove& base,
  const EdgeMove& top, Mesh& mesh)
{
  const bool isBaseCurved = Norm(base.Move) > 0.0;
  if (!isBaseCurved && !(Norm(top.Move) > 0.0))
  {
    return;
  }
  const Buffer<Index>& ids = mesh.CommonIds();
  for (int layer = 1; layer < parts.Layers; ++layer)
  {
    const double place =
      0.5 * (PlaceOn(parts, pair[0], layer, mesh) + PlaceOn(parts, pair[1], layer, mesh));
    const EdgeIds edge =
      MakeEdgeIds(ids[parts.PointAt(pair[0], layer)], ids[parts.PointAt(pair[1], layer)]);
    const Vector3 move = (1.0 - place) * base.Move + place * top.Move;
    mesh.Pulls.push_back(
      { edge, edge[0], 2.0 * move, false, isBaseCurved ? base.Group : top.Group });
  }
}

} // namespace

void AddLayerPulls(const LayerParts& parts, Ranks& ranks, Mesh& mesh)
{
  if (!ranks.Any(!mesh.Pulls.empty()))
  {
    return;
  }
  const std::vector<EdgePair> pairs = ListPairs(parts.Columns);
  const Buffer<Index>& ids = mesh.CommonIds();
  std::vector<EdgeIds> questions;
  for (const EdgePair& pair : pairs)
  {
    for (int layer : { 0, parts.Layers })
    {
      questions.push_back(
        MakeEdgeIds(ids[parts.PointAt(pair[0], layer)], ids[parts.PointAt(pair[1], layer)]));
    }
  }
  const std::vector<EdgeMove> moves = CombinePulls(mesh.Pulls, questions, ranks);
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    AddPulls(parts, pairs[p], moves[2 * p], moves[2 * p + 1], mesh);
  }
}

} // namespace vfm
