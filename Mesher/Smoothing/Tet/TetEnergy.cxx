#include "Smoothing/Tet/TetEnergy.h"

#include "Smoothing/Tet/TetTerms.h"

namespace vfm
{

using namespace tetterms;

namespace
{

constexpr double SmallestDeterminant = 1e-9; // D, in cell volumes
// Limits of float precision. Within them, rounding errors are far below the gain of a step, and D
// is positive in doubles too.
constexpr float SmallestInFloat = 1e-5f; // D
constexpr float PoorestInFloat = 1e5f;   // 432 mu^3
constexpr double LargestInFloat = 1e8;   // the energy

struct Request
{
  const ActiveMesh& Mesh;
  int Point;
  const Vector3& X; // position of the point
  const TetQualityFloors& Floors;
  const SmoothingStage& Stage;
};

VFM_INLINE bool HasOneWidth(const ActiveMesh& mesh)
{
  return mesh.Widths.size() == 1;
}

/// Returns the demands of the tets at some corners, from position `at` of CornerList on.
/// @param count  number of tets; further lanes repeat the last one
template <class Real>
VFM_INLINE LanesOf<Real> DemandsAt(const ActiveMesh& mesh, Index at, Index count)
{
  LanesOf<Real> demands;
  for (int lane = 0; lane < ElementLanes<Real>::Count; ++lane)
  {
    demands[lane] =
      static_cast<Real>(mesh.DemandAt(mesh.CornerList[at + std::min<Index>(lane, count - 1)]));
  }
  return demands;
}

template <class Real>
VFM_INLINE VectorLanes<Real> Scaled(const VectorLanes<Real>& a, const VectorLanes<Real>& scale)
{
  return { a.X * scale.X, a.Y * scale.Y, a.Z * scale.Z };
}

/// Tets at a point, eight at a time in floats.
class TetsInFloat
{
public:
  using Real = float;

  VFM_INLINE TetsInFloat(const Request& what) :
    Mesh(what.Mesh),
    Star(what.Mesh.Stars.At(what.Point)),
    At(what.Mesh.CornerOffset[what.Point]),
    End(what.Mesh.CornerOffset[what.Point + 1])
  {
    const Double4 x{ what.X[0], what.X[1], what.X[2], 0.0 };
    Double4 scale = Fill<double>(1.0);
    if (HasOneWidth(this->Mesh))
    {
      const Vector3& widths = this->Mesh.Widths[0];
      // Used twice, because valgrind lacks the instruction that would fill in a 0.
      const double z = 1.0 / widths[2];
      scale = Double4{ 1.0 / widths[0], 1.0 / widths[1], z, z };
      this->Scale = { Fill(static_cast<float>(scale[0])), Fill(static_cast<float>(scale[1])),
        Fill(static_cast<float>(scale[2])) };
    }
    Float4* near = this->Near;
    for (const int* n = this->Star.FirstNeighbour; n != this->Star.LastNeighbour; ++n)
    {
      const double* p = this->Mesh.X[*n].data();
      *near++ = __builtin_convertvector((Double4{ p[0], p[1], p[2], 0.0 } - x) * scale, Float4);
    }
  }
  VFM_INLINE bool IsDone() const { return this->At >= this->End; }
  VFM_INLINE LanesOf<float> Demands() const
  {
    return DemandsAt<float>(this->Mesh, this->At, this->End - this->At);
  }
  VFM_INLINE Tets<float> Take(Factors<float>& factors)
  {
    const Index count = this->End - this->At;
    if (count < TetStars::Width)
    {
      KeepLanes(factors, count);
    }
    const TetStars::Eight& eight = *this->Star.Tets++;
    VectorLanes<float> a = this->Gather(eight[0]), b = this->Gather(eight[1]),
                       c = this->Gather(eight[2]);
    if (!HasOneWidth(this->Mesh))
    {
      this->Scale = this->ScalesOf(count);
      a = Scaled(a, this->Scale);
      b = Scaled(b, this->Scale);
      c = Scaled(c, this->Scale);
    }
    this->At += TetStars::Width;
    return MakeTets(a, b, c);
  }
  /// Returns 1 / widths of the last tets taken.
  VFM_INLINE const VectorLanes<float>& Scales() const { return this->Scale; }

private:
  VFM_INLINE VectorLanes<float> ScalesOf(Index count) const
  {
    VectorLanes<float> scale;
    for (int lane = 0; lane < TetStars::Width; ++lane)
    {
      const Vector3& widths =
        this->Mesh.WidthsAt(this->Mesh.CornerList[this->At + std::min<Index>(lane, count - 1)]);
      scale.X[lane] = static_cast<float>(1.0 / widths[0]);
      scale.Y[lane] = static_cast<float>(1.0 / widths[1]);
      scale.Z[lane] = static_cast<float>(1.0 / widths[2]);
    }
    return scale;
  }
  VFM_INLINE VectorLanes<float> Gather(
    const std::array<unsigned char, TetStars::Width>& places) const
  {
    return GatherPoints(this->Near, [&](int lane) { return places[lane]; });
  }

