#include "Transfer/TransferState.h"

#include "Transfer/Slopes.h"
#include "Transfer/VolumeFluxes.h"

namespace vfm
{
namespace
{

/// Returns which materials have elements on any rank. Collective.
std::vector<unsigned char> FindMeshed(const Mesh& mesh, int materials, Ranks& ranks)
{
  std::vector<std::int64_t> elements(materials + 1, 0);
  for (int material : mesh.Material)
  {
    ++elements[material];
  }
  ranks.Sum(elements);
  std::vector<unsigned char> isMeshed(elements.size());
  std::transform(elements.begin(), elements.end(), isMeshed.begin(),
    [](std::int64_t count) { return count > 0; });
  return isMeshed;
}

/// State of an element, summed over its parts.
class ElementState
{
public:
  explicit ElementState(const StateColumns& columns) :
    Columns(columns), Count(columns.Count()), Numbers(4 * columns.Count())
  {
  }

  void Start()
  {
    this->Inside = 0.0;
    std::fill_n(this->Contents(), 2 * this->Count, 0.0);
  }
  /// Returns the array to which the caller writes the values of the next part.
  double* NextValues() { return this->Numbers.data(); }
  /// Adds a part.
  /// @param inside  volume of the element in the part
  /// @param volume  volume of the material that the part receives, equal up to rounding
  void Add(double inside, double volume)
  {
    double *values = this->NextValues(), *parts = values + this->Count;
    double *contents = this->Contents(), *means = contents + this->Count;
    this->Columns.FindContents(volume, values, parts);
    this->Inside += inside;
    for (int c = 0; c < this->Count; ++c)
    {
      contents[c] += parts[c];
      means[c] += inside * values[c];
    }
  }
  double Mass() const { return this->Contents()[this->Columns.Density()]; }
  double Value(int c) const
  {
    const int base = this->Columns.Base(c);
    const double* contents = this->Contents();
    const double weight = base < 0 ? this->Inside : contents[base];
    if (weight > 0.0)
    {
      return contents[c] / weight;
    }
    const double mean = contents[this->Count + c]; // volume mean without mass
    return this->Inside > 0.0 ? mean / this->Inside : 0.0;
  }

private:
  double* Contents() { return this->Numbers.data() + 2 * this->Count; }
  const double* Contents() const { return this->Numbers.data() + 2 * this->Count; }

