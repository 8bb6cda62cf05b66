#include "Fractions/ChildFractions.h"

#include "Base/ConvexClip.h"
#include "Base/Vector3.h"
#include "Fractions/LayerFit.h"
#include "Fractions/SharpFractions.h"

#include <numeric>

namespace vfm
{
namespace
{

// Largest rms error of fractions of a plane or film that is accepted.
constexpr double GoodFit = 0.1;
constexpr double FilmAdvantage = 0.6; // largest error of a film, relative to the plane
constexpr double Nothing = 1e-13;     // smaller fractions count as 0
// Fractions this close to one half become one half, so that a flat face gets one label.
constexpr double Tie = 1e-12;

/// Positions of the children of a cell, in its frame.
class Children
{
public:
  explicit Children(const Index3& counts) :
    Counts(counts),
    ChildSize{ { 1.0 / static_cast<double>(counts[0]), 1.0 / static_cast<double>(counts[1]),
      1.0 / static_cast<double>(counts[2]) } }
  {
  }

  std::size_t Count() const { return this->Counts[0] * this->Counts[1] * this->Counts[2]; }
  const Vector3& Size() const { return this->ChildSize; }
  Vector3 Centre(std::size_t c) const
  {
    const Index3 place = CellInBox({ { { 0, 0, 0 } }, this->Counts }, static_cast<Index>(c));
    Vector3 centre;
    for (int a = 0; a < 3; ++a)
    {
      centre[a] =
        (static_cast<double>(place[a]) + 0.5) / static_cast<double>(this->Counts[a]) - 0.5;
    }
    return centre;
  }
  /// Returns the fractions of full children.
  ChildFractions Full() const { return ChildFractions(this->Count(), 1.0); }

  const Index3 Counts;

private:
  const Vector3 ChildSize;
};

/// Corrects the rounding of planes: makes the mean fraction of the children equal to the fraction
/// of the cell. Values stay between 0 and the largest fraction of each child.
void Correct(ChildFractions& values, const ChildFractions& room, double fraction)
{
  double missing = static_cast<double>(values.size()) * fraction, weights = 0.0;
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    double& value = values[c];
    value = value < Nothing ? 0.0 : (value > room[c] - Nothing ? room[c] : value);
    missing -= value;
    weights += value * (room[c] - value);
  }
  for (std::size_t c = 0; weights > 0.0 && c < values.size(); ++c)
  {
    const double share = values[c] * (room[c] - values[c]) / weights;
    values[c] = std::min(std::max(values[c] + share * missing, 0.0), room[c]);
  }
}

/// Part of a cell that planes have left.
class Remainder
{
public:
  explicit Remainder(const Children& children) :
    Whole(MakeBoxPiece({ { -0.5, -0.5, -0.5 } }, { { 0.5, 0.5, 0.5 } }))
  {
    for (std::size_t c = 0; c < children.Count(); ++c)
    {
      const Vector3 centre = children.Centre(c), half = 0.5 * children.Size();
      this->Pieces.push_back(MakeBoxPiece(centre - half, centre + half));
    }
  }

