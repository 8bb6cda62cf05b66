#include "Interface/Crossings.h"

#include "Base/Vector3.h"
#include "Fractions/GradientFit.h"
#include "Fractions/LayerFit.h"
#include "Fractions/Plic.h"

namespace vfm
{
namespace
{

constexpr double PureFraction = 0.003; // a cell closer to 0 or 1 has no plane
constexpr double PairShare = 0.3;      // least fraction of the pair in a cell with a plane
// Least fraction of the pair in a cell that a plane is fitted to.
constexpr double SampleShare = 0.5;
constexpr double GoodFit = 0.1;      // largest rms error of fractions of a fitted plane
constexpr double LeastWeight = 0.01; // least weight of a crossing
// For a smaller n.axis, the foot of the plane replaces its cut with the edge.
constexpr double SteepPlane = 0.25;
// Normals of crossings with a smaller n.axis are turned by AddedSlope.
constexpr double SmallestSlope = 0.02;
constexpr double AddedSlope = 0.3;
constexpr Index SearchRadius = 2; // distance of faces for FindCrossingNear, in cells

/// One of the two cells of the dual edge.
struct Side
{
  Index Cell;
  Vector3 Centre; // grid coordinates
  Vector3 Widths; // grid coordinates
  double D;       // difference field
  // Gradient of D in the frame of the cell; at sides of the domain turned to the normal
  // of the fitted plane.
  Vector3 Gradient;
  bool IsOneSided; // whether the cell is at a side of the domain
  bool HasPlane;   // whether a plane was fitted
};

struct Work
{
  const CartesianGrid& Grid;
  const FractionField& Fractions;
  const InterfaceFace& Face;
  double IsoValue;
  int First = Face.First(), Second = Face.Second();
  double Scale = 1.0 / Grid.MeanWidth();
};

Vector3 CellCentre(const Work& work, const Index3& p)
{
  Vector3 c;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = work.Grid.Coordinates(a);
    c[a] = (0.5 * (x[p[a]] + x[p[a] + 1]) - x[0]) * work.Scale;
  }
  return c;
}

Vector3 CellWidths(const Work& work, const Index3& p)
{
  return { { work.Grid.Width(0, p[0]) * work.Scale, work.Grid.Width(1, p[1]) * work.Scale,
    work.Grid.Width(2, p[2]) * work.Scale } };
}

double Difference(const Work& work, Index cell)
{
  return work.First == 0
    ? 2.0 * (1.0 - work.IsoValue - work.Fractions.Fraction(cell, 0))
    : work.Fractions.Fraction(cell, work.Second) - work.Fractions.Fraction(cell, work.First);
}

/// Returns the gradient over the 3^3 cells in the domain.
Vector3 Gradient(const Work& work, const Side& side, const Index3& p)
{
  GradientFit fit;
  for (int c = 0; c < 27; ++c)
  {
    const Index3 q = CellAround(p, c);
    if (c != 13 && work.Grid.InDomain(q))
    {
      fit.Add(Divided(CellCentre(work, q) - side.Centre, side.Widths),
        Difference(work, work.Grid.Linear(q)) - side.D);
    }
  }
  return fit.Solve();
}

/// Returns the fraction of a cell that both labels fill.
double PairFills(const Work& work, Index cell)
{
  return work.Fractions.Fraction(cell, work.First) + work.Fractions.Fraction(cell, work.Second);
}

/// Adds the share of the first label in the pair, unless the pair fills little of the cell.
void AddSample(
  const Work& work, const Side& side, const Index3& p, std::vector<FractionSample>& samples)
{
  const Index cell = work.Grid.Linear(p);
  const double filled = PairFills(work, cell);
  if (filled >= SampleShare)
  {
    samples.push_back({ Divided(CellCentre(work, p) - side.Centre, side.Widths),
      Divided(CellWidths(work, p), side.Widths),
      std::min(work.Fractions.Fraction(cell, work.First) / filled, 1.0), 1.0 });
  }
}

bool IsMixed(double fraction)
{
  return fraction > PureFraction && fraction < 1.0 - PureFraction;
}

/// Turns the gradient to the normal of the plane that fits the fractions over 3^3 cells; returns
/// false if no plane fits.
bool TurnToPlane(const Work& work, const Index3& p, Side& side)
{
  std::vector<FractionSample> samples;
  samples.reserve(27);
  AddSample(work, side, p, samples);
  if (samples.empty() || !IsMixed(samples[0].Value))
  {
    return false;
  }
  for (int c = 0; c < 27; ++c)
  {
    const Index3 q = CellAround(p, c);
    if (c != 13 && work.Grid.InDomain(q))
    {
      AddSample(work, side, q, samples);
    }
  }
  const LayerFit fit = FitHalfSpace(samples);
  if (!fit.IsFound || fit.Error > GoodFit)
  {
    return false;
  }
  side.Gradient = Norm(side.Gradient) * fit.Region.Normal;
  return true;
}

Side MakeSide(const Work& work, Index cell)
{
  Side side;
  const Index3 p = work.Grid.Position(cell);
  side.Cell = cell;
  side.Centre = CellCentre(work, p);
  side.Widths = CellWidths(work, p);
  side.D = Difference(work, cell);
  side.Gradient = Gradient(work, side, p);
  side.IsOneSided = !work.Grid.InDomain({ { p[0] - 1, p[1] - 1, p[2] - 1 } }) ||
    !work.Grid.InDomain({ { p[0] + 1, p[1] + 1, p[2] + 1 } });
  side.HasPlane = side.IsOneSided && TurnToPlane(work, p, side);
  return side;
}

/// Returns where D changes sign along the dual edge: 0 at the lower cell, 1 at the upper.
double LinearParameter(const Work& work, const Side& lower, const Side& upper)
{
  const double sign = work.Face.LowerLabel == work.First ? 1.0 : -1.0;
  const double a = sign * lower.D, b = sign * upper.D; // a < 0 < b unless a cell was flipped
  if (a <= 0.0 && b >= 0.0 && a < b)
  {
    return a / (a - b);
  }
  return a > 0.0 && b > 0.0 ? 0.0 : (a < 0.0 && b < 0.0 ? 1.0 : 0.5);
}

/// Sets the share of the first label in the pair; returns false if the cell has no plane.
bool PlaneFraction(const Work& work, const Side& side, double& fraction)
{
  if (work.First == 0)
  {
    fraction = work.Fractions.Fraction(side.Cell, 0);
  }
  else
  {
    const double a = work.Fractions.Fraction(side.Cell, work.First);
    const double b = work.Fractions.Fraction(side.Cell, work.Second);
    if (a + b < PairShare)
    {
      return false;
    }
    fraction = a / (a + b);
  }
  return IsMixed(fraction) && Norm(side.Gradient) > 1e-12;
}

/// Returns the cut of the plane of a cell with the dual edge.
Vector3 CutOfPlane(const Work& work, const Side& side, double fraction)
{
  const Vector3 n = Unit(side.Gradient);
  const double d = PlaneOfVolume(n, fraction);
  const double slope = work.Face.LowerLabel == work.First ? n[work.Face.Axis] : -n[work.Face.Axis];
  Vector3 foot = d * n;
  if (slope >= SteepPlane)
  {
    foot = { { 0.0, 0.0, 0.0 } };
    foot[work.Face.Axis] = d / n[work.Face.Axis];
  }
  return side.Centre + Scaled(side.Widths, foot);
}

void MoveToPlanes(const Work& work, const Side& lower, const Side& upper, Vector3& point)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  double weights = 0.0;
  for (const Side* side : { &lower, &upper })
  {
    double f = 0.0;
    if (PlaneFraction(work, *side, f))
    {
      const double w = f * (1.0 - f) + 0.01;
      sum = sum + w * CutOfPlane(work, *side, f);
      weights += w;
    }
  }
  if (weights > 0.0)
  {
    point = (1.0 / weights) * sum;
  }
}

