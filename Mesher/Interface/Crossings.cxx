#include "Interface/Crossings.h"

#include "Base/Vector3.h"
#include "Fractions/GradientFit.h"
#include "Fractions/LayerFit.h"
#include "Fractions/Plic.h"
#include "Interface/ScaledCells.h"

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
constexpr Index SearchRadius = 2;       // distance of faces for FindNear, in cells
constexpr std::size_t KeptSides = 2048; // power of 2

/// Fractions of the two labels of a face.
class PairFractions
{
public:
  PairFractions(const FractionField& fractions, const InterfaceFace& face, double isoValue) :
    Fractions(fractions), First(face.First()), Second(face.Second()), IsoValue(isoValue)
  {
  }

  bool HasVoid() const { return this->First == 0; }
  double OfFirst(Index cell) const { return this->Fractions.Fraction(cell, this->First); }
  double OfSecond(Index cell) const { return this->Fractions.Fraction(cell, this->Second); }
  double OfBoth(Index cell) const { return this->OfFirst(cell) + this->OfSecond(cell); }
  /// Returns the difference field, 0 at the interface.
  double Difference(Index cell) const
  {
    return this->HasVoid() ? 2.0 * (1.0 - this->IsoValue - this->OfFirst(cell))
                           : this->OfSecond(cell) - this->OfFirst(cell);
  }

private:
  const FractionField& Fractions;
  int First, Second;
  double IsoValue;
};

/// Returns the gradient over the 3^3 cells in the domain.
Vector3 Gradient(
  const ScaledCells& cells, const PairFractions& pair, const EndCell& side, const Index3& p)
{
  GradientFit fit;
  for (int c = 0; c < 27; ++c)
  {
    const Index3 q = CellAround(p, c);
    if (c != 13 && cells.Grid.InDomain(q))
    {
      fit.Add(Divided(cells.Centre(q) - side.Centre, side.Widths),
        pair.Difference(cells.Grid.Linear(q)) - side.D);
    }
  }
  return fit.Solve();
}

/// Adds the share of the first label in the pair, unless the pair fills little of the cell.
void AddSample(const ScaledCells& cells, const PairFractions& pair, const EndCell& side,
  const Index3& p, std::vector<FractionSample>& samples)
{
  const Index cell = cells.Grid.Linear(p);
  const double filled = pair.OfBoth(cell);
  if (filled >= SampleShare)
  {
    samples.push_back({ Divided(cells.Centre(p) - side.Centre, side.Widths),
      Divided(cells.Widths(p), side.Widths), std::min(pair.OfFirst(cell) / filled, 1.0), 1.0 });
  }
}

bool IsMixed(double fraction)
{
  return fraction > PureFraction && fraction < 1.0 - PureFraction;
}

