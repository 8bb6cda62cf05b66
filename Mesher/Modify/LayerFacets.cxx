#include "Modify/LayerFacets.h"

#include "Base/Sorted.h"
#include "Ranks/MergeByKey.h"

#include <limits>

namespace vfm
{
namespace
{

/// Returns the points of a layer of a face.
std::array<Index, 4> PointsOfLayer(
  const LayerParts& parts, const std::array<CutCorner, 4>& corners, int layer)
{
  std::array<Index, 4> points;
  for (int c = 0; c < 4; ++c)
  {
    points[c] = parts.PointAt(corners[c].Edge, layer + (corners[c].IsTop ? 1 : 0));
  }
  return points;
}

/// Cuts the facets of elements.
void CutElementFacets(const LayerParts& parts, Mesh& mesh)
{
  std::vector<Index> columnOf(parts.OldElements, -1);
  for (std::size_t c = 0; c < parts.Columns.Columns.size(); ++c)
  {
    columnOf[parts.Columns.Columns[c].Element] = static_cast<Index>(c);
  }
  std::vector<MeshFacet> facets;
  for (const MeshFacet& facet : mesh.Facets)
  {
    const Index column = columnOf[facet.Element];
    if (column < 0)
    {
      facets.push_back(facet);
      continue;
    }
    const int base = parts.Columns.Columns[column].Side;
    const int first = facet.Side == (base ^ 1) ? parts.Layers - 1 : 0;
    const int last = facet.Side == base ? 0 : parts.Layers - 1;
    for (int layer = first; layer <= last; ++layer)
    {
      facets.push_back(facet);
      facets.back().Element = parts.ElementAt(column, layer);
    }
  }
  std::sort(facets.begin(), facets.end());
  mesh.Facets = std::move(facets);
}

template <class T>
Buffer<T> ToBuffer(const std::vector<T>& values)
{
  Buffer<T> buffer(values.size());
  std::copy(values.begin(), values.end(), buffer.begin());
  return buffer;
}

/// Rows of GeometryTables::EdgeFacets.
using EdgeFacets = std::vector<std::array<std::int64_t, 5>>;

std::array<std::int64_t, 5> RowOf(const Mesh& mesh, const Index* points, int surface)
{
  std::array<std::int64_t, 5> row;
  std::transform(
    points, points + 4, row.begin(), [&mesh](Index point) { return mesh.PointIds[point]; });
  std::sort(row.begin(), row.begin() + 4);
  row[4] = surface;
  return row;
}

/// Collective. Replaces rows of facets that were cut on any rank.
/// @param cut  rows that this rank cut
/// @param parts  rows of the parts of each: `layers` each
/// @param rows  known to this rank
void ReplaceRows(
  const EdgeFacets& cut, const EdgeFacets& parts, int layers, Ranks& ranks, EdgeFacets& rows)
{
  SortUnique(rows);
  const std::size_t width = 4 * static_cast<std::size_t>(layers);
  std::vector<std::int64_t> points(width * rows.size(), -1); // of the parts of each row
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const std::size_t row = FindSorted(rows, cut[p / layers]);
    std::copy_n(parts[p].begin(), 4, points.begin() + width * row + 4 * (p % layers));
  }
  KeyMerge<EdgeFacets::value_type>(rows, ranks)
    .Merge(points, width, [](std::int64_t& a, std::int64_t b) { a = std::max(a, b); });
  EdgeFacets replaced;
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    const std::int64_t* part = points.data() + width * row;
    if (part[0] < 0)
    {
      replaced.push_back(rows[row]);
    }
    for (const auto* end = part + width; part[0] >= 0 && part < end; part += 4)
    {
      replaced.push_back({ { part[0], part[1], part[2], part[3], rows[row][4] } });
    }
  }
  std::sort(replaced.begin(), replaced.end());
  rows = std::move(replaced);
}