Vector3 BlendNormals(const Work& work, const Side& lower, const Side& upper, double t)
{
  if (lower.IsOneSided && upper.IsOneSided && lower.HasPlane != upper.HasPlane)
  {
    t = upper.HasPlane ? 1.0 : 0.0; // the gradient would tilt the normal
  }
  const Vector3 widths = 0.5 * (lower.Widths + upper.Widths);
  Vector3 n = Unit((1.0 - t) * Scaled(widths, Divided(lower.Gradient, lower.Widths)) +
    t * Scaled(widths, Divided(upper.Gradient, upper.Widths)));
  const double sign = work.Face.LowerLabel == work.First ? 1.0 : -1.0;
  if (sign * n[work.Face.Axis] < SmallestSlope)
  {
    n[work.Face.Axis] += sign * AddedSlope;
    if (sign * n[work.Face.Axis] <= 0.0) // the gradients contradict the labels
    {
      n = { { 0.0, 0.0, 0.0 } };
      n[work.Face.Axis] = sign;
    }
  }
  return Unit(Divided(n, widths));
}

/// Position of a face relative to another.
struct FaceStep
{
  Index3 Node;
  int Axis;
};

/// Lists the steps from a face across an axis to the faces at most SearchRadius
/// away, the nearest first.
std::vector<FaceStep> MakeSteps(int axis)
{
  std::vector<FaceStep> steps;
  IndexBox box;
  box.Lower.fill(-SearchRadius);
  box.Upper.fill(SearchRadius + 1);
  ForCells(box,
    [&](const Index3& p)
    {
      for (int a = 0; a < 3; ++a)
      {
        steps.push_back({ p, a });
      }
    });
  // Square of the distance of face centres, in half cells.
  const auto square = [axis](const FaceStep& step)
  {
    Index sum = 0;
    for (int a = 0; a < 3; ++a)
    {
      const Index halves = 2 * step.Node[a] + (a == axis) - (a == step.Axis);
      sum += halves * halves;
    }
    return sum;
  };
  std::stable_sort(steps.begin(), steps.end(),
    [&](const FaceStep& a, const FaceStep& b) { return square(a) < square(b); });
  return steps;
}

} // namespace

