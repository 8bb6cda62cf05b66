/**
 * TetTerms: the SIMD kernel of TetEnergy, its terms and their derivatives in floats or doubles.
 * Only sources with VFM_CLONES (Base/Lanes.h) include it.
 */
#pragma once

#include "Base/Lanes.h"
#include "Smoothing/Tet/TetEnergy.h"

#include <algorithm>

namespace vfm
{
namespace tetterms
{

constexpr int Next[3] = { 1, 2, 0 };
constexpr int Previous[3] = { 2, 0, 1 };

/// Tets in widths of their cells. Corners 0, 1, 2 follow the moving point in positive order.
template <class Real>
struct Tets
{
  // k: from the moving point to corner k. 3 + k: the opposite edge, from corner k + 1 to k + 2.
  VectorLanes<Real> Edge[6];
  // k: normal of the face without corner k, inwards. 3: normal of the face without the moving
  // point, outwards.
  VectorLanes<Real> Normal[4];
  LanesOf<Real> Length[6]; // squared: l^2
  LanesOf<Real> Area[4];   // squared: N^2
  LanesOf<Real> D;
};

/// Returns tets from the vectors to their other corners.
/// @param a,b,c  vectors from the moving point to corners 0, 1, 2, in cell widths
template <class Real>
VFM_INLINE Tets<Real> MakeTets(
  const VectorLanes<Real>& a, const VectorLanes<Real>& b, const VectorLanes<Real>& c)
{
  Tets<Real> t;
  t.Edge[0] = a;
  t.Edge[1] = b;
  t.Edge[2] = c;
  for (int k = 0; k < 3; ++k)
  {
    t.Edge[3 + k] = t.Edge[Previous[k]] - t.Edge[Next[k]];
    t.Normal[k] = Cross(t.Edge[Next[k]], t.Edge[Previous[k]]);
  }
  t.Normal[3] = Cross(t.Edge[4], t.Edge[5]);
  for (int e = 0; e < 6; ++e)
  {
    t.Length[e] = Dot(t.Edge[e], t.Edge[e]);
  }
  for (int f = 0; f < 4; ++f)
  {
    t.Area[f] = Dot(t.Normal[f], t.Normal[f]);
  }
  t.D = Dot(t.Edge[0], t.Normal[0]);
  return t;
}

/// Factors of the terms; 0 in unused lanes.
template <class Real>
struct Factors
{
  LanesOf<Real> Acute, Obtuse; // s*^2
  LanesOf<Real> MeanRatio;     // m*^3 / 432
  LanesOf<Real> Omega;         // omega / 432
  LanesOf<Real> ShortestEdge;  // l*^2
  int HalfPower;               // p / 2
  int ShapePower;              // q
};

template <class Real>
VFM_INLINE Factors<Real> MakeFactors(const TetQualityFloors& floors, const SmoothingStage& stage)
{
  const auto all = [](double a) { return Fill<Real>(static_cast<Real>(a)); };
  return { all(floors.Acute * floors.Acute), all(floors.Obtuse * floors.Obtuse),
    all(floors.MeanRatio * floors.MeanRatio * floors.MeanRatio / 432.0), all(stage.Omega / 432.0),
    all(floors.ShortestEdge * floors.ShortestEdge), stage.HalfPower,
    std::max(1, stage.HalfPower / 2) };
}

/// Sets the factors to 0 except in the first `count` lanes.
template <class Real>
VFM_INLINE void KeepLanes(Factors<Real>& factors, Index count)
{
  LanesOf<Real> weight;
  for (int lane = 0; lane < ElementLanes<Real>::Count; ++lane)
  {
    weight[lane] = lane < count ? Real(1.0) : Real(0.0);
  }
  factors.Acute *= weight;
  factors.Obtuse *= weight;
  factors.MeanRatio *= weight;
  factors.Omega *= weight;
  factors.ShortestEdge *= weight;
}

/// Multiplies the targets of tets, and the weight of their shape, by their demands
/// (ActiveMesh::Demands).
template <class Real>
VFM_INLINE void SetDemands(Factors<Real>& factors, const LanesOf<Real>& demands)
{
  const LanesOf<Real> square = demands * demands;
  factors.Acute *= square;
  factors.Obtuse *= square;
  factors.MeanRatio *= square * demands;
  factors.ShortestEdge *= square;
  factors.Omega *= demands;
}

/// Terms of the energy of tets.
template <class Real>
struct Terms
{
  using L = LanesOf<Real>;
  // Terms at each edge; (m* mu)^3q; omega mu^3.
  L Dihedral[6], Barrier, Shape;
  L RightAngles; // sum of s*^p, the dihedral terms at 90 degrees
  L Short[3];    // edges of the moving point
  L InverseLength[6];
  L InverseD;
  L SumOfLengths; // squared
  L Cube;         // 432 mu^3
};

template <class Real>
VFM_INLINE LanesOf<Real> EdgeTerm(const Factors<Real>& factors, const LanesOf<Real>& inverseLength)
{
  const LanesOf<Real> square = factors.ShortestEdge * inverseLength;
  const LanesOf<Real> fourth = square * square;
  return Real(0.25) * fourth * fourth;
}

template <class Real>
VFM_INLINE Terms<Real> ComputeTerms(const Tets<Real>& t, const Factors<Real>& factors)
{
  using L = LanesOf<Real>;
  const L zero{};
  Terms<Real> terms;
  terms.InverseD = Real(1.0) / t.D;
  const L inverseD2 = terms.InverseD * terms.InverseD;
  L acute = factors.Acute, obtuse = factors.Obtuse;
  decltype(acute > obtuse) isObtuse[6];
  for (int k = 0; k < 3; ++k)
  {
    const int i = Next[k], j = Previous[k];
    terms.InverseLength[k] = Real(1.0) / t.Length[k];
    terms.InverseLength[3 + k] = Real(1.0) / t.Length[3 + k];
    isObtuse[k] = Dot(t.Normal[i], t.Normal[j]) > zero;
    isObtuse[3 + k] = Dot(t.Normal[k], t.Normal[3]) < zero;
    terms.Dihedral[k] = (isObtuse[k] ? obtuse : acute) * (t.Area[i] * t.Area[j]) *
      (inverseD2 * terms.InverseLength[k]);
    terms.Dihedral[3 + k] = (isObtuse[3 + k] ? obtuse : acute) * (t.Area[k] * t.Area[3]) *
      (inverseD2 * terms.InverseLength[3 + k]);
    terms.Short[k] = EdgeTerm(factors, terms.InverseLength[k]);
  }
  for (int power = 1; power < factors.HalfPower; power *= 2)
  {
    for (int e = 0; e < 6; ++e)
    {
      terms.Dihedral[e] *= terms.Dihedral[e];
    }
    acute *= acute;
    obtuse *= obtuse;
  }
  terms.RightAngles = zero;
  for (int e = 0; e < 6; ++e)
  {
    terms.RightAngles += isObtuse[e] ? obtuse : acute;
  }
  terms.SumOfLengths =
    (t.Length[0] + t.Length[1] + t.Length[2]) + (t.Length[3] + t.Length[4] + t.Length[5]);
  terms.Cube = terms.SumOfLengths * terms.SumOfLengths * (terms.SumOfLengths * inverseD2);
  terms.Barrier = factors.MeanRatio * terms.Cube;
  for (int power = 1; power < factors.ShapePower; power *= 2)
  {
    terms.Barrier *= terms.Barrier;
  }
  terms.Shape = factors.Omega * terms.Cube;
  return terms;
}

template <class Real>
VFM_INLINE LanesOf<Real> Total(const Terms<Real>& t)
{
  return (t.Dihedral[0] + t.Dihedral[1] + t.Dihedral[2]) +
    (t.Dihedral[3] + t.Dihedral[4] + t.Dihedral[5]) - t.RightAngles + (t.Barrier + t.Shape) +
    (t.Short[0] + t.Short[1] + t.Short[2]);
}

/// Sum of gradients and Hessians.
template <class Real>
struct Sums
{
  LanesOf<Real> GX, GY, GZ, XX, YY, ZZ, XY, XZ, YZ;