  const StateColumns& Columns;
  const int Count;
  double Inside = 0.0;
  // Per column: values and contents of the last part, sums of contents, and of values by volume.
  std::vector<double> Numbers;
};

/// Data of all steps.
struct Work
{
  const Mesh& TheMesh;
  const TransferRequest& Request;
  Runtime& Run;
  const CartesianGrid& Grid = Request.Grid;
  const Partition Parts{ Grid, Run.Group() };
  const StateColumns Columns{ Request.Quantities, Request.Density };
  // One flag per material.
  const std::vector<unsigned char> IsMeshed =
    FindMeshed(TheMesh, Request.Fractions.NumberOfMaterials(), Run.Group());
  const StateSource Source{ Request, Columns, IsMeshed };
  const WholeElements Whole{ TheMesh, Grid, Request.Fractions, Run };
  const RegularTets Regular{ TheMesh, Grid, Run };
  DonorTable Donors{ Grid };
};

/// Cuts the elements for which isNeeded(element) is true, and makes their donors. Collective.
template <class IsNeeded>
std::vector<DonorParts> FindParts(
  Work& work, const IsNeeded& isNeeded, std::vector<DonorShape>& shapes)
{
  std::vector<Index> elements;
  for (Index e = 0; e < static_cast<Index>(work.TheMesh.Material.size()); ++e)
  {
    if (isNeeded(e))
    {
      elements.push_back(e);
    }
  }
  return FindDonorParts(
    work.TheMesh, elements, work.Grid, work.Regular, work.Parts, work.Run, work.Donors, shapes);
}

/// Returns whether a whole element has donors because mismatch cells are near.
bool IsNear(const Work& work, const MismatchCells& mismatches, Index element)
{
  bool isNear = false;
  ForCells(work.Whole.CellsOf(element),
    [&](const Index3& p)
    { isNear = isNear || mismatches.IsNear(work.Grid.Linear(p), DonorLayers); });
  return isNear;
}

/// Returns the region of donors between which contents move. The donors of elements that are not
/// whole cells, and of whole elements near mismatch cells, exist already. Collective.
FlowRegion FindRegion(Work& work, const MismatchCells& mismatches)
{
  const DonorLinks links(work.Grid, work.Parts, work.Donors);
  return { mismatches, FindDivided(work.Grid, mismatches, links, work.Donors, work.Run.Group()) };
}

/// Updates the volumes and values of copies from their owners.
void UpdateCopies(Work& work, const DonorLinks& links, DonorValues& values)
{
  links.Exchange(
    1 + work.Columns.Count(),
    [&](int s, double* numbers)
    {
      numbers[0] = work.Donors[s].Volume;
      std::copy_n(values.Of(s), work.Columns.Count(), numbers + 1);
    },
    [&](int s, const double* numbers)
    {
      work.Donors[s].Volume = numbers[0];
      std::copy_n(numbers + 1, work.Columns.Count(), values.Of(s));
    });
}

void Allocate(const Work& work, TransferredState& state)
{
  const std::size_t elements = work.TheMesh.Material.size();
  for (const StateQuantity& quantity : work.Request.Quantities)
  {
    state.Values.emplace_back(elements * quantity.Components);
  }
  state.Mass = Buffer<double>(elements);
}

void Write(const Work& work, const ElementState& element, Index e, TransferredState& state)
{
  state.Mass[e] = element.Mass();
  int c = 0;
  for (std::size_t q = 0; q < work.Request.Quantities.size(); ++q)
  {
    const int components = work.Request.Quantities[q].Components;
    for (int i = 0; i < components; ++i)
    {
      state.Values[q][e * components + i] = element.Value(c++);
    }
  }
}

void FillFromDonors(Work& work, const std::vector<DonorParts>& pieces, const Slopes& slopes,
  const DonorValues& values, TransferredState& state)
{
  for (const DonorParts& some : pieces)
  {
    work.Run.For(0, static_cast<Index>(some.Elements.size()),
      [&](Index begin, Index end)
      {
        ElementState element(work.Columns);
        PartReader reader(work.TheMesh, work.Grid, work.Regular, work.Donors);
        for (Index i = begin; i < end; ++i)
        {
          element.Start();
          reader.ForParts(some, i,
            [&](const DonorPart& part)
            {
              const Donor& donor = work.Donors[part.Donor];
              slopes.Evaluate(part.Donor, part.Centroid - donor.Centroid, values.Of(part.Donor),
                element.NextValues());
              element.Add(part.Volume, part.Volume * (donor.Volume / donor.Overlap));
            });
          Write(work, element, some.Elements[i], state);
        }
      });
  }
}

/// Copies the state of cells to whole elements without donors.
void FillFromCells(Work& work, const FlowRegion& region, TransferredState& state)
{
  work.Run.For(0, static_cast<Index>(work.TheMesh.Material.size()),
    [&](Index begin, Index end)
    {
      ElementState element(work.Columns);
      for (Index e = begin; e < end; ++e)
      {
        if (!work.Whole.IsWhole(e) || IsNear(work, region.Mismatches, e) ||
          region.HoldsAll(work.TheMesh.Fragment[e]))
        {
          continue;
        }
        element.Start();
        ForCells(work.Whole.CellsOf(e),
          [&](const Index3& p)
          {
            work.Source.Read(p, work.TheMesh.Material[e], element.NextValues());
            element.Add(work.Grid.CellVolume(p), work.Grid.CellVolume(p));
          });
        Write(work, element, e, state);
      }
    });
}

} // namespace

TransferredState TransferState(const Mesh& mesh, const TransferRequest& request, Runtime& runtime)
{
  Work work{ mesh, request, runtime };
  const int materials = static_cast<int>(work.IsMeshed.size());
  std::vector<DonorShape> shapes;
  const std::vector<DonorParts> moved = FindParts(
    work, [&](Index e) { return !work.Whole.IsWhole(e); }, shapes);
  const MismatchCells mismatches(
    work.Grid, work.Request.Fractions, work.Whole, work.Donors, work.IsMeshed, work.Parts);
  const std::vector<DonorParts> near = FindParts(
    work, [&](Index e) { return work.Whole.IsWhole(e) && IsNear(work, mismatches, e); }, shapes);
  const FlowRegion region = FindRegion(work, mismatches);
  const std::vector<DonorParts> inside = FindParts(
    work,
    [&](Index e)
    {
      return work.Whole.IsWhole(e) && !IsNear(work, mismatches, e) &&
        region.HoldsAll(work.TheMesh.Fragment[e]);
    },
    shapes);
  CentreShapes(work.Donors, shapes);
  const DonorLinks links(work.Grid, work.Parts, work.Donors);
  MaterialSums input(materials, work.Columns), unmeshed(materials, work.Columns);
  DonorValues values =
    FillDonors(work.Source, work.Whole, work.Parts, work.Donors, input, unmeshed);
  TransferredState state;
  state.Factors = MoveContents(work.Source, region, links, work.Run, work.Donors, values);
  UpdateCopies(work, links, values);
  const Slopes slopes = work.Request.Order == 1
    ? Slopes(work.Columns)
    : Slopes(work.Columns, work.Grid, work.Donors, values, shapes,
        links.Narrow([&work](int s) { return work.Donors[s].HasParts; }), work.Run);
  Allocate(work, state);
  FillFromDonors(work, moved, slopes, values, state);
  FillFromDonors(work, near, slopes, values, state);
  FillFromDonors(work, inside, slopes, values, state);
  FillFromCells(work, region, state);
  state.Input = input.Finish(work.Run.Group());
  state.Unmeshed = unmeshed.Finish(work.Run.Group());
  return state;
}

} // namespace vfm
