#include "Surfaces/SurfaceFractions.h"

#include "Base/Groups.h"
#include "Surfaces/RowSums.h"
#include "Surfaces/SharedCells.h"

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
  /// Returns the cells of a tile.
  IndexBox CellsOf(Index tile) const;
  /// Returns empty sums for the rows of a tile.
  std::vector<RowSums> MakeRows() const
  {
    return std::vector<RowSums>(TileHeight, RowSums(this->Nodes[0], this->Cells.Lower[0]));
  }
  /// Computes the fractions of the cells of a tile.
  /// @param rows  empty sums, which are empty again afterwards
  /// @param fractions  values of all cells of the box
  void Compute(Index tile, std::vector<RowSums>& rows, Buffer<double>& fractions) const;
  /// Adds the crossings with the surface to the rays through rows of a tile.
  /// @param shared  shared cells of each row; only rows with such cells need crossings
  void AddCrossings(Index tile, int body, const std::vector<std::vector<SharedCell>>& shared,
    std::vector<RowRays>& rays) const;

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

IndexBox SurfaceTiles::CellsOf(Index tile) const
{
  const Index k = this->Cells.Lower[2] + tile / this->PerLayer;
  const Index first = this->Cells.Lower[1] + tile % this->PerLayer * TileHeight;
  const Index last = std::min(first + TileHeight, this->Cells.Upper[1]);
  return { { { this->Cells.Lower[0], first, k } }, { { this->Cells.Upper[0], last, k + 1 } } };
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
  const IndexBox cells = this->CellsOf(tile);
  const Index first = cells.Lower[1], count = cells.Size(1);
  const Interval z = this->RangeOf(2, cells.Lower[2]);
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
    const Index row = IndexInBox(this->Cells, { { cells.Lower[0], first + j, cells.Lower[2] } });
    rows[j].Finish(this->Cells.Size(0), fractions.data() + row);
  }
}

void SurfaceTiles::AddCrossings(Index tile, int body,
  const std::vector<std::vector<SharedCell>>& shared, std::vector<RowRays>& rays) const
{
  const IndexBox cells = this->CellsOf(tile);
  for (Index m = this->Members.Begin[tile]; m < this->Members.Begin[tile + 1]; ++m)
  {
    const CutPolygon triangle = this->PolygonOf(this->Members.Items[m]);
    const CellSpan range = FindCells(this->Nodes[1], triangle.Extent(1));
    const Index last = std::min(range.Last, cells.Upper[1] - 1);
    for (Index j = std::max(range.First, cells.Lower[1]); j <= last; ++j)
    {
      if (!shared[j - cells.Lower[1]].empty())
      {
        rays[j - cells.Lower[1]].Add(triangle, body);
      }
    }
  }
}

Buffer<double> FractionsOfBody(const SurfaceTiles& tiles, Index cellCount, Runtime& runtime)
{
  Buffer<double> fractions(cellCount);
  runtime.For(0, tiles.Count(),
    [&](Index begin, Index end)
    {
      std::vector<RowSums> rows = tiles.MakeRows();
      for (Index tile = begin; tile < end; ++tile)
      {
        tiles.Compute(tile, rows, fractions);
      }
    });
  return fractions;
}

/// Finds the shared cells of a row.
/// @param row  place of its first cell in the fractions of each body alone
/// @param first,count  cells of the row
void FindShared(const std::vector<Buffer<double>>& fractions, Index row, Index first, Index count,
  std::vector<SharedCell>& shared)
{
  shared.clear();
  const int bodies = static_cast<int>(fractions.size());
  for (Index i = 0; i < count; ++i)
  {
    bool isCut = false;
    for (int b = 0; b < bodies && fractions[b][row + i] < 1.0; ++b)
    {
      const bool isCutByBody = fractions[b][row + i] > 0.0;
      if (isCut && isCutByBody)
      {
        shared.push_back({ first + i, b });
      }
      isCut = isCut || isCutByBody;
    }
  }
}

/// Subtracts earlier bodies in the shared cells of a row.
/// @param offset  place of cell 0 of the row in the fractions
void SubtractEarlier(
  const std::vector<SharedCell>& shared, Index offset, std::vector<Buffer<double>>& fractions)
{
  for (const SharedCell& cell : shared)
  {
    const Index i = offset + cell.Cell;
    double earlier = 0.0;
    for (int b = 0; b < cell.Body; ++b)
    {
      earlier += fractions[b][i];
    }
    double& own = fractions[cell.Body][i];
    own = Snapped(FractionBesideEarlier(earlier, own, cell.Parts));
  }
}