  VFM_INLINE void AddOuter(const LanesOf<Real>& weight, const VectorLanes<Real>& a)
  {
    const VectorLanes<Real> wa = Times<Real>(weight, a);
    this->XX += wa.X * a.X;
    this->YY += wa.Y * a.Y;
    this->ZZ += wa.Z * a.Z;
    this->XY += wa.X * a.Y;
    this->XZ += wa.X * a.Z;
    this->YZ += wa.Y * a.Z;
  }
  VFM_INLINE void AddGradient(const LanesOf<Real>& weight, const VectorLanes<Real>& a)
  {
    this->GX += weight * a.X;
    this->GY += weight * a.Y;
    this->GZ += weight * a.Z;
  }
};

/// Adds gradient and Hessian of the energy of tets, in cell widths. Derivatives are with respect
/// to the moving point. n and e are the normal and the opposite edge of a face at it; W is the sum
/// of l^2.
///   log D:   g = grad D / D,         Hess -g g^T
///   log N^2: h = 2 n x e / N^2,      Hess 2 e^2 n n^T / N^4 - h h^T / 2
///   log l^2: c = grad l^2 / l^2,     Hess 2 / l^2 - c c^T
///   log W:   u = grad W / W,         Hess 6 / W - u u^T
/// (s* / s)^2 and mu^3 are products of these factors. A power F^r has gradient r F grad log F and
/// Hessian r F (r grad log F (grad log F)^T + Hess log F).
template <class Real>
VFM_INLINE void AddDerivatives(
  Sums<Real>& sum, const Tets<Real>& t, const Terms<Real>& terms, const Factors<Real>& factors)
{
  using L = LanesOf<Real>;
  using V = VectorLanes<Real>;
  const V g = Times<Real>(-terms.InverseD, t.Normal[3]);
  const V g2 = g + g;
  const Real p = static_cast<Real>(factors.HalfPower);
  L f[6];
  for (int e = 0; e < 6; ++e)
  {
    f[e] = p * terms.Dihedral[e];
  }
  V h[3];
  for (int k = 0; k < 3; ++k)
  {
    const L inverseArea = Real(1.0) / t.Area[k];
    h[k] = Times<Real>(Real(2.0) * inverseArea, Cross(t.Normal[k], t.Edge[3 + k]));
    const L weight = f[Next[k]] + f[Previous[k]] + f[3 + k];
    sum.AddOuter(Real(2.0) * weight * t.Length[3 + k] * (inverseArea * inverseArea), t.Normal[k]);
    sum.AddOuter(Real(-0.5) * weight, h[k]);
    const V far = h[k] - g2;
    sum.AddGradient(f[3 + k], far);
    sum.AddOuter(p * f[3 + k], far);
  }
  L unit{};
  for (int k = 0; k < 3; ++k)
  {
    const V c = Times<Real>(Real(-2.0) * terms.InverseLength[k], t.Edge[k]);
    const V near = h[Next[k]] + h[Previous[k]] - g2 - c;
    sum.AddGradient(f[k], near);
    sum.AddOuter(p * f[k], near);
    sum.AddGradient(Real(-4.0) * terms.Short[k], c);
    sum.AddOuter(f[k] + Real(20.0) * terms.Short[k], c);
    unit -= (Real(2.0) * f[k] + Real(8.0) * terms.Short[k]) * terms.InverseLength[k];
  }

  const Real q = static_cast<Real>(factors.ShapePower);
  const L inverseW = Real(1.0) / terms.SumOfLengths;
  const V u = Times<Real>(Real(-2.0) * inverseW, t.Edge[0] + t.Edge[1] + t.Edge[2]);
  const V shape = u + u + u - g2;
  const L fShape = q * terms.Barrier + terms.Shape;
  sum.AddGradient(fShape, shape);
  sum.AddOuter(q * q * terms.Barrier + terms.Shape, shape);
  sum.AddOuter(Real(-3.0) * fShape, u);
  const L all = fShape + (f[0] + f[1] + f[2]) + (f[3] + f[4] + f[5]);
  sum.AddOuter(all + all, g);
  unit += Real(18.0) * fShape * inverseW;
  sum.XX += unit;
  sum.YY += unit;
  sum.ZZ += unit;
}

} // namespace tetterms
} // namespace vfm
