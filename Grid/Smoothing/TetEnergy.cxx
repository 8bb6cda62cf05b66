#include "Smoothing/TetEnergy.h"

#include "Base/Lanes.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr double SmallestDeterminant = 1e-9; // D, in cell volumes

// One tet a lane.

VFM_INLINE Lanes3 Pack(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return vfm::Pack(a.data(), b.data(), c.data(), d.data());
}
VFM_INLINE Lanes3 Pack(const Vector3& a)
{
  return { Splat(a[0]), Splat(a[1]), Splat(a[2]) };
}
VFM_INLINE Lanes3 Inverse(const Lanes3& a)
{
  return { 1.0 / a.X, 1.0 / a.Y, 1.0 / a.Z };
}

constexpr int Next[3] = { 1, 2, 0 };
constexpr int Previous[3] = { 2, 0, 1 };

/// Four tets in widths of their cells. Corners 0, 1, 2 follow the moving point in positive order.
struct Tets
{
  Lanes3 Edge[6]; // k: from the moving point to corner k; 3 + k: opposite, from k + 1 to k + 2
  Lanes3 Normal
    [4]; // k: of the face without corner k, inwards; 3: of the face without the point, outwards
  Lanes Length[6]; // squared: l^2
  Lanes Area[4];   // squared: N^2
  Lanes D;
};

