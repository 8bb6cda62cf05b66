#include "Transfer/DonorContents.h"

#include <limits>
#include <numeric>

namespace vfm
{

void StateSource::Read(const Index3& cell, int material, double* values) const
{
  this->Request.Values.Read(cell, material, values);
  std::fill(values + this->Columns.CountOfQuantities(), values + this->Columns.Count(), 1.0);
}

MaterialSums::MaterialSums(int materials, const StateColumns& columns) :
  Columns(columns),
  Width(2 + columns.CountOfQuantities()),
  Sums(static_cast<std::size_t>(materials) * this->Width),
  Contents(columns.Count())
{
}

void MaterialSums::Add(int material, double volume, const double* values)
{
  this->Columns.FindContents(volume, values, this->Contents.data());
  WideSum* sums = this->Sums.data() + static_cast<std::size_t>(material) * this->Width;
  sums[0].Add(volume);
  sums[1].Add(this->Contents[this->Columns.Density()]);
  for (int c = 0; c < this->Columns.CountOfQuantities(); ++c)
  {
    sums[2 + c].Add(this->Contents[c]);
  }
}

std::vector<StateTotals> MaterialSums::Finish(Ranks& ranks)
{
  WideSum::SumOverRanks(this->Sums, ranks);
  std::vector<StateTotals> totals(this->Sums.size() / this->Width, StateTotals(this->Width));
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    totals[i / this->Width][i % this->Width] = this->Sums[i].Value();
  }
  return totals;
}

namespace
{

/// What a cell without a donor gives to one near it.
struct Gift
{
  Index From, To; // keys of cells
  int Fragment;
  double Volume;
};

class DonorFiller
{
public:
  DonorFiller(const StateSource& source, const WholeElements& whole, const Partition& partition,
    DonorTable& donors, MaterialSums& input, MaterialSums& unmeshed) :
    Source(source),
    Grid(source.Request.Grid),
    Whole(whole),
    Parts(partition),
    Donors(donors),
    Input(input),
    Unmeshed(unmeshed),
    Values(donors.Count(), source.Columns),
    Own(source.Columns.Count()),
    Gifts(partition.Peers().size() + 1),
    GiftValues(partition.Peers().size() + 1)
  {
  }

  DonorValues Fill()
  {
    const FractionField& fractions = this->Source.Request.Fractions;
    ForCells(this->Grid.Owned(),
      [&](const Index3& p)
      {
        const Index cell = this->Grid.Linear(p);
        if (!fractions.IsMixed(cell))
        {
          this->Deal(p, cell, fractions.Label(cell), 1.0);
          return;
        }
        for (const FractionField::Part& part : fractions.Parts(cell))
        {
          this->Deal(p, cell, part.Material, part.Fraction);
        }
      });
    this->FillEmpty();
    this->ExchangeGifts();
    return std::move(this->Values);
  }

private:
  /// The content of a material in a cell.
  void Deal(const Index3& p, Index cell, int material, double fraction)
  {
    const double volume = fraction * this->Grid.CellVolume(p);
    if (!this->Source.Counts(material) || !(volume > 0.0))
    {
      return;
    }
    this->Source.Read(p, material, this->Own.data());
    this->Input.Add(material, volume, this->Own.data());
    double overlap = 0.0;
    this->Donors.ForCell(cell,
      [&](int s)
      { overlap += this->Donors[s].Material == material ? this->Donors[s].Overlap : 0.0; });
    if (overlap > 0.0)
    {
      this->Donors.ForCell(cell,
        [&](int s)
        {
          if (this->Donors[s].Material == material)
          {
            this->Donors[s].Volume = volume * (this->Donors[s].Overlap / overlap);
            std::copy(this->Own.begin(), this->Own.end(), this->Values.Of(s));
          }
        });
    }
    else if (!this->Whole.Covers(cell) && !this->Give(p, material, volume))
    {
      this->Unmeshed.Add(material, volume, this->Own.data());
    }
  }

  bool Give(const Index3& p, int material, double volume)
  {
    if (!this->Source.IsMeshed[material])
    {
      return false;
    }
    int nearest = this->FindNearest(p, material, RimReach);
    if (nearest < 0 && this->Source.Request.GiveUnmeshed)
    {
      nearest = this->FindNearest(p, material, GivingReach);
    }
    if (nearest < 0)
    {
      return false;
    }
    const Donor& donor = this->Donors[nearest];
    const Index3 to = this->Grid.Position(donor.Cell);
    const std::size_t peer = donor.IsOwned ? this->Gifts.size() - 1 : this->Parts.PeerOfCell(to);
    this->Gifts[peer].push_back(
      { this->Grid.CellKey(p), this->Grid.CellKey(to), donor.Fragment, volume });
    this->GiftValues[peer].insert(this->GiftValues[peer].end(), this->Own.begin(), this->Own.end());
    return true;
  }