Crossing FindCrossing(const CartesianGrid& grid, const FractionField& fractions,
  const InterfaceFace& face, double isoValue)
{
  const Work work{ grid, fractions, face, isoValue };
  const Side lower = MakeSide(work, work.Face.Node - work.Grid.Stride(work.Face.Axis));
  const Side upper = MakeSide(work, work.Face.Node);
  const double t = LinearParameter(work, lower, upper);
  Crossing crossing;
  crossing.Point = (1.0 - t) * lower.Centre + t * upper.Centre;
  if (work.IsoValue == 0.5)
  {
    MoveToPlanes(work, lower, upper, crossing.Point);
  }
  crossing.Normal = BlendNormals(work, lower, upper, t);
  const double filled = PairFills(work, lower.Cell) * PairFills(work, upper.Cell);
  crossing.Weight = std::max(filled * filled, LeastWeight);
  return crossing;
}

Crossing FindCrossingNear(const CartesianGrid& grid, const FractionField& fractions,
  const InterfaceFace& face, double isoValue)
{
  static const std::array<std::vector<FaceStep>, 3> steps{ { MakeSteps(0), MakeSteps(1),
    MakeSteps(2) } };
  const Index3 p = grid.Position(face.Node);
  for (const FaceStep& step : steps[face.Axis])
  {
    const Index3 upper{ { p[0] + step.Node[0], p[1] + step.Node[1], p[2] + step.Node[2] } };
    Index3 lower = upper;
    --lower[step.Axis];
    if (!grid.Local().Contains(upper) || !grid.Local().Contains(lower))
    {
      continue;
    }
    const Index node = grid.Linear(upper);
    const InterfaceFace other{ node, step.Axis,
      MaterialOfCell(fractions, node - grid.Stride(step.Axis), isoValue),
      MaterialOfCell(fractions, node, isoValue) };
    if (other.First() == face.First() && other.Second() == face.Second())
    {
      return FindCrossing(grid, fractions, other, isoValue);
    }
  }
  return FindCrossing(grid, fractions, face, isoValue);
}

} // namespace vfm
