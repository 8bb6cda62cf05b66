#include "State/Transfer/DonorContents.h"

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

/// Contents that a cell without a donor gives to a donor nearby.
struct Gift
{
  Index From, To; // keys of the two cells
  int Fragment;
  double Volume;
};

struct Work
{
  const StateSource& Source;
  const WholeElements& Whole;
  const Partition& Parts;
  DonorTable& Donors;
  MaterialSums &Input, &Unmeshed;
  const CartesianGrid& Grid = Source.Request.Grid;
  DonorValues Values{ Donors.Count(), Source.Columns };
  // Values of the cell whose contents are distributed.
  std::vector<double> Own = std::vector<double>(Source.Columns.Count());
  // Gifts per peer, and their values; the last lists are for donors of this rank.
  std::vector<std::vector<Gift>> Gifts{ Parts.Peers().size() + 1 };
  std::vector<std::vector<double>> GiftValues{ Parts.Peers().size() + 1 };
};

/// Returns four times the squared distance between the centres of two cells.
double SquaredDistance(const Work& work, const Index3& p, const Index3& q)
{
  double sum = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = work.Grid.Coordinates(a);
    const double d = (x[p[a]] + x[p[a] + 1]) - (x[q[a]] + x[q[a] + 1]);
    sum += d * d;
  }
  return sum;
}

/// Returns the donor of a material whose cell is nearest, and the largest in this cell; -1 if there
/// is none.
int FindNearest(const Work& work, const Index3& p, int material, int layers)
{
  int nearest = -1;
  double least = std::numeric_limits<double>::max();
  ForCells(Grow(BoxOfCell(p), layers, work.Grid.Local()),
    [&](const Index3& q)
    {
      work.Donors.ForCell(work.Grid.Linear(q),
        [&](int s)
        {
          const Donor& donor = work.Donors[s];
          if (donor.Material != material || !(donor.Overlap > 0.0))
          {
            return;
          }
          const double distance = SquaredDistance(work, p, q);
          if (distance < least ||
            (distance == least && work.Donors[nearest].Cell == donor.Cell &&
              donor.Overlap > work.Donors[nearest].Overlap))
          {
            nearest = s;
            least = distance;
          }
        });
    });
  return nearest;
}

/// Gives the contents of a cell without a donor to the nearest donor. Returns whether there is one.
bool Give(Work& work, const Index3& p, int material, double volume)
{
  if (!work.Source.IsMeshed[material])
  {
    return false;
  }
  int nearest = FindNearest(work, p, material, RimReach);
  if (nearest < 0 && work.Source.Request.GiveUnmeshed)
  {
    nearest = FindNearest(work, p, material, GivingReach);
  }
  if (nearest < 0)
  {
    return false;
  }
  const Donor& donor = work.Donors[nearest];
  const Index3 to = work.Grid.Position(donor.Cell);
  const std::size_t peer = donor.IsOwned ? work.Gifts.size() - 1 : work.Parts.PeerOfCell(to);
  const Index key = donor.IsOwned ? work.Grid.CellKey(to) : work.Parts.CellKeyAtPeer(peer, to);
  work.Gifts[peer].push_back({ work.Grid.CellKey(p), key, donor.Fragment, volume });
  work.GiftValues[peer].insert(work.GiftValues[peer].end(), work.Own.begin(), work.Own.end());
  return true;
}

/// Distributes the content of a material in a cell.
void Distribute(Work& work, const Index3& p, Index cell, int material, double fraction)
{
  const double volume = fraction * work.Grid.CellVolume(p);
  if (!work.Source.Counts(material) || !(volume > 0.0))
  {
    return;
  }
  work.Source.Read(p, material, work.Own.data());
  work.Input.Add(material, volume, work.Own.data());
  double overlap = 0.0;
  work.Donors.ForCell(cell,
    [&](int s) { overlap += work.Donors[s].Material == material ? work.Donors[s].Overlap : 0.0; });
  if (overlap > 0.0)
  {
    work.Donors.ForCell(cell,
      [&](int s)
      {
        if (work.Donors[s].Material == material)
        {
          work.Donors[s].Volume = volume * (work.Donors[s].Overlap / overlap);
          std::copy(work.Own.begin(), work.Own.end(), work.Values.Of(s));
        }
      });
  }
  else if (!work.Whole.Covers(cell) && !Give(work, p, material, volume))
  {
    work.Unmeshed.Add(material, volume, work.Own.data());
  }
}

