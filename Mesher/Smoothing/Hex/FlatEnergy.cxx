#include "Smoothing/Hex/FlatEnergy.h"

#include "Base/Clones.h"

#include <atomic>
#include <bit>

namespace vfm
{
namespace
{

constexpr double SmallestDeterminant = 1e-9; // smallest determinant of a corner, in cell areas
// Smallest determinants, in cell areas, of all quads and of those of which only some points went
// back.
constexpr double LeastOfQuads = 1e-6, LeastOfMixed = 0.01;
constexpr double ShortestEdge = 0.15; // l*, in cell widths

/// A vector of the plane.
struct Flat
{
  double U, V;
};

Flat operator-(const Flat& a, const Flat& b)
{
  return { a.U - b.U, a.V - b.V };
}

double Dot(const Flat& a, const Flat& b)
{
  return a.U * b.U + a.V * b.V;
}

double Cross(const Flat& a, const Flat& b)
{
  return a.U * b.V - a.V * b.U;
}

/// The axes of the plane, so that they and the axis of the columns are right-handed.
struct Plane
{
  explicit Plane(int axis) : Axis(axis), U((axis + 1) % 3), V((axis + 2) % 3) {}
  Flat At(const Vector3& x) const { return { x[this->U], x[this->V] }; }
  int Axis, U, V;
};

/// A quad at a point: its edges from the point along U and V, and its diagonal.
struct QuadAtPoint
{
  Flat Arm[2], Diagonal;
  double Sign;     ///< of the determinant of the arms
  double Scale[2]; ///< 1 / width^2 of the cell
  double Edge[2];  ///< (l* width)^2
  double Area;     ///< of the cell
  double Target;   ///< s*^2
};

/// Calls visit(quad) for the quads at a point that would be at x.
template <class Visit>
VFM_INLINE void ForQuads(const ActiveMesh& mesh, const Plane& plane, int point, const Vector3& x,
  double target, const Visit& visit)
{
  const Flat here = plane.At(x);
  for (CornerPosition at = mesh.CornerOffset[point]; at < mesh.CornerOffset[point + 1]; ++at)
  {
    const CornerPosition position = mesh.CornerList[at];
    const int corner = position & 7, u = 1 << plane.U, v = 1 << plane.V;
    const int* points = mesh.Elements.data() + (position & ~CornerPosition(7));
    const auto to = [&](int other) { return plane.At(mesh.X[points[other]]) - here; };
    const Vector3& widths = mesh.WidthsAt(position);
    const double wide = widths[plane.U], high = widths[plane.V];
    const double demand = mesh.DemandAt(position);
    visit(QuadAtPoint{ { to(corner ^ u), to(corner ^ v) }, to(corner ^ u ^ v),
      std::popcount(static_cast<unsigned>(corner)) % 2 == 0 ? 1.0 : -1.0,
      { 1.0 / (wide * wide), 1.0 / (high * high) },
      { ShortestEdge * wide * ShortestEdge * wide, ShortestEdge * high * ShortestEdge * high },
      wide * high, target * target * demand * demand });
  }
}

/// A corner of a quad as a function of the point.
struct Corner
{
  Flat Arm[2]; ///< from the point to the far ends of the edges that move with it; else 0
  double L[2]; ///< squared lengths of the edges along U and V
  double D;    ///< determinant
  Flat GradD;  ///< its gradient
  bool Moves[2];
};

VFM_INLINE Corner OwnCorner(const QuadAtPoint& q)
{
  const Flat &a = q.Arm[0], &b = q.Arm[1];
  return { { a, b }, { Dot(a, a), Dot(b, b) }, q.Sign * Cross(a, b),
    { q.Sign * (a.V - b.V), q.Sign * (b.U - a.U) }, { true, true } };
}

/// Returns the corner at the far end of arm k.
VFM_INLINE Corner EndCorner(const QuadAtPoint& q, int k)
{
  const Flat& arm = q.Arm[k];
  const Flat side = q.Diagonal - arm;
  const double sign = k == 0 ? q.Sign : -q.Sign;
  Corner c{};
  c.Arm[k] = arm;
  c.Moves[k] = true;
  c.L[k] = Dot(arm, arm);
  c.L[1 - k] = Dot(side, side);
  c.D = sign * Cross(arm, side);
  c.GradD = { -sign * side.V, sign * side.U };
  return c;
}

VFM_INLINE double Power(double a, int half)
{
  for (int p = 1; p < half; p *= 2)
  {
    a *= a;
  }
  return a;
}

struct Terms
{
  double Jacobian, Shape;
};

VFM_INLINE Terms ComputeTerms(const Corner& c, const QuadAtPoint& q, const SmoothingStage& stage)
{
  const double inverse = 1.0 / c.D;
  return { Power(q.Target * c.L[0] * c.L[1] * (inverse * inverse), stage.HalfPower),
    stage.Omega * 0.5 * q.Area * (c.L[0] * q.Scale[0] + c.L[1] * q.Scale[1]) * inverse };
}

/// Returns the edge terms of both ends of arm k.
VFM_INLINE double ComputeEdge(const QuadAtPoint& q, double length, int k)
{
  const double shortness = q.Edge[k] / length, square = shortness * shortness;
  return 2.0 * square * square;
}

/// Sums of derivatives.
struct Sums
{
  double Value = 0.0, U = 0.0, V = 0.0, UU = 0.0, VV = 0.0, UV = 0.0, Steepest = 0.0;