/// Collective. Cuts the facets of surfaces.
void CutSurfaces(const LayerParts& parts, const EdgeFinder& edges, Ranks& ranks, Mesh& mesh)
{
  const SurfaceFacets& old = mesh.Surfaces;
  std::vector<Index> points;
  std::vector<int> ids, pairs, sides;
  std::vector<unsigned char> isOwned;
  EdgeFacets rows, rowsOfParts;
  const EdgeFacets& listed = mesh.Tables.EdgeFacets;
  for (std::size_t f = 0; f < old.SurfaceId.size(); ++f)
  {
    const Index* face = old.Points.data() + 4 * f;
    const auto cut = edges.FindCut(face);
    const auto row = RowOf(mesh, face, old.SurfaceId[f]);
    const bool isListed = cut && std::binary_search(listed.begin(), listed.end(), row);
    if (isListed)
    {
      rows.push_back(row);
    }
    for (int layer = 0; layer < (cut ? parts.Layers : 1); ++layer)
    {
      std::array<Index, 4> part{ { face[0], face[1], face[2], face[3] } };
      part = cut ? PointsOfLayer(parts, *cut, layer) : part;
      points.insert(points.end(), part.begin(), part.end());
      ids.push_back(old.SurfaceId[f]);
      pairs.insert(pairs.end(), { old.MaterialPair[2 * f], old.MaterialPair[2 * f + 1] });
      sides.push_back(old.DomainSide[f]);
      isOwned.push_back(old.IsOwned[f]);
      if (isListed)
      {
        rowsOfParts.push_back(RowOf(mesh, part.data(), old.SurfaceId[f]));
      }
    }
  }
  mesh.Surfaces = { ToBuffer(points), ToBuffer(ids), ToBuffer(pairs), std::move(isOwned),
    ToBuffer(sides) };
  ReplaceRows(rows, rowsOfParts, parts.Layers, ranks, mesh.Tables.EdgeFacets);
}

/// Cuts the edges of curves.
void CutCurves(const LayerParts& parts, const EdgeFinder& edges, Mesh& mesh)
{
  std::vector<Index> points;
  std::vector<int> ids;
  for (std::size_t e = 0; e < mesh.Curves.CurveId.size(); ++e)
  {
    const Index* ends = mesh.Curves.Points.data() + 2 * e;
    const Index edge = std::max(edges.Find(ends[0], ends[1]), edges.Find(ends[1], ends[0]));
    std::vector<Index> cuts{ ends[0], ends[1] };
    if (edge >= 0)
    {
      cuts = parts.PointsOfEdge(edge);
    }
    for (std::size_t c = 1; c < cuts.size(); ++c)
    {
      points.push_back(std::min(cuts[c - 1], cuts[c]));
      points.push_back(std::max(cuts[c - 1], cuts[c]));
      ids.push_back(mesh.Curves.CurveId[e]);
    }
  }
  mesh.Curves = { ToBuffer(points), ToBuffer(ids) };
}

} // namespace

std::vector<EdgeGeometry> FindEdgeGeometry(
  const Mesh& mesh, const LayerColumns& columns, const EdgeFinder& edges, Ranks& ranks)
{
  using Bounds = std::array<int, 2>; // lowest and highest surface at an edge; none: low > high
  constexpr Bounds none{ { std::numeric_limits<int>::max(), 0 } };
  std::vector<Bounds> surfaces(columns.Edges.size(), none);
  const auto widen = [](const Bounds& a, const Bounds& b) {
    return Bounds{ { std::min(a[0], b[0]), std::max(a[1], b[1]) } };
  };
  for (std::size_t f = 0; f < mesh.Surfaces.SurfaceId.size(); ++f)
  {
    const int surface = mesh.Surfaces.SurfaceId[f];
    if (const auto cut = edges.FindCut(mesh.Surfaces.Points.data() + 4 * f))
    {
      for (const CutCorner& corner : *cut)
      {
        Bounds& at = surfaces[corner.Edge];
        at = widen(at, { { surface, surface } });
      }
    }
  }
  surfaces = MergeByKey(columns.IdsOfEdges(mesh), surfaces, widen, ranks);
  std::vector<EdgeGeometry> geometry(surfaces.size(), { DimensionOfVolumes, 0 });
  for (const LayerColumns::Column& column : columns.Columns)
  {
    for (Index edge : column.Edges)
    {
      geometry[edge].Id = mesh.Fragment[column.Element];
    }
  }
  for (std::size_t e = 0; e < surfaces.size(); ++e)
  {
    const auto [low, high] = surfaces[e];
    const LayerColumns::Edge& edge = columns.Edges[e];
    if (low == high)
    {
      geometry[e] = { DimensionOfSurfaces, low };
    }
    else if (low < high) // the curve where several surfaces meet: its end names it
    {
      const Index end = mesh.GeometryDimension[edge.Top] == 1 ? edge.Top : edge.Foot;
      geometry[e] = { 1, mesh.GeometryDimension[end] == 1 ? mesh.GeometryId[end] : 0 };
    }
  }
  return geometry;
}

void CutFacets(const LayerParts& parts, const EdgeFinder& edges, Ranks& ranks, Mesh& mesh)
{
  CutElementFacets(parts, mesh);
  CutSurfaces(parts, edges, ranks, mesh);
  CutCurves(parts, edges, mesh);
}

} // namespace vfm
