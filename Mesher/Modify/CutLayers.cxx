#include "Modify/CutLayers.h"

#include "Mesh/MeasureFragments.h"
#include "Mesh/SelectPoints.h"
#include "Modify/LayerFacets.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/NumberInOrder.h"

namespace vfm
{
namespace
{

/// Appends values to a buffer.
template <class T>
void Append(Buffer<T>& buffer, const std::vector<T>& values)
{
  Buffer<T> all(buffer.size() + values.size());
  std::copy(buffer.begin(), buffer.end(), all.begin());
  std::copy(values.begin(), values.end(), all.begin() + buffer.size());
  buffer = std::move(all);
}

/// Collective. Returns new ids for the parts of items: `count` ids per item, above all ids.
/// @param numbers  position of each item among those of all ranks
std::vector<Index> MakeIds(
  const std::vector<std::int64_t>& numbers, Index count, const Buffer<Index>& ids, Ranks& ranks)
{
  const Index mine = ids.empty() ? 0 : *std::max_element(ids.begin(), ids.end());
  const auto greatest = static_cast<Index>(ranks.Max(static_cast<double>(mine)));
  std::vector<Index> added;
  for (std::int64_t number : numbers)
  {
    for (Index part = 1; part <= count; ++part)
    {
      added.push_back(greatest + count * number + part);
    }
  }
  return added;
}

/// Collective. Returns the partners of new points: the lowest id of the same part of all copies of
/// an edge.
std::vector<Index> FindPartners(const Mesh& mesh, const LayerColumns& columns,
  const std::vector<Index>& ids, Index count, Ranks& ranks)
{
  std::vector<std::array<Index, 3>> keys;
  for (const std::array<Index, 2>& edge : columns.KeysOfEdges(mesh.PeriodicPartner))
  {
    for (Index part = 0; part < count; ++part)
    {
      keys.push_back({ { edge[0], edge[1], part } });
    }
  }
  return MergeByKey(
    keys, ids, [](Index a, Index b) { return std::min(a, b); }, ranks);
}

/// Collective. Adds the points inside edges.
void AddPoints(
  const LayerColumns& columns, const LayerSpacing& spacing, Runtime& runtime, Mesh& mesh)
{
  Ranks& ranks = runtime.Group();
  const int inner = spacing.Layers - 1;
  const std::vector<EdgeGeometry> geometry = FindEdgeGeometry(mesh, columns, ranks);
  const std::vector<std::vector<double>> ends = FindLayerHeights(mesh, columns, spacing, runtime);
  const std::vector<Index> ids =
    MakeIds(NumberInOrder(columns.KeysOfEdges(mesh.PointIds), ranks), inner, mesh.PointIds, ranks);
  std::vector<double> points;
  std::vector<int> dimensions, numbers;
  for (std::size_t e = 0; e < columns.Edges.size(); ++e)
  {
    const Vector3 foot = mesh.PointAt(columns.Edges[e].Foot);
    const Vector3 along = mesh.PointAt(columns.Edges[e].Top) - foot;
    for (int part = 1; part <= inner; ++part)
    {
      const Vector3 x = foot + ends[e][part] * along;
      points.insert(points.end(), x.begin(), x.end());
      dimensions.push_back(geometry[e].Dimension);
      numbers.push_back(geometry[e].Id);
    }
  }
  if (ranks.Any(!mesh.PeriodicPartner.empty()))
  {
    Append(mesh.PeriodicPartner, FindPartners(mesh, columns, ids, inner, ranks));
  }
  Append(mesh.Points, points);
  Append(mesh.PointIds, ids);
  Append(mesh.GeometryDimension, dimensions);
  Append(mesh.GeometryId, numbers);
}

/// Returns for each element of the cut mesh the element that it was part of.
std::vector<Index> ListParents(const LayerParts& parts)
{
  std::vector<Index> parents(parts.OldElements);
  std::iota(parents.begin(), parents.end(), 0);
  for (const LayerColumns::Column& column : parts.Columns.Columns)
  {
    parents.insert(parents.end(), parts.Layers - 1, column.Element);
  }
  return parents;
}

/// Collective. Adds the layers above the first one, which replaces the column.
void AddElements(
  const LayerParts& parts, const std::vector<Index>& parents, Ranks& ranks, Mesh& mesh)
{
  const std::vector<LayerColumns::Column>& columns = parts.Columns.Columns;
  std::vector<Index> ids;
  for (const LayerColumns::Column& column : columns)
  {
    ids.push_back(mesh.ElementIds[column.Element]);
  }
  ids = MakeIds(NumberInOrder(ids, ranks), parts.Layers - 1, mesh.ElementIds, ranks);
  Append(mesh.ElementIds, ids);
  mesh.Elements = Select(mesh.Elements, parents, mesh.Corners);
  mesh.Material = Select(mesh.Material, parents);
  mesh.Fragment = Select(mesh.Fragment, parents);
  Buffer<int> layers =
    mesh.Layer.empty() ? Buffer<int>(parents.size(), 0) : Select(mesh.Layer, parents);
  for (std::size_t c = 0; c < columns.size(); ++c)
  {
    for (int layer = 0; layer < parts.Layers; ++layer)
    {
      const Index element = parts.ElementAt(static_cast<Index>(c), layer);
      const std::array<Index, 8> points = parts.PointsOf(static_cast<Index>(c), layer);
      std::copy(points.begin(), points.end(), mesh.Elements.data() + mesh.Corners * element);
      const int before = layers[element];
      layers[element] = before == 0 ? layer + 1 : std::min(before, layer + 1);
    }
  }
  mesh.Layer = std::move(layers);
  mesh.WholeCells = 0;
  mesh.RowOffset.clear();
}

/// Returns the volume of each element relative to the column that it was part of.
std::vector<double> FindShares(const Mesh& mesh, const std::vector<Index>& parents)
{
  std::vector<double> shares, sums(parents.size(), 0.0);
  for (std::size_t e = 0; e < parents.size(); ++e)
  {
    shares.push_back(VolumeOfElement(mesh, static_cast<Index>(e)));
    sums[parents[e]] += shares.back();
  }
  for (std::size_t e = 0; e < parents.size(); ++e)
  {
    shares[e] = shares[e] < sums[parents[e]] ? shares[e] / sums[parents[e]] : 1.0;
  }
  return shares;
}

/// Gives the parts of an element its values.
/// @param elements number of elements before
void DivideArray(Index elements, const std::vector<Index>& parents,
  const std::vector<double>& shares, TransferredArray& array)
{
  if (elements == 0)
  {
    return;
  }
  array.Values = Select(array.Values, parents, static_cast<Index>(array.Values.size()) / elements);
  if (array.IsExtensive)
  {
    auto* values = reinterpret_cast<double*>(array.Values.data());
    for (std::size_t i = 0; i < array.Values.size() / sizeof(double); ++i)
    {
      values[i] *= shares[i / array.Components];
    }
  }
}

} // namespace

void CutLayers(const LayerColumns& columns, const LayerSpacing& spacing, Runtime& runtime,
  Mesh& mesh, OutputState& state)
{
  const LayerParts parts(columns, spacing.Layers, mesh);
  AddPoints(columns, spacing, runtime, mesh);
  CheckNumberOfPoints(static_cast<Index>(mesh.PointIds.size()), runtime.Group());
  const std::vector<Index> parents = ListParents(parts);
  AddElements(parts, parents, runtime.Group(), mesh);
  CutFacets(parts, runtime.Group(), mesh);
  const std::vector<double> shares = FindShares(mesh, parents);
  for (TransferredArray& array : state.Arrays)
  {
    DivideArray(parts.OldElements, parents, shares, array);
  }
}

} // namespace vfm