/// Limits fractions, cell by cell, to what the earlier ones leave of 1.
void LimitSumsOf(Index begin, Index end, std::vector<Buffer<double>>& fractions)
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
}

/// Rows of a tile, in which later bodies give way.
class SharedRows
{
public:
  SharedRows(const NodeLists& coordinates, const IndexBox& cells) :
    Nodes(coordinates), Cells(cells), Shared(TileHeight), Rays(TileHeight)
  {
  }

  /// @param bodies  tiles of all bodies, over the same cells
  void GiveWay(
    const std::vector<SurfaceTiles>& bodies, Index tile, std::vector<Buffer<double>>& fractions);

private:
  bool Find(const IndexBox& tile, const std::vector<Buffer<double>>& fractions);
  Index RowOf(const IndexBox& tile, Index j) const
  {
    return IndexInBox(this->Cells, { { tile.Lower[0], tile.Lower[1] + j, tile.Lower[2] } });
  }

  const NodeLists& Nodes;
  const IndexBox Cells;
  std::vector<std::vector<SharedCell>> Shared; // by row
  std::vector<RowRays> Rays;
};

/// Finds the shared cells, and begins the rays of their rows. Returns whether there are any.
bool SharedRows::Find(const IndexBox& tile, const std::vector<Buffer<double>>& fractions)
{
  bool isAny = false;
  const Index k = tile.Lower[2];
  for (Index j = 0; j < tile.Size(1); ++j)
  {
    FindShared(fractions, this->RowOf(tile, j), tile.Lower[0], tile.Size(0), this->Shared[j]);
    if (!this->Shared[j].empty())
    {
      const double* y = &this->Nodes[1][tile.Lower[1] + j];
      this->Rays[j].Begin({ y[0], y[1] }, { this->Nodes[2][k], this->Nodes[2][k + 1] });
      isAny = true;
    }
  }
  return isAny;
}

void SharedRows::GiveWay(
  const std::vector<SurfaceTiles>& bodies, Index tile, std::vector<Buffer<double>>& fractions)
{
  const IndexBox cells = bodies[0].CellsOf(tile);
  if (this->Find(cells, fractions))
  {
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
      bodies[b].AddCrossings(tile, static_cast<int>(b), this->Shared, this->Rays);
    }
  }
  for (Index j = 0; j < cells.Size(1); ++j)
  {
    const Index row = this->RowOf(cells, j);
    if (!this->Shared[j].empty())
    {
      this->Rays[j].Measure(this->Nodes[0], this->Shared[j]);
      SubtractEarlier(this->Shared[j], row - cells.Lower[0], fractions);
    }
    LimitSumsOf(row, row + cells.Size(0), fractions);
  }
}

} // namespace

std::vector<Buffer<double>> FractionsOfSurfaces(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& cells,
  const std::vector<const ClosedSurface*>& surfaces, Runtime& runtime)
{
  const std::size_t count = surfaces.size();
  if (cells.NumberOfCells() == 0)
  {
    return std::vector<Buffer<double>>(count);
  }
  std::vector<SurfaceTiles> bodies;
  std::vector<Buffer<double>> fractions;
  for (const ClosedSurface* surface : surfaces)
  {
    runtime.Progress(
      static_cast<double>(fractions.size()) / static_cast<double>(count), "Computing fractions");
    bodies.emplace_back(coordinates, cells, *surface, runtime);
    fractions.push_back(FractionsOfBody(bodies.back(), cells.NumberOfCells(), runtime));
  }
  runtime.For(0, count > 1 ? bodies[0].Count() : 0,
    [&](Index begin, Index end)
    {
      SharedRows rows(coordinates, cells);
      for (Index tile = begin; tile < end; ++tile)
      {
        rows.GiveWay(bodies, tile, fractions);
      }
    });
  return fractions;
}

std::vector<Buffer<double>> FractionsOfSurfaces(
  const std::array<std::vector<double>, 3>& coordinates, const IndexBox& cells,
  const InputSurfaces& surfaces, Runtime& runtime)
{
  std::vector<const ClosedSurface*> boundaries;
  for (const BodySurface& body : surfaces.Bodies)
  {
    boundaries.push_back(&body.Boundary);
  }
  return FractionsOfSurfaces(coordinates, cells, boundaries, runtime);
}

void LimitSums(std::vector<Buffer<double>>& fractions, Runtime& runtime)
{
  if (fractions.size() > 1)
  {
    runtime.For(0, static_cast<Index>(fractions[0].size()),
      [&fractions](Index begin, Index end) { LimitSumsOf(begin, end, fractions); });
  }
}

} // namespace vfm
