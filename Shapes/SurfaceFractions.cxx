#include "Shapes/SurfaceFractions.h"

#include "Base/Groups.h"
#include "Shapes/RowSums.h"

#include <algorithm>

namespace vfm
{
namespace
{

using NodeLists = std::array<std::vector<double>, 3>;

constexpr Index TileHeight = 16; // rows of a tile

/// Tiles are up to TileHeight rows of a layer of cells. Each tile is computed by one thread.
class SurfaceTiles
{
public:
  SurfaceTiles(const NodeLists& coordinates, const IndexBox& cells, const ClosedSurface& surface);

  Index Count() const { return this->PerLayer * this->Cells.Size(2); }
  /// Computes the fractions of the cells of a tile.
  /// @param fractions  values of all cells of the box
  void Compute(Index tile, Buffer<double>& fractions) const;

private:
  CutPolygon PolygonOf(Index triangle) const;
  Interval RangeOf(int axis, Index cell) const;
  CellSpan FindInBox(const Interval& extent, int axis) const;
  template <class Visit>
  void ForTiles(const Visit& visit) const;
  void AddRows(const CutPolygon& slab, Index first, std::vector<RowSums>& rows) const;

  const NodeLists& Nodes;
  const IndexBox Cells;
  const ClosedSurface& Surface;
  const Index PerLayer;
  Groups<Index> Members; // triangles by tile
};

SurfaceTiles::SurfaceTiles(
  const NodeLists& coordinates, const IndexBox& cells, const ClosedSurface& surface) :
  Nodes(coordinates),
  Cells(cells),
  Surface(surface),
  PerLayer((cells.Size(1) + TileHeight - 1) / TileHeight)
{
  this->Members =
    MakeGroups<Index>(this->Count(), [this](const auto& visit) { this->ForTiles(visit); });
}

CutPolygon SurfaceTiles::PolygonOf(Index triangle) const
{
  CutPolygon polygon;
  for (Index point : this->Surface.Triangles[triangle])
  {
    polygon.Corners[polygon.Size++] = this->Surface.Points[point];
  }
  return polygon;
}

Interval SurfaceTiles::RangeOf(int axis, Index cell) const
{
  return { this->Nodes[axis][cell], this->Nodes[axis][cell + 1] };
}

/// Returns the cells of the box whose interior an interval meets; an empty range if there are none.
CellSpan SurfaceTiles::FindInBox(const Interval& extent, int axis) const
{
  const CellSpan found = FindCells(this->Nodes[axis], extent);
  return { std::max(found.First, this->Cells.Lower[axis]),
    std::min(found.Last, this->Cells.Upper[axis] - 1) };
}

/// Calls visit(tile, triangle) for the tiles that the bounds of each triangle meet.
template <class Visit>
void SurfaceTiles::ForTiles(const Visit& visit) const
{
  for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
  {
    const CutPolygon polygon = this->PolygonOf(static_cast<Index>(t));
    const CellSpan y = this->FindInBox(polygon.Extent(1), 1);
    const CellSpan z = this->FindInBox(polygon.Extent(2), 2);
    for (Index k = z.First; y.First <= y.Last && k <= z.Last; ++k)
    {
      const Index layer = (k - this->Cells.Lower[2]) * this->PerLayer;
      const Index last = (y.Last - this->Cells.Lower[1]) / TileHeight;
      for (Index j = (y.First - this->Cells.Lower[1]) / TileHeight; j <= last; ++j)
      {
        visit(layer + j, static_cast<Index>(t));
      }
    }
  }
}

/// Adds a polygon, whose z are relative to its layer, to the rows that it meets.
/// @param first  row of rows[0]
void SurfaceTiles::AddRows(const CutPolygon& slab, Index first, std::vector<RowSums>& rows) const
{
  const CellSpan range = FindCells(this->Nodes[1], slab.Extent(1));
  const Index last = std::min(range.Last, first + static_cast<Index>(rows.size()) - 1);
  for (Index j = std::max(range.First, first); j <= last; ++j)
  {
    const Interval y = this->RangeOf(1, j);
    CutPolygon part = CutBetween(slab, 1, y);
    for (int i = 0; i < part.Size; ++i)
    {
      part.Corners[i][1] = (part.Corners[i][1] - y.Low) / (y.High - y.Low);
    }
    rows[j - first].Add(part);
  }
}

void SurfaceTiles::Compute(Index tile, Buffer<double>& fractions) const
{
  const Index k = this->Cells.Lower[2] + tile / this->PerLayer;
  const Index first = this->Cells.Lower[1] + tile % this->PerLayer * TileHeight;
  const Index count = std::min(TileHeight, this->Cells.Upper[1] - first);
  const Interval z = this->RangeOf(2, k);
  std::vector<RowSums> rows(count, RowSums(this->Nodes[0], this->Cells.Lower[0]));
  for (Index m = this->Members.Begin[tile]; m < this->Members.Begin[tile + 1]; ++m)
  {
    CutPolygon slab = CutBetween(this->PolygonOf(this->Members.Items[m]), 2, z);
    for (int i = 0; i < slab.Size; ++i)
    {
      slab.Corners[i][2] = (slab.Corners[i][2] - z.Low) / (z.High - z.Low);
    }
    this->AddRows(slab, first, rows);
  }
  for (Index j = 0; j < count; ++j)
  {
    const Index row = IndexInBox(this->Cells, { { this->Cells.Lower[0], first + j, k } });
    rows[j].Finish(this->Cells.Size(0), fractions.data() + row);
  }
}

Buffer<double> FractionsOfBody(const NodeLists& coordinates, const IndexBox& cells,
  const ClosedSurface& surface, Runtime& runtime)
{
  Buffer<double> fractions(cells.NumberOfCells());
  if (cells.NumberOfCells() > 0)
  {
    const SurfaceTiles tiles(coordinates, cells, surface);
    ForEach(runtime, tiles.Count(), [&](Index tile) { tiles.Compute(tile, fractions); });
  }
  return fractions;
}

} // namespace

std::vector<Buffer<double>> FractionsOfSurfaces(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& cells,
  const InputSurfaces& surfaces, Runtime& runtime)
{
  std::vector<Buffer<double>> fractions;
  const double count = static_cast<double>(surfaces.Bodies.size());
  for (const BodySurface& body : surfaces.Bodies)
  {
    runtime.Progress(static_cast<double>(fractions.size()) / count, "Computing fractions");
    fractions.push_back(FractionsOfBody(coordinates, cells, body.Boundary, runtime));
  }
  LimitSums(fractions, runtime);
  return fractions;
}

void LimitSums(std::vector<Buffer<double>>& fractions, Runtime& runtime)
{
  if (fractions.size() < 2)
  {
    return;
  }
  runtime.For(0, static_cast<Index>(fractions[0].size()),
    [&fractions](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        double rest = 1.0;
        for (Buffer<double>& values : fractions)
        {
          values[i] = Snapped(std::min(values[i], rest));
          rest -= values[i];
        }
      }
    });
}

} // namespace vfm