VFM_INLINE Tets MakeTets(
  const Lanes3& x, const Lanes3& a, const Lanes3& b, const Lanes3& c, const Lanes3& inverseWidths)
{
  Tets t;
  t.Edge[0] = Times(inverseWidths, Minus(a, x));
  t.Edge[1] = Times(inverseWidths, Minus(b, x));
  t.Edge[2] = Times(inverseWidths, Minus(c, x));
  for (int k = 0; k < 3; ++k)
  {
    t.Edge[3 + k] = Minus(t.Edge[Previous[k]], t.Edge[Next[k]]);
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

VFM_INLINE Mask IsPositive(const Tets& t)
{
  return t.D > Splat(SmallestDeterminant);
}
VFM_INLINE bool AllPositive(const Tets& t)
{
  const Mask good = IsPositive(t);
  return good[0] & good[1] & good[2] & good[3];
}

/// Factors of the terms. All are 0 in a lane that does not count.
struct Factors
{
  Lanes Acute, Obtuse; // s*^2
  Lanes MeanRatio;     // m*^3 / 432
  Lanes Omega;         // omega / 432
  Lanes ShortestEdge;  // l*^2
  int HalfPower;       // p / 2
  int ShapePower;      // q
};

VFM_INLINE Factors MakeFactors(const TetQualityFloors& floors, const SmoothingStage& stage)
{
  return { Splat(floors.Acute * floors.Acute), Splat(floors.Obtuse * floors.Obtuse),
    Splat(floors.MeanRatio * floors.MeanRatio * floors.MeanRatio / 432.0),
    Splat(stage.Omega / 432.0), Splat(floors.ShortestEdge * floors.ShortestEdge), stage.HalfPower,
    std::max(1, stage.HalfPower / 2) };
}

/// Only the first lanes count.
VFM_INLINE void KeepLanes(Factors& factors, Index count)
{
  const Lanes weight{ 1.0, count > 1 ? 1.0 : 0.0, count > 2 ? 1.0 : 0.0, count > 3 ? 1.0 : 0.0 };
  factors.Acute *= weight;
  factors.Obtuse *= weight;
  factors.MeanRatio *= weight;
  factors.Omega *= weight;
  factors.ShortestEdge *= weight;
}

/// The terms of the energy of four tets.
struct Terms
{
  Lanes Dihedral[6], Barrier, Shape; // at each edge; (m* mu)^3q, omega mu^3
  Lanes RightAngles;                 // s*^p: the dihedral terms at 90 degrees, together
  Lanes Short[3];                    // edges of the moving point
  Lanes InverseLength[6];
  Lanes SumOfLengths; // squared
};

VFM_INLINE Lanes EdgeTerm(const Factors& factors, const Lanes& inverseLength)
{
  const Lanes square = factors.ShortestEdge * inverseLength;
  const Lanes fourth = square * square;
  return 0.25 * fourth * fourth;
}

VFM_INLINE Terms ComputeTerms(const Tets& t, const Factors& factors)
{
  Terms terms;
  const Lanes inverseD2 = 1.0 / (t.D * t.D);
  Lanes acute = factors.Acute, obtuse = factors.Obtuse;
  Mask isObtuse[6];
  for (int k = 0; k < 3; ++k)
  {
    const int i = Next[k], j = Previous[k];
    terms.InverseLength[k] = 1.0 / t.Length[k];
    terms.InverseLength[3 + k] = 1.0 / t.Length[3 + k];
    isObtuse[k] = Dot(t.Normal[i], t.Normal[j]) > Splat(0.0);
    isObtuse[3 + k] = Dot(t.Normal[k], t.Normal[3]) < Splat(0.0);
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
  terms.RightAngles = Splat(0.0);
  for (int e = 0; e < 6; ++e)
  {
    terms.RightAngles += isObtuse[e] ? obtuse : acute;
  }
  terms.SumOfLengths =
    (t.Length[0] + t.Length[1] + t.Length[2]) + (t.Length[3] + t.Length[4] + t.Length[5]);
  const Lanes cube =
    terms.SumOfLengths * terms.SumOfLengths * (terms.SumOfLengths * inverseD2); // 432 mu^3
  terms.Barrier = factors.MeanRatio * cube;
  for (int power = 1; power < factors.ShapePower; power *= 2)
  {
    terms.Barrier *= terms.Barrier;
  }
  terms.Shape = factors.Omega * cube;
  return terms;
}

VFM_INLINE Lanes Total(const Terms& t)
{
  return (t.Dihedral[0] + t.Dihedral[1] + t.Dihedral[2]) +
    (t.Dihedral[3] + t.Dihedral[4] + t.Dihedral[5]) - t.RightAngles + (t.Barrier + t.Shape) +
    (t.Short[0] + t.Short[1] + t.Short[2]);
}

/// Value, gradient and Hessian of the energy of four tets, in widths of the cells. With grad and Hess in the moving point,
/// n, e normal and opposite edge of a face at it, W the sum of l^2:
///   log D:   g = grad D / D,         Hess -g g^T
///   log N^2: h = 2 n x e / N^2,      Hess 2 e^2 n n^T / N^4 - h h^T / 2
///   log l^2: c = grad l^2 / l^2,     Hess 2 / l^2 - c c^T
///   log W:   u = grad W / W,         Hess 6 / W - u u^T
/// (s* / s)^2 and mu^3 are products of these; a power F^r has gradient r F grad log F and
/// Hessian r F (r grad log F (grad log F)^T + Hess log F).
VFM_INLINE Accumulator DifferentiateFour(const Tets& t, const Factors& factors)
{
  const Terms terms = ComputeTerms(t, factors);
  Accumulator sum{};
  sum.Value = Total(terms);

  const Lanes3 g = Times(-1.0 / t.D, t.Normal[3]);
  const Lanes3 g2 = Plus(g, g);
  const double p = factors.HalfPower;
  Lanes f[6];
  for (int e = 0; e < 6; ++e)
  {
    f[e] = p * terms.Dihedral[e];
  }
  Lanes3 h[3];
  for (int k = 0; k < 3; ++k)
  {
    const Lanes inverseArea = 1.0 / t.Area[k];
    h[k] = Times(2.0 * inverseArea, Cross(t.Normal[k], t.Edge[3 + k]));
    const Lanes weight = f[Next[k]] + f[Previous[k]] + f[3 + k];
    AddOuter(sum, 2.0 * weight * t.Length[3 + k] * (inverseArea * inverseArea), t.Normal[k]);
    AddOuter(sum, -0.5 * weight, h[k]);
    const Lanes3 far = Minus(h[k], g2);
    AddGradient(sum, f[3 + k], far);
    AddOuter(sum, p * f[3 + k], far);
  }
  Lanes unit = Splat(0.0);
  for (int k = 0; k < 3; ++k)
  {
    const Lanes3 c = Times(-2.0 * terms.InverseLength[k], t.Edge[k]);
    const Lanes3 near = Minus(Minus(Plus(h[Next[k]], h[Previous[k]]), g2), c);
    AddGradient(sum, f[k], near);
    AddOuter(sum, p * f[k], near);
    AddGradient(sum, -4.0 * terms.Short[k], c);
    AddOuter(sum, f[k] + 20.0 * terms.Short[k], c);
    unit -= (2.0 * f[k] + 8.0 * terms.Short[k]) * terms.InverseLength[k];
  }

  const double q = factors.ShapePower;
  const Lanes inverseW = 1.0 / terms.SumOfLengths;
  const Lanes3 u = Times(-2.0 * inverseW, Plus(Plus(t.Edge[0], t.Edge[1]), t.Edge[2]));
  const Lanes3 shape = Minus(Times(Splat(3.0), u), g2);
  const Lanes fShape = q * terms.Barrier + terms.Shape;
  AddGradient(sum, fShape, shape);
  AddOuter(sum, q * q * terms.Barrier + terms.Shape, shape);
  AddOuter(sum, -3.0 * fShape, u);
  const Lanes all = fShape + (f[0] + f[1] + f[2]) + (f[3] + f[4] + f[5]);
  AddOuter(sum, all + all, g);
  unit += 18.0 * fShape * inverseW;
  sum.XX += unit;
  sum.YY += unit;
  sum.ZZ += unit;
  return sum;
}

/// Adds part, which is in widths of the cells.
VFM_INLINE void AddScaled(Accumulator& sum, const Accumulator& part, const Lanes3& inverseWidths)
{
  const Lanes3& k = inverseWidths;
  sum.Value += part.Value;
  sum.GX += k.X * part.GX;
  sum.GY += k.Y * part.GY;
  sum.GZ += k.Z * part.GZ;
  sum.XX += k.X * k.X * part.XX;
  sum.YY += k.Y * k.Y * part.YY;
  sum.ZZ += k.Z * k.Z * part.ZZ;
  sum.XY += k.X * k.Y * part.XY;
  sum.XZ += k.X * k.Z * part.XZ;
  sum.YZ += k.Y * k.Z * part.YZ;
}

/// The tets at a point, four at a time: the last four are filled up with the last tet, which then does not count.
class TetsAtPoint
{
public:
  VFM_INLINE TetsAtPoint(const ActiveMesh& mesh, int point, const Vector3& x) :
    TheMesh(mesh),
    At(mesh.CornerOffset[point]),
    End(mesh.CornerOffset[point + 1]),
    X(Pack(x)),
    InverseWidths(Inverse(Pack(mesh.Widths[0])))
  {
  }
  VFM_INLINE bool IsDone() const { return this->At >= this->End; }
  /// The next four. Adapts the factors to them.
  VFM_INLINE Tets Take(Factors& factors)
  {
    const Index count = this->End - this->At;
    const Index* list = this->TheMesh.CornerList.data() + this->At;
    const Index i = list[0], j = list[count > 1 ? 1 : 0], k = list[count > 2 ? 2 : count - 1],
                l = list[count > 3 ? 3 : count - 1];
    if (count < 4)
    {
      KeepLanes(factors, count);
    }
    if (this->TheMesh.Widths.size() > 1)
    {
      const Vector3* widths = this->TheMesh.Widths.data();
      this->InverseWidths =
        Inverse(Pack(widths[i >> 2], widths[j >> 2], widths[k >> 2], widths[l >> 2]));
    }
    this->At += 4;
    const Vector3* points = this->TheMesh.X.data();
    const int* corners = this->TheMesh.Elements.data();
    // c, c ^ 1, c ^ 2, c ^ 3 is an even permutation for every corner c
    const auto others = [=](int bits)
    {
      return Pack(points[corners[i ^ bits]], points[corners[j ^ bits]], points[corners[k ^ bits]],
        points[corners[l ^ bits]]);
    };
    return MakeTets(this->X, others(1), others(2), others(3), this->InverseWidths);
  }
  /// Of the last four taken.
  VFM_INLINE const Lanes3& Scales() const { return this->InverseWidths; }

private:
  const ActiveMesh& TheMesh;
  Index At, End;
  Lanes3 X, InverseWidths;
};

// Virtual functions cannot be compiled for several machines, so these are free.

VFM_CLONES
double EvaluateTets(const ActiveMesh& mesh, int point, const Vector3& x,
  const TetQualityFloors& floors, const SmoothingStage& stage)
{
  Factors factors = MakeFactors(floors, stage);
  TetsAtPoint tets(mesh, point, x);
  Lanes sum = Splat(0.0);
  while (!tets.IsDone())
  {
    const Tets four = tets.Take(factors);
    if (!AllPositive(four))
    {
      return InvalidEnergy;
    }
    sum += Total(ComputeTerms(four, factors));
  }
  return Sum(sum);
}

VFM_CLONES
Derivatives DifferentiateTets(
  const ActiveMesh& mesh, int point, const TetQualityFloors& floors, const SmoothingStage& stage)
{
  Factors factors = MakeFactors(floors, stage);
  TetsAtPoint tets(mesh, point, mesh.X[point]);
  Accumulator sum{};
  while (!tets.IsDone())
  {
    const Tets four = tets.Take(factors);
    AddScaled(sum, DifferentiateFour(four, factors), tets.Scales());
  }
  Derivatives d;
  d.Value = Sum(sum.Value);
  d.Gradient = { { Sum(sum.GX), Sum(sum.GY), Sum(sum.GZ) } };
  d.Hessian = { { Sum(sum.XX), Sum(sum.YY), Sum(sum.ZZ), Sum(sum.XY), Sum(sum.XZ), Sum(sum.YZ) } };
  return d;
}

VFM_CLONES
std::array<double, 4> EvaluateFour(const Vector3 corners[4][4], const Vector3& widths,
  const TetQualityFloors& floors, const SmoothingStage& stage)
{
  const auto all = [=](int c)
  { return Pack(corners[0][c], corners[1][c], corners[2][c], corners[3][c]); };
  const Factors factors = MakeFactors(floors, stage);
  const Tets four = MakeTets(all(0), all(1), all(2), all(3), Inverse(Pack(widths)));
  const Terms terms = ComputeTerms(four, factors);
  Lanes sum = Total(terms);
  for (int e = 3; e < 6; ++e)
  {
    sum += EdgeTerm(factors, terms.InverseLength[e]);
  }
  sum = IsPositive(four) ? sum : Splat(InvalidEnergy);
  return { { sum[0], sum[1], sum[2], sum[3] } };
}

} // namespace

double TetEnergy::Evaluate(
  const ActiveMesh& mesh, int point, const Vector3& x, const SmoothingStage& stage) const
{
  return EvaluateTets(mesh, point, x, this->Floors, stage);
}

Derivatives TetEnergy::Differentiate(
  const ActiveMesh& mesh, int point, const SmoothingStage& stage) const
{
  return DifferentiateTets(mesh, point, this->Floors, stage);
}

std::array<double, 4> TetEnergy::OfTets(
  const Vector3 corners[4][4], const Vector3& widths, const SmoothingStage& stage) const
{
  return EvaluateFour(corners, widths, this->Floors, stage);
}

double TetEnergy::OfTet(
  const Vector3 corners[4], const Vector3& widths, const SmoothingStage& stage) const
{
  Vector3 four[4][4];
  for (auto& tet : four)
  {
    std::copy(corners, corners + 4, tet);
  }
  return this->OfTets(four, widths, stage)[0];
}

} // namespace vfm
