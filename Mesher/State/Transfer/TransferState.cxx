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

/// Finds and writes the state of elements, some at a time.
class StateWriter
{
public:
  StateWriter(const StateSource& source, TransferredState& state) :
    Mass(state.Mass.data()), Width(source.Columns.Width()), States(source.Columns)
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

  /// Begins an element of the mesh, and returns the states, to which the caller adds its parts.
  /// What these parts point to must not change before Write.
  ElementStates& Start(Index e)
  {
    if (this->States.Count() == AtOnce)
    {
      this->Write();
    }
    this->Elements[this->States.Count()] = e;
    this->States.Start();
    return this->States;
  }
  /// Writes the state of the elements begun.
  void Write()
  {
    const std::size_t count = this->States.Count();
    this->States.Finish();
    const double* values = this->States.Values(0);
    const std::size_t width = this->Width;
    for (const Target& target : this->Targets) // column by column, for longer runs of memory
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        target.Values[this->Elements[i] * target.Components] = values[i * width];
      }
      ++values;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Mass[this->Elements[i]] = this->States.Mass(i);
    }
    this->States.Clear();
  }

private:
  static constexpr std::size_t AtOnce = 64;
  struct Target
  {
    double* Values;
    Index Components;
  };
  std::vector<Target> Targets; // one per column of the quantities
  double* Mass;
  std::size_t Width; // numbers per element in States
  std::array<Index, AtOnce> Elements;
  ElementStates States;
};

/// RegularShape with numbers that need no conversion.
struct RegularNumbers
{
  double Volume;
  Vector3 Centroid;
};

constexpr std::array<RegularNumbers, RegularKinds> ListRegularNumbers()
{
  std::array<RegularNumbers, RegularKinds> numbers{};
  for (int kind = 0; kind < RegularKinds; ++kind)
  {
    const RegularShape& shape = RegularShapes[kind];
    numbers[kind] = { static_cast<double>(shape.Volume),
      { { static_cast<double>(shape.Centroid[0]), static_cast<double>(shape.Centroid[1]),
        static_cast<double>(shape.Centroid[2]) } } };
  }
  return numbers;
}

constexpr std::array<RegularNumbers, RegularKinds> AllRegularNumbers = ListRegularNumbers();

/// What elements get from a donor.
class DonorSource
{
public:
  DonorSource() = default;
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
    const RegularNumbers& shape = AllRegularNumbers[kind];
    Vector3 x;
    for (int a = 0; a < 3; ++a)
    {
      x[a] = this->Centre[a] + shape.Centroid[a] * this->Eighth[a];
    }
    const double inside = shape.Volume * this->Volume24;
    return { this->Own, this->Line, x, inside, inside * this->Ratio };
  }

private:
  const double *Own = nullptr, *Line = nullptr;
  Vector3 Centroid{};
  double Ratio = 0.0;         // volume of material per volume of elements
  Vector3 Centre{}, Eighth{}; // centre of the cell relative to the centroid, eighths of its widths
  double Volume24 = 0.0;      // 24th of the volume of the cell
};

/// Donors with their values, on which elements depend.
struct FilledDonors
{
  const CartesianGrid& Grid;
  const DonorTable& Donors;
  const DonorValues& Values;
  const Slopes& Lines;
};

/// The sources of the donors that were used last, because consecutive elements share most of them.
class RecentSources
{
public:
  explicit RecentSources(const FilledDonors& filled) : Filled(filled), Recent(Count) {}

  /// Returns what elements get from a donor. Valid until the next call.
  const DonorSource& Of(int donor)
  {
    Entry& entry = this->Recent[donor % Count];
    if (entry.Donor != donor)
    {
      const FilledDonors& f = this->Filled;
      entry.Donor = donor;
      entry.Source =
        DonorSource(f.Grid, f.Donors[donor], f.Values.Of(donor), f.Lines.LineOf(donor));
    }
    return entry.Source;
  }

private:
  static constexpr unsigned int Count = 512;
  struct Entry
  {
    int Donor = -1;
    DonorSource Source;
  };
  const FilledDonors& Filled;
  std::vector<Entry> Recent;
};

/// Adds the parts of element i of a list.
void AddParts(const DonorParts& some, Index i, RecentSources& sources, ElementStates& states)
{
  for (int p = some.Offsets[i]; p < some.Offsets[i + 1]; ++p)
  {
    states.Add(sources.Of(some.Parts[p].Donor).Find(some.Parts[p]));
  }
  if (some.Regular.empty())
  {
    return;
  }
  const RegularDonors& regular = some.Regular[i];
  for (int p = 0; p < 2 && regular.Donor[p] >= 0; ++p)
  {
    states.Add(sources.Of(regular.Donor[p]).Find(regular.Kind[p]));
  }
}

/// Fills elements, and frees their parts, so that parts and state need not fit in memory together.
void FillFromDonors(std::vector<DonorParts> pieces, const FilledDonors& filled,
  const StateSource& source, Runtime& runtime, TransferredState& state)
{
  constexpr int ListsPerRelease = 16;
  int lists = 0;
  for (DonorParts& some : pieces)
  {
    runtime.For(0, static_cast<Index>(some.Elements.size()),
      [&](Index begin, Index end)
      {
        StateWriter writer(source, state);
        RecentSources sources(filled);
        for (Index i = begin; i < end; ++i)
        {
          AddParts(some, i, sources, writer.Start(some.ElementAt(i)));
        }
        writer.Write();
      });
    some = DonorParts();
    if (++lists % ListsPerRelease == 0)
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
        ElementStates& states = writer.Start(e);
        const IndexBox cells = whole.CellsOf(e);
        own.resize(cells.NumberOfCells() * width);
        double* next = own.data();
        ForCells(cells,
          [&](const Index3& p)
          {
            source.Read(p, mesh.Material[e], next);
            const double volume = source.Request.Grid.CellVolume(p);
            states.Add({ next, slopes.LineOf(0), {}, volume, volume });
            next += width;
          });
        writer.Write(); // before own changes
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
  DonorShapes shapes;
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
  DonorShapes().swap(shapes); // keeps the peak of memory low

  Allocate(request.Quantities, mesh.Material.size(), state);
  for (std::vector<DonorParts>* pieces : { &moved, &near, &inside })
  {
    FillFromDonors(std::move(*pieces), { grid, donors, values, slopes }, source, runtime, state);
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
