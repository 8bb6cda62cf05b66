#include "Interface/FilmCrossings.h"

#include "Base/Vector3.h"
#include "Interface/ScaledCells.h"

namespace vfm
{
namespace
{

constexpr double GoodFit = 0.1; // largest rms error of fractions of a film
// Faces whose axis is closer to the plane of the film are at its rim.
constexpr double RimSlope = 0.1;
// For a smaller n.axis, the foot of the plane replaces its cut with the axis.
constexpr double SteepPlane = 0.25;
constexpr double LargestDistance = 1.0; // of a crossing from the cell's centre, in cells
constexpr Index CellsOfBlock = 64;      // cells per task

/// Returns the fractions of a material in a cell and the cells around it, in the frame of the cell.
std::vector<FractionSample> SampleAround(
  const CartesianGrid& grid, const FractionField& fractions, const Index3& p, int material)
{
  const ScaledCells cells(grid);
  const Vector3 centre = cells.Centre(p), widths = cells.Widths(p);
  std::vector<FractionSample> samples;
  const auto add = [&](const Index3& q)
  {
    samples.push_back({ Divided(cells.Centre(q) - centre, widths), Divided(cells.Widths(q), widths),
      fractions.Fraction(grid.Linear(q), material), 1.0 });
  };
  add(p);
  for (int c = 0; c < 27; ++c)
  {
    const Index3 q = CellAround(p, c);
    if (c != 13 && grid.InDomain(q))
    {
      add(q);
    }
  }
  return samples;
}

/// Returns whether a cell has a face to another label.
bool HasFace(const CartesianGrid& grid, const LabelArray& labels, const Index3& p)
{
  for (int side = 0; side < 6; ++side)
  {
    Index3 q = p;
    q[side / 2] += side % 2 ? 1 : -1;
    if (grid.Local().Contains(q) && labels[grid.Linear(q)] != labels[grid.Linear(p)])
    {
      return true;
    }
  }
  return false;
}

/// Lists the cells with a face to another label and their own label in a thin cell among the 27
/// around them, ascending.
std::vector<Index> ListCells(
  const CartesianGrid& grid, const LabelArray& labels, const std::vector<Index>& thin)
{
  std::vector<Index> cells;
  const IndexBox inner = grid.Extended(GhostLayers - 1);
  for (Index cell : thin)
  {
    const Index3 p = grid.Position(cell);
    for (int c = 0; c < 27; ++c)
    {
      const Index3 q = CellAround(p, c);
      if (inner.Contains(q) && labels[cell] > 0 && labels[grid.Linear(q)] == labels[cell] &&
        HasFace(grid, labels, q))
      {
        cells.push_back(grid.Linear(q));
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

} // namespace

FilmCrossings::FilmCrossings(const CartesianGrid& grid, const FractionField& fractions,
  const LabelArray& labels, const std::vector<Index>& thin, Runtime& runtime) :
  Grid(grid)
{
  const std::vector<Index> cells = ListCells(grid, labels, thin);
  this->Films = CollectItems<Film>(runtime, cells.size(), CellsOfBlock,
    [&](Index i, std::vector<Film>& films)
    {
      const Index3 p = grid.Position(cells[i]);
      const std::vector<FractionSample> samples =
        SampleAround(grid, fractions, p, labels[cells[i]]);
      if (samples[0].Value <= 0.0 || samples[0].Value >= 1.0 || IsAlongLine(samples))
      {
        return;
      }
      const LayerFit fit = FitFilm(samples);
      if (fit.IsFound && fit.Error <= GoodFit)
      {
        films.push_back({ cells[i], fit.Region });
      }
    });
}

const FilmCrossings::Film* FilmCrossings::FilmOf(Index cell) const
{
  const auto at = std::lower_bound(this->Films.begin(), this->Films.end(), cell,
    [](const Film& film, Index c) { return film.Cell < c; });
  return at != this->Films.end() && at->Cell == cell ? &*at : nullptr;
}

/// Returns the crossing with the film in one of the cells of a face.
std::optional<Crossing> FilmCrossings::Cross(const InterfaceFace& face, bool isLower) const
{
  const Index cell = isLower ? face.Node - this->Grid.Stride(face.Axis) : face.Node;
  const Film* film = this->FilmOf(cell);
  if (!film)
  {
    return std::nullopt;
  }
  const double towards = isLower ? 1.0 : -1.0; // direction from the cell to the other
  const Layer& layer = film->Region;
  const bool isUpper = towards * layer.Normal[face.Axis] > 0.0;
  const Vector3 out = isUpper ? layer.Normal : -1.0 * layer.Normal;
  const double distance = isUpper ? layer.Upper : -layer.Lower;
  const double slope = towards * out[face.Axis];
  if (slope < RimSlope || std::fabs(distance) > LargestDistance)
  {
    return std::nullopt;
  }
  Vector3 foot = distance * out;
  if (slope >= SteepPlane)
  {
    foot = { { 0.0, 0.0, 0.0 } };
    foot[face.Axis] = distance / out[face.Axis];
  }
  const Index3 p = this->Grid.Position(cell);
  const ScaledCells cells(this->Grid);
  const Vector3 widths = cells.Widths(p);
  const int label = isLower ? face.LowerLabel : face.UpperLabel;
  Crossing crossing;
  crossing.Point = cells.Centre(p) + Scaled(widths, foot);
  crossing.Normal = (label == face.First() ? 1.0 : -1.0) * Unit(Divided(out, widths));
  crossing.Weight = 1.0;
  return crossing;
}

std::optional<Crossing> FilmCrossings::Find(const InterfaceFace& face) const
{
  std::optional<Crossing> crossing = this->Cross(face, true);
  return crossing ? crossing : this->Cross(face, false);
}

} // namespace vfm
