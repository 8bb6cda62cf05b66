#include "State/Transfer/TransferState.h"

#include "Base/Memory.h"
#include "State/Transfer/ElementState.h"
#include "State/Transfer/Slopes.h"
#include "State/Transfer/VolumeFluxes.h"

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
std::vector<DonorParts> FindParts(
  Work& work, const std::function<bool(Index element)>& isNeeded, std::vector<DonorShape>& shapes)
{
  return FindDonorParts(
    work.TheMesh, isNeeded, work.Grid, work.Regular, work.Parts, work.Run, work.Donors, shapes);
}

/// Does so for whole elements.
std::vector<DonorParts> FindWholeParts(
  Work& work, const std::function<bool(Index element)>& isNeeded, std::vector<DonorShape>& shapes)
{
  if (!work.Whole.CanExist())
  {
    shapes.resize(work.Donors.Count());
    return {};
  }
  return FindParts(
    work, [&](Index e) { return work.Whole.IsWhole(e) && isNeeded(e); }, shapes);
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
  StateWriter(
    const StateColumns& columns, const TransferRequest& request, TransferredState& state) :
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

/// What elements get from a donor.
class DonorSource
{
public:
  DonorSource(
    const CartesianGrid& grid, const Donor& donor, const double* own, const double* line) :
    Own(own), Line(line), Centroid(donor.Centroid), Ratio(donor.Volume / donor.Overlap)
  {
    const Index3 cell = grid.Position(donor.Cell);
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& x = grid.Coordinates(a);
      this->Eighth[a] = grid.Width(a, cell[a]) / 8.0;
      this->Centre[a] = 0.5 * (x[cell[a]] + x[cell[a] + 1]) - donor.Centroid[a];
    }
    this->Volume24 = grid.CellVolume(cell) / 24.0;
  }

  StatePart Find(const DonorPart& part) const
  {
    return { this->Own, this->Line, part.Centroid - this->Centroid, part.Volume,
      part.Volume * this->Ratio };
  }
  /// Returns the part of a regular tet.
  StatePart Find(int kind) const
  {
    const RegularShape& shape = RegularShapes[kind];
    Vector3 x;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = this->Centre[a] + shape.Centroid[a] * this->Eighth[a];
    }
    const double inside = shape.Volume * this->Volume24;
    return { this->Own, this->Line, x, inside, inside * this->Ratio };
  }

private:
  const double *Own, *Line;
  Vector3 Centroid;
  double Ratio;           // volume of material per volume of elements
  Vector3 Centre, Eighth; // centre of the cell relative to the centroid, eighths of its widths
  double Volume24;        // 24th of the volume of the cell
};

std::vector<DonorSource> ListSources(
  const Work& work, const Slopes& slopes, const DonorValues& values)
{
  std::vector<DonorSource> sources;
  sources.reserve(work.Donors.Count());
  for (int s = 0; s < work.Donors.Count(); ++s)
  {
    sources.emplace_back(work.Grid, work.Donors[s], values.Of(s), slopes.LineOf(s));
  }
  return sources;
}

/// Adds the parts of element i of a list.
void AddParts(
  const DonorParts& some, Index i, const std::vector<DonorSource>& sources, ElementState& element)
{
  for (int p = some.Offsets[i]; p < some.Offsets[i + 1]; ++p)
  {
    element.Add(sources[some.Parts[p].Donor].Find(some.Parts[p]));
  }
  for (int p = 0; !some.Regular.empty() && p < 2 && some.Regular[i].Donor[p] >= 0; ++p)
  {
    element.Add(sources[some.Regular[i].Donor[p]].Find(some.Regular[i].Kind[p]));
  }
}

/// Fills elements, and frees their parts, so that parts and state need not fit in memory together.
void FillFromDonors(Work& work, std::vector<DonorParts> pieces,
  const std::vector<DonorSource>& sources, TransferredState& state)
{
  constexpr int ListsPerRelease = 16;
  int filled = 0;
  for (DonorParts& some : pieces)
  {
    work.Run.For(0, static_cast<Index>(some.Elements.size()),
      [&](Index begin, Index end)
      {
        StateWriter writer(work.Columns, work.Request, state);
        for (Index i = begin; i < end; ++i)
        {
          AddParts(some, i, sources, writer.Next());
          writer.Write(some.ElementAt(i));
        }
      });
    some = DonorParts();
    if (++filled % ListsPerRelease == 0)
    {
      ReleaseFreeMemory();
    }
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
  std::vector<DonorParts> moved = FindParts(
    work, [&](Index e) { return !work.Whole.IsWhole(e); }, shapes);
  const MismatchCells mismatches(
    work.Grid, work.Request.Fractions, work.Whole, work.Donors, work.IsMeshed, work.Parts);
  std::vector<DonorParts> near = FindWholeParts(
    work, [&](Index e) { return IsNear(work, mismatches, e); }, shapes);
  const FlowRegion region = FindRegion(work, mismatches);
  std::vector<DonorParts> inside = FindWholeParts(
    work,
    [&](Index e)
    { return !IsNear(work, mismatches, e) && region.HoldsAll(work.TheMesh.Fragment[e]); },
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
  std::vector<DonorShape>().swap(shapes); // keeps the peak of memory low
  Allocate(work, state);
  const std::vector<DonorSource> sources = ListSources(work, slopes, values);
  FillFromDonors(work, std::move(moved), sources, state);
  FillFromDonors(work, std::move(near), sources, state);
  FillFromDonors(work, std::move(inside), sources, state);
  FillFromCells(work, region, state);
  state.Input = input.Finish(work.Run.Group());
  state.Unmeshed = unmeshed.Finish(work.Run.Group());
  return state;
}

} // namespace vfm
