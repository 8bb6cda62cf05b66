#include "Interface/SurfaceTargets.h"

#include "Base/PortableMath.h"
#include "Base/Vector3.h"
#include "Interface/FaceWalk.h"

#include <Eigen/Cholesky>

#include <stdexcept>

namespace vfm
{
namespace
{

constexpr double FitRadius = 1.2; // radius of the Gaussian weight, in cells
constexpr int Rings = 2;          // rings of interface faces whose crossings are fitted
// Least cosine between the normals of a crossing and the base plane.
constexpr double SmallestCosine = 0.2;
constexpr double LargestHeight = 1.6; // height of a crossing over the base plane
// Least squared sine of the angle between quadric and side of the domain.
constexpr double SmallestSlide = 0.1;
constexpr double LinearBeyond = 1.5; // radius beyond which a quadric continues as a plane
// Shift of a quadric per curvature. Facets between nodes on a bend cut it off, which changes the
// volume in the cells. This is half of the shift that preserves it; the shift of entire interfaces
// (Volumes.h) does the rest. The full shift would move coarse levels too far.
constexpr double StandOff = 1.0 / 12.0;
constexpr std::array<double, 6> Tikhonov{ { 1e-6, 1e-3, 1e-3, 0.02, 0.02, 0.02 } };

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Adds weight * row * row^T to the lower triangle of a matrix, which is all that LDLT reads.
void AddLower(double weight, const Vector6& row, Matrix6& A)
{
  const Vector6 weighted = weight * row;
  for (int j = 0; j < 6; ++j)
  {
    for (int i = j; i < 6; ++i)
    {
      A(i, j) += weighted[i] * row[j];
    }
  }
}

/// Returns the point of a triangle nearest to 0. Ericson, Real-Time Collision
/// Detection, 2005, section 5.1.5.
Vector3 NearestOfTriangle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const Vector3 ab = b - a, ac = c - a;
  const double d1 = -Dot(ab, a), d2 = -Dot(ac, a);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return a;
  }
  const double d3 = -Dot(ab, b), d4 = -Dot(ac, b);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return b;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return a + (d1 / (d1 - d3)) * ab;
  }
  const double d5 = -Dot(ab, c), d6 = -Dot(ac, c);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return c;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return a + (d2 / (d2 - d6)) * ac;
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  }
  const double sum = va + vb + vc;
  return a + (vb / sum) * ab + (vc / sum) * ac;
}

constexpr Vector3 Axes[] = { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } };

/// Returns the first tangent of MakeTangents as a number: the factor that makes the cross product
/// of n and an axis a unit vector, 1 to 1.23, times 1, 2 or 4 for the axes.
double PackTangent(const Vector3& n)
{
  int flat = 0;
  for (int a = 1; a < 3; ++a)
  {
    flat = std::fabs(n[a]) < std::fabs(n[flat]) ? a : flat;
  }
  const double norm = Norm(Cross(n, Axes[flat]));
  return (norm > 0.0 ? 1.0 / norm : 1.0) * (1 << flat);
}

/// Returns the tangent. Has no branches, which processors could not predict.
Vector3 UnpackTangent(const Vector3& n, double packed)
{
  constexpr double inverse[] = { 1.0, 0.5, 0.25 };
  const int flat = (packed > 1.5) + (packed > 3.0);
  return (inverse[flat] * packed) * Cross(n, Axes[flat]);
}

} // namespace

SurfaceTargets::SurfaceTargets(const Interface& interface, Kind kind, Runtime& runtime) :
  SurfaceTargets(std::vector<const Interface*>{ &interface }, kind, runtime)
{
}

SurfaceTargets::SurfaceTargets(
  const std::vector<const Interface*>& interfaces, Kind kind, Runtime& runtime) :
  TheKind(kind)
{
  Index count = 0;
  for (const Interface* interface : interfaces)
  {
    this->Levels.push_back({ interface, interface->Scale() / interfaces.back()->Scale(), count });
    count += static_cast<Index>(interface->Points().size());
  }
  this->Frames.resize(count);
  this->StartWidths();
  this->Facets.resize(kind == Kind::Facets ? count : 0);
  this->Corners.resize(this->Facets.size());
  for (const Level& level : this->Levels)
  {
    this->FitLevel(level, runtime);
  }
}

/// Stores widths once if all nodes of a single grid have the same, to the last bit.
void SurfaceTargets::StartWidths()
{
  const Interface& interface = *this->Levels[0].Source;
  const CartesianGrid& grid = interface.Grid();
  this->HasEqualWidths = this->Levels.size() == 1 && !interface.Nodes().empty();
  for (int a = 0; a < 3; ++a)
  {
    for (Index i = 1; i < grid.Global().Upper[a]; ++i)
    {
      this->HasEqualWidths &= grid.Width(a, i) == grid.Width(a, 0);
    }
  }
  this->InverseWidths.resize(this->HasEqualWidths ? 1 : this->Frames.size());
  if (this->HasEqualWidths)
  {
    this->InverseWidths[0] =
      Divided({ { 1.0, 1.0, 1.0 } }, interface.NodeWidths(interface.Nodes()[0]));
  }
}