  VFM_INLINE void AddOuter(double factor, const Flat& a)
  {
    this->UU += factor * a.U * a.U;
    this->VV += factor * a.V * a.V;
    this->UV += factor * a.U * a.V;
  }
  /// Adds a term E of which ln E has this gradient; its Hessian, except for a multiple of 1 and
  /// outer products that the caller adds, is E g g^T.
  VFM_INLINE void AddTerm(double e, const Flat& g, double unit)
  {
    this->U += e * g.U;
    this->V += e * g.V;
    this->AddOuter(e, g);
    this->UU += e * unit;
    this->VV += e * unit;
  }
};

// ln J = m (ln l0 + ln l1 - 2 ln D), ln S = ln W - ln D; grad l = -2 arm, grad^2 l = 2.
VFM_INLINE void AddCorner(
  const Corner& c, const QuadAtPoint& q, const SmoothingStage& stage, Sums& sums)
{
  const Terms t = ComputeTerms(c, q, stage);
  const double m = stage.HalfPower, inverse = 1.0 / c.D;
  const Flat n{ inverse * c.GradD.U, inverse * c.GradD.V };
  const double w = c.L[0] * q.Scale[0] + c.L[1] * q.Scale[1];
  Flat jacobian{ -2.0 * m * n.U, -2.0 * m * n.V }, gradW{ 0.0, 0.0 };
  double unitJ = 0.0, unitS = 0.0;
  for (int k = 0; k < 2; ++k)
  {
    if (c.Moves[k])
    {
      const double per = 2.0 / c.L[k];
      jacobian = jacobian - Flat{ m * per * c.Arm[k].U, m * per * c.Arm[k].V };
      unitJ += m * per;
      sums.AddOuter(-t.Jacobian * m * per * per, c.Arm[k]);
      const double scale = 2.0 * q.Scale[k] / w;
      gradW = gradW - Flat{ scale * c.Arm[k].U, scale * c.Arm[k].V };
      unitS += scale;
    }
  }
  sums.Value += t.Jacobian + t.Shape;
  sums.AddTerm(t.Jacobian, jacobian, unitJ);
  sums.AddOuter(2.0 * m * t.Jacobian, n);
  sums.AddTerm(t.Shape, gradW - n, unitS);
  sums.AddOuter(-t.Shape, gradW);
  sums.AddOuter(t.Shape, n);
  sums.Steepest = std::max(sums.Steepest, Dot(n, n));
}

VFM_INLINE void AddEdge(const QuadAtPoint& q, int k, Sums& sums)
{
  const double length = Dot(q.Arm[k], q.Arm[k]), e = ComputeEdge(q, length, k);
  const double per = 8.0 / length;
  sums.Value += e;
  sums.U += e * per * q.Arm[k].U;
  sums.V += e * per * q.Arm[k].V;
  sums.AddOuter(e * 80.0 / (length * length), q.Arm[k]);
  sums.UU -= e * per;
  sums.VV -= e * per;
}

VFM_CLONES
double EvaluateQuads(const ActiveMesh& mesh, const Plane& plane, int point, const Vector3& x,
  double target, const SmoothingStage& stage)
{
  double value = 0.0;
  bool isValid = true;
  ForQuads(mesh, plane, point, x, target,
    [&](const QuadAtPoint& q)
    {
      for (const Corner& c : { OwnCorner(q), EndCorner(q, 0), EndCorner(q, 1) })
      {
        isValid = isValid && c.D > SmallestDeterminant * q.Area;
        const Terms t = ComputeTerms(c, q, stage);
        value += t.Jacobian + t.Shape;
      }
      for (int k = 0; k < 2; ++k)
      {
        value += ComputeEdge(q, Dot(q.Arm[k], q.Arm[k]), k);
      }
    });
  return isValid ? value : InvalidEnergy;
}

VFM_CLONES
Sums DifferentiateQuads(
  const ActiveMesh& mesh, const Plane& plane, int point, double target, const SmoothingStage& stage)
{
  Sums sums;
  ForQuads(mesh, plane, point, mesh.X[point], target,
    [&](const QuadAtPoint& q)
    {
      AddCorner(OwnCorner(q), q, stage, sums);
      for (int k = 0; k < 2; ++k)
      {
        AddCorner(EndCorner(q, k), q, stage, sums);
        AddEdge(q, k, sums);
      }
    });
  return sums;
}

/// Returns the smallest determinant of the quads at a point that depends on it, in cell areas.
VFM_INLINE double SmallestAt(
  const ActiveMesh& mesh, const Plane& plane, int point, const Vector3& x)
{
  double smallest = std::numeric_limits<double>::infinity();
  ForQuads(mesh, plane, point, x, 1.0,
    [&](const QuadAtPoint& q)
    {
      for (const Corner& c : { OwnCorner(q), EndCorner(q, 0), EndCorner(q, 1) })
      {
        smallest = std::min(smallest, c.D / q.Area);
      }
    });
  return smallest;
}

/// Returns the smallest determinant of the quad below a hex, in cell areas.
/// @param first  position of the hex
double SmallestOfQuad(const ActiveMesh& mesh, const Plane& plane, Index first)
{
  const int u = 1 << plane.U, v = 1 << plane.V;
  const int* points = mesh.Elements.data() + first;
  const Flat x[4] = { plane.At(mesh.X[points[0]]), plane.At(mesh.X[points[u]]),
    plane.At(mesh.X[points[u ^ v]]), plane.At(mesh.X[points[v]]) };
  const Vector3& widths = mesh.WidthsAt(static_cast<CornerPosition>(first));
  double smallest = std::numeric_limits<double>::infinity();
  for (int c = 0; c < 4; ++c)
  {
    smallest = std::min(smallest, Cross(x[(c + 1) % 4] - x[c], x[(c + 3) % 4] - x[c]));
  }
  return smallest / (widths[plane.U] * widths[plane.V]);
}

/// Returns whether some lower active points of a hex went back, but not all.
bool IsMixed(const ActiveMesh& mesh, const std::vector<unsigned char>& returned, Index first)
{
  bool isAny = false, areAll = true;
  for (int c = 0; c < 8; ++c)
  {
    const int point = mesh.Elements[first + c];
    isAny |= mesh.IsActive[point] && returned[point];
    areAll &= returned[point] || !mesh.IsActive[point];
  }
  return isAny && !areAll;
}

} // namespace

double FlatEnergy::Evaluate(
  const ActiveMesh& mesh, int point, const Vector3& x, const SmoothingStage& stage) const
{
  return EvaluateQuads(mesh, Plane(this->Axis), point, x, this->Target, stage);
}

Derivatives FlatEnergy::Differentiate(
  const ActiveMesh& mesh, int point, const SmoothingStage& stage) const
{
  const Plane plane(this->Axis);
  const Sums sums = DifferentiateQuads(mesh, plane, point, this->Target, stage);
  Derivatives d;
  d.Value = sums.Value;
  d.Gradient[plane.U] = sums.U;
  d.Gradient[plane.V] = sums.V;
  d.Hessian[plane.U] = sums.UU;
  d.Hessian[plane.V] = sums.VV;
  d.Hessian[plane.Axis] = 1.0;
  d.Hessian[plane.Axis == 2 ? 3 : plane.Axis == 1 ? 4 : 5] = sums.UV;
  d.Steepness = std::sqrt(sums.Steepest);
  return d;
}

bool FlatEnergy::MarkLost(const ActiveMesh& mesh, Runtime& runtime,
  const std::vector<unsigned char>& returned, std::vector<unsigned char>& points) const
{
  const Plane plane(this->Axis);
  std::atomic<bool> isFound(false);
  ForEach(runtime, static_cast<Index>(mesh.Elements.size() / 8),
    [&](Index hex)
    {
      const Index first = 8 * hex;
      const bool isMixed = !returned.empty() && IsMixed(mesh, returned, first);
      if (!(SmallestOfQuad(mesh, plane, first) > (isMixed ? LeastOfMixed : LeastOfQuads)))
      {
        for (int c = 0; c < 8; ++c)
        {
          __atomic_store_n(&points[mesh.Elements[first + c]], 1, __ATOMIC_RELAXED);
        }
        isFound = true;
      }
    });
  return isFound;
}

bool FlatEnergy::KeepsAt(const ActiveMesh& mesh, int point, const Vector3& x) const
{
  const Plane plane(this->Axis);
  const double then = SmallestAt(mesh, plane, point, x);
  return then > LeastOfQuads || then >= SmallestAt(mesh, plane, point, mesh.X[point]);
}

} // namespace vfm
