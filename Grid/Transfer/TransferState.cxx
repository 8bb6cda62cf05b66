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

/// Writes the state of elements.
class StateWriter
{
public:
  StateWriter(const StateColumns& columns, const TransferRequest& request, TransferredState& state) :
    Mass(state.Mass.data()), State(columns)
  {
    for (std::size_t q = 0; q < state.Values.size(); ++q)
    {
      const int components = request.Quantities[q].Components;
      for (int i = 0; i < components; ++i)
      {
        this->Targets.push_back({ state.Values[q].data() + i, components });
      }
    }
  }

  /// Returns the state of the next element, to which the caller adds its parts.
  ElementState& Next()
  {
    this->State.Start();
    return this->State;
  }
  /// Writes the state of an element.
  void Write(Index e)
  {
    this->State.Finish();
    this->Mass[e] = this->State.Mass();
    const double* value = this->State.Values();
    for (const Target& target : this->Targets)
    {
      target.Values[e * target.Components] = *value++;
    }
  }

private:
  struct Target
  {
    double* Values;
    Index Components;
  };
  std::vector<Target> Targets; // one per column of the quantities
  double* Mass;
  ElementState State;
};

void FillFromDonors(Work& work, const std::vector<DonorParts>& pieces, const Slopes& slopes,
  const DonorValues& values, TransferredState& state)
{
  for (const DonorParts& some : pieces)
  {
    work.Run.For(0, static_cast<Index>(some.Elements.size()),
      [&](Index begin, Index end)
      {
        StateWriter writer(work.Columns, work.Request, state);
        PartReader reader(work.TheMesh, work.Grid, work.Regular, work.Donors);
        for (Index i = begin; i < end; ++i)
        {
          ElementState& element = writer.Next();
          reader.ForParts(some, i,
            [&](const DonorPart& part)
            {
              const Donor& donor = work.Donors[part.Donor];
              element.Add({ values.Of(part.Donor), slopes.LineOf(part.Donor),
                part.Centroid - donor.Centroid, part.Volume,
                part.Volume * (donor.Volume / donor.Overlap) });
            });
          writer.Write(some.Elements[i]);
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
      StateWriter writer(work.Columns, work.Request, state);
      const Slopes slopes(work.Columns);
      std::vector<double> own(work.Columns.Width());
      for (Index e = begin; e < end; ++e)
      {
        if (!work.Whole.IsWhole(e) || IsNear(work, region.Mismatches, e) ||
          region.HoldsAll(work.TheMesh.Fragment[e]))
        {
          continue;
        }
        ElementState& element = writer.Next();
        const IndexBox cells = work.Whole.CellsOf(e);
        own.resize(cells.NumberOfCells() * work.Columns.Width());
        double* next = own.data();
        ForCells(cells,
          [&](const Index3& p)
          {
            work.Source.Read(p, work.TheMesh.Material[e], next);
            const double volume = work.Grid.CellVolume(p);
            element.Add({ next, slopes.LineOf(0), {}, volume, volume });
            next += work.Columns.Width();
          });
        writer.Write(e);
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
