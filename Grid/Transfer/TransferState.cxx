#include "Transfer/TransferState.h"

#include "Transfer/Slopes.h"
#include "Transfer/VolumeFluxes.h"

namespace vfm
{
namespace
{

/// By material, over all ranks.
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

/// What an element gets, part after part.
class ElementState
{
public:
  explicit ElementState(const StateColumns& columns) :
    Columns(columns),
    Values(columns.Count()),
    Contents(columns.Count()),
    Parts(columns.Count()),
    Means(columns.Count())
  {
  }

  void Start()
  {
    this->Inside = 0.0;
    std::fill(this->Contents.begin(), this->Contents.end(), 0.0);
    std::fill(this->Means.begin(), this->Means.end(), 0.0);
  }
  /// Where the values of the next part are put.
  double* NextValues() { return this->Values.data(); }
  /// inside: the volume of the element there; volume: of what it gets, but for rounding the same.
  void Add(double inside, double volume)
  {
    this->Columns.FindContents(volume, this->Values.data(), this->Parts.data());
    this->Inside += inside;
    for (int c = 0; c < this->Columns.Count(); ++c)
    {
      this->Contents[c] += this->Parts[c];
      this->Means[c] += inside * this->Values[c];
    }
  }
  double Mass() const { return this->Contents[this->Columns.Density()]; }
  double Value(int c) const
  {
    const int base = this->Columns.Base(c);
    const double weight = base < 0 ? this->Inside : this->Contents[base];
    if (weight > 0.0)
    {
      return this->Contents[c] / weight;
    }
    return this->Inside > 0.0 ? this->Means[c] / this->Inside : 0.0; // of what has no mass
  }

private:
  const StateColumns& Columns;
  double Inside = 0.0;
  std::vector<double> Values, Contents, Parts, Means;
};

/// All steps, one after another.
class StateTransfer
{
public:
  StateTransfer(const Mesh& mesh, const TransferRequest& request, Runtime& runtime) :
    TheMesh(mesh),
    Request(request),
    Grid(request.Grid),
    Run(runtime),
    Parts(request.Grid, runtime.Group()),
    Columns(request.Quantities, request.Density),
    IsMeshed(FindMeshed(mesh, request.Fractions.NumberOfMaterials(), runtime.Group())),
    Source(request, this->Columns, this->IsMeshed),
    Whole(mesh, request.Grid, request.Fractions, runtime),
    Donors(request.Grid)
  {
  }

  TransferredState Transfer()
  {
    const int materials = static_cast<int>(this->IsMeshed.size());
    std::vector<DonorShape> shapes;
    const std::vector<DonorParts> moved =
      this->FindParts([this](Index e) { return !this->Whole.IsWhole(e); }, shapes);
    const MisfitCells misfits(
      this->Grid, this->Request.Fractions, this->Whole, this->Donors, this->IsMeshed, this->Parts);
    const std::vector<DonorParts> near = this->FindParts(
      [&](Index e) { return this->Whole.IsWhole(e) && this->IsNear(misfits, e); }, shapes);
    const FlowRegion region = this->FindRegion(misfits);
    const std::vector<DonorParts> inside = this->FindParts(
      [&](Index e)
      {
        return this->Whole.IsWhole(e) && !this->IsNear(misfits, e) &&
          region.HoldsAll(this->TheMesh.Fragment[e]);
      },
      shapes);
    CentreShapes(this->Donors, shapes);
    const DonorLinks links(this->Grid, this->Parts, this->Donors);
    MaterialSums input(materials, this->Columns), unmeshed(materials, this->Columns);
    DonorValues values =
      FillDonors(this->Source, this->Whole, this->Parts, this->Donors, input, unmeshed);
    TransferredState state;
    state.Factors = MoveContents(this->Source, region, links, this->Run, this->Donors, values);
    this->UpdateCopies(links, values);
    const Slopes slopes = this->Request.Order == 1
      ? Slopes(this->Columns)
      : Slopes(this->Columns, this->Grid, this->Donors, values, shapes,
          this->LinksToParts(links, moved), this->Run);
    this->Allocate(state);
    this->FillFromDonors(moved, slopes, values, state);
    this->FillFromDonors(near, slopes, values, state);
    this->FillFromDonors(inside, slopes, values, state);
    this->FillFromCells(region, state);
    state.Input = input.Finish(this->Run.Group());
    state.Unmeshed = unmeshed.Finish(this->Run.Group());
    return state;
  }

private:
  template <class Wants>
  std::vector<DonorParts> FindParts(const Wants& wants, std::vector<DonorShape>& shapes)
  {
    std::vector<Index> elements;
    for (Index e = 0; e < static_cast<Index>(this->TheMesh.Material.size()); ++e)
    {
      if (wants(e))
      {
        elements.push_back(e);
      }
    }
    return FindDonorParts(
      this->TheMesh, elements, this->Grid, this->Parts, this->Run, this->Donors, shapes);
  }