void SurfaceTargets::FitLevel(const Level& level, Runtime& runtime)
{
  const Interface& interface = *level.Source;
  const bool hasFacets = this->TheKind == Kind::Facets;
  runtime.For(0, static_cast<Index>(interface.Nodes().size()),
    [&](Index first, Index last)
    {
      FaceWalk walk(interface);
      const auto all = [](Index) { return true; };
      for (Index n = first; n < last; ++n)
      {
        for (Index p = interface.PointOffset(n); p < interface.PointOffset(n + 1); ++p)
        {
          const SurfacePoint& point = interface.Points()[p];
          const std::vector<int>& faces = walk.Find(n, point.First, point.Second, Rings, all);
          this->FitQuadric(level, n, p, faces);
          if (hasFacets)
          {
            this->Facets[level.First + p] = faces;
            this->Corners[level.First + p] = this->FindCorner(level, n, p);
          }
        }
      }
    });
}

const SurfaceTargets::Level& SurfaceTargets::LevelOf(Index target) const
{
  auto level = this->Levels.end() - 1;
  while (level->First > target)
  {
    --level;
  }
  return *level;
}

void SurfaceTargets::FitQuadric(
  const Level& level, Index node, Index point, const std::vector<int>& faces)
{
  const Interface& interface = *level.Source;
  const SurfacePoint& base = interface.Points()[point];
  const Vector3 widths = interface.NodeWidths(interface.Nodes()[node]);
  const Vector3 inverseWidths = Divided({ { 1.0, 1.0, 1.0 } }, widths);
  Frame frame; // uses the coordinates of its own grid until it is stored
  frame.Base = base.Point;
  frame.N = Unit(Scaled(base.Normal, widths));
  frame.Tangent = PackTangent(frame.N);
  Vector3 along, tangent;
  MakeTangents(frame.N, along, tangent);

  Matrix6 A = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  int used = 0;
  for (int face : faces)
  {
    const Crossing& crossing = interface.Crossings()[face];
    const Vector3 y = Scaled(crossing.Point - frame.Base, inverseWidths);
    const Vector3 normal = Scaled(crossing.Normal, widths);
    const double u = Dot(y, along), v = Dot(y, tangent), w = Dot(y, frame.N);
    if (std::fabs(w) >= LargestHeight || Dot(normal, frame.N) <= SmallestCosine * Norm(normal))
    {
      continue;
    }
    const double weight = crossing.Weight * Exp(-(u * u + v * v) / (2.0 * FitRadius * FitRadius));
    Vector6 row;
    row << 1.0, u, v, u * u, u * v, v * v;
    AddLower(weight, row, A);
    b += weight * w * row;
    ++used;
  }
  for (int i = 0; i < 6; ++i)
  {
    A(i, i) += Tikhonov[i];
  }
  Vector6 c = Vector6::Zero();
  if (used >= 6)
  {
    c = A.ldlt().solve(b);
  }
  else
  {
    c.head<3>() = A.topLeftCorner<3, 3>().ldlt().solve(b.head<3>());
  }
  for (int i = 0; i < 6; ++i)
  {
    const double bound = i == 0 ? 1.0 : (i < 3 ? 1e30 : 0.5);
    frame.C[i] = std::min(std::max(c[i], -bound), bound);
  }
  frame.C[0] -= StandOff * (frame.C[3] + frame.C[5]);
  frame.Base = level.Ratio * frame.Base;
  this->Frames[level.First + point] = frame;
  this->SetWidths(level.First + point, (1.0 / level.Ratio) * inverseWidths);
}

void SurfaceTargets::SetWidths(Index target, const Vector3& inverse)
{
  if (!this->HasEqualWidths)
  {
    this->InverseWidths[target] = inverse;
  }
  else if (this->InverseWidths[0] != inverse) // other threads may read them
  {
    throw std::logic_error("The cells of a surface target have other widths than all others.");
  }
}

/// Returns the surface point of a target moved onto its quadric, in grid coordinates of the finest
/// grid. On a side of the domain it stays there.
Vector3 SurfaceTargets::FindCorner(const Level& level, Index node, Index point) const
{
  const Frame& frame = this->Frames[level.First + point];
  const CartesianGrid& grid = level.Source->Grid();
  const int sides = grid.DomainSides(grid.Position(level.Source->Nodes()[node]));
  Vector3 gradient;
  const double d = this->QuadricDistance(frame, { { 0.0, 0.0, 0.0 } }, gradient);
  Vector3 along = gradient;
  for (int a = 0; a < 3; ++a)
  {
    along[a] = sides >> (2 * a) & 3 ? 0.0 : along[a];
  }
  const double slope = Dot(along, gradient);
  return slope > SmallestSlide
    ? frame.Base - Divided((d / slope) * along, this->WidthsAt(level.First + point))
    : frame.Base;
}

LocalQuadric SurfaceTargets::QuadricOf(
  Index target, const Vector3& origin, const Vector3& widths) const
{
  const Frame& frame = this->Frames[target];
  LocalQuadric quadric = MakeLocalPlane(Divided(frame.Base - origin, widths), frame.N);
  quadric.C = frame.C;
  quadric.C[0] += StandOff * (quadric.C[3] + quadric.C[5]);
  return quadric;
}

