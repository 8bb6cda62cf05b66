#include "Modify/CutLayers.h"

#include "Elements/MeasureFragments.h"
#include "Elements/SelectPoints.h"
#include "Modify/GreatestId.h"
#include "Modify/LayerFacets.h"
#include "Modify/LayerPulls.h"
#include "Ranks/MergeByKey.h"
#include "Ranks/NumberKeys.h"

#include <cmath>

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

/// Returns new ids for the parts of items: `count` ids per item.
/// @param items  of this rank; new ids are in the order of the items of all ranks
/// @param greatest  greatest id of all ranks
/// @pre Collective
template <class Item>
std::vector<Index> MakeIds(
  const std::vector<Item>& items, Index count, Index greatest, Ranks& ranks)
{
  std::vector<Index> added;
  for (std::int64_t number : NumberItems(items, FirstOfKey(), ranks).Numbers)
  {
    for (Index part = 1; part <= count; ++part)
    {
      added.push_back(greatest + count * number + part);
    }
  }
  return added;
}

/// A new point inside an edge.
struct NewPoint
{
  Index Id;
  Vector3 Position;
};

/// Collective. Returns for each new point the copy with the lowest id: the same part of a copy of
/// its edge.
/// @param count new points per edge
std::vector<NewPoint> FindPartners(const Mesh& mesh, const LayerColumns& columns,
  const std::vector<NewPoint>& points, Index count, Ranks& ranks)
{
  std::vector<std::array<Index, 3>> keys;
  for (const std::array<Index, 2>& edge : columns.KeysOfEdges(mesh))
  {
    for (Index part = 0; part < count; ++part)
    {
      keys.push_back({ { edge[0], edge[1], part } });
    }
  }
  return MergeByKey(
    keys, points, [](const NewPoint& a, const NewPoint& b) { return a.Id < b.Id ? a : b; }, ranks);
}

/// Moves a point to exactly whole periods from its partner.
Vector3 MoveToCopy(const Vector3& x, const Vector3& partner, const Vector3& periods)
{
  Vector3 moved = partner;
  for (int a = 0; a < 3; ++a)
  {
    moved[a] += periods[a] > 0.0 ? periods[a] * std::round((x[a] - partner[a]) / periods[a]) : 0.0;
  }
  return moved;
}

/// Collective. Returns the points inside edges.
std::vector<NewPoint> MakePoints(
  const LayerColumns& columns, const LayerSpacing& spacing, Runtime& runtime, const Mesh& mesh)
{
  const Index inner = spacing.Layers - 1;
  const std::vector<std::vector<double>> ends = FindLayerHeights(mesh, columns, spacing, runtime);
  // Where sides will be joined, partners may be points that are not in the mesh.
  const Index greatest = std::max(FindGreatestId(mesh.PointIds, runtime.Group()),
    FindGreatestId(mesh.PeriodicPartner, runtime.Group()));
  const std::vector<Index> ids =
    MakeIds(columns.IdsOfEdges(mesh), inner, greatest, runtime.Group());
  std::vector<NewPoint> points;
  for (std::size_t e = 0; e < columns.Edges.size(); ++e)
  {
    const Vector3 foot = mesh.PointAt(columns.Edges[e].Foot);
    const Vector3 along = mesh.PointAt(columns.Edges[e].Top) - foot;
    for (Index part = 1; part <= inner; ++part)
    {
      points.push_back({ ids[points.size()], foot + ends[e][part] * along });
    }
  }
  return points;
}

/// Collective. Appends the partners of new points, and moves points to copies of their partners.
void AddPartners(const LayerColumns& columns, const LayerSpacing& spacing, const Vector3& periods,
  Ranks& ranks, std::vector<NewPoint>& points, Mesh& mesh)
{
  const std::vector<NewPoint> partners =
    FindPartners(mesh, columns, points, spacing.Layers - 1, ranks);
  std::vector<Index> ids;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    ids.push_back(partners[p].Id);
    points[p].Position = MoveToCopy(points[p].Position, partners[p].Position, periods);
  }
  Append(mesh.PeriodicPartner, ids);
}

