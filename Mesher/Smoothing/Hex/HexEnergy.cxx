#include "Smoothing/Hex/HexEnergy.h"

#include "Smoothing/HexesAtPoint.h"

namespace vfm
{
namespace
{

constexpr double SmallestDeterminant = 1e-9; // smallest determinant of a corner, in cell volumes
// Limits of float precision. Within them, rounding errors are far below the gain of a step.
constexpr float SmallestInFloat = 1e-2f;
constexpr double LargestInFloat = 1e4;

constexpr int Next[3] = { 1, 2, 0 };
constexpr int Previous[3] = { 2, 0, 1 };

/// One corner per hex that depends on the point.
template <class Real>
struct Corner
{
  using L = LanesOf<Real>;
  VectorLanes<Real> Normal; // minus the gradient of D
  L D;                      // determinant, positive in a valid hex
  L Lengths;                // product of the squared lengths of its edges
  L W;                      // tr T^T T
};

/// Squared lengths of the arms.
template <class Real>
struct ArmLengths
{
  LanesOf<Real> Of[3];
};

template <class Real>
VFM_INLINE ArmLengths<Real> MeasureArms(const Hexes<Real>& h)
{
  return { { Dot(h.Arm[0], h.Arm[0]), Dot(h.Arm[1], h.Arm[1]), Dot(h.Arm[2], h.Arm[2]) } };
}

/// Returns the corner at the far end of arm k.
template <class Real>
VFM_INLINE Corner<Real> EndCorner(const Hexes<Real>& h, const ArmLengths<Real>& l, int k)
{
  const VectorLanes<Real> a = h.Diagonal[k] - h.Arm[k], b = h.Diagonal[Previous[k]] - h.Arm[k];
  const LanesOf<Real> aa = Dot(a, a), bb = Dot(b, b);
  Corner<Real> c;
  c.Normal = Cross(a, b);
  c.D = Dot(h.Arm[k], c.Normal);
  c.Lengths = l.Of[k] * aa * bb;
  c.W = l.Of[k] * h.Scale[k] + aa * h.Scale[Next[k]] + bb * h.Scale[Previous[k]];
  return c;
}

template <class Real>
VFM_INLINE Corner<Real> OwnCorner(const Hexes<Real>& h, const ArmLengths<Real>& l)
{
  Corner<Real> c;
  c.Normal = Cross(h.Arm[1] - h.Arm[0], h.Arm[2] - h.Arm[0]);
  c.D = Dot(h.Arm[0], c.Normal);
  c.Lengths = l.Of[0] * l.Of[1] * l.Of[2];
  c.W = l.Of[0] * h.Scale[0] + l.Of[1] * h.Scale[1] + l.Of[2] * h.Scale[2];
  return c;
}

template <class L>
VFM_INLINE L Power(L a, int half)
{
  for (int p = 1; p < half; p *= 2)
  {
    a *= a;
  }
  return a;
}

/// Terms of the energy at a corner.
template <class Real>
struct Terms
{
  LanesOf<Real> Jacobian, Shape, InverseD;
};

template <class Real>
VFM_INLINE Terms<Real> ComputeTerms(const Corner<Real>& c, const Hexes<Real>& h, int halfPower)
{
  Terms<Real> t;
  t.InverseD = Real(1.0) / c.D;
  t.Jacobian = Power(h.Target * c.Lengths * (t.InverseD * t.InverseD), halfPower);
  const LanesOf<Real> third = c.W * Real(1.0 / 3.0);
  t.Shape = h.Shape * third * SquareRoot(third) * t.InverseD;
  return t;
}

/// Returns the edge terms of both ends of arm k.
template <class Real>
VFM_INLINE LanesOf<Real> ComputeEdge(
  const Hexes<Real>& h, const LanesOf<Real>& inverseLength, int k)
{
  const LanesOf<Real> shortness = h.Edge[k] * inverseLength;
  const LanesOf<Real> square = shortness * shortness;
  return Real(2.0) * square * square;
}

/// Sum over hexes, the smallest determinant of their corners in cell volumes, and the largest
/// squared gradient of the logarithm of a determinant, if derivatives are computed.
template <class Real>
struct Barrier
{
  LanesOf<Real> Value, Least, Steepest;
};

template <class Real>
VFM_INLINE void AddValue(Barrier<Real>& sum, const Hexes<Real>& h, int halfPower)
{
  const ArmLengths<Real> l = MeasureArms(h);
  const Corner<Real> own = OwnCorner(h, l);
  LanesOf<Real> least = own.D;
  Terms<Real> t = ComputeTerms(own, h, halfPower);
  sum.Value += t.Jacobian + t.Shape;
  for (int k = 0; k < 3; ++k)
  {
    const Corner<Real> c = EndCorner(h, l, k);
    least = Least(least, c.D);
    t = ComputeTerms(c, h, halfPower);
    sum.Value += t.Jacobian + t.Shape + ComputeEdge(h, Real(1.0) / l.Of[k], k);
  }
  sum.Least = Least(sum.Least, least * h.InverseVolume);
}

// Derivatives of the logarithms of the terms of a corner, with e the edges that move:
//   1/SJ:  gradient A - C, Hessian sum_e (I - 2 e e^T / l) / l + C C^T
//   shape: gradient B - C, Hessian 3 k_e I / W - (2/3) B B^T + C C^T
//   A = sum e / l, B = 1.5 grad W / W, C = grad D / D = -n, n = Normal / D

/// Adds the derivatives at the point's own corner, except for the parts that depend on one
/// arm only.
/// @param beta  3 k / W of each arm
template <class Real>
VFM_INLINE void AddOwnCorner(DerivativeSums<Real>& d, const Hexes<Real>& h, const Corner<Real>& own,
  const Terms<Real>& t, const LanesOf<Real> (&inverse)[3], const LanesOf<Real> (&beta)[3], Real p)
{
  using V = VectorLanes<Real>;
  const LanesOf<Real> f = p * t.Jacobian;
  const V n = Times<Real>(t.InverseD, own.Normal);
  const V a = Times<Real>(inverse[0], h.Arm[0]) + Times<Real>(inverse[1], h.Arm[1]) +
    Times<Real>(inverse[2], h.Arm[2]);
  const V b = Times<Real>(beta[0], h.Arm[0]) + Times<Real>(beta[1], h.Arm[1]) +
    Times<Real>(beta[2], h.Arm[2]);
  d.Gradient = d.Gradient + Times<Real>(f + t.Shape, n);
  const V pfa = Times<Real>(p * f, a);
  const V mixed =
    Times<Real>(Real(0.5) * (p + Real(1.0)) * f + t.Shape, n) - pfa - Times<Real>(t.Shape, b);
  d.AddOuter(n, mixed, mixed, n);
  d.AddOuter(pfa, a, Times<Real>(t.Shape * Real(1.0 / 3.0), b), b);
}

/// Adds value, gradient and Hessian. At the far end of an arm, A and B are along the arm, so three
/// coefficients of products of the arm and n represent the Hessian.
template <class Real>
VFM_INLINE void AddDerivatives(
  Barrier<Real>& sum, DerivativeSums<Real>& d, const Hexes<Real>& h, int halfPower)
{
  using L = LanesOf<Real>;
  const Real p = Real(2 * halfPower);
  const ArmLengths<Real> l = MeasureArms(h);
  const Corner<Real> own = OwnCorner(h, l);
  const Terms<Real> t = ComputeTerms(own, h, halfPower);
  const L f = p * t.Jacobian, overW = Real(3.0) / own.W;
  const L inverse[3] = { Real(1.0) / l.Of[0], Real(1.0) / l.Of[1], Real(1.0) / l.Of[2] };
  const L ownBeta[3] = { overW * h.Scale[0], overW * h.Scale[1], overW * h.Scale[2] };
  AddOwnCorner(d, h, own, t, inverse, ownBeta, p);
  sum.Value += t.Jacobian + t.Shape;
  const VectorLanes<Real> ownN = Times<Real>(t.InverseD, own.Normal);
  sum.Steepest = Greatest(sum.Steepest, Dot(ownN, ownN));
  L least = own.D, unit = Fill<Real>(0.0);
  for (int k = 0; k < 3; ++k)
  {
    const Corner<Real> end = EndCorner(h, l, k);
    const Terms<Real> e = ComputeTerms(end, h, halfPower);
    const L edge = ComputeEdge(h, inverse[k], k), g = p * e.Jacobian;
    const L alpha = inverse[k], beta = Real(3.0) * h.Scale[k] / end.W;
    const VectorLanes<Real> n = Times<Real>(e.InverseD, end.Normal);
    sum.Value += e.Jacobian + e.Shape + edge;
    least = Least(least, end.D);
    sum.Steepest = Greatest(sum.Steepest, Dot(n, n));
    const L along = (f + g - Real(8.0) * edge) * alpha + t.Shape * ownBeta[k] + e.Shape * beta;
    unit += along;
    d.Gradient = d.Gradient + Times<Real>(g + e.Shape, n) - Times<Real>(along, h.Arm[k]);
    const L ee = ((p - Real(2.0)) * g - Real(2.0) * f + Real(80.0) * edge) * alpha * alpha +
      Real(1.0 / 3.0) * e.Shape * beta * beta;
    const L en = p * g * alpha + e.Shape * beta;
    const L nn = (p + Real(1.0)) * g + Real(2.0) * e.Shape;
    d.AddOuter(h.Arm[k], Times<Real>(ee, h.Arm[k]) - Times<Real>(en, n), n,
      Times<Real>(nn, n) - Times<Real>(en, h.Arm[k]));
  }
  d.XX += unit;
  d.YY += unit;
  d.ZZ += unit;
  sum.Least = Least(sum.Least, least * h.InverseVolume);
}

template <class Real>
VFM_INLINE Barrier<Real> NoBarrier()
{
  return { Fill<Real>(0.0), Fill<Real>(1e30), Fill<Real>(0.0) };
}

template <class L>
VFM_INLINE bool AllExceed(const L& a, double bound)
{
  bool exceed = true;
  for (std::size_t i = 0; i < sizeof(L) / sizeof(a[0]); ++i)
  {
    exceed &= a[i] > bound;
  }
  return exceed;
}

VFM_INLINE bool IsSafe(const Barrier<float>& b, double value)
{
  return AllExceed(b.Least, SmallestInFloat) && value < LargestInFloat;
}

template <class Real>
VFM_INLINE Barrier<Real> SumValues(
  const ActiveMesh& mesh, int point, const Vector3& x, const BarrierWeights& weights)
{
  Barrier<Real> sum = NoBarrier<Real>();
  const HexesAtPoint<Real> hexes(mesh, point, x);
  for (int hex = 0; hex < hexes.Count(); hex += ElementLanes<Real>::Count)
  {
    AddValue(sum, hexes.Get(hex, weights), weights.HalfPower);
  }
  return sum;
}

template <class Real>
VFM_INLINE Barrier<Real> SumDerivatives(
  const ActiveMesh& mesh, int point, const BarrierWeights& weights, Derivatives& result)
{
  Barrier<Real> sum = NoBarrier<Real>();
  DerivativeSums<Real> d{};
  const HexesAtPoint<Real> hexes(mesh, point, mesh.X[point]);
  for (int hex = 0; hex < hexes.Count(); hex += ElementLanes<Real>::Count)
  {
    AddDerivatives(sum, d, hexes.Get(hex, weights), weights.HalfPower);
  }
  result.Value = Sum(sum.Value);
  result.Gradient = { { Sum(d.Gradient.X), Sum(d.Gradient.Y), Sum(d.Gradient.Z) } };
  result.Hessian = { { Sum(d.XX), Sum(d.YY), Sum(d.ZZ), Sum(d.XY), Sum(d.XZ), Sum(d.YZ) } };
  result.Steepness = std::sqrt(GreatestLane(sum.Steepest));
  return sum;
}

VFM_CLONES
double EvaluateBarrier(
  const ActiveMesh& mesh, int point, const Vector3& x, const BarrierWeights& weights)
{
  const Barrier<float> coarse = SumValues<float>(mesh, point, x, weights);
  const double value = Sum(coarse.Value);
  if (IsSafe(coarse, value))
  {
    return value;
  }
  if (!AllExceed(coarse.Least, -SmallestInFloat))
  {
    return InvalidEnergy;
  }
  const Barrier<double> fine = SumValues<double>(mesh, point, x, weights);
  return AllExceed(fine.Least, SmallestDeterminant) ? Sum(fine.Value) : InvalidEnergy;
}

VFM_CLONES
Derivatives DifferentiateBarrier(const ActiveMesh& mesh, int point, const BarrierWeights& weights)
{
  Derivatives d;
  const Barrier<float> coarse = SumDerivatives<float>(mesh, point, weights, d);
  if (!IsSafe(coarse, d.Value))
  {
    SumDerivatives<double>(mesh, point, weights, d);
  }
  return d;
}

} // namespace

double TargetJacobian(const MeshSettings& options, int materials)
{
  const bool several = materials > 1 || options.MeshVoid;
  return options.TargetScaledJacobian > 0.0 ? options.TargetScaledJacobian : (several ? 0.5 : 0.55);
}

const SmoothingRamp& HexRamp()
{
  static const SmoothingPace early{ 1.8, 4.0, 0.0, 2e-4, 5e-3 }, late{ 1.7, 4.0, 0.0, 2e-4, 4e-3 };
  static const SmoothingRamp ramp{ { 2, 10.0, 0.05, 8, 0.0, early, 2 },
    { 8, 60.0, 0.01, 30, 2e-3, late } };
  return ramp;
}

double HexEnergy::Evaluate(
  const ActiveMesh& mesh, int point, const Vector3& x, const SmoothingStage& stage) const
{
  return EvaluateBarrier(mesh, point, x, { stage.HalfPower, this->Target, stage.Omega });
}

Derivatives HexEnergy::Differentiate(
  const ActiveMesh& mesh, int point, const SmoothingStage& stage) const
{
  return DifferentiateBarrier(mesh, point, { stage.HalfPower, this->Target, stage.Omega });
}

} // namespace vfm
