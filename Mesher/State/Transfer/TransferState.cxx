#include "State/Transfer/TransferState.h"

#include "Base/Memory.h"
#include "State/Transfer/ElementState.h"
#include "State/Transfer/JoinRows.h"
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

/// Returns whether a whole element has donors because mismatch cells are near.
bool IsNear(const WholeElements& whole, const CartesianGrid& grid, const MismatchCells& mismatches,
  Index element)
{
  bool isNear = false;
  ForCells(whole.CellsOf(element),
    [&](const Index3& p) { isNear = isNear || mismatches.IsNear(grid.Linear(p), DonorLayers); });
  return isNear;
}

/// Updates the volumes and values of copies from their owners.
void UpdateCopies(const DonorLinks& links, int columns, DonorTable& donors, DonorValues& values)
{
  links.Exchange(
    1 + columns,
    [&](int s, double* numbers)
    {
      numbers[0] = donors[s].Volume;
      std::copy_n(values.Of(s), columns, numbers + 1);
    },
    [&](int s, const double* numbers)
    {
      donors[s].Volume = numbers[0];
      std::copy_n(numbers + 1, columns, values.Of(s));
    });
}

/// Allocates the values and masses of elements.
void Allocate(
  const std::vector<StateQuantity>& quantities, std::size_t elements, TransferredState& state)
{
  for (const StateQuantity& quantity : quantities)
  {
    state.Values.emplace_back(elements * quantity.Components);
  }
  state.Mass = Buffer<double>(elements);
}

/// Writes the state of elements.
class StateWriter
{
public:
  StateWriter(const StateSource& source, TransferredState& state) :
    Mass(state.Mass.data()), State(source.Columns)
  {
    for (std::size_t q = 0; q < state.Values.size(); ++q)
    {
      const int components = source.Request.Quantities[q].Components;
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

std::vector<DonorSource> ListSources(const CartesianGrid& grid, const DonorTable& donors,
  const DonorValues& values, const Slopes& slopes)
{
  std::vector<DonorSource> sources;
  sources.reserve(donors.Count());
  for (int s = 0; s < donors.Count(); ++s)
  {
    sources.emplace_back(grid, donors[s], values.Of(s), slopes.LineOf(s));
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
void FillFromDonors(std::vector<DonorParts> pieces, const std::vector<DonorSource>& sources,
  const StateSource& source, Runtime& runtime, TransferredState& state)
{
  constexpr int ListsPerRelease = 16;
  int filled = 0;
  for (DonorParts& some : pieces)
  {
    runtime.For(0, static_cast<Index>(some.Elements.size()),
      [&](Index begin, Index end)
      {
        StateWriter writer(source, state);
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

/// Copies the state of cells to the whole elements for which hasDonors(element) is false.
template <class HasDonors>
void FillFromCells(const Mesh& mesh, const WholeElements& whole, const HasDonors& hasDonors,
  const StateSource& source, Runtime& runtime, TransferredState& state)
{
  const int width = source.Columns.Width();
  runtime.For(0, static_cast<Index>(mesh.Material.size()),
    [&](Index begin, Index end)
    {
      StateWriter writer(source, state);
      const Slopes slopes(source.Columns);
      std::vector<double> own(width);
      for (Index e = begin; e < end; ++e)
      {
        if (!whole.IsWhole(e) || hasDonors(e))
        {
          continue;
        }
        ElementState& element = writer.Next();
        const IndexBox cells = whole.CellsOf(e);
        own.resize(cells.NumberOfCells() * width);
        double* next = own.data();
        ForCells(cells,
          [&](const Index3& p)
          {
            source.Read(p, mesh.Material[e], next);
            const double volume = source.Request.Grid.CellVolume(p);
            element.Add({ next, slopes.LineOf(0), {}, volume, volume });
            next += width;
          });
        writer.Write(e);
      }
    });
}

} // namespace

TransferredState TransferState(const Mesh& mesh, const TransferRequest& request, Runtime& runtime)
{
  const CartesianGrid& grid = request.Grid;
  const Partition partition(grid, runtime.Group());
  const StateColumns columns(request.Quantities, request.Density);
  const std::vector<unsigned char> isMeshed =
    FindMeshed(mesh, request.Fractions.NumberOfMaterials(), runtime.Group());
  const StateSource source(request, columns, isMeshed);
  const WholeElements whole(mesh, grid, request.Fractions, runtime);
  const RegularTets regular(mesh, grid, runtime);

  DonorTable donors(grid);
  std::vector<DonorShape> shapes;
  const auto findParts = [&](const std::function<bool(Index element)>& isNeeded)
  { return FindDonorParts(mesh, isNeeded, grid, regular, partition, runtime, donors, shapes); };
  const auto findWholeParts = [&](const std::function<bool(Index element)>& isNeeded)
  {
    shapes.resize(donors.Count());
    return whole.CanExist() ? findParts([&](Index e) { return whole.IsWhole(e) && isNeeded(e); })
                            : std::vector<DonorParts>();
  };
  std::vector<DonorParts> moved = findParts([&](Index e) { return !whole.IsWhole(e); });
  const MismatchCells mismatches(grid, request.Fractions, whole, donors, isMeshed, partition);
  const auto isNear = [&](Index e) { return IsNear(whole, grid, mismatches, e); };
  std::vector<DonorParts> near = findWholeParts(isNear);
  const FlowRegion region{ mismatches,
    FindDivided(grid, mismatches, DonorLinks(grid, partition, donors), donors, runtime.Group()) };
  const auto isInside = [&](Index e) { return region.HoldsAll(mesh.Fragment[e]); };
  std::vector<DonorParts> inside =
    findWholeParts([&](Index e) { return !isNear(e) && isInside(e); });
  CentreShapes(donors, shapes);

  const DonorLinks links(grid, partition, donors);
  const int materials = static_cast<int>(isMeshed.size());
  MaterialSums input(materials, columns), unmeshed(materials, columns);
  FarContents far(grid, columns, request.Particles);
  DonorValues values = FillDonors(source, whole, partition, donors, input, unmeshed, far);
  TransferredState state;
  state.Factors = MoveContents(source, region, links, runtime, donors, values);
  UpdateCopies(links, columns.Count(), donors, values);
  const Slopes slopes = request.Order == 1
    ? Slopes(columns)
    : Slopes(columns, grid, donors, values, shapes,
        links.Narrow([&](int s) { return donors[s].HasParts; }), runtime);
  std::vector<DonorShape>().swap(shapes); // keeps the peak of memory low

  Allocate(request.Quantities, mesh.Material.size(), state);
  const std::vector<DonorSource> sources = ListSources(grid, donors, values, slopes);
  for (std::vector<DonorParts>* pieces : { &moved, &near, &inside })
  {
    FillFromDonors(std::move(*pieces), sources, source, runtime, state);
  }
  FillFromCells(
    mesh, whole, [&](Index e) { return isNear(e) || isInside(e); }, source, runtime, state);
  state.Input = input.Finish(runtime.Group());
  state.Unmeshed = unmeshed.Finish(runtime.Group());
  if (request.Particles)
  {
    state.Particles = JoinRows(std::move(far.Rows),
      { request.Particles->Clusters, request.Particles->Least }, columns, partition, grid);
  }
  return state;
}

} // namespace vfm