/// Collective. Adds the points inside edges.
void AddPoints(const LayerColumns& columns, const EdgeFinder& edges, const LayerSpacing& spacing,
  const Vector3& periods, Runtime& runtime, Mesh& mesh)
{
  const std::vector<EdgeGeometry> geometry =
    FindEdgeGeometry(mesh, columns, edges, runtime.Group());
  std::vector<NewPoint> points = MakePoints(columns, spacing, runtime, mesh);
  if (runtime.Group().Any(!mesh.PeriodicPartner.empty()))
  {
    AddPartners(columns, spacing, periods, runtime.Group(), points, mesh);
  }
  std::vector<double> positions;
  std::vector<Index> ids;
  std::vector<int> dimensions, numbers;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const EdgeGeometry& of = geometry[p / (spacing.Layers - 1)];
    positions.insert(positions.end(), points[p].Position.begin(), points[p].Position.end());
    ids.push_back(points[p].Id);
    dimensions.push_back(of.Dimension);
    numbers.push_back(of.Id);
  }
  Append(mesh.Points, positions);
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
  const LayerParts& parts, const std::vector<Index>& parents, Runtime& runtime, Mesh& mesh)
{
  const std::vector<LayerColumns::Column>& columns = parts.Columns.Columns;
  std::vector<Index> ids;
  for (const LayerColumns::Column& column : columns)
  {
    ids.push_back(mesh.ElementIds[column.Element]);
  }
  Ranks& ranks = runtime.Group();
  ids = MakeIds(ids, parts.Layers - 1, FindGreatestId(mesh.ElementIds, ranks), ranks);
  Append(mesh.ElementIds, ids);
  mesh.Elements = Select(mesh.Elements, parents, runtime, mesh.Corners);
  mesh.Material = Select(mesh.Material, parents, runtime);
  mesh.Fragment = Select(mesh.Fragment, parents, runtime);
  Buffer<int> layers =
    mesh.Layer.empty() ? Buffer<int>(parents.size(), 0) : Select(mesh.Layer, parents, runtime);
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
}

/// Returns the volume of each element relative to the column that it was part of.
std::vector<double> FindShares(const Mesh& mesh, const std::vector<Index>& parents)
{
  std::vector<double> shares(parents.size()), sums(parents.size());
  for (std::size_t e = 0; e < parents.size(); ++e)
  {
    shares[e] = VolumeOfElement(mesh, static_cast<Index>(e));
    sums[parents[e]] += shares[e];
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
  const std::vector<double>& shares, Runtime& runtime, TransferredArray& array)
{
  if (elements == 0)
  {
    return;
  }
  array.Values =
    Select(array.Values, parents, runtime, static_cast<Index>(array.Values.size()) / elements);
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

void CutLayers(const LayerColumns& columns, const LayerSpacing& spacing, const Vector3& periods,
  Runtime& runtime, Mesh& mesh, OutputState& state)
{
  const LayerParts parts(columns, spacing.Layers, mesh);
  const EdgeFinder edges(columns);
  AddPoints(columns, edges, spacing, periods, runtime, mesh);
  CheckNumberOfPoints(static_cast<Index>(mesh.PointIds.size()), runtime.Group());
  AddLayerPulls(parts, runtime.Group(), mesh);
  const std::vector<Index> parents = ListParents(parts);
  AddElements(parts, parents, runtime, mesh);
  CutFacets(parts, edges, runtime.Group(), mesh);
  const std::vector<double> shares = FindShares(mesh, parents);
  for (TransferredArray& array : state.Arrays)
  {
    DivideArray(parts.OldElements, parents, shares, runtime, array);
  }
}

} // namespace vfm
