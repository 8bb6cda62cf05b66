/**
 * LayerParts: the points and elements of columns that are cut into layers.
 */
#pragma once

#include "Base/HexNumbering.h"
#include "Modify/LayerColumns.h"

namespace vfm
{

/// Numbers the parts of columns on this rank. New points and elements follow the old ones.
struct LayerParts
{
  LayerParts(const LayerColumns& columns, int layers, const Mesh& mesh) :
    Columns(columns),
    Layers(layers),
    OldPoints(static_cast<Index>(mesh.PointIds.size())),
    OldElements(static_cast<Index>(mesh.ElementIds.size()))
  {
  }

  /// Returns the point where layer `end` of an edge begins; `Layers`: its top.
  Index PointAt(Index edge, int end) const
  {
    return end == 0         ? this->Columns.Edges[edge].Foot
      : end == this->Layers ? this->Columns.Edges[edge].Top
                            : this->OldPoints + edge * (this->Layers - 1) + end - 1;
  }
  /// Returns the points of an edge from its foot to its top.
  std::vector<Index> PointsOfEdge(Index edge) const
  {
    std::vector<Index> points;
    for (int end = 0; end <= this->Layers; ++end)
    {
      points.push_back(this->PointAt(edge, end));
    }
    return points;
  }
  /// Returns the element of a layer of a column; layer 0 replaces the column.
  Index ElementAt(Index column, int layer) const
  {
    return layer == 0 ? this->Columns.Columns[column].Element
                      : this->OldElements + column * (this->Layers - 1) + layer - 1;
  }
  /// Returns the points of a layer of a column in VTK's order.
  std::array<Index, 8> PointsOf(Index column, int layer) const
  {
    const LayerColumns::Column& of = this->Columns.Columns[column];
    std::array<Index, 8> points;
    for (int c = 0; c < 4; ++c)
    {
      const int corner = FaceCorners[of.Side][c];
      points[VtkCorner[corner]] = this->PointAt(of.Edges[c], layer);
      points[VtkCorner[OppositeCorner(corner, of.Side)]] = this->PointAt(of.Edges[c], layer + 1);
    }
    return points;
  }

  const LayerColumns& Columns;
  const int Layers;
  const Index OldPoints, OldElements;
};

} // namespace vfm
