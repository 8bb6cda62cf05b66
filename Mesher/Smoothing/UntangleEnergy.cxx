#include "Smoothing/UntangleEnergy.h"

#include "Base/Vector3.h"

namespace vfm
{
namespace
{

constexpr double Target = 0.3;         // s*
constexpr double ShortestEdge = 0.075; // l*, in cell widths
constexpr double TinyLength = 1e-12;   // squared, in cells; keeps divisions finite

/// Corner of a hex as a function of one moving point. Edges point along +x, +y, +z of the hex.
struct Corner
{
  Vector3 Q[3];
  Vector3 Moves;    // 1 for edges whose end moves, -1 for edges whose start moves
  double L[3];      // squared lengths
  double K[3];      // 1 / width^2 of the cell along the edge
  double Lengths;   // product of the lengths, in cell volumes
  double D;         // determinant, in cell volumes
  Vector3 Gradient; // gradient of D
};

Corner MakeCorner(const ActiveMesh& mesh, const int* hex, int corner, int moving, const Vector3& x,
  const Vector3& widths)
{
  const auto at = [&](int c) { return c == moving ? x : mesh.X[hex[c]]; };
  const double perVolume = 1.0 / (widths[0] * widths[1] * widths[2]);
  Corner k;
  for (int a = 0; a < 3; ++a)
  {
    const int other = corner ^ 1 << a;
    const double sign = corner >> a & 1 ? -1.0 : 1.0;
    k.Q[a] = sign * (at(other) - at(corner));
    k.Moves[a] = sign * ((other == moving) - (corner == moving));
    k.K[a] = 1.0 / (widths[a] * widths[a]);
    k.L[a] = Dot(k.Q[a], k.Q[a]) + TinyLength;
  }
  k.Lengths = std::sqrt(k.L[0] * k.L[1] * k.L[2]) * perVolume;
  k.Gradient = { { 0.0, 0.0, 0.0 } };
  for (int a = 0; a < 3; ++a)
  {
    const Vector3 across = perVolume * Cross(k.Q[(a + 1) % 3], k.Q[(a + 2) % 3]);
    k.Gradient = k.Gradient + k.Moves[a] * across;
    k.D = Dot(k.Q[a], across);
  }
  return k;
}

/// Value of chi and its first two derivatives.
struct Regularised
{
  double Value, First, Second;
};

Regularised Regularise(double d, double eps)
{
  const double root = std::sqrt(d * d + eps * eps);
  const double value = d > 0.0 ? 0.5 * (d + root) : 0.5 * eps * eps / (root - d);
  return { value, 0.5 * (1.0 + d / root), 0.5 * eps * eps / (root * root * root) };
}

double TraceOf(const Corner& k)
{
  return k.L[0] * k.K[0] + k.L[1] * k.K[1] + k.L[2] * k.K[2];
}

double ShapeOf(const Corner& k)
{
  const double third = TraceOf(k) / 3.0;
  return third * std::sqrt(third);
}

/// Returns the term of one end of an edge.
double EdgeOf(const Corner& k, int e)
{
  const double s = ShortestEdge * ShortestEdge / (k.L[e] * k.K[e]);
  return s * s * s * s;
}

void AddOuter(std::array<double, 6>& h, double weight, const Vector3& u)
{
  h[0] += weight * u[0] * u[0];
  h[1] += weight * u[1] * u[1];
  h[2] += weight * u[2] * u[2];
  h[3] += weight * u[0] * u[1];
  h[4] += weight * u[0] * u[2];
  h[5] += weight * u[1] * u[2];
}

void AddUnit(std::array<double, 6>& h, double weight)
{
  for (int a = 0; a < 3; ++a)
  {
    h[a] += weight;
  }
}

/// Adds the terms of a corner. F = exp(f) has gradient F g and Hessian F (g g^T + H), with gradient
/// g and Hessian H of f.
void AddCorner(Derivatives& d, const Corner& k, double omega, double eps)
{
  const Regularised chi = Regularise(k.D, eps);
  const double slope = chi.First / chi.Value;
  const Vector3 c = slope * k.Gradient; // gradient of log chi
  const double w = TraceOf(k);
  Vector3 a{ { 0.0, 0.0, 0.0 } }, b = a;
  std::array<double, 6> hA{}, hB{};
  for (int e = 0; e < 3; ++e)
  {
    const double moves = k.Moves[e] * k.Moves[e];
    a = a + (k.Moves[e] / k.L[e]) * k.Q[e];
    b = b + (3.0 * k.K[e] * k.Moves[e] / w) * k.Q[e];
    AddUnit(hA, moves / k.L[e]);
    AddOuter(hA, -2.0 * moves / (k.L[e] * k.L[e]), k.Q[e]);
    AddUnit(hB, 3.0 * k.K[e] * moves / w);
  }
  AddOuter(hB, -2.0 / 3.0, b);
  const auto add = [&](double value, const Vector3& g, const std::array<double, 6>& h)
  {
    d.Value += value;
    d.Gradient = d.Gradient + value * (g - c);
    AddOuter(d.Hessian, value, g - c);
    AddOuter(d.Hessian, value * (slope * slope - chi.Second / chi.Value), k.Gradient);
    for (int i = 0; i < 6; ++i)
    {
      d.Hessian[i] += value * h[i];
    }
  };
  add(Target * k.Lengths / chi.Value, a, hA);
  add(omega * ShapeOf(k) / chi.Value, b, hB);
  for (int e = 0; e < 3; ++e)
  {
    const double edge = EdgeOf(k, e), moves = k.Moves[e] * k.Moves[e];
    d.Value += edge;
    d.Gradient = d.Gradient + (-8.0 * edge * k.Moves[e] / k.L[e]) * k.Q[e];
    AddUnit(d.Hessian, -8.0 * edge * moves / k.L[e]);
    AddOuter(d.Hessian, 80.0 * edge * moves / (k.L[e] * k.L[e]), k.Q[e]);
  }
}

/// Calls visit(corner) for the four corners of each hex at the point that depend on it.
template <class Visitor>
void ForCorners(const ActiveMesh& mesh, int point, const Vector3& x, const Visitor& visit)
{
  for (CornerPosition at = mesh.CornerOffset[point]; at < mesh.CornerOffset[point + 1]; ++at)
  {
    const Index position = mesh.CornerList[at];
    const int* hex = mesh.Elements.data() + (position & ~7);
    const int moving = static_cast<int>(position & 7);
    for (int corner : { moving, moving ^ 1, moving ^ 2, moving ^ 4 })
    {
      visit(MakeCorner(mesh, hex, corner, moving, x, mesh.WidthsAt(position)));
    }
  }
}

} // namespace

double UntangleEnergy::Evaluate(
  const ActiveMesh& mesh, int point, const Vector3& x, const SmoothingStage& stage) const
{
  double energy = 0.0;
  ForCorners(mesh, point, x,
    [&](const Corner& k)
    {
      energy += (Target * k.Lengths + stage.Omega * ShapeOf(k)) / Regularise(k.D, this->Eps).Value +
        EdgeOf(k, 0) + EdgeOf(k, 1) + EdgeOf(k, 2);
    });
  return energy;
}

Derivatives UntangleEnergy::Differentiate(
  const ActiveMesh& mesh, int point, const SmoothingStage& stage) const
{
  Derivatives d;
  ForCorners(
    mesh, point, mesh.X[point], [&](const Corner& k) { AddCorner(d, k, stage.Omega, this->Eps); });
  return d;
}

} // namespace vfm
