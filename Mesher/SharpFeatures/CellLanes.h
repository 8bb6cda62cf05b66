/**
 * CellLanes: fractions of a sharp-feature model in four cells at once, one per lane. Only for
 * sources with VFM_CLONES (Base/Lanes.h).
 */
#pragma once

#include "Base/Lanes.h"
#include "SharpFeatures/BoxCut.h"
#include "SharpFeatures/Compositions.h"
#include "SharpFeatures/PackedCells.h"

namespace vfm
{

/// Four cells, one per lane, in the frame of a node.
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

/// A surface in four cells: its tangent plane over their centres, in the frame of each cell
/// as a unit cube.
struct SurfaceLanes
{
  Lanes U, V;           ///< coordinates of the cell centres on the surface
  Lanes AlongU, AlongV; ///< slopes of the surface
  BoxPlaneOf<Lanes> Plane;
  Lanes Inside;              ///< share of the cell inside this plane
  PlaneRatesOf<Lanes> Rates; ///< derivatives of Inside, later of the fraction of the model
};

/// Fractions of a model in four cells.
struct ModelLanes
{
  Lanes Fraction;
  /// The first FeatureModel::Count are set.
  std::array<SurfaceLanes, FeatureModel::MaximumSurfaces> Surfaces;
  bool IsCut;    ///< whether any surface cuts any cell
  bool IsShared; ///< whether several surfaces cut one of the cells
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
  const double mean = (c[3] + c[5]) / 12.0; // mean of the quadratic term over a cell
  at.Plane.Height =
    DotWith(s.N, r) - (c[0] + mean + (c[1] + c[3] * u + c[4] * v) * u + (c[2] + c[5] * v) * v);
  at.Plane.Normal = { { cells.Width.X * (s.N[0] - at.AlongU * s.U[0] - at.AlongV * s.V[0]),
    cells.Width.Y * (s.N[1] - at.AlongU * s.U[1] - at.AlongV * s.V[1]),
    cells.Width.Z * (s.N[2] - at.AlongU * s.U[2] - at.AlongV * s.V[2]) } };
}

/// Returns the fraction in one cell that several planes cut, and adds to the rates of the planes.
/// @param in,out  bits of the planes whose inside contains the whole cell, or none of it
double FractionUnder(const Composition& composition, const std::array<BoxPlane, 3>& planes, int in,
  int out, std::array<PlaneRates, 3>& rates);

/// Sets the exact fraction and rates in one lane.
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

/// Sets fractions and rates from products of the shares inside each plane. This is exact in cells
/// that at most one plane cuts.
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

/// Sets Plane, Inside and Rates of a surface; returns the cells that it cuts.
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

/// Sets the fractions in four cells and their derivatives by each surface.
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

/// Sums for the residual of a model (FeatureFit.h).
struct ResidualSums
{
  Lanes Squares, Weights;
};

VFM_INLINE void AddErrors(
  ResidualSums& sums, const Lanes& fraction, const Lanes& data, const Lanes& allWeight)
{
  constexpr double full = 1e-6; // cells closer to 0 or 1 count as empty or full
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

/// Returns the derivatives of fractions by the coefficients of a surface, by the chain
/// rule over its plane.
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