  /// The donor of a material whose cell is nearest; in it the largest. -1: none.
  int FindNearest(const Index3& p, int material, int layers) const
  {
    int nearest = -1;
    double least = std::numeric_limits<double>::max();
    ForCells(Grow(BoxOfCell(p), layers, this->Grid.Local()),
      [&](const Index3& q)
      {
        this->Donors.ForCell(this->Grid.Linear(q),
          [&](int s)
          {
            const Donor& donor = this->Donors[s];
            if (donor.Material != material || !(donor.Overlap > 0.0))
            {
              return;
            }
            const double distance = this->SquaredDistance(p, q);
            if (distance < least ||
              (distance == least && this->Donors[nearest].Cell == donor.Cell &&
                donor.Overlap > this->Donors[nearest].Overlap))
            {
              nearest = s;
              least = distance;
            }
          });
      });
    return nearest;
  }

  double SquaredDistance(const Index3& p, const Index3& q) const
  {
    double sum = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      const std::vector<double>& x = this->Grid.Coordinates(a);
      const double d = (x[p[a]] + x[p[a] + 1]) - (x[q[a]] + x[q[a] + 1]);
      sum += d * d;
    }
    return sum;
  }

  /// Donors in cells without their material have values, though no volume: those of the nearest cell with some. They hold if nothing
  /// comes from elsewhere.
  void FillEmpty()
  {
    for (int s = 0; s < this->Donors.Count(); ++s)
    {
      const Donor& donor = this->Donors[s];
      Index3 cell;
      if (donor.IsOwned && !(donor.Volume > 0.0) &&
        (this->FindMaterial(donor, RimReach, cell) || this->FindMaterial(donor, GivingReach, cell)))
      {
        this->Source.Read(cell, donor.Material, this->Values.Of(s));
      }
    }
  }

  /// The nearest cell with the material of a donor.
  bool FindMaterial(const Donor& donor, int layers, Index3& cell) const
  {
    const Index3 p = this->Grid.Position(donor.Cell);
    double least = std::numeric_limits<double>::max();
    ForCells(Grow(BoxOfCell(p), layers, this->Grid.Local()),
      [&](const Index3& q)
      {
        const double distance = this->SquaredDistance(p, q);
        if (distance<least&& this->Source.Request.Fractions.Fraction(
              this->Grid.Linear(q), donor.Material)> 0.0)
        {
          cell = q;
          least = distance;
        }
      });
    return least < std::numeric_limits<double>::max();
  }

  /// Sends gifts to who owns the donors, and adds those for mine by the cells that they come from.
  void ExchangeGifts()
  {
    const std::vector<Gift> gifts = this->Receive(this->Gifts);
    const std::vector<double> values = this->Receive(this->GiftValues);
    std::vector<Index> order(gifts.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
      [&gifts](Index a, Index b) { return gifts[a].From < gifts[b].From; });
    for (Index g : order)
    {
      const int s =
        this->Donors.Find(this->Grid.Linear(this->Grid.CellOfKey(gifts[g].To)), gifts[g].Fragment);
      this->Source.Columns.Mix(this->Donors[s].Volume, this->Values.Of(s), gifts[g].Volume,
        values.data() + g * static_cast<Index>(this->Own.size()));
    }
  }

  /// Those of this rank, which are last in sent, then those of its peers.
  template <class T>
  std::vector<T> Receive(std::vector<std::vector<T>>& sent) const
  {
    std::vector<T> items = std::move(sent.back());
    sent.pop_back();
    const std::vector<T> received = ExchangeItems(this->Parts.Group(), this->Parts.Peers(), sent);
    items.insert(items.end(), received.begin(), received.end());
    return items;
  }

  const StateSource& Source;
  const CartesianGrid& Grid;
  const WholeElements& Whole;
  const Partition& Parts;
  DonorTable& Donors;
  MaterialSums &Input, &Unmeshed;
  DonorValues Values;
  std::vector<double> Own;                     // of the cell that is dealt
  std::vector<std::vector<Gift>> Gifts;        // by peer; last those for donors of this rank
  std::vector<std::vector<double>> GiftValues; // of each
};

} // namespace

DonorValues FillDonors(const StateSource& source, const WholeElements& whole,
  const Partition& partition, DonorTable& donors, MaterialSums& input, MaterialSums& unmeshed)
{
  return DonorFiller(source, whole, partition, donors, input, unmeshed).Fill();
}

} // namespace vfm