  const ActiveMesh& Mesh;
  TetStars::Star Star;
  Index At, End;
  VectorLanes<float> Scale;
  Float4 Near[TetStars::MaximumNeighbours];
};

/// Tets at a point, four at a time in doubles. The last group is filled up with the last tet, whose
/// repetitions have no weight.
class TetsInDouble
{
public:
  using Real = double;

  VFM_INLINE TetsInDouble(const Request& what) :
    Mesh(what.Mesh),
    At(what.Mesh.CornerOffset[what.Point]),
    End(what.Mesh.CornerOffset[what.Point + 1]),
    X(what.X),
    Scale{}
  {
  }
  VFM_INLINE bool IsDone() const { return this->At >= this->End; }
  VFM_INLINE LanesOf<double> Demands() const
  {
    return DemandsAt<double>(this->Mesh, this->At, this->End - this->At);
  }
  VFM_INLINE Tets<double> Take(Factors<double>& factors)
  {
    constexpr int Count = ElementLanes<double>::Count;
    const Index count = this->End - this->At;
    if (count < Count)
    {
      KeepLanes(factors, count);
    }
    const double* others[3][Count];
    for (int lane = 0; lane < Count; ++lane)
    {
      const Index position = this->Mesh.CornerList[this->At + std::min<Index>(lane, count - 1)];
      for (int k = 0; k < 3; ++k)
      {
        // c ^ 1, c ^ 2, c ^ 3 follow c in an even permutation for every corner c
        others[k][lane] = this->Mesh.X[this->Mesh.Elements[position ^ (k + 1)]].data();
      }
      const Vector3& widths = this->Mesh.WidthsAt(position);
      this->Scale.X[lane] = 1.0 / widths[0];
      this->Scale.Y[lane] = 1.0 / widths[1];
      this->Scale.Z[lane] = 1.0 / widths[2];
    }
    this->At += Count;
    const auto seen = [this](const double* const(&points)[Count])
    { return Scaled(Differences(points, this->X), this->Scale); };
    return MakeTets(seen(others[0]), seen(others[1]), seen(others[2]));
  }
  VFM_INLINE const VectorLanes<double>& Scales() const { return this->Scale; }

private:
  const ActiveMesh& Mesh;
  Index At, End;
  const Vector3& X;
  VectorLanes<double> Scale;
};

/// Results per lane of the tets so far: energy, smallest D and poorest shape (largest 432 mu^3).
template <class Real>
struct Found
{
  LanesOf<Real> Value, Least, Poorest;

