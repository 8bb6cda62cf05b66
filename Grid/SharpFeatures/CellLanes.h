/**
 * What a crease model leaves in four cells side by side. Only for sources with VFM_CLONES (Base/Lanes.h).
 */
#pragma once

#include "Base/Lanes.h"
#include "SharpFeatures/BoxCut.h"
#include "SharpFeatures/Compositions.h"
#include "SharpFeatures/PackedCells.h"

namespace vfm
{

struct CellLanes
{
  Lanes3 Centre, Width;
  Lanes Fraction, Weight;
};

VFM_INLINE Lanes Load(const std::array<double, 4>& a)
{
  return Lanes{ a[0], a[1], a[2], a[3] };
}
VFM_INLINE CellLanes Load(const FourCells& four)
{
  return { { Load(four.Centre[0]), Load(four.Centre[1]), Load(four.Centre[2]) },
    { Load(four.Width[0]), Load(four.Width[1]), Load(four.Width[2]) }, Load(four.Fraction),
    Load(four.Weight) };
}

/// A surface in four cells: its tangent plane over their centres, in the frames of the cells as unit cubes.
struct SurfaceLanes
{
  Lanes U, V; ///< of the centres
  Lanes AlongU, AlongV;
  BoxPlaneOf<Lanes> Plane;
  Lanes Inside;              ///< what is inside of the plane alone
  PlaneRatesOf<Lanes> Rates; ///< of this, then of the model's fraction
};

struct ModelLanes
{
  Lanes Fraction;
  std::array<SurfaceLanes, FeatureModel::MaximumSurfaces> Surfaces; ///< the first Count
  bool IsCut;                                                       ///< any cell, by any surface
  bool IsShared; ///< any cell, by more surfaces than one
};

VFM_INLINE bool Any(const Mask& mask)
{
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
}

VFM_INLINE Lanes DotWith(const Vector3& a, const Lanes3& b)
{
  return a[0] * b.X + a[1] * b.Y + a[2] * b.Z;
}

VFM_INLINE void SetPlane(SurfaceLanes& at, const LocalQuadric& s, const CellLanes& cells)
{
  const Lanes3 r{ cells.Centre.X - s.Base[0], cells.Centre.Y - s.Base[1],
    cells.Centre.Z - s.Base[2] };
  const std::array<double, 6>& c = s.C;
  const Lanes u = DotWith(s.U, r), v = DotWith(s.V, r);
  at.U = u;
  at.V = v;
  at.AlongU = c[1] + 2.0 * c[3] * u + c[4] * v;
  at.AlongV = c[2] + c[4] * u + 2.0 * c[5] * v;
  const double mean = (c[3] + c[5]) / 12.0; // of the quadratic term
  at.Plane.Height =
    DotWith(s.N, r) - (c[0] + mean + (c[1] + c[3] * u + c[4] * v) * u + (c[2] + c[5] * v) * v);
  at.Plane.Normal = { { cells.Width.X * (s.N[0] - at.AlongU * s.U[0] - at.AlongV * s.V[0]),
    cells.Width.Y * (s.N[1] - at.AlongU * s.U[1] - at.AlongV * s.V[1]),
    cells.Width.Z * (s.N[2] - at.AlongU * s.U[2] - at.AlongV * s.V[2]) } };
}

/// Fraction in one cell that several planes cut, and its rates. in, out: planes that leave it wholly inside, outside.
double FractionUnder(const Composition& composition, const std::array<BoxPlane, 3>& planes, int in,
  int out, std::array<PlaneRates, 3>& rates);

/// The same in a lane.
VFM_INLINE void CutLane(ModelLanes& at, const FeatureModel& model, int lane)
{
  std::array<BoxPlane, FeatureModel::MaximumSurfaces> planes;
  std::array<PlaneRates, FeatureModel::MaximumSurfaces> rates{};
  int in = 0, out = 0;
  for (int k = 0; k < model.Count; ++k)
  {
    const BoxPlaneOf<Lanes>& plane = at.Surfaces[k].Plane;
    planes[k] = { { { plane.Normal[0][lane], plane.Normal[1][lane], plane.Normal[2][lane] } },
      plane.Height[lane] };
    const double reach = ReachOf(planes[k]);
    in |= (planes[k].Height >= reach) << k;
    out |= (planes[k].Height <= -reach) << k;
  }
  at.Fraction[lane] =
    FractionUnder(CompositionOf(model.Count, model.Composition), planes, in, out, rates);
  for (int k = 0; k < model.Count; ++k)
  {
    PlaneRatesOf<Lanes>& all = at.Surfaces[k].Rates;
    all.ByHeight[lane] = rates[k].ByHeight;
    for (int axis = 0; axis < 3; ++axis)
    {
      all.ByNormal[axis][lane] = rates[k].ByNormal[axis];
    }
  }
}

/// Where one plane at most cuts a cell, what is inside of several is the product of what is inside of each.
VFM_INLINE void MultiplyInsides(ModelLanes& at, const FeatureModel& model)
{
  std::array<Lanes, FeatureModel::MaximumSurfaces> factors{};
  at.Fraction = Lanes{};
  for (const CompositionTerm& term : CompositionOf(model.Count, model.Composition))
  {
    Lanes product = Fill<double>(term.Sign);
    for (int k = 0; k < model.Count; ++k)
    {
      if (term.Mask >> k & 1)
      {
        const Lanes& inside = at.Surfaces[k].Inside;
        product *= term.Flipped >> k & 1 ? 1.0 - inside : inside;
        Lanes others = Fill<double>(term.Flipped >> k & 1 ? -term.Sign : term.Sign);
        for (int j = 0; j < model.Count; ++j)
        {
          if (j != k && (term.Mask >> j & 1))
          {
            const Lanes& other = at.Surfaces[j].Inside;
            others *= term.Flipped >> j & 1 ? 1.0 - other : other;
          }
        }
        factors[k] += others;
      }
    }
    at.Fraction += product;
  }
  for (int k = 0; k < model.Count; ++k)
  {
    PlaneRatesOf<Lanes>& rates = at.Surfaces[k].Rates;
    rates.ByHeight *= factors[k];
    for (Lanes& rate : rates.ByNormal)
    {
      rate *= factors[k];
    }
  }
}

/// Plane, Inside and Rates of a surface; returns which cells it cuts.
VFM_INLINE Mask SetInside(SurfaceLanes& at, const LocalQuadric& surface, const CellLanes& cells)
{
  SetPlane(at, surface, cells);
  const Lanes zero{}, reach = ReachOf(at.Plane), height = at.Plane.Height;
  const Mask isCut = (height < reach) & (height > -reach);
  if (Any(isCut))
  {
    at.Inside = CutBox(at.Plane, at.Rates);
  }
  else
  {
    at.Inside = height > 0.0 ? Fill(1.0) : zero;
    at.Rates = { zero, { { zero, zero, zero } } };
  }
  return isCut;
}

/// Fractions in four cells, and what each surface does to them.
VFM_INLINE void SetFractions(
  ModelLanes& at, const FeatureModel& model, const CellLanes& cells, SharedCells how)
{
  Mask cut{}, shared{};
  for (int k = 0; k < model.Count; ++k)
  {
    const Mask isCut = SetInside(at.Surfaces[k], model.Surfaces[k], cells);
    shared |= cut & isCut;
    cut |= isCut;
  }
  at.IsCut = Any(cut);
  at.IsShared = Any(shared);
  MultiplyInsides(at, model);
  for (int lane = 0; how == SharedCells::Exact && at.IsShared && lane < 4; ++lane)
  {
    if (shared[lane])
    {
      CutLane(at, model, lane);
    }
  }
}

/// Of the fractions of a model in cells (FeatureFit.h).
struct ResidualSums
{
  Lanes Squares, Weights;
};

VFM_INLINE void AddErrors(
  ResidualSums& sums, const Lanes& fraction, const Lanes& data, const Lanes& allWeight)
{
  constexpr double full = 1e-6; // fractions nearer to 0 or 1 are of full cells
  const Lanes error = fraction - data;
  const Mask counts = ((data > full) & (data < 1.0 - full)) |
    ((fraction > full) & (fraction < 1.0 - full)) | (error > full) | (error < -full);
  const Lanes weight = counts ? allWeight : Fill(0.0);
  sums.Squares += weight * error * error;
  sums.Weights += weight;
}

VFM_INLINE double RootMeanSquare(const ResidualSums& sums)
{
  const double weights = Sum(sums.Weights);
  return weights > 0.0 ? std::sqrt(Sum(sums.Squares) / weights) : 0.0;
}

/// Chain rule: plane -> coefficients of its surface.
VFM_INLINE std::array<Lanes, 6> DerivativesBy(
  const SurfaceLanes& at, const LocalQuadric& s, const Lanes3& width)
{
  const Lanes3 moved{ -width.X * at.Rates.ByNormal[0], -width.Y * at.Rates.ByNormal[1],
    -width.Z * at.Rates.ByNormal[2] };
  const Lanes h = -at.Rates.ByHeight, u = DotWith(s.U, moved), v = DotWith(s.V, moved);
  return { { h, h * at.U + u, h * at.V + v, h * (at.U * at.U + 1.0 / 12.0) + 2.0 * at.U * u,
    h * at.U * at.V + at.V * u + at.U * v, h * (at.V * at.V + 1.0 / 12.0) + 2.0 * at.V * v } };
}

} // namespace vfm