Index SurfaceTargets::Add(const LocalQuadric& quadric, const Vector3& origin, const Vector3& widths)
{
  const Vector3 inverse = Divided({ { 1.0, 1.0, 1.0 } }, widths);
  const Index target = this->Count();
  if (this->HasEqualWidths && this->InverseWidths[0] != inverse)
  {
    this->InverseWidths.assign(target, this->InverseWidths[0]);
    this->HasEqualWidths = false;
  }
  if (!this->HasEqualWidths)
  {
    this->InverseWidths.push_back(inverse);
  }
  this->Frames.emplace_back();
  this->Replace(target, quadric, origin, widths);
  return target;
}

void SurfaceTargets::Replace(
  Index target, const LocalQuadric& quadric, const Vector3& origin, const Vector3& widths)
{
  this->Frames[target] = { origin + Scaled(quadric.Base, widths), quadric.N, PackTangent(quadric.N),
    quadric.C };
  this->SetWidths(target, Divided({ { 1.0, 1.0, 1.0 } }, widths));
}

double SurfaceTargets::LocalScale(Index target) const
{
  const Frame& frame = this->Frames[target];
  return Norm(Scaled(frame.N, this->WidthsAt(target)));
}

double SurfaceTargets::Distance(Index target, const Vector3& x, Vector3& gradient) const
{
  const Frame& frame = this->Frames[target];
  const Vector3& inverseWidths = this->WidthsAt(target);
  const Vector3 y = Scaled(x - frame.Base, inverseWidths);
  const double d = this->TheKind == Kind::Quadrics ? this->QuadricDistance(frame, y, gradient)
                                                   : this->FacetDistance(target, y, gradient);
  gradient = Scaled(gradient, inverseWidths);
  return d;
}

double SurfaceTargets::QuadricDistance(
  const Frame& frame, const Vector3& y, Vector3& gradient) const
{
  const Vector3 along = UnpackTangent(frame.N, frame.Tangent);
  const Vector3 tangent = Cross(frame.N, along);
  const double u = Dot(y, along), v = Dot(y, tangent), w = Dot(y, frame.N);
  const std::array<double, 6>& c = frame.C;
  const double r2 = u * u + v * v;
  const double shrink = r2 > LinearBeyond * LinearBeyond ? LinearBeyond / std::sqrt(r2) : 1.0;
  const double uc = shrink * u, vc = shrink * v;
  const double fu = c[1] + 2.0 * c[3] * uc + c[4] * vc;
  const double fv = c[2] + c[4] * uc + 2.0 * c[5] * vc;
  const double f = c[0] + c[1] * uc + c[2] * vc + c[3] * uc * uc + c[4] * uc * vc + c[5] * vc * vc +
    fu * (u - uc) + fv * (v - vc);
  const double steep = 1.0 / std::sqrt(1.0 + fu * fu + fv * fv);
  gradient = steep * (frame.N - fu * along - fv * tangent);
  return (w - f) * steep;
}

double SurfaceTargets::FacetDistance(Index target, const Vector3& y, Vector3& gradient) const
{
  const Frame& frame = this->Frames[target];
  const Level& level = this->LevelOf(target);
  const Interface& interface = *level.Source;
  const SurfacePoint& base = interface.Points()[target - level.First];
  const bool skipsFolds = this->Levels.size() > 1; // steps of coarser cells fold quads
  constexpr double None = 1e30;
  double best = None;
  Vector3 nearest{ { 0.0, 0.0, 0.0 } }, normal = frame.N;
  for (int face : this->Facets[target])
  {
    Vector3 corner[4];
    int c = 0;
    for (int n : interface.CornersOfFace(face))
    {
      const SurfacePoint* point = interface.FindPoint(n, base.First, base.Second);
      const Vector3& x = this->Corners[level.First + (point - interface.Points().data())];
      corner[c++] = Scaled(x - frame.Base, this->WidthsAt(target)) - y;
    }
    const bool along = interface.Faces()[face].LowerLabel == base.First;
    for (int half = 0; half < 2; ++half)
    {
      const Vector3 &a = corner[0], &b = corner[1 + half], &d = corner[2 + half];
      const Vector3 p = NearestOfTriangle(a, b, d);
      if (Dot(p, p) < best)
      {
        const Vector3 across = Unit((along ? 1.0 : -1.0) * Cross(b - a, d - a));
        if (skipsFolds && Dot(across, frame.N) <= SmallestCosine)
        {
          continue;
        }
        best = Dot(p, p);
        nearest = p;
        normal = across;
      }
    }
  }
  if (best == None)
  {
    gradient = frame.N;
    return Dot(y, frame.N);
  }
  const double distance = std::sqrt(best);
  const double sign = Dot(nearest, normal) <= 0.0 ? 1.0 : -1.0;
  gradient = distance > 1e-6 ? (-sign / distance) * nearest : normal;
  return sign * distance;
}

} // namespace vfm