/// Finds the nearest cell that contains the material of a donor. Returns whether there is one.
bool FindMaterial(const Work& work, const Donor& donor, int layers, Index3& cell)
{
  const Index3 p = work.Grid.Position(donor.Cell);
  double least = std::numeric_limits<double>::max();
  ForCells(Grow(BoxOfCell(p), layers, work.Grid.Local()),
    [&](const Index3& q)
    {
      const double distance = SquaredDistance(work, p, q);
      if (distance < least &&
        work.Source.Request.Fractions.Fraction(work.Grid.Linear(q), donor.Material) > 0.0)
      {
        cell = q;
        least = distance;
      }
    });
  return least < std::numeric_limits<double>::max();
}

/// A material in a cell of another rank.
struct CellMaterial
{
  Index Key; // key of the cell
  int Material;
};

/// Returns the values of the requested materials on each peer, one after another. Collective among
/// peers.
std::vector<std::vector<double>> ReadAtPeers(
  const Work& work, const std::vector<std::vector<CellMaterial>>& requested)
{
  const std::size_t width = work.Own.size();
  std::vector<std::vector<double>> answers;
  for (const std::vector<CellMaterial>& cells : work.Parts.Exchange(requested))
  {
    std::vector<double>& values = answers.emplace_back(cells.size() * width);
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      work.Source.Read(
        work.Grid.CellOfKey(cells[i].Key), cells[i].Material, values.data() + i * width);
    }
  }
  return work.Parts.Exchange(answers);
}

/// Sets the values of donors in cells without their material, whose volume is 0, to the values of
/// the nearest cell that contains it. They are used if the donor receives nothing. Collective among
/// peers.
void FillEmpty(Work& work)
{
  std::vector<std::vector<CellMaterial>> requested(work.Parts.Peers().size());
  std::vector<std::vector<int>> donors(requested.size());
  for (int s = 0; s < work.Donors.Count(); ++s)
  {
    const Donor& donor = work.Donors[s];
    Index3 cell;
    if (!donor.IsOwned || donor.Volume > 0.0 ||
      !(FindMaterial(work, donor, RimReach, cell) || FindMaterial(work, donor, GivingReach, cell)))
    {
      continue;
    }
    if (work.Parts.OwnsCell(cell))
    {
      work.Source.Read(cell, donor.Material, work.Values.Of(s));
      continue;
    }
    const int peer = work.Parts.PeerOfCell(cell);
    requested[peer].push_back({ work.Parts.CellKeyAtPeer(peer, cell), donor.Material });
    donors[peer].push_back(s);
  }
  const std::vector<std::vector<double>> values = ReadAtPeers(work, requested);
  for (std::size_t peer = 0; peer < values.size(); ++peer)
  {
    for (std::size_t i = 0; i < donors[peer].size(); ++i)
    {
      std::copy_n(values[peer].data() + i * work.Own.size(), work.Own.size(),
        work.Values.Of(donors[peer][i]));
    }
  }
}

/// Returns the items for this rank, the last list of sent, followed by the items received
/// from peers.
template <class T>
std::vector<T> Receive(const Work& work, std::vector<std::vector<T>>& sent)
{
  std::vector<T> items = std::move(sent.back());
  sent.pop_back();
  const std::vector<T> received = Joined(work.Parts.Exchange(sent));
  items.insert(items.end(), received.begin(), received.end());
  return items;
}

/// Sends gifts to the owners of the donors. Adds the gifts to owned donors in the order of the
/// cells that they come from.
void ExchangeGifts(Work& work)
{
  const std::vector<Gift> gifts = Receive(work, work.Gifts);
  const std::vector<double> values = Receive(work, work.GiftValues);
  std::vector<Index> order(gifts.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(),
    [&gifts](Index a, Index b) { return gifts[a].From < gifts[b].From; });
  for (Index g : order)
  {
    const int s =
      work.Donors.Find(work.Grid.Linear(work.Grid.CellOfKey(gifts[g].To)), gifts[g].Fragment);
    work.Source.Columns.Mix(work.Donors[s].Volume, work.Values.Of(s), gifts[g].Volume,
      values.data() + g * static_cast<Index>(work.Own.size()));
  }
}

} // namespace

DonorValues FillDonors(const StateSource& source, const WholeElements& whole,
  const Partition& partition, DonorTable& donors, MaterialSums& input, MaterialSums& unmeshed)
{
  Work work{ source, whole, partition, donors, input, unmeshed };
  const FractionField& fractions = work.Source.Request.Fractions;
  ForCells(work.Grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = work.Grid.Linear(p);
      fractions.ForParts(cell,
        [&](int material, double fraction) { Distribute(work, p, cell, material, fraction); });
    });
  FillEmpty(work);
  ExchangeGifts(work);
  return std::move(work.Values);
}

} // namespace vfm
