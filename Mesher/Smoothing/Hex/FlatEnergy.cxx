#include "Smoothing/Hex/FlatEnergy.h"

#include "Base/Clones.h"

#include <atomic>
#include <bit>

namespace vfm
{
namespace
{

constexpr double SmallestDeterminant = 1e-9; // smallest determinant of a corner, in cell areas
// Smallest determinants, in cell areas, of all elements and of those of which only some points
// went back.
constexpr double LeastOfAll = 1e-6, LeastOfMixed = 0.01;
constexpr double ShortestEdge = 0.15; // l*, in cell widths

/// A quad or triangle at a point: its edges from the point, and the far ends of the edges that
/// follow them.
struct PartAtPoint
{
  FlatVector Arm[2], Far[2];
  double Sign;     ///< of the determinant of the arms
  double Scale[2]; ///< 1 / length^2 of each arm in the cell
  double Edge[2];  ///< (l* length)^2
  double Area;     ///< of the cell
  double Target;   ///< s*^2
};

/// Returns the part of the sine of 45 degrees that the angles of a divided cell have.
double SineOfDivided(double wide, double high)
{
  return std::sqrt(2.0 / (wide * wide + high * high)) * std::min(wide, high);
}

/// Calls visit(part) for the triangles of a divided quad that have its corner.
template <class Visit>
VFM_INLINE void ForTriangles(const PartAtPoint& quad, bool isOnDiagonal, const Visit& visit)
{
  const FlatVector &first = quad.Arm[0], &last = quad.Arm[1], &diagonal = quad.Far[0];
  PartAtPoint part = quad;
  const auto visitArms = [&](const FlatVector& a, const FlatVector& b)
  {
    part.Arm[0] = part.Far[1] = a;
    part.Arm[1] = part.Far[0] = b;
    visit(part);
  };
  if (isOnDiagonal)
  {
    visitArms(first, diagonal);
    visitArms(diagonal, last);
  }
  else
  {
    visitArms(first, last);
  }
}

/// Elements of a layer, of which the lower points are read.
struct Layer
{
  const ActiveMesh& Mesh;
  FlatPlane Plane;
  const FlatDiagonals* Diagonals; ///< null: quads
  double Target;                  ///< s*
};

/// Calls visit(part) for the elements at a point that would be at x.
template <class Visit>
VFM_INLINE void ForParts(const Layer& layer, int point, const Vector3& x, const Visit& visit)
{
  const ActiveMesh& mesh = layer.Mesh;
  const FlatPlane& plane = layer.Plane;
  const FlatVector here = plane.At(x);
  for (CornerPosition at = mesh.CornerOffset[point]; at < mesh.CornerOffset[point + 1]; ++at)
  {
    const CornerPosition position = mesh.CornerList[at];
    const int corner = position & 7, u = 1 << plane.U, v = 1 << plane.V;
    const int* points = mesh.Elements.data() + (position & ~CornerPosition(7));
    const auto to = [&](int other) { return plane.At(mesh.X[points[other]]) - here; };
    const Vector3& widths = mesh.WidthsAt(position);
    const double wide = widths[plane.U], high = widths[plane.V], area = wide * high;
    const double target = layer.Target * mesh.DemandAt(position);
    const double sign = std::popcount(static_cast<unsigned>(corner)) % 2 == 0 ? 1.0 : -1.0;
    const FlatVector far = to(corner ^ u ^ v);
    PartAtPoint quad{ { to(corner ^ u), to(corner ^ v) }, { far, far }, sign, {}, {}, area,
      target * target };
    if (!layer.Diagonals)
    {
      for (int k = 0; k < 2; ++k)
      {
        const double square = k == 0 ? wide * wide : high * high;
        quad.Scale[k] = 1.0 / square;
        quad.Edge[k] = ShortestEdge * ShortestEdge * square;
      }
      visit(quad);
      continue;
    }
    const double part = SineOfDivided(wide, high);
    quad.Target *= part * part;
    quad.Scale[0] = quad.Scale[1] = 1.0 / area;
    quad.Edge[0] = quad.Edge[1] = ShortestEdge * ShortestEdge * area;
    const bool isEven = sign > 0.0;
    ForTriangles(quad, layer.Diagonals->IsTurned(mesh.ElementAt(position)) != isEven, visit);
  }
}

/// A corner of an element as a function of the point.
struct Corner
{
  FlatVector Arm[2]; ///< from the point to the far ends of the edges that move with it; else 0
  double L[2];       ///< squared lengths of the edges along U and V
  double D;          ///< determinant
  FlatVector GradD;  ///< its gradient
  bool Moves[2];
};

VFM_INLINE Corner OwnCorner(const PartAtPoint& q)
{
  const FlatVector &a = q.Arm[0], &b = q.Arm[1];
  return { { a, b }, { Dot(a, a), Dot(b, b) }, q.Sign * Cross(a, b),
    { q.Sign * (a.V - b.V), q.Sign * (b.U - a.U) }, { true, true } };
}

/// Returns the corner at the far end of arm k.
VFM_INLINE Corner EndCorner(const PartAtPoint& q, int k)
{
  const FlatVector& arm = q.Arm[k];
  const FlatVector side = q.Far[k] - arm;
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

VFM_INLINE Terms ComputeTerms(const Corner& c, const PartAtPoint& q, const SmoothingStage& stage)
{
  const double inverse = 1.0 / c.D;
  return { Power(q.Target * c.L[0] * c.L[1] * (inverse * inverse), stage.HalfPower),
    stage.Omega * 0.5 * q.Area * (c.L[0] * q.Scale[0] + c.L[1] * q.Scale[1]) * inverse };
}

/// Returns the edge terms of both ends of arm k.
VFM_INLINE double ComputeEdge(const PartAtPoint& q, double length, int k)
{
  const double shortness = q.Edge[k] / length, square = shortness * shortness;
  return 2.0 * square * square;
}

/// Sums of derivatives.
struct Sums
{
  double Value = 0.0, U = 0.0, V = 0.0, UU = 0.0, VV = 0.0, UV = 0.0, Steepest = 0.0;

  VFM_INLINE void AddOuter(double factor, const FlatVector& a)
  {
    this->UU += factor * a.U * a.U;
    this->VV += factor * a.V * a.V;
    this->UV += factor * a.U * a.V;
  }
  /// Adds a term E of which ln E has this gradient; its Hessian, except for a multiple of 1 and
  /// outer products that the caller adds, is E g g^T.
  VFM_INLINE void AddTerm(double e, const FlatVector& g, double unit)
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
  const Corner& c, const PartAtPoint& q, const SmoothingStage& stage, Sums& sums)
{
  const Terms t = ComputeTerms(c, q, stage);
  const double m = stage.HalfPower, inverse = 1.0 / c.D;
  const FlatVector n{ inverse * c.GradD.U, inverse * c.GradD.V };
  const double w = c.L[0] * q.Scale[0] + c.L[1] * q.Scale[1];
  FlatVector jacobian{ -2.0 * m * n.U, -2.0 * m * n.V }, gradW{ 0.0, 0.0 };
  double unitJ = 0.0, unitS = 0.0;
  for (int k = 0; k < 2; ++k)
  {
    if (c.Moves[k])
    {
      const double per = 2.0 / c.L[k];
      jacobian = jacobian - FlatVector{ m * per * c.Arm[k].U, m * per * c.Arm[k].V };
      unitJ += m * per;
      sums.AddOuter(-t.Jacobian * m * per * per, c.Arm[k]);
      const double scale = 2.0 * q.Scale[k] / w;
      gradW = gradW - FlatVector{ scale * c.Arm[k].U, scale * c.Arm[k].V };
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

VFM_INLINE void AddEdge(const PartAtPoint& q, int k, Sums& sums)
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
double EvaluateParts(const Layer& layer, int point, const Vector3& x, const SmoothingStage& stage)
{
  double value = 0.0;
  bool isValid = true;
  ForParts(layer, point, x,
    [&](const PartAtPoint& q)
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
Sums DifferentiateParts(const Layer& layer, int point, const SmoothingStage& stage)
{
  Sums sums;
  ForParts(layer, point, layer.Mesh.X[point],
    [&](const PartAtPoint& q)
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

/// Returns the smallest determinant of the elements at a point that depends on it, in cell areas.
VFM_INLINE double SmallestAt(const Layer& layer, int point, const Vector3& x)
{
  double smallest = std::numeric_limits<double>::infinity();
  ForParts(layer, point, x,
    [&](const PartAtPoint& q)
    {
      for (const Corner& c : { OwnCorner(q), EndCorner(q, 0), EndCorner(q, 1) })
      {
        smallest = std::min(smallest, c.D / q.Area);
      }
    });
  return smallest;
}

/// Returns the smallest determinant of the elements below a hex, in cell areas.
double SmallestOfHex(const Layer& layer, Index hex)
{
  const std::array<FlatVector, 4> x = LowerQuad(layer.Mesh, layer.Plane, hex);
  const Vector3& widths = layer.Mesh.WidthsAt(static_cast<CornerPosition>(8 * hex));
  // The determinant at each corner is that of a triangle of one of both diagonals.
  double ofCorner[4];
  for (int c = 0; c < 4; ++c)
  {
    ofCorner[c] = Cross(x[(c + 1) % 4] - x[c], x[(c + 3) % 4] - x[c]);
  }
  const double first = std::min(ofCorner[1], ofCorner[3]), // of the diagonal from 0 to 2
    second = std::min(ofCorner[0], ofCorner[2]);
  const double smallest = !layer.Diagonals ? std::min(first, second)
    : layer.Diagonals->IsTurned(hex)       ? second
                                           : first;
  return smallest / (widths[layer.Plane.U] * widths[layer.Plane.V]);
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
  return EvaluateParts({ mesh, this->Plane, this->Diagonals, this->Target }, point, x, stage);
}

Derivatives FlatEnergy::Differentiate(
  const ActiveMesh& mesh, int point, const SmoothingStage& stage) const
{
  const FlatPlane& plane = this->Plane;
  const Sums sums =
    DifferentiateParts({ mesh, plane, this->Diagonals, this->Target }, point, stage);
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
  const std::vector<unsigned char>& returned, const std::vector<unsigned char>& /*where*/,
  std::vector<unsigned char>& points) const
{
  const Layer layer{ mesh, this->Plane, this->Diagonals, this->Target };
  std::atomic<bool> isFound(false);
  ForEach(runtime, static_cast<Index>(mesh.Elements.size() / 8),
    [&](Index hex)
    {
      const Index first = 8 * hex;
      const bool isMixed = !returned.empty() && IsMixed(mesh, returned, first);
      if (!(SmallestOfHex(layer, hex) > (isMixed ? LeastOfMixed : LeastOfAll)))
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
  const Layer layer{ mesh, this->Plane, this->Diagonals, this->Target };
  const double then = SmallestAt(layer, point, x);
  return then > LeastOfAll || then >= SmallestAt(layer, point, mesh.X[point]);
}

} // namespace vfm
