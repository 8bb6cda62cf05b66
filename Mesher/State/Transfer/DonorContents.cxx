#include "State/Transfer/DonorContents.h"

#include <limits>
#include <numeric>
#include <optional>

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

/// Returns four times the squared distance between the centres of two cells.
double SquaredDistance(const CartesianGrid& grid, const Index3& p, const Index3& q)
{
  double sum = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const std::vector<double>& x = grid.Coordinates(a);
    const double d = (x[p[a]] + x[p[a] + 1]) - (x[q[a]] + x[q[a] + 1]);
    sum += d * d;
  }
  return sum;
}

/// Returns the donor of a material whose cell is nearest, and the largest in this cell; -1 if there
/// is none.
int FindNearest(
  const CartesianGrid& grid, const DonorTable& donors, const Index3& p, int material, int layers)
{
  int nearest = -1;
  double least = std::numeric_limits<double>::max();
  ForCells(Grow(BoxOfCell(p), layers, grid.Local()),
    [&](const Index3& q)
    {
      donors.ForCell(grid.Linear(q),
        [&](int s)
        {
          const Donor& donor = donors[s];
          if (donor.Material != material || !(donor.Overlap > 0.0))
          {
            return;
          }
          const double distance = SquaredDistance(grid, p, q);
          if (distance < least ||
            (distance == least && donors[nearest].Cell == donor.Cell &&
              donor.Overlap > donors[nearest].Overlap))
          {
            nearest = s;
            least = distance;
          }
        });
    });
  return nearest;
}

/// Returns the donor that gets a material of a cell without a donor; -1 if there is none.
int FindReceiver(const StateSource& source, const DonorTable& donors, const Index3& p, int material)
{
  if (!source.IsMeshed[material])
  {
    return -1;
  }
  const CartesianGrid& grid = source.Request.Grid;
  const int nearest = FindNearest(grid, donors, p, material, RimReach);
  const bool gives = material == 0 || !source.Request.Particles;
  return nearest < 0 && source.Request.GiveUnmeshed && gives
    ? FindNearest(grid, donors, p, material, GivingReach)
    : nearest;
}

/// Contents that a cell without a donor gives to a donor nearby.
struct Gift
{
  Index From, To; // keys of the two cells
  int Fragment;
  double Volume;
};

/// Gifts of the cells of this rank.
class GiftList
{
public:
  GiftList(const CartesianGrid& grid, const Partition& partition) :
    Grid(grid),
    Parts(partition),
    Gifts(partition.Peers().size() + 1),
    Values(partition.Peers().size() + 1)
  {
  }

  /// Adds the gift of a cell.
  /// @param values  values of all columns in the cell
  void Add(const Index3& from, const Donor& donor, double volume, const std::vector<double>& values)
  {
    const Index3 to = this->Grid.Position(donor.Cell);
    const std::size_t peer = donor.IsOwned ? this->Gifts.size() - 1 : this->Parts.PeerOfCell(to);
    const Index key = donor.IsOwned ? this->Grid.CellKey(to) : this->Parts.CellKeyAtPeer(peer, to);
    this->Gifts[peer].push_back({ this->Grid.CellKey(from), key, donor.Fragment, volume });
    this->Values[peer].insert(this->Values[peer].end(), values.begin(), values.end());
  }

  /// Sends gifts to the owners of the donors. Adds the gifts to owned donors in the order of the
  /// cells that they come from. Collective among peers.
  void Give(const StateColumns& columns, DonorTable& donors, DonorValues& values)
  {
    const std::vector<Gift> gifts = this->Receive(this->Gifts);
    const std::vector<double> given = this->Receive(this->Values);
    std::vector<Index> order(gifts.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
      [&gifts](Index a, Index b) { return gifts[a].From < gifts[b].From; });
    for (Index g : order)
    {
      const int s =
        donors.Find(this->Grid.Linear(this->Grid.CellOfKey(gifts[g].To)), gifts[g].Fragment);
      columns.Mix(
        donors[s].Volume, values.Of(s), gifts[g].Volume, given.data() + g * columns.Count());
    }
  }

private:
  /// Returns the items for this rank, the last list of sent, followed by the items received
  /// from peers.
  template <class T>
  std::vector<T> Receive(std::vector<std::vector<T>>& sent) const
  {
    std::vector<T> items = std::move(sent.back());
    sent.pop_back();
    const std::vector<T> received = Joined(this->Parts.Exchange(sent));
    items.insert(items.end(), received.begin(), received.end());
    return items;
  }

  const CartesianGrid& Grid;
  const Partition& Parts;
  // Gifts per peer, and their values; the last lists are for donors of this rank.
  std::vector<std::vector<Gift>> Gifts;
  std::vector<std::vector<double>> Values;
};

/// Distributes a volume of a material in a cell to the donors of the material there, by their
/// overlaps.
/// @param own  values of all columns of the material in the cell
/// @return whether there are donors
bool FillCell(Index cell, int material, double volume, const std::vector<double>& own,
  DonorTable& donors, DonorValues& values)
{
  double overlap = 0.0;
  donors.ForCell(
    cell, [&](int s) { overlap += donors[s].Material == material ? donors[s].Overlap : 0.0; });
  if (!(overlap > 0.0))
  {
    return false;
  }
  donors.ForCell(cell,
    [&](int s)
    {
      if (donors[s].Material == material)
      {
        donors[s].Volume = volume * (donors[s].Overlap / overlap);
        std::copy(own.begin(), own.end(), values.Of(s));
      }
    });
  return true;
}