  /// Cuts off a volume below a plane with a normal; returns the fractions of that
  /// volume in the children.
  ChildFractions CutOff(const Vector3& normal, double volume)
  {
    const HalfSpace plane{ normal, this->FindOffset(normal, volume) };
    const double count = static_cast<double>(this->Pieces.size());
    ChildFractions values;
    for (ConvexPiece& piece : this->Pieces)
    {
      values.push_back(count * this->Cut(piece, plane));
      std::swap(piece, this->Above);
    }
    this->Cut(this->Whole, plane);
    std::swap(this->Whole, this->Above);
    return values;
  }

private:
  double FindOffset(const Vector3& normal, double volume)
  {
    double low = -1.0, high = 1.0;
    while (high - low > 1e-12)
    {
      const double middle = 0.5 * (low + high);
      (this->Cut(this->Whole, { normal, middle }) < volume ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  double Cut(const ConvexPiece& piece, const HalfSpace& plane)
  {
    ClipPiece(piece, plane, this->Below, this->Above, this->Section);
    return ComputeVolume(this->Below);
  }

  ConvexPiece Whole, Below, Above;
  std::vector<ConvexPiece> Pieces; // remaining part of each child
  std::vector<Vector3> Section;
};

/// Cell of the neighbourhood, in the frame of the divided cell.
struct Around
{
  Index Cell;
  Vector3 Centre, Size;
};
using Neighbourhood = std::vector<Around>; // the divided cell first

/// Part that a plane may cut off.
struct Choice
{
  std::size_t Place; // position among the parts that are left
  std::vector<FractionSample> Samples;
  LayerFit Fit;
  double Score = 0.0; // lower is better
};

/// Samples a part among some parts, itself included, in the cells that hold any of them.
std::vector<FractionSample> Sample(const FractionField& fractions, const Neighbourhood& cells,
  int material, const std::vector<int>& among)
{
  std::vector<FractionSample> samples;
  for (const Around& around : cells)
  {
    double sum = 0.0;
    for (int part : among)
    {
      sum += fractions.Fraction(around.Cell, part);
    }
    if (sum > 0.0)
    {
      samples.push_back({ around.Centre, around.Size,
        std::min(fractions.Fraction(around.Cell, material) / sum, 1.0), sum });
    }
  }
  return samples;
}

/// Samples a part against everything else.
std::vector<FractionSample> Sample(
  const FractionField& fractions, const Neighbourhood& cells, int material)
{
  std::vector<FractionSample> samples;
  for (const Around& around : cells)
  {
    samples.push_back(
      { around.Centre, around.Size, fractions.Fraction(around.Cell, material), 1.0 });
  }
  return samples;
}

/// Returns whether there are other materials than those of the divided cell.
bool HasOthersAround(const FractionField& fractions, const Neighbourhood& cells)
{
  const FractionField::Range parts = fractions.Parts(cells[0].Cell);
  return std::any_of(cells.begin(), cells.end(),
    [&](const Around& around)
    {
      double sum = 0.0;
      for (const FractionField::Part& part : parts)
      {
        sum += fractions.Fraction(around.Cell, part.Material);
      }
      return sum < 1.0 - 1e-9;
    });
}

/// Returns the error of cells without data; each counts with the error of a good fit.
double Doubt(const std::vector<FractionSample>& samples, std::size_t cells)
{
  double known = 0.0;
  for (const FractionSample& sample : samples)
  {
    known += sample.Weight;
  }
  return GoodFit * (1.0 - known / static_cast<double>(cells));
}

/// Returns the part that a plane separates best from the other parts left, or, first, from
/// everything else.
/// @param left  positions among the parts of the divided cell
Choice Choose(const FractionField& fractions, const Neighbourhood& cells,
  const std::vector<std::size_t>& left, bool isFirst)
{
  const FractionField::Range parts = fractions.Parts(cells[0].Cell);
  const bool isPair = left.size() == 2;
  const bool knowsOthers = isFirst && HasOthersAround(fractions, cells);
  std::vector<int> materials;
  for (std::size_t position : left)
  {
    materials.push_back(parts.First[position].Material);
  }
  std::vector<Choice> choices;
  for (std::size_t place = 0; place < left.size(); ++place)
  {
    const bool isNew = place == 0 || !isPair; // both parts of a pair give the same plane
    if (isFirst && (isNew || knowsOthers))
    {
      choices.push_back({ place, Sample(fractions, cells, materials[place]), {} });
    }
    if (isNew && (!isFirst || (isPair && knowsOthers)))
    {
      choices.push_back({ place, Sample(fractions, cells, materials[place], materials), {} });
    }
  }
  for (Choice& choice : choices)
  {
    choice.Fit = FitHalfSpace(choice.Samples);
    choice.Score =
      choice.Fit.IsFound ? choice.Fit.Error + Doubt(choice.Samples, cells.size()) : 2.0;
  }
  return *std::min_element(choices.begin(), choices.end(),
    [](const Choice& a, const Choice& b) { return a.Score < b.Score; });
}

ChildFractions FillChildren(const Children& children, const Layer& layer)
{
  ChildFractions values(children.Count());
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    values[c] = FractionInLayer(layer, children.Centre(c), children.Size());
  }
  return values;
}

/// Divides edges, corners, rods and balls, which no plane fits.
/// @param cut  part whose fractions are returned, 0 or 1
ChildFractions ShareSmoothly(const CartesianGrid& grid, const FractionField& fractions,
  const Index3& cell, const Index3& counts, std::size_t cut)
{
  const FractionField::Range parts = fractions.Parts(grid.Linear(cell));
  const FractionField::Part& first = parts.First[cut];
  const std::vector<double> weights(fractions.NumberOfMaterials() + 1, 1.0);
  const std::array<int, 2> materials{ { first.Material, parts.First[1 - cut].Material } };
  PatchFinder finder(grid, fractions.NumberOfMaterials());
  const std::vector<MaterialPatch>& patches = finder.Find(cell, materials, weights,
    [&](const auto& visit)
    {
      for (int n = 0; n < 27; ++n)
      {
        fractions.ForParts(grid.Linear(grid.Global().Nearest(CellAround(cell, n))),
          [&](int material, double fraction) { visit(n, material, fraction); });
      }
    });
  return ShareChildren(patches[0], patches[1], counts, first.Fraction);
}

/// Replaces the fit by the film of either part that fits much better.
void TryFilms(std::vector<FractionSample> samples, LayerFit& fit, std::size_t& cut)
{
  double largest = fit.IsFound ? FilmAdvantage * fit.Error : 2.0;
  for (std::size_t part : { cut, 1 - cut })
  {
    const LayerFit film = FitFilm(samples);
    if (film.Error < largest)
    {
      fit = film;
      cut = part;
      largest = film.Error;
    }
    for (FractionSample& sample : samples)
    {
      sample.Value = 1.0 - sample.Value;
    }
  }
}

/// Divides a cell with two parts.
std::vector<ChildFractions> SplitInTwo(const CartesianGrid& grid, const FractionField& fractions,
  const Neighbourhood& cells, const Children& places)
{
  Choice choice = Choose(fractions, cells, { 0, 1 }, true);
  std::size_t cut = choice.Place; // the part inside the layer
  if (!choice.Fit.IsFound || choice.Fit.Error > GoodFit)
  {
    TryFilms(choice.Samples, choice.Fit, cut);
  }
  const Index cell = cells[0].Cell;
  std::vector<ChildFractions> children(2);
  children[cut] = choice.Fit.IsFound && choice.Fit.Error <= GoodFit
    ? FillChildren(places, choice.Fit.Region)
    : ShareSmoothly(grid, fractions, grid.Position(cell), places.Counts, cut);
  Correct(children[cut], places.Full(), fractions.Parts(cell).First[cut].Fraction);
  for (double& value : children[cut])
  {
    value = std::fabs(value - 0.5) < Tie ? 0.5 : value;
    children[1 - cut].push_back(1.0 - value);
  }
  return children;
}

/// Fills the space that planes have left evenly with the remaining parts.
/// @param left  positions of the remaining parts
void Share(FractionField::Range parts, const std::vector<std::size_t>& left,
  const ChildFractions& room, std::vector<ChildFractions>& children)
{
  double sum = 0.0;
  for (std::size_t position : left)
  {
    sum += parts.First[position].Fraction;
  }
  for (std::size_t position : left)
  {
    for (double value : room)
    {
      children[position].push_back(value * (parts.First[position].Fraction / sum));
    }
  }
}

/// Divides a cell with three parts or more.
std::vector<ChildFractions> CutOneByOne(
  const FractionField& fractions, const Neighbourhood& cells, const Children& places)
{
  const FractionField::Range parts = fractions.Parts(cells[0].Cell);
  const std::size_t count = parts.Last - parts.First;
  std::vector<ChildFractions> children(count);
  std::vector<std::size_t> left(count); // positions of parts
  std::iota(left.begin(), left.end(), std::size_t(0));
  ChildFractions room = places.Full();
  Remainder remainder(places);
  while (left.size() > 1)
  {
    const Choice choice = Choose(fractions, cells, left, left.size() == count);
    if (!choice.Fit.IsFound)
    {
      break;
    }
    const std::size_t position = left[choice.Place];
    const double fraction = parts.First[position].Fraction;
    children[position] = remainder.CutOff(choice.Fit.Region.Normal, fraction);
    Correct(children[position], room, fraction);
    for (std::size_t c = 0; c < room.size(); ++c)
    {
      room[c] -= children[position][c];
    }
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(choice.Place));
  }
  Share(parts, left, room, children);
  return children;
}

/// Places the neighbour at a step in the frame of a cell.
Around Place(const CartesianGrid& grid, const Index3& middle, const Index3& step)
{
  const Index3 at{ { middle[0] + step[0], middle[1] + step[1], middle[2] + step[2] } };
  Around around{ grid.Linear(at), {}, {} };
  for (int a = 0; a < 3; ++a)
  {
    around.Size[a] = grid.Width(a, at[a]) / grid.Width(a, middle[a]);
    around.Centre[a] = 0.5 * static_cast<double>(step[a]) * (1.0 + around.Size[a]);
  }
  return around;
}

Neighbourhood FindNeighbourhood(const CartesianGrid& grid, const Index3& cell)
{
  Neighbourhood cells{ Place(grid, cell, { { 0, 0, 0 } }) };
  for (int c = 0; c < 27; ++c)
  {
    if (c != 13 && grid.InDomain(CellAround(cell, c)))
    {
      cells.push_back(Place(grid, cell, StepAround(c)));
    }
  }
  return cells;
}

} // namespace

std::vector<ChildFractions> SplitCell(const CartesianGrid& grid, const FractionField& fractions,
  const Index3& cell, const Index3& counts)
{
  const Children places(counts);
  const Neighbourhood cells = FindNeighbourhood(grid, cell);
  const FractionField::Range parts = fractions.Parts(cells[0].Cell);
  return parts.Last - parts.First == 2 ? SplitInTwo(grid, fractions, cells, places)
                                       : CutOneByOne(fractions, cells, places);
}

} // namespace vfm
