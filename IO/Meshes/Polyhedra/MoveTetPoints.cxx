#include "Meshes/Polyhedra/MoveTetPoints.h"

#include "Meshes/Polyhedra/DualMeasures.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr int MostSweeps = 12;       ///< over the tetrahedra at poor faces
constexpr double LongestStep = 0.25; ///< of the way to a corner
constexpr double ShortestStep = 0.03;
constexpr double LeastShare = 0.05; ///< of the volume of the tetrahedron between point and side
constexpr double LeastGain = 0.001; ///< of a move
// Faces that are better than this count as equal.
constexpr double GoodDepth = 0.06;
constexpr double GoodCosine = 0.2;
constexpr double GoodSkewness = 3.6;
constexpr double SkewnessWeight = 0.1;

double Square(double x)
{
  return x * x;
}

/// Returns the tetrahedra of the cells at poor faces.
std::vector<Index> FindPoorTets(
  const DualTets& tets, const DualMesh& dual, const CellMeasures& cells)
{
  std::vector<char> isPoor(dual.NumberOfCells(), 0);
  ForFaces(dual,
    [&](Index face, Index cell, double)
    {
      if (IsPoor(dual, cells, face))
      {
        isPoor[cell] = 1;
      }
    });
  std::vector<Index> found;
  for (Index tet = 0; tet < tets.Count(); ++tet)
  {
    const Index* around = dual.Cells.OfCorner.data() + 4 * tet;
    if (std::any_of(around, around + 4, [&isPoor](Index cell) { return isPoor[cell] != 0; }))
    {
      found.push_back(tet);
    }
  }
  return found;
}

/// Returns whether a point is inside of a tetrahedron, not close to its sides.
bool IsInside(const DualTets& tets, Index tet, const Vector3& x)
{
  const auto volume = [&](int replaced)
  {
    std::array<Vector3, 4> points;
    for (int c = 0; c < 4; ++c)
    {
      points[c] = c == replaced ? x : tets.Data().PointAt(tets.Node(tet, c));
    }
    return Dot(Cross(points[1] - points[0], points[2] - points[0]), points[3] - points[0]);
  };
  const double least = LeastShare * volume(-1);
  return volume(0) > least && volume(1) > least && volume(2) > least && volume(3) > least;
}

/// The dual mesh with its measures, which follow the points.
class MovedDual
{
public:
  MovedDual(const DualTets& tets, CellMeasures measures, DualMesh& dual) :
    Tets(tets), Dual(dual), Faces(FacesOfCells(dual)), Measures(std::move(measures))
  {
  }

  /// Moves the point of a tetrahedron towards one of the corners or away from it, if its cells
  /// become better.
  /// @return whether it moved
  bool Improve(Index tet, double step)
  {
    const Vector3 place = PointOfDual(this->Dual, tet);
    Vector3 best = place;
    const double before = this->PenaltyAt(tet, place);
    double least = before;
    for (int c = 0; before > 0.0 && c < 8; ++c)
    {
      const Vector3 corner = this->Tets.Data().PointAt(this->Tets.Node(tet, c % 4));
      const Vector3 next = place + (c < 4 ? step : -step) * (corner - place);
      const double penalty = IsInside(this->Tets, tet, next) ? this->PenaltyAt(tet, next) : least;
      if (penalty < (1.0 - LeastGain) * least)
      {
        least = penalty;
        best = next;
      }
    }
    this->PenaltyAt(tet, best);
    return least < before;
  }

private:
  std::array<Index, 4> CellsOf(Index tet) const
  {
    const Index* cells = this->Dual.Cells.OfCorner.data() + 4 * tet;
    return { { cells[0], cells[1], cells[2], cells[3] } };
  }

  /// Moves the point of a tetrahedron.
  /// @return how poor the faces of its cells are
  double PenaltyAt(Index tet, const Vector3& x)
  {
    std::copy(x.begin(), x.end(), this->Dual.Points.begin() + 3 * tet);
    for (const Index cell : this->CellsOf(tet))
    {
      for (const CellFace& face : this->Faces[cell])
      {
        this->Measures.Faces[face.Face] = MeasureFace(this->Dual, face.Face);
      }
    }
    for (const Index cell : this->CellsOf(tet))
    {
      MeasureCell(this->Faces[cell], cell, this->Measures);
    }
    double penalty = 0.0;
    for (const Index cell : this->CellsOf(tet))
    {
      for (const CellFace& face : this->Faces[cell])
      {
        penalty += this->PenaltyOf(face.Face);
      }
    }
    return penalty;
  }

  double PenaltyOf(Index face) const
  {
    const FaceQuality quality = QualityOf(this->Dual, this->Measures, face);
    return Square(std::max(0.0, GoodDepth - quality.Depth)) +
      Square(std::max(0.0, GoodCosine - quality.Cosine)) +
      Square(SkewnessWeight * std::max(0.0, quality.Skewness - GoodSkewness));
  }

  const DualTets& Tets;
  DualMesh& Dual;
  const std::vector<std::vector<CellFace>> Faces;
  CellMeasures Measures;
};

} // namespace

void MoveTetPoints(const DualTets& tets, DualMesh& dual)
{
  CellMeasures cells = MeasureCells(dual);
  const std::vector<Index> poor = FindPoorTets(tets, dual, cells);
  if (poor.empty())
  {
    return;
  }
  MovedDual moved(tets, std::move(cells), dual);
  double step = LongestStep;
  for (int sweep = 0; sweep < MostSweeps && step > ShortestStep; ++sweep)
  {
    bool isAny = false;
    for (const Index tet : poor)
    {
      isAny = moved.Improve(tet, step) || isAny;
    }
    step *= isAny ? 1.0 : 0.5;
  }
}

} // namespace vfm