/// Returns the nearest cell that contains the material of a donor, if there is one.
std::optional<Index3> FindMaterial(const TransferRequest& request, const Donor& donor, int layers)
{
  const CartesianGrid& grid = request.Grid;
  const Index3 p = grid.Position(donor.Cell);
  std::optional<Index3> cell;
  double least = std::numeric_limits<double>::max();
  ForCells(Grow(BoxOfCell(p), layers, grid.Local()),
    [&](const Index3& q)
    {
      const double distance = SquaredDistance(grid, p, q);
      if (distance < least && request.Fractions.Fraction(grid.Linear(q), donor.Material) > 0.0)
      {
        cell = q;
        least = distance;
      }
    });
  return cell;
}

/// A material in a cell of another rank.
struct CellMaterial
{
  Index Key; // key of the cell
  int Material;
};

/// Returns the values of the requested materials on each peer, one after another. Collective among
/// peers.
std::vector<std::vector<double>> ReadAtPeers(const StateSource& source, const Partition& partition,
  const std::vector<std::vector<CellMaterial>>& requested)
{
  const std::size_t width = source.Columns.Count();
  std::vector<std::vector<double>> answers;
  for (const std::vector<CellMaterial>& cells : partition.Exchange(requested))
  {
    std::vector<double>& values = answers.emplace_back(cells.size() * width);
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      source.Read(
        source.Request.Grid.CellOfKey(cells[i].Key), cells[i].Material, values.data() + i * width);
    }
  }
  return partition.Exchange(answers);
}

/// Sets the values of donors in cells without their material, whose volume is 0, to the values of
/// the nearest cell that contains it. They are used if the donor receives nothing. Collective among
/// peers.
void FillEmpty(const StateSource& source, const Partition& partition, const DonorTable& donors,
  DonorValues& values)
{
  std::vector<std::vector<CellMaterial>> requested(partition.Peers().size());
  std::vector<std::vector<int>> receivers(requested.size());
  for (int s = 0; s < donors.Count(); ++s)
  {
    const Donor& donor = donors[s];
    if (!donor.IsOwned || donor.Volume > 0.0)
    {
      continue;
    }
    const std::optional<Index3> near = FindMaterial(source.Request, donor, RimReach);
    const std::optional<Index3> cell =
      near ? near : FindMaterial(source.Request, donor, GivingReach);
    if (!cell)
    {
      continue;
    }
    if (partition.OwnsCell(*cell))
    {
      source.Read(*cell, donor.Material, values.Of(s));
      continue;
    }
    const int peer = partition.PeerOfCell(*cell);
    requested[peer].push_back({ partition.CellKeyAtPeer(peer, *cell), donor.Material });
    receivers[peer].push_back(s);
  }
  const std::vector<std::vector<double>> read = ReadAtPeers(source, partition, requested);
  const std::size_t width = source.Columns.Count();
  for (std::size_t peer = 0; peer < read.size(); ++peer)
  {
    for (std::size_t i = 0; i < receivers[peer].size(); ++i)
    {
      std::copy_n(read[peer].data() + i * width, width, values.Of(receivers[peer][i]));
    }
  }
}

} // namespace

DonorValues FillDonors(const StateSource& source, const WholeElements& whole,
  const Partition& partition, DonorTable& donors, MaterialSums& input, MaterialSums& unmeshed,
  FarContents& far)
{
  const CartesianGrid& grid = source.Request.Grid;
  DonorValues values(donors.Count(), source.Columns);
  GiftList gifts(grid, partition);
  std::vector<double> own(source.Columns.Count()); // values of a material in a cell
  const auto distribute = [&](const Index3& p, Index cell, int material, double fraction)
  {
    const double all = fraction * grid.CellVolume(p);
    if (!source.Counts(material) || !(all > 0.0))
    {
      return;
    }
    source.Read(p, material, own.data());
    input.Add(material, all, own.data());
    const double volume = far.Take(cell, material, all, own.data());
    if (!(volume > 0.0) || FillCell(cell, material, volume, own, donors, values) ||
      whole.Covers(cell))
    {
      return;
    }
    const int receiver = FindReceiver(source, donors, p, material);
    if (receiver >= 0)
    {
      gifts.Add(p, donors[receiver], volume, own);
    }
    else if (!far.TakeRest(cell, material, volume, own.data()))
    {
      unmeshed.Add(material, volume, own.data());
    }
  };
  ForCells(grid.Owned(),
    [&](const Index3& p)
    {
      const Index cell = grid.Linear(p);
      source.Request.Fractions.ForParts(
        cell, [&](int material, double fraction) { distribute(p, cell, material, fraction); });
    });
  FillEmpty(source, partition, donors, values);
  gifts.Give(source.Columns, donors, values);
  return values;
}

} // namespace vfm