  VFM_INLINE Found() : Value{}, Least(Fill<Real>(Real(1e30))), Poorest{} {}
  VFM_INLINE void Add(const Tets<Real>& tets, const Terms<Real>& terms)
  {
    this->Value += Total(terms);
    this->Least = vfm::Least(tets.D, this->Least);
    this->Poorest = Greatest(terms.Cube, this->Poorest);
  }
};

/// Returns whether all lanes of a exceed b; false if any is NaN.
template <class L>
VFM_INLINE bool AllExceed(const L& a, const L& b)
{
  const auto exceeds = a > b;
  bool all = true;
  for (std::size_t i = 0; i < sizeof(L) / sizeof(a[0]); ++i)
  {
    all &= exceeds[i] != 0;
  }
  return all;
}

VFM_INLINE bool IsGood(const Found<float>& found, double energy)
{
  return energy < LargestInFloat && AllExceed(found.Least, Fill(SmallestInFloat)) &&
    AllExceed(Fill(PoorestInFloat), found.Poorest);
}

/// Returns the factors of the next tets of a source.
/// @param all  factors without demands
template <class Source, class Real = typename Source::Real>
VFM_INLINE Factors<Real> NextFactors(
  const Source& source, const Request& what, const Factors<Real>& all)
{
  Factors<Real> factors = all;
  if (!what.Mesh.Demands.empty())
  {
    SetDemands(factors, source.Demands());
  }
  return factors;
}

/// Computes the energy of all tets of a source; returns it too.
template <class Source>
VFM_INLINE double Compute(
  Source& source, const Request& what, Found<typename Source::Real>& found, double& energy)
{
  using Real = typename Source::Real;
  const Factors<Real> all = MakeFactors<Real>(what.Floors, what.Stage);
  while (!source.IsDone())
  {
    Factors<Real> factors = NextFactors(source, what, all);
    const Tets<Real> tets = source.Take(factors);
    found.Add(tets, ComputeTerms(tets, factors));
  }
  return energy = Sum(found.Value);
}

/// Adds sums in cell widths, converted to grid coordinates.
/// @param k  1 / widths
template <class Real>
VFM_INLINE void AddTo(Derivatives& d, const Sums<Real>& sum, const VectorLanes<Real>& k)
{
  d.Gradient[0] += Sum(k.X * sum.GX);
  d.Gradient[1] += Sum(k.Y * sum.GY);
  d.Gradient[2] += Sum(k.Z * sum.GZ);
  d.Hessian[0] += Sum(k.X * k.X * sum.XX);
  d.Hessian[1] += Sum(k.Y * k.Y * sum.YY);
  d.Hessian[2] += Sum(k.Z * k.Z * sum.ZZ);
  d.Hessian[3] += Sum(k.X * k.Y * sum.XY);
  d.Hessian[4] += Sum(k.X * k.Z * sum.XZ);
  d.Hessian[5] += Sum(k.Y * k.Z * sum.YZ);
}

template <class Source>
VFM_INLINE double Compute(
  Source& source, const Request& what, Found<typename Source::Real>& found, Derivatives& d)
{
  using Real = typename Source::Real;
  const Factors<Real> all = MakeFactors<Real>(what.Floors, what.Stage);
  const bool hasOneWidth = HasOneWidth(what.Mesh);
  Sums<Real> sum{};
  LanesOf<Real> steepest{};
  d = Derivatives();
  while (!source.IsDone())
  {
    Factors<Real> factors = NextFactors(source, what, all);
    const Tets<Real> tets = source.Take(factors);
    const Terms<Real> terms = ComputeTerms(tets, factors);
    found.Add(tets, terms);
    AddDerivatives(sum, tets, terms, factors);
    const VectorLanes<Real> steepness =
      Scaled(Times<Real>(terms.InverseD, tets.Normal[3]), source.Scales());
    steepest = Greatest(steepest, Dot(steepness, steepness));
    if (source.IsDone() || !hasOneWidth)
    {
      AddTo(d, sum, source.Scales());
      sum = Sums<Real>{};
    }
  }
  d.Steepness = std::sqrt(static_cast<double>(GreatestLane(steepest)));
  return d.Value = Sum(found.Value);
}

/// Computes a result in floats; returns whether they are accurate enough.
template <class Result>
VFM_INLINE bool ComputeInFloat(const Request& what, Result& result)
{
  if (!what.Mesh.Stars.Has(what.Point))
  {
    return false;
  }
  TetsInFloat tets(what);
  Found<float> found;
  return IsGood(found, Compute(tets, what, found, result));
}

// Free functions, because VFM_CLONES does not support virtual functions.

VFM_CLONES
double EvaluateInDouble(const Request& what)
{
  TetsInDouble tets(what);
  Found<double> found;
  double energy;
  Compute(tets, what, found, energy);
  return AllExceed(found.Least, Fill(SmallestDeterminant)) ? energy : InvalidEnergy;
}

VFM_CLONES
bool EvaluateInFloat(const Request& what, double& energy)
{
  return ComputeInFloat(what, energy);
}

VFM_CLONES
Derivatives DifferentiateInDouble(const Request& what)
{
  TetsInDouble tets(what);
  Found<double> found;
  Derivatives d;
  Compute(tets, what, found, d);
  return d;
}

VFM_CLONES
bool DifferentiateInFloat(const Request& what, Derivatives& d)
{
  return ComputeInFloat(what, d);
}

VFM_CLONES
std::array<double, 4> EvaluateFour(const Vector3 corners[4][4], const Vector3& widths,
  const TetQualityFloors& floors, const SmoothingStage& stage)
{
  const auto seen = [&](int c)
  {
    VectorLanes<double> edge;
    for (int lane = 0; lane < 4; ++lane)
    {
      edge.X[lane] = (corners[lane][c][0] - corners[lane][0][0]) / widths[0];
      edge.Y[lane] = (corners[lane][c][1] - corners[lane][0][1]) / widths[1];
      edge.Z[lane] = (corners[lane][c][2] - corners[lane][0][2]) / widths[2];
    }
    return edge;
  };
  const Factors<double> factors = MakeFactors<double>(floors, stage);
  const Tets<double> four = MakeTets(seen(1), seen(2), seen(3));
  const Terms<double> terms = ComputeTerms(four, factors);
  Double4 sum = Total(terms);
  for (int e = 3; e < 6; ++e)
  {
    sum += EdgeTerm(factors, terms.InverseLength[e]);
  }
  sum = four.D > Fill(SmallestDeterminant) ? sum : Fill(InvalidEnergy);
  return { { sum[0], sum[1], sum[2], sum[3] } };
}

} // namespace

double TetEnergy::Evaluate(
  const ActiveMesh& mesh, int point, const Vector3& x, const SmoothingStage& stage) const
{
  const Request what{ mesh, point, x, this->Floors, stage };
  double energy;
  return this->Precise || !EvaluateInFloat(what, energy) ? EvaluateInDouble(what) : energy;
}

Derivatives TetEnergy::Differentiate(
  const ActiveMesh& mesh, int point, const SmoothingStage& stage) const
{
  const Request what{ mesh, point, mesh.X[point], this->Floors, stage };
  Derivatives d;
  return this->Precise || !DifferentiateInFloat(what, d) ? DifferentiateInDouble(what) : d;
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