/// Turns the gradient to the normal of the plane that fits the fractions over 3^3 cells; returns
/// false if no plane fits.
bool TurnToPlane(
  const ScaledCells& cells, const PairFractions& pair, const Index3& p, EndCell& side)
{
  std::vector<FractionSample> samples;
  samples.reserve(27);
  AddSample(cells, pair, side, p, samples);
  if (samples.empty() || !IsMixed(samples[0].Value))
  {
    return false;
  }
  for (int c = 0; c < 27; ++c)
  {
    const Index3 q = CellAround(p, c);
    if (c != 13 && cells.Grid.InDomain(q))
    {
      AddSample(cells, pair, side, q, samples);
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

/// Finds the PLIC plane of a cell, if it has one.
void FindPlane(const PairFractions& pair, EndCell& side)
{
  const double both = pair.HasVoid() ? 1.0 : pair.OfBoth(side.Cell);
  if (both < PairShare)
  {
    return;
  }
  side.Share = pair.OfFirst(side.Cell) / both;
  side.IsCut = IsMixed(side.Share) && Norm(side.Gradient) > 1e-12;
  if (side.IsCut)
  {
    side.Plane = PlaneOfVolume(Unit(side.Gradient), side.Share);
  }
}

/// @param hasPlanes  whether cells may have PLIC planes
EndCell MakeSide(const ScaledCells& cells, const PairFractions& pair, Index cell, bool hasPlanes)
{
  EndCell side;
  const CartesianGrid& grid = cells.Grid;
  const Index3 p = grid.Position(cell);
  side.Cell = cell;
  side.Centre = cells.Centre(p);
  side.Widths = cells.Widths(p);
  side.D = pair.Difference(cell);
  side.Gradient = Gradient(cells, pair, side, p);
  side.IsOneSided = !grid.InDomain({ { p[0] - 1, p[1] - 1, p[2] - 1 } }) ||
    !grid.InDomain({ { p[0] + 1, p[1] + 1, p[2] + 1 } });
  side.HasPlane = side.IsOneSided && TurnToPlane(cells, pair, p, side);
  side.IsCut = false;
  if (hasPlanes)
  {
    FindPlane(pair, side);
  }
  return side;
}

/// Returns 1 if the difference field grows along the axis of a face, otherwise -1.
double SignOf(const InterfaceFace& face)
{
  return face.LowerLabel == face.First() ? 1.0 : -1.0;
}

/// Returns where D changes sign along the dual edge: 0 at the lower cell, 1 at the upper.
double LinearParameter(const InterfaceFace& face, const EndCell& lower, const EndCell& upper)
{
  const double sign = SignOf(face);
  const double a = sign * lower.D, b = sign * upper.D; // a < 0 < b unless a cell was flipped
  if (a <= 0.0 && b >= 0.0 && a < b)
  {
    return a / (a - b);
  }
  return a > 0.0 && b > 0.0 ? 0.0 : (a < 0.0 && b < 0.0 ? 1.0 : 0.5);
}

/// Returns the cut of the plane of a cell with the dual edge.
Vector3 CutOfPlane(const InterfaceFace& face, const EndCell& side)
{
  const Vector3 n = Unit(side.Gradient);
  Vector3 foot = side.Plane * n;
  if (SignOf(face) * n[face.Axis] >= SteepPlane)
  {
    foot = { { 0.0, 0.0, 0.0 } };
    foot[face.Axis] = side.Plane / n[face.Axis];
  }
  return side.Centre + Scaled(side.Widths, foot);
}

/// Moves a point to the mean cut of the planes of both cells, as far as they have one.
void MoveToPlanes(
  const InterfaceFace& face, const EndCell& lower, const EndCell& upper, Vector3& point)
{
  Vector3 sum{ { 0.0, 0.0, 0.0 } };
  double weights = 0.0;
  for (const EndCell* side : { &lower, &upper })
  {
    if (side->IsCut)
    {
      const double w = side->Share * (1.0 - side->Share) + 0.01;
      sum = sum + w * CutOfPlane(face, *side);
      weights += w;
    }
  }
  if (weights > 0.0)
  {
    point = (1.0 / weights) * sum;
  }
}

Vector3 BlendNormals(
  const InterfaceFace& face, const EndCell& lower, const EndCell& upper, double t)
{
  if (lower.IsOneSided && upper.IsOneSided && lower.HasPlane != upper.HasPlane)
  {
    t = upper.HasPlane ? 1.0 : 0.0; // the gradient would tilt the normal
  }
  const Vector3 widths = 0.5 * (lower.Widths + upper.Widths);
  Vector3 n = Unit((1.0 - t) * Scaled(widths, Divided(lower.Gradient, lower.Widths)) +
    t * Scaled(widths, Divided(upper.Gradient, upper.Widths)));
  const double sign = SignOf(face);
  if (sign * n[face.Axis] < SmallestSlope)
  {
    n[face.Axis] += sign * AddedSlope;
    if (sign * n[face.Axis] <= 0.0) // the gradients contradict the labels
    {
      n = { { 0.0, 0.0, 0.0 } };
      n[face.Axis] = sign;
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

CrossingFinder::CrossingFinder(
  const CartesianGrid& grid, const FractionField& fractions, double isoValue) :
  Grid(grid), Fractions(fractions), IsoValue(isoValue), Sides(KeptSides)
{
}

/// Returns a cell of the dual edge of a face. Valid until the next call for a cell that has the
/// same place in the list.
const EndCell& CrossingFinder::FindSide(const InterfaceFace& face, Index cell)
{
  const int first = face.First(), second = face.Second();
  const std::size_t key = static_cast<std::size_t>(cell) ^ (37 * first + 1009 * second);
  EndCell& side = this->Sides[key % KeptSides];
  if (side.Cell != cell || side.First != first || side.Second != second)
  {
    side = MakeSide(ScaledCells(this->Grid), PairFractions(this->Fractions, face, this->IsoValue),
      cell, this->IsoValue == 0.5);
    side.First = first;
    side.Second = second;
  }
  return side;
}

Crossing CrossingFinder::Find(const InterfaceFace& face)
{
  const EndCell lower = this->FindSide(face, face.Node - this->Grid.Stride(face.Axis));
  const EndCell& upper = this->FindSide(face, face.Node);
  const double t = LinearParameter(face, lower, upper);
  Crossing crossing;
  crossing.Point = (1.0 - t) * lower.Centre + t * upper.Centre;
  MoveToPlanes(face, lower, upper, crossing.Point);
  crossing.Normal = BlendNormals(face, lower, upper, t);
  const PairFractions pair(this->Fractions, face, this->IsoValue);
  const double filled = pair.OfBoth(lower.Cell) * pair.OfBoth(upper.Cell);
  crossing.Weight = std::max(filled * filled, LeastWeight);
  return crossing;
}

Crossing CrossingFinder::FindNear(const InterfaceFace& face)
{
  static const std::array<std::vector<FaceStep>, 3> steps{ { MakeSteps(0), MakeSteps(1),
    MakeSteps(2) } };
  const Index3 p = this->Grid.Position(face.Node);
  for (const FaceStep& step : steps[face.Axis])
  {
    const Index3 upper{ { p[0] + step.Node[0], p[1] + step.Node[1], p[2] + step.Node[2] } };
    Index3 lower = upper;
    --lower[step.Axis];
    if (!this->Grid.Local().Contains(upper) || !this->Grid.Local().Contains(lower))
    {
      continue;
    }
    const Index node = this->Grid.Linear(upper);
    const InterfaceFace other{ node, step.Axis,
      MaterialOfCell(this->Fractions, node - this->Grid.Stride(step.Axis), this->IsoValue),
      MaterialOfCell(this->Fractions, node, this->IsoValue) };
    if (other.First() == face.First() && other.Second() == face.Second())
    {
      return this->Find(other);
    }
  }
  return this->Find(face);
}

} // namespace vfm
