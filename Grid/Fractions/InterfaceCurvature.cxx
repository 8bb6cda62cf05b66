#include "Fractions/InterfaceCurvature.h"

#include "Base/ConvexClip.h"
#include "Base/PortableMath.h"
#include "Base/Sorted.h"
#include "Base/Vector3.h"
#include "Fractions/GradientFit.h"
#include "Fractions/Plic.h"

#include <Eigen/Eigenvalues>

namespace vfm
{
namespace
{

// Distance of the planes that are fitted; their normals read one cell more.
constexpr int PlaneReach = CurvatureReach - 1;
constexpr double FitRadius = 1.5; // radius of the Gaussian weight, in cells
// Smallest cosine between the normals of two planes of one interface.
constexpr double SmallestCosine = 0.3;
constexpr double SmallSlope = 1e-6; // fractions with a smaller slope have no direction
constexpr double LittleArea = 1e-9; // planes with a smaller area in their cell are ignored
constexpr int FewestPlanes = 6;
// Regularisation, relative to the weight of all planes.
constexpr std::array<double, 6> Tikhonov{ { 1e-6, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4 } };

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Interface of one part in a cell.
struct CellPlane
{
  Vector3 Middle{ { 0.0, 0.0, 0.0 } }, Normal{ { 0.0, 0.0, 0.0 } };
  double Area = 0.0;
};

/// Returns the centroid and the area of a flat convex polygon.
CellPlane MeasurePolygon(const std::vector<Vector3>& polygon, const Vector3& normal)
{
  CellPlane plane;
  plane.Normal = normal;
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    const Vector3 &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const double area = 0.5 * Norm(Cross(b - a, c - a));
    plane.Middle = plane.Middle + (area / 3.0) * (a + b + c);
    plane.Area += area;
  }
  if (plane.Area > 0.0)
  {
    plane.Middle = (1.0 / plane.Area) * plane.Middle;
  }
  return plane;
}

/// Calls body(position) for the mixed cells of a box in the order of the grid.
template <class Body>
void ForMixedCells(
  const CartesianGrid& grid, const FractionField& fractions, const IndexBox& box, const Body& body)
{
  ForCells(box,
    [&](const Index3& p)
    {
      if (fractions.IsMixed(grid.Linear(p)))
      {
        body(p);
      }
    });
}

/// Cuts cells by planes across the gradients of fractions.
class PlaneCutter
{
public:
  PlaneCutter(const CartesianGrid& grid, const FractionField& fractions) :
    Grid(grid),
    Fractions(fractions),
    Cube(MakeBoxPiece({ { -0.5, -0.5, -0.5 } }, { { 0.5, 0.5, 0.5 } }))
  {
  }

  /// Returns the interface of a part in a cell; its area is 0 if the fractions show no direction.
  CellPlane Cut(const Index3& cell, const FractionField::Part& part)
  {
    GradientFit gradient;
    for (int c = 0; c < 27; ++c)
    {
      const Index3 d = StepAround(c), q = CellAround(cell, c);
      if (c != 13 && this->Grid.InDomain(q))
      {
        gradient.Add(
          { { static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2]) } },
          this->Fractions.Fraction(this->Grid.Linear(q), part.Material) - part.Fraction);
      }
    }
    const Vector3 slope = gradient.Solve();
    if (!(Norm(slope) > SmallSlope))
    {
      return CellPlane();
    }
    const Vector3 normal = Unit(-1.0 * slope);
    ClipPiece(this->Cube, { normal, PlaneOfVolume(normal, part.Fraction) }, this->Below,
      this->Above, this->Section);
    return MeasurePolygon(this->Section, normal);
  }

private:
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const ConvexPiece Cube;
  ConvexPiece Below, Above;
  std::vector<Vector3> Section;
};

/// Planes of all parts of the mixed cells that the owned cells read.
class PlaneField
{
public:
  PlaneField(const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime) :
    Grid(grid), Fractions(fractions)
  {
    std::vector<Index> first(1, 0); // first plane of each cell, and the end
    ForMixedCells(grid, fractions, grid.Extended(PlaneReach),
      [&](const Index3& p)
      {
        const FractionField::Range parts = fractions.Parts(grid.Linear(p));
        this->Cells.push_back(grid.Linear(p));
        first.push_back(first.back() + (parts.end() - parts.begin()));
      });
    this->First = std::move(first);
    this->Planes.resize(this->First.back());
    runtime.For(0, static_cast<Index>(this->Cells.size()),
      [this](Index begin, Index end)
      {
        PlaneCutter cutter(this->Grid, this->Fractions);
        for (Index n = begin; n < end; ++n)
        {
          CellPlane* plane = this->Planes.data() + this->First[n];
          for (const FractionField::Part& part : this->Fractions.Parts(this->Cells[n]))
          {
            *plane++ = cutter.Cut(this->Grid.Position(this->Cells[n]), part);
          }
        }
      });
  }

