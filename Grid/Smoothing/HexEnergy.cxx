#include "Smoothing/HexEnergy.h"

#include "Base/Lanes.h"

namespace vfm
{
namespace
{

constexpr double SmallestDeterminant = 1e-9; // of a corner, in cell volumes
constexpr double ShortestEdge = 0.15;        // l*, in cell widths

struct BarrierWeights
{
  int HalfPower; // p / 2, a power of two
  double Target; // s*
  double Shape;  // omega
};

// Lanes 0..2: the corner at the other end of the point's edge along x, y, z. Lane 3: the point's own corner.

/// Lane 0 of a, lane 1 of b, lane 2 of c, lane 3 of d.
VFM_INLINE Lanes Diagonal(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d)
{
  return Lanes{ a[0], b[1], c[2], d[3] };
}
/// Lanes 0..2 as they are, their sum in lane 3.
VFM_INLINE Lanes WithSum(const Lanes& a)
{
  return Lanes{ a[0], a[1], a[2], a[0] + a[1] + a[2] };
}

/// The four corners of one hex that depend on the point.
struct Corners
{
  Lanes3 Q0, Q1, Q2; // outgoing edges along x, y, z of the hex
  Lanes3 C0, C1, C2; // Q1 x Q2, Q2 x Q0, Q0 x Q1
  Lanes L0, L1, L2;  // squared lengths
  Lanes D;           // determinant, positive in a valid hex
  double Sign;       // of the point's own corner: -1 where its edges form a left-handed frame
};

VFM_INLINE Corners GatherCorners(const Vector3* X, const int* hex, int corner, const double* x)
{
  const double* p1 = X[hex[corner ^ 1]].data();
  const double* p2 = X[hex[corner ^ 2]].data();
  const double* p3 = X[hex[corner ^ 3]].data();
  const double* p4 = X[hex[corner ^ 4]].data();
  const double* p5 = X[hex[corner ^ 5]].data();
  const double* p6 = X[hex[corner ^ 6]].data();
  const Lanes3 tail = Pack(p1, p2, p4, x);
  Corners c;
  c.Q0 = Minus(Pack(x, p3, p5, p1), tail);
  c.Q1 = Minus(Pack(p3, x, p6, p2), tail);
  c.Q2 = Minus(Pack(p5, p6, x, p4), tail);
  c.C0 = Cross(c.Q1, c.Q2);
  c.C1 = Cross(c.Q2, c.Q0);
  c.C2 = Cross(c.Q0, c.Q1);
  c.L0 = Dot(c.Q0, c.Q0);
  c.L1 = Dot(c.Q1, c.Q1);
  c.L2 = Dot(c.Q2, c.Q2);
  c.Sign = 0x69 >> corner & 1 ? 1.0 : -1.0; // even number of bits
  c.D = Dot(c.Q0, c.C0) * Lanes{ -c.Sign, -c.Sign, -c.Sign, c.Sign };
  return c;
}

/// Constants of the cell of a hex.
struct CellScales
{
  Lanes K0, K1, K2; // 1 / width^2
  Lanes K;          // lanes 0..2: the same, by lane
  Lanes Volume;     // 1 / volume
};

VFM_INLINE CellScales MakeScales(const Vector3& widths)
{
  const double k0 = 1.0 / (widths[0] * widths[0]), k1 = 1.0 / (widths[1] * widths[1]),
               k2 = 1.0 / (widths[2] * widths[2]);
  return { Splat(k0), Splat(k1), Splat(k2), Lanes{ k0, k1, k2, 0.0 },
    Splat(1.0 / (widths[0] * widths[1] * widths[2])) };
}

VFM_INLINE Lanes Power(Lanes a, int half)
{
  for (int p = 1; p < half; p *= 2)
  {
    a *= a;
  }
  return a;
}

/// The terms of the energy of four corners. Edge: lanes 0..2, one end of the point's three edges.
struct Terms
{
  Lanes Jacobian, Shape, Edge;
  Lanes W; // tr T^T T
  Lanes InverseD;
  Lanes3 E; // lanes 0..2: the point's edges, from their other ends
  Lanes EL; // lanes 0..2: their squared lengths; lane 3: 1
};

VFM_INLINE Terms ComputeTerms(const Corners& c, const CellScales& k, const BarrierWeights& weights)
{
  Terms t;
  t.InverseD = Splat(1.0) / c.D;
  const Lanes ratio =
    Splat(weights.Target * weights.Target) * c.L0 * c.L1 * c.L2 * (t.InverseD * t.InverseD);
  t.Jacobian = Power(ratio, weights.HalfPower);
  t.W = c.L0 * k.K0 + c.L1 * k.K1 + c.L2 * k.K2;
  const Lanes third = t.W * Splat(1.0 / 3.0);
  t.Shape = Splat(weights.Shape) * third * SquareRoot(third) * (t.InverseD / k.Volume);
  const Lanes zero = Splat(0.0), one = Splat(1.0);
  t.E = { Diagonal(c.Q0.X, c.Q1.X, c.Q2.X, zero), Diagonal(c.Q0.Y, c.Q1.Y, c.Q2.Y, zero),
    Diagonal(c.Q0.Z, c.Q1.Z, c.Q2.Z, zero) };
  t.EL = Diagonal(c.L0, c.L1, c.L2, one);
  const Lanes shortness =
    Splat(ShortestEdge * ShortestEdge) / (t.EL * k.K + Lanes{ 0.0, 0.0, 0.0, 1.0 });
  const Lanes square = shortness * shortness;
  t.Edge = square * square * Lanes{ 1.0, 1.0, 1.0, 0.0 };
  return t;
}

VFM_INLINE bool AllPositive(const Corners& c, const CellScales& k)
{
  const Mask bad = c.D * k.Volume <= Splat(SmallestDeterminant);
  return !(bad[0] | bad[1] | bad[2] | bad[3]);
}

/// Adds value, gradient and Hessian of the energy of the four corners.
///   log(1/SJ):  gradient A - C, Hessian sum_e (I - 2 e e^T / l) / l + C C^T
///   log(shape): gradient B - C, Hessian 3 k_e I / W - (2/3) B B^T + C C^T
/// with e the edges that move, A = sum e / l, B = 1.5 grad W / W, C = grad D / D.
VFM_INLINE void AddDerivatives(
  Accumulator& sum, const Corners& c, const CellScales& k, const BarrierWeights& weights)
{
  const Terms t = ComputeTerms(c, k, weights);
  const Lanes inverseL = Splat(1.0) / t.EL;
  const Lanes inverseW = Splat(1.0) / t.W;
  const Lanes3 a0 = Times(inverseL, t.E);
  const Lanes3 A{ WithSum(a0.X), WithSum(a0.Y), WithSum(a0.Z) };
  const Lanes3 b0 = Times(k.K, t.E);
  const Lanes3 B = Times(Splat(3.0) * inverseW, { WithSum(b0.X), WithSum(b0.Y), WithSum(b0.Z) });
  const Lanes scale = Splat(-c.Sign) * t.InverseD;
  const Lanes3 C{ scale * Diagonal(c.C0.X, c.C1.X, c.C2.X, c.C0.X + c.C1.X + c.C2.X),
    scale * Diagonal(c.C0.Y, c.C1.Y, c.C2.Y, c.C0.Y + c.C1.Y + c.C2.Y),
    scale * Diagonal(c.C0.Z, c.C1.Z, c.C2.Z, c.C0.Z + c.C1.Z + c.C2.Z) };
  const Lanes3 AC = Minus(A, C), BC = Minus(B, C);

  const double p = 2.0 * weights.HalfPower;
  const Lanes f = Splat(p) * t.Jacobian;
  sum.Value += t.Jacobian + t.Shape + t.Edge + t.Edge;
  AddGradient(sum, f, AC);
  AddGradient(sum, t.Shape, BC);
  AddOuter(sum, Splat(p) * f, AC);
  AddOuter(sum, t.Shape, BC);
  AddOuter(sum, f + t.Shape, C);
  AddOuter(sum, Splat(-2.0 / 3.0) * t.Shape, B);

  // what belongs to an edge itself: its part in lane 3 and in its own lane are equal but for the weight
  const Lanes fEdge = f + Splat(f[3]);
  const Lanes edge = Splat(2.0) * t.Edge; // both ends
  AddGradient(sum, Splat(-8.0) * edge * inverseL, t.E);
  const Lanes unit = Lanes{ 1.0, 1.0, 1.0, 0.0 } *
    (fEdge * inverseL - Splat(8.0) * edge * inverseL +
      Splat(3.0) * k.K * (t.Shape * inverseW + Splat(t.Shape[3] * inverseW[3])));
  AddOuter(sum, (Splat(80.0) * edge - Splat(2.0) * fEdge) * inverseL * inverseL, t.E);
  sum.XX += unit;
  sum.YY += unit;
  sum.ZZ += unit;
}

/// The corners of the hex at a position of the corner list, as the point at x sees them.
VFM_INLINE Corners GatherAt(const ActiveMesh& mesh, Index position, const Vector3& x)
{
  return GatherCorners(mesh.X.data(), mesh.Elements.data() + (position & ~7),
    static_cast<int>(position & 7), x.data());
}

/// What is asked of the hex at a position of the corner list.
VFM_INLINE BarrierWeights WeightsAt(
  const ActiveMesh& mesh, Index position, const BarrierWeights& weights)
{
  return { weights.HalfPower, mesh.DemandAt(position) * weights.Target, weights.Shape };
}

VFM_CLONES
double EvaluateBarrier(
  const ActiveMesh& mesh, int point, const Vector3& x, const BarrierWeights& weights)
{
  Lanes sum = Splat(0.0);
  for (Index at = mesh.CornerOffset[point]; at < mesh.CornerOffset[point + 1]; ++at)
  {
    const Index position = mesh.CornerList[at];
    const Corners c = GatherAt(mesh, position, x);
    const CellScales k = MakeScales(mesh.WidthsAt(position));
    if (!AllPositive(c, k))
    {
      return InvalidEnergy;
    }
    const Terms t = ComputeTerms(c, k, WeightsAt(mesh, position, weights));
    sum += t.Jacobian + t.Shape + t.Edge + t.Edge;
  }
  return Sum(sum);
}

VFM_CLONES
Derivatives DifferentiateBarrier(const ActiveMesh& mesh, int point, const BarrierWeights& weights)
{
  Accumulator sum{};
  for (Index at = mesh.CornerOffset[point]; at < mesh.CornerOffset[point + 1]; ++at)
  {
    const Index position = mesh.CornerList[at];
    AddDerivatives(sum, GatherAt(mesh, position, mesh.X[point]),
      MakeScales(mesh.WidthsAt(position)), WeightsAt(mesh, position, weights));
  }
  Derivatives d;
  d.Value = Sum(sum.Value);
  d.Gradient = { { Sum(sum.GX), Sum(sum.GY), Sum(sum.GZ) } };
  d.Hessian = { { Sum(sum.XX), Sum(sum.YY), Sum(sum.ZZ), Sum(sum.XY), Sum(sum.XZ), Sum(sum.YZ) } };
  return d;
}

} // namespace

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
