/**
 * SelectPoints: removal of points of a mesh.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

namespace vfm
{

/// Returns the items with the given indices.
/// @param width  values per item
template <class T>
Buffer<T> Select(
  const Buffer<T>& items, const std::vector<Index>& kept, Runtime& runtime, Index width = 1)
{
  Buffer<T> result(kept.size() * width);
  ForEach(runtime, kept.size(),
    [&](Index i)
    { std::copy_n(items.data() + width * kept[i], width, result.data() + width * i); });
  return result;
}

/// Leaves only the items with the given indices, in the memory that they have.
/// @param kept  ascending
/// @param width  values per item
template <class T>
void KeepItems(const std::vector<Index>& kept, Index width, Buffer<T>& items)
{
  const Index count = static_cast<Index>(kept.size());
  for (Index i = 0; i < count; ++i)
  {
    if (kept[i] != i)
    {
      std::copy_n(items.data() + width * kept[i], width, items.data() + width * i);
    }
  }
  if (static_cast<Index>(items.size()) > width * count)
  {
    T* all = items.release();
    void* less = std::realloc(all, std::max<std::size_t>(1, width * count * sizeof(T)));
    items = Buffer<T>::From(less ? static_cast<T*>(less) : all, width * count);
  }
}

/// Leaves only some points, and renumbers the points of elements, facets, curves and vertices.
/// @param kept  points that remain, in their new order
/// @param numbers  new number of each point, or -1
inline void SelectPoints(
  const std::vector<Index>& kept, const std::vector<Index>& numbers, Runtime& runtime, Mesh& mesh)
{
  const bool areAscending =
    std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<Index>()) == kept.end();
  const auto select = [&](auto& items, Index width)
  {
    if (areAscending)
    {
      KeepItems(kept, width, items);
    }
    else
    {
      items = Select(items, kept, runtime, width);
    }
  };
  select(mesh.Points, 3);
  select(mesh.PointIds, 1);
  select(mesh.GeometryDimension, 1);
  select(mesh.GeometryId, 1);
  for (Buffer<Index>* points :
    { &mesh.Elements, &mesh.Surfaces.Points, &mesh.Curves.Points, &mesh.Vertices.Points })
  {
    ForEach(runtime, points->size(), [&](Index i) { (*points)[i] = numbers[(*points)[i]]; });
  }
}

/// Restores the order of the points of curves and vertices after points were renumbered. The points
/// of an edge ascend by their ids before interfaces were split, which do not depend on ranks.
inline void SortGeometry(Mesh& mesh)
{
  const Buffer<Index>& ids = mesh.UnsplitPointIds();
  Buffer<Index>& edges = mesh.Curves.Points;
  for (std::size_t e = 0; e < edges.size(); e += 2)
  {
    std::sort(edges.begin() + e, edges.begin() + e + 2,
      [&ids](Index a, Index b) { return ids[a] < ids[b]; });
  }
  const std::size_t count = mesh.Vertices.Points.size();
  std::vector<std::pair<Index, int>> vertices;
  for (std::size_t v = 0; v < count; ++v)
  {
    vertices.emplace_back(mesh.Vertices.Points[v], mesh.Vertices.VertexId[v]);
  }
  std::sort(vertices.begin(), vertices.end());
  for (std::size_t v = 0; v < count; ++v)
  {
    std::tie(mesh.Vertices.Points[v], mesh.Vertices.VertexId[v]) = vertices[v];
  }
}

} // namespace vfm