  /// Returns the plane of a part in a cell, or nullptr.
  const CellPlane* Find(Index cell, int material) const
  {
    const Index n = FindSorted(this->Cells, cell);
    return n < 0 ? nullptr : this->Get(n, material);
  }

  /// Calls body(offset from the cell, plane) for the planes of a material in the
  /// cells around, x fastest.
  template <class Body>
  void ForAround(const Index3& cell, int material, const Body& body) const
  {
    for (Index dz = -PlaneReach; dz <= PlaneReach; ++dz)
    {
      for (Index dy = -PlaneReach; dy <= PlaneReach; ++dy)
      {
        const Index middle = this->Grid.Linear({ { cell[0], cell[1] + dy, cell[2] + dz } });
        auto at = std::lower_bound(this->Cells.begin(), this->Cells.end(), middle - PlaneReach);
        for (; at != this->Cells.end() && *at <= middle + PlaneReach; ++at)
        {
          if (const CellPlane* plane = this->Get(at - this->Cells.begin(), material))
          {
            body(Vector3{ { static_cast<double>(*at - middle), static_cast<double>(dy),
                   static_cast<double>(dz) } },
              *plane);
          }
        }
      }
    }
  }

private:
  const CellPlane* Get(Index n, int material) const
  {
    const FractionField::Range parts = this->Fractions.Parts(this->Cells[n]);
    for (const FractionField::Part* part = parts.begin(); part != parts.end(); ++part)
    {
      const CellPlane& plane = this->Planes[this->First[n] + (part - parts.begin())];
      if (part->Material == material && plane.Area > LittleArea)
      {
        return &plane;
      }
    }
    return nullptr;
  }

  const CartesianGrid& Grid;
  const FractionField& Fractions;
  std::vector<Index> Cells; // mixed cells, ascending
  std::vector<Index> First;
  std::vector<CellPlane> Planes;
};

/// Returns the magnitude of the larger principal curvature of the height field with
/// the paraboloid terms q.
double LargestCurvature(const Vector6& q)
{
  Eigen::Matrix2d first, second; // first and second fundamental forms
  first << 1.0 + q[1] * q[1], q[1] * q[2], q[1] * q[2], 1.0 + q[2] * q[2];
  second << q[3], q[4], q[4], q[5];
  second /= std::sqrt(1.0 + q[1] * q[1] + q[2] * q[2]);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> solver(
    second, first, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

/// Returns the curvature of a part in a cell, or a negative value if it has too few planes.
double FitCurvature(const PlaneField& planes, const Index3& cell, Index linear, int material)
{
  const CellPlane* base = planes.Find(linear, material);
  if (!base)
  {
    return -1.0;
  }
  Vector3 u, v;
  MakeTangents(base->Normal, u, v);
  Matrix6 A = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  int count = 0;
  planes.ForAround(cell, material,
    [&](const Vector3& d, const CellPlane& plane)
    {
      if (Dot(plane.Normal, base->Normal) < SmallestCosine)
      {
        return;
      }
      const Vector3 r = plane.Middle + d - base->Middle;
      const double x = Dot(r, u), y = Dot(r, v);
      const double weight = plane.Area * Exp(-Dot(r, r) / (FitRadius * FitRadius));
      Vector6 terms;
      terms << 1.0, x, y, 0.5 * x * x, x * y, 0.5 * y * y;
      A += weight * terms * terms.transpose();
      b += weight * Dot(r, base->Normal) * terms;
      ++count;
    });
  if (count < FewestPlanes)
  {
    return -1.0;
  }
  const double weights = A(0, 0);
  for (int i = 0; i < 6; ++i)
  {
    A(i, i) += Tikhonov[i] * weights;
  }
  return LargestCurvature(A.ldlt().solve(b));
}

} // namespace

std::vector<CellCurvature> FindCurvatures(
  const CartesianGrid& grid, const FractionField& fractions, Runtime& runtime)
{
  const PlaneField planes(grid, fractions, runtime);
  std::vector<CellCurvature> curvatures;
  ForMixedCells(grid, fractions, grid.Owned(),
    [&](const Index3& p) {
      curvatures.push_back({ grid.Linear(p), -1.0 });
    });
  ForEach(runtime, curvatures.size(),
    [&](Index n)
    {
      const Index cell = curvatures[n].Cell;
      const FractionField::Range parts = fractions.Parts(cell);
      if (parts.end() - parts.begin() == 2) // both have the same curvature
      {
        curvatures[n].Curvature =
          FitCurvature(planes, grid.Position(cell), cell, parts.begin()[1].Material);
      }
    });
  curvatures.erase(std::remove_if(curvatures.begin(), curvatures.end(),
                     [](const CellCurvature& c) { return c.Curvature < 0.0; }),
    curvatures.end());
  return curvatures;
}

} // namespace vfm
