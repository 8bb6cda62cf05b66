#include "Surfaces/SurfaceFractions.h"

#include "Base/Groups.h"
#include "Surfaces/RowSums.h"

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
  SurfaceTiles(const NodeLists& coordinates, const IndexBox& cells, const ClosedSurface& surface,
    Runtime& runtime);

  Index Count() const { return this->PerLayer * this->Cells.Size(2); }
  /// Returns empty sums for the rows of a tile.
  std::vector<RowSums> MakeRows() const
  {
    return std::vector<RowSums>(TileHeight, RowSums(this->Nodes[0], this->Cells.Lower[0]));
  }
  /// Computes the fractions of the cells of a tile.
  /// @param rows  empty sums, which are empty again afterwards
  /// @param fractions  values of all cells of the box
  void Compute(Index tile, std::vector<RowSums>& rows, Buffer<double>& fractions) const;

private:
  CutPolygon PolygonOf(Index triangle) const;
  Interval RangeOf(int axis, Index cell) const;
  CellSpan FindInBox(const Interval& extent, int axis) const;
  template <class Visit>
  void ForTiles(const CellSpan& y, const CellSpan& z, const Visit& visit) const;
  void AddRows(const CutPolygon& slab, Index first, Index count, std::vector<RowSums>& rows) const;

  const NodeLists& Nodes;
  const IndexBox Cells;
  const ClosedSurface& Surface;
  const Index PerLayer;
  Groups<Index> Members; // triangles by tile
};

SurfaceTiles::SurfaceTiles(const NodeLists& coordinates, const IndexBox& cells,
  const ClosedSurface& surface, Runtime& runtime) :
  Nodes(coordinates),
  Cells(cells),
  Surface(surface),
  PerLayer((cells.Size(1) + TileHeight - 1) / TileHeight)
{
  std::vector<std::array<CellSpan, 2>> spans(surface.Triangles.size()); // along y and z
  ForEach(runtime, spans.size(),
    [&](Index t)
    {
      const CutPolygon polygon = this->PolygonOf(t);
      spans[t] = { { this->FindInBox(polygon.Extent(1), 1),
        this->FindInBox(polygon.Extent(2), 2) } };
    });
  this->Members = MakeGroups<Index>(this->Count(),
    [&](const auto& visit)
    {
      for (std::size_t t = 0; t < spans.size(); ++t)
      {
        this->ForTiles(
          spans[t][0], spans[t][1], [&](Index tile) { visit(tile, static_cast<Index>(t)); });
      }
    });
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

/// Calls visit(tile) for the tiles that hold some cells.
template <class Visit>
void SurfaceTiles::ForTiles(const CellSpan& y, const CellSpan& z, const Visit& visit) const
{
  if (y.First > y.Last)
  {
    return;
  }
  const Index first = (y.First - this->Cells.Lower[1]) / TileHeight;
  const Index last = (y.Last - this->Cells.Lower[1]) / TileHeight;
  for (Index k = z.First; k <= z.Last; ++k)
  {
    const Index layer = (k - this->Cells.Lower[2]) * this->PerLayer;
    for (Index j = first; j <= last; ++j)
    {
      visit(layer + j);
    }
  }
}

/// Adds a polygon, whose z are relative to its layer, to the rows that it meets.
/// @param first,count  rows of the tile
void SurfaceTiles::AddRows(
  const CutPolygon& slab, Index first, Index count, std::vector<RowSums>& rows) const
{
  const CellSpan range = FindCells(this->Nodes[1], slab.Extent(1));
  const Index last = std::min(range.Last, first + count - 1);
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

void SurfaceTiles::Compute(Index tile, std::vector<RowSums>& rows, Buffer<double>& fractions) const
{
  const Index k = this->Cells.Lower[2] + tile / this->PerLayer;
  const Index first = this->Cells.Lower[1] + tile % this->PerLayer * TileHeight;
  const Index count = std::min(TileHeight, this->Cells.Upper[1] - first);
  const Interval z = this->RangeOf(2, k);
  for (Index m = this->Members.Begin[tile]; m < this->Members.Begin[tile + 1]; ++m)
  {
    CutPolygon slab = CutBetween(this->PolygonOf(this->Members.Items[m]), 2, z);
    for (int i = 0; i < slab.Size; ++i)
    {
      slab.Corners[i][2] = (slab.Corners[i][2] - z.Low) / (z.High - z.Low);
    }
    this->AddRows(slab, first, count, rows);
  }
  for (Index j = 0; j < count; ++j)
  {
    const Index row = IndexInBox(this->Cells, { { this->Cells.Lower[0], first + j, k } });
    rows[j].Finish(this->Cells.Size(0), fractions.data() + row);
  }
}

} // namespace

Buffer<double> FractionsOfSurface(const std::array<std::vector<double>, 3>& coordinates,
  const IndexBox& cells, const ClosedSurface& surface, Runtime& runtime)
{
  Buffer<double> fractions(cells.NumberOfCells());
  if (cells.NumberOfCells() > 0)
  {
    const SurfaceTiles tiles(coordinates, cells, surface, runtime);
    runtime.For(0, tiles.Count(),
      [&](Index begin, Index end)
      {
        std::vector<RowSums> rows = tiles.MakeRows();
        for (Index tile = begin; tile < end; ++tile)
        {
          tiles.Compute(tile, rows, fractions);
        }
      });
  }
  return fractions;
}

std::vector<Buffer<double>> FractionsOfSurfaces(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& cells,
  const InputSurfaces& surfaces, Runtime& runtime)
{
  std::vector<Buffer<double>> fractions;
  const double count = static_cast<double>(surfaces.Bodies.size());
  for (const BodySurface& body : surfaces.Bodies)
  {
    runtime.Progress(static_cast<double>(fractions.size()) / count, "Computing fractions");
    fractions.push_back(FractionsOfSurface(coordinates, cells, body.Boundary, runtime));
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
          if (values[i] > rest) // few cells: most memory is only read
          {
            values[i] = Snapped(rest);
          }
          rest -= values[i];
        }
      }
    });
}

} // namespace vfm
