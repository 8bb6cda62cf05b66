#include "Creases/CreaseModel.h"

#include "Creases/BoxCut.h"

namespace vfm
{
namespace
{

/// Sign times the indicator of what is inside of all surfaces of a mask, outside of those that are flipped. Mask 0: 1.
struct Term
{
  int Sign, Mask, Flipped;
};

/// Of at most two terms, so that at most one needs more planes than one: A or B = 1 - (not A and not B).
using Terms = std::array<Term, 2>;

constexpr int NoTerm = 0;
constexpr Terms OfOne{ { { 1, 1, 0 }, { NoTerm, 0, 0 } } };
constexpr std::array<Terms, 2> OfTwo{ {
  { { { 1, 3, 0 }, { NoTerm, 0, 0 } } },
  { { { 1, 0, 0 }, { -1, 3, 3 } } },
} };
constexpr std::array<Terms, 8> OfThree{ {
  { { { 1, 7, 0 }, { NoTerm, 0, 0 } } },
  { { { 1, 0, 0 }, { -1, 7, 7 } } },
  { { { 1, 1, 0 }, { -1, 7, 6 } } }, // (X or Y) and Z
  { { { 1, 2, 0 }, { -1, 7, 5 } } },
  { { { 1, 4, 0 }, { -1, 7, 3 } } },
  { { { 1, 1, 0 }, { 1, 7, 1 } } }, // (X and Y) or Z
  { { { 1, 2, 0 }, { 1, 7, 2 } } },
  { { { 1, 4, 0 }, { 1, 7, 4 } } },
} };

const Terms& TermsOf(const CreaseModel& model)
{
  if (model.Count == 1)
  {
    return OfOne;
  }
  return model.Count == 2 ? OfTwo[model.Composition] : OfThree[model.Composition];
}

BoxPlane Flipped(const BoxPlane& plane)
{
  return { -1.0 * plane.Normal, -plane.Height };
}

/// The tangent plane of a surface over the centre of a cell, in the frame of the cell as a unit cube.
BoxPlane PlaneIn(const LocalQuadric& s, const SampleCell& cell, QuadricHeight& at)
{
  at = HeightAt(s, cell.Centre);
  const double mean = (s.C[3] + s.C[5]) / 12.0;
  return { 2.0 * Scaled(cell.Half, s.N - at.AlongU * s.U - at.AlongV * s.V),
    Dot(cell.Centre - s.Base, s.N) - at.W - mean };
}

/// The planes of a model in a cell, and which leave it wholly inside or outside.
struct CellPlanes
{
  std::array<BoxPlane, CreaseModel::MostSurfaces> Planes;
  std::array<QuadricHeight, CreaseModel::MostSurfaces> At;
  int In = 0, Out = 0;

  CellPlanes(const CreaseModel& model, const SampleCell& cell)
  {
    for (int k = 0; k < model.Count; ++k)
    {
      this->Planes[k] = PlaneIn(model.Surfaces[k], cell, this->At[k]);
      const double reach = ReachOf(this->Planes[k]);
      this->In |= (this->Planes[k].Height >= reach) << k;
      this->Out |= (this->Planes[k].Height <= -reach) << k;
    }
  }
};

/// Volume of a term; adds what each plane does to it.
double VolumeOf(const Term& term, const CellPlanes& cell, std::array<PlaneRates, 3>& rates)
{
  const int in = (cell.In & ~term.Flipped) | (cell.Out & term.Flipped);
  const int out = (cell.Out & ~term.Flipped) | (cell.In & term.Flipped);
  if (term.Mask & out)
  {
    return 0.0;
  }
  const int mask = term.Mask & ~in;
  if (mask == 0)
  {
    return term.Sign;
  }
  std::array<BoxPlane, 3> planes;
  std::array<PlaneRates, 3> parts;
  for (int k = 0; k < 3; ++k)
  {
    if (mask >> k & 1)
    {
      planes[k] = term.Flipped >> k & 1 ? Flipped(cell.Planes[k]) : cell.Planes[k];
    }
  }
  const bool single = (mask & (mask - 1)) == 0;
  const double volume =
    single ? CutBox(planes[mask >> 1], parts[mask >> 1]) : CutBox(planes, mask, parts);
  for (int k = 0; k < 3; ++k)
  {
    if (mask >> k & 1)
    {
      const double sign = term.Flipped >> k & 1 ? -term.Sign : term.Sign;
      rates[k].ByHeight += sign * parts[k].ByHeight;
      rates[k].ByNormal = rates[k].ByNormal + sign * parts[k].ByNormal;
    }
  }
  return term.Sign * volume;
}

/// Chain rule: plane -> coefficients of its surface.
void SetDerivatives(const LocalQuadric& s, const SampleCell& cell, const QuadricHeight& at,
  const PlaneRates& rates, double* derivatives)
{
  const Vector3 moved = -2.0 * Scaled(cell.Half, rates.ByNormal);
  const double h = -rates.ByHeight, u = Dot(moved, s.U), v = Dot(moved, s.V);
  derivatives[0] = h;
  derivatives[1] = h * at.U + u;
  derivatives[2] = h * at.V + v;
  derivatives[3] = h * (at.U * at.U + 1.0 / 12.0) + 2.0 * at.U * u;
  derivatives[4] = h * at.U * at.V + at.V * u + at.U * v;
  derivatives[5] = h * (at.V * at.V + 1.0 / 12.0) + 2.0 * at.V * v;
}

} // namespace

int NumberOfCompositions(int surfaces)
{
  return surfaces == 1 ? 1 : static_cast<int>(surfaces == 2 ? OfTwo.size() : OfThree.size());
}

bool IsInside(const CreaseModel& model, int bits)
{
  int sum = 0;
  for (const Term& term : TermsOf(model))
  {
    sum += ((bits ^ term.Flipped) & term.Mask) == term.Mask ? term.Sign : 0;
  }
  return sum != 0;
}

double FractionIn(const CreaseModel& model, const SampleCell& cell)
{
  return FractionIn(model, cell, nullptr, nullptr);
}

double FractionIn(
  const CreaseModel& model, const SampleCell& cell, double* derivatives, double* areas)
{
  const CellPlanes planes(model, cell);
  std::array<PlaneRates, CreaseModel::MostSurfaces> rates{};
  double fraction = 0.0;
  for (const Term& term : TermsOf(model))
  {
    fraction += term.Sign != NoTerm ? VolumeOf(term, planes, rates) : 0.0;
  }
  for (int k = 0; k < model.Count; ++k)
  {
    const QuadricHeight& at = planes.At[k];
    if (areas)
    {
      areas[k] += 8.0 * cell.Half[0] * cell.Half[1] * cell.Half[2] * rates[k].ByHeight *
        std::sqrt(1.0 + at.AlongU * at.AlongU + at.AlongV * at.AlongV);
    }
    if (derivatives)
    {
      SetDerivatives(model.Surfaces[k], cell, at, rates[k], derivatives + 6 * k);
    }
  }
  return fraction;
}

} // namespace vfm