  bool IsNear(const MisfitCells& misfits, Index element) const
  {
    bool isNear = false;
    ForCells(this->Whole.CellsOf(element),
      [&](const Index3& p)
      { isNear = isNear || misfits.IsNear(this->Grid.Linear(p), DonorLayers); });
    return isNear;
  }

  /// Between which donors contents move; donors of elements that are no whole cells, or near misfits, there are. Collective.
  FlowRegion FindRegion(const MisfitCells& misfits)
  {
    const DonorLinks links(this->Grid, this->Parts, this->Donors);
    return { misfits, FindDivided(this->Grid, misfits, links, this->Donors, this->Run.Group()) };
  }

  /// Gives copies what their owners hold now.
  void UpdateCopies(const DonorLinks& links, DonorValues& values)
  {
    links.Exchange(
      1 + this->Columns.Count(),
      [&](int s, double* numbers)
      {
        numbers[0] = this->Donors[s].Volume;
        std::copy_n(values.Of(s), this->Columns.Count(), numbers + 1);
      },
      [&](int s, const double* numbers)
      {
        this->Donors[s].Volume = numbers[0];
        std::copy_n(numbers + 1, this->Columns.Count(), values.Of(s));
      });
  }

  DonorLinks LinksToParts(const DonorLinks& links, const std::vector<DonorParts>& moved) const
  {
    std::vector<unsigned char> wanted(this->Donors.Count(), 0);
    for (const DonorParts& some : moved)
    {
      for (const DonorPart& part : some.Parts)
      {
        wanted[part.Donor] = 1;
      }
    }
    return links.Narrow([&wanted](int s) { return wanted[s]; });
  }

  void Allocate(TransferredState& state) const
  {
    const std::size_t elements = this->TheMesh.Material.size();
    for (const StateQuantity& quantity : this->Request.Quantities)
    {
      state.Values.emplace_back(elements * quantity.Components);
    }
    state.Mass = Buffer<double>(elements);
  }

  void Write(const ElementState& element, Index e, TransferredState& state) const
  {
    state.Mass[e] = element.Mass();
    int c = 0;
    for (std::size_t q = 0; q < this->Request.Quantities.size(); ++q)
    {
      const int components = this->Request.Quantities[q].Components;
      for (int i = 0; i < components; ++i)
      {
        state.Values[q][e * components + i] = element.Value(c++);
      }
    }
  }

  void FillFromDonors(const std::vector<DonorParts>& pieces, const Slopes& slopes,
    const DonorValues& values, TransferredState& state)
  {
    for (const DonorParts& some : pieces)
    {
      this->Run.For(0, static_cast<Index>(some.Elements.size()),
        [&](Index begin, Index end)
        {
          ElementState element(this->Columns);
          for (Index i = begin; i < end; ++i)
          {
            element.Start();
            for (int p = some.Offsets[i]; p < some.Offsets[i + 1]; ++p)
            {
              const DonorPart& part = some.Parts[p];
              const Donor& donor = this->Donors[part.Donor];
              std::copy_n(values.Of(part.Donor), this->Columns.Count(), element.NextValues());
              slopes.AddAt(part.Donor, part.Centroid - donor.Centroid, element.NextValues());
              element.Add(part.Volume, part.Volume * (donor.Volume / donor.Overlap));
            }
            this->Write(element, some.Elements[i], state);
          }
        });
    }
  }

  /// Whole elements without donors.
  void FillFromCells(const FlowRegion& region, TransferredState& state)
  {
    this->Run.For(0, static_cast<Index>(this->TheMesh.Material.size()),
      [&](Index begin, Index end)
      {
        ElementState element(this->Columns);
        for (Index e = begin; e < end; ++e)
        {
          if (!this->Whole.IsWhole(e) || this->IsNear(region.Misfits, e) ||
            region.HoldsAll(this->TheMesh.Fragment[e]))
          {
            continue;
          }
          element.Start();
          ForCells(this->Whole.CellsOf(e),
            [&](const Index3& p)
            {
              this->Source.Read(p, this->TheMesh.Material[e], element.NextValues());
              element.Add(this->Grid.CellVolume(p), this->Grid.CellVolume(p));
            });
          this->Write(element, e, state);
        }
      });
  }

  const Mesh& TheMesh;
  const TransferRequest& Request;
  const CartesianGrid& Grid;
  Runtime& Run;
  const Partition Parts;
  const StateColumns Columns;
  const std::vector<unsigned char> IsMeshed; // by material
  const StateSource Source;
  const WholeElements Whole;
  DonorTable Donors;
};

} // namespace

TransferredState TransferState(const Mesh& mesh, const TransferRequest& request, Runtime& runtime)
{
  return StateTransfer(mesh, request, runtime).Transfer();
}

} // namespace vfm
