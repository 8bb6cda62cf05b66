#include "State/Transfer/DonorParts.h"

#include <limits>

namespace vfm
{
namespace
{

/// Part of an element in a cell of another rank.
struct SentPart
{
  Index Id, Key; // id of the element, key of the cell
  int Fragment, Material;
  double Volume;
  Vector3 Centroid;
};

/// Parts of regular tets in a cell of another rank.
struct SentKinds
{
  Index Key; // key of the cell
  int Fragment, Material;
  std::uint64_t Kinds;
};

void AddPart(double volume, const Vector3& centroid, Donor& donor, DonorShape& shape)
{
  const Vector3 x = centroid - donor.Centroid;
  donor.Overlap += volume;
  shape.First = shape.First + volume * x;
  for (int a = 0; a < 3; ++a)
  {
    shape.Second[a] += volume * x[a] * x[a];
    shape.Lower[a] = std::min(shape.Lower[a], x[a]);
    shape.Upper[a] = std::max(shape.Upper[a], x[a]);
  }
  shape.Second[3] += volume * x[0] * x[1];
  shape.Second[4] += volume * x[0] * x[2];
  shape.Second[5] += volume * x[1] * x[2];
}

/// Sums over the parts of regular tets in a donor.
struct RegularSums
{
  explicit RegularSums(std::uint64_t kinds) : Kinds(kinds)
  {
    for (int kind = 0; kind < RegularKinds; ++kind)
    {
      if (kinds >> kind & 1)
      {
        this->Add(RegularShapes[kind]);
      }
    }
  }

  std::uint64_t Kinds; // one bit per kind
  // Sums of volumes, in 24ths, of products with positions, and the range of positions, in eighths.
  int Volume = 0;
  std::array<int, 3> First{}, Lower{ { 8, 8, 8 } }, Upper{ { -8, -8, -8 } };
  std::array<int, 6> Second{}; // as DonorShape::Second

private:
  void Add(const RegularShape& part)
  {
    const std::array<int, 3>& x = part.Centroid;
    this->Volume += part.Volume;
    for (int a = 0; a < 3; ++a)
    {
      this->First[a] += part.Volume * x[a];
      this->Second[a] += part.Volume * x[a] * x[a];
      this->Lower[a] = std::min(this->Lower[a], x[a]);
      this->Upper[a] = std::max(this->Upper[a], x[a]);
    }
    this->Second[3] += part.Volume * x[0] * x[1];
    this->Second[4] += part.Volume * x[0] * x[2];
    this->Second[5] += part.Volume * x[1] * x[2];
  }
};

/// Adds the parts of regular tets to their donor.
/// @param cell  cell of the donor
void AddRegular(const RegularSums& sums, const CartesianGrid& grid, const Index3& cell,
  Donor& donor, DonorShape& shape)
{
  const double unit = grid.CellVolume(cell);
  const Vector3 h{ { grid.Width(0, cell[0]) / 8.0, grid.Width(1, cell[1]) / 8.0,
    grid.Width(2, cell[2]) / 8.0 } };
  donor.Overlap += unit * (sums.Volume / 24.0);
  for (int a = 0; a < 3; ++a)
  {
    shape.First[a] += unit * h[a] * (sums.First[a] / 24.0);
    shape.Second[a] += unit * h[a] * h[a] * (sums.Second[a] / 24.0);
    shape.Lower[a] = std::min(shape.Lower[a], sums.Lower[a] * h[a]);
    shape.Upper[a] = std::max(shape.Upper[a], sums.Upper[a] * h[a]);
  }
  shape.Second[3] += unit * h[0] * h[1] * (sums.Second[3] / 24.0);
  shape.Second[4] += unit * h[0] * h[2] * (sums.Second[4] / 24.0);
  shape.Second[5] += unit * h[1] * h[2] * (sums.Second[5] / 24.0);
}

constexpr Index ElementsAtOnce = 32768;

/// Donors of the cells that were searched last, because consecutive elements are mostly in the same
/// cells.
class RecentDonors
{
public:
  /// Returns the donor of a fragment in a cell.
  /// @param search  search() returns the donor if it is not a recent one
  template <class Search>
  int Find(Index cell, int fragment, const Search& search)
  {
    Entry& entry = this->Recent[(static_cast<std::uint64_t>(cell) * Spread >> 32) % Count];
    if (entry.Cell != cell || entry.Fragment != fragment)
    {
      entry = { cell, fragment, search() };
    }
    return entry.Donor;
  }

private:
  static constexpr std::size_t Count = 1024;
  static constexpr std::uint64_t Spread = 0x9e3779b97f4a7c15; // spreads cells over all entries
  struct Entry
  {
    Index Cell = -1;
    int Fragment = 0, Donor = 0;
  };
  std::array<Entry, Count> Recent;
};

/// What FindDonorParts works on.
struct Work
{
  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const RegularTets& Regular;
  const Partition& Parts;
  Runtime& Run;
  DonorTable& Donors;
  std::vector<DonorShape>& Shapes;
  OverlapFinder Finder{ TheMesh, Grid, Run };
  // Kinds of the parts of regular tets, one bit per kind, per donor.
  std::vector<std::uint64_t> Kinds = std::vector<std::uint64_t>(Donors.Count(), 0);
  RecentDonors Recent{};      // by linear index of the cell
  RecentDonors RecentInBox{}; // by index of the cell in the local box
};

int GetDonor(Work& work, Index cell, int fragment, int material)
{
  return work.Recent.Find(cell, fragment,
    [&]
    {
      const int donor = work.Donors.Get(cell, fragment, material);
      work.Kinds.resize(work.Donors.Count());
      return donor;
    });
}

int GetDonor(Work& work, Index cell, Index element)
{
  return GetDonor(work, cell, work.TheMesh.Fragment[element], work.TheMesh.Material[element]);
}

/// Returns the donor of an element in a cell of the local box (IndexInBox).
int GetDonorInBox(Work& work, Index cell, Index element)
{
  return work.RecentInBox.Find(cell, work.TheMesh.Fragment[element],
    [&] { return GetDonor(work, work.Grid.Linear(CellInBox(work.Grid.Local(), cell)), element); });
}

/// Finds the parts of regular tets and their donors. Returns the positions of the other elements.
std::vector<Index> FindRegular(Work& work, DonorParts& some)
{
  const std::size_t count = some.Elements.size();
  std::vector<std::array<RegularPart, 2>> found(work.Regular.IsUsed() ? count : 0);
  ForEach(work.Run, found.size(), [&](Index i) { work.Regular.Find(some.ElementAt(i), found[i]); });
  some.Regular.resize(found.size());
  std::vector<Index> others;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (found.empty() || found[i][0].Cell < 0)
    {
      others.push_back(static_cast<Index>(i));
      continue;
    }
    for (int p = 0; p < 2 && found[i][p].Cell >= 0; ++p)
    {
      const RegularPart& part = found[i][p];
      const int donor = GetDonor(work, part.Cell, some.ElementAt(i));
      some.Regular[i].Donor[p] = donor;
      some.Regular[i].Kind[p] = static_cast<std::uint8_t>(part.Kind);
      work.Kinds[donor] |= std::uint64_t(1) << part.Kind;
    }
  }
  return others;
}

/// Cuts some elements and makes the donors of their parts.
DonorParts CutElements(Work& work, Index first, std::vector<int> elements)
{
  DonorParts some;
  some.First = first;
  some.Elements = std::move(elements);
  const std::vector<Index> others = FindRegular(work, some);
  std::vector<Index> cut;
  for (Index i : others)
  {
    cut.push_back(some.ElementAt(i));
  }
  const Overlaps& overlaps = work.Finder.Find(cut);
  some.Offsets.assign(some.Elements.size() + 1, 0);
  some.Parts.reserve(overlaps.Parts.size());
  for (std::size_t i = 0, n = 0; i < some.Elements.size(); ++i)
  {
    if (n < others.size() && others[n] == static_cast<Index>(i))
    {
      for (Index p = overlaps.Offsets[n]; p < overlaps.Offsets[n + 1]; ++p)
      {
        const OverlapPart& overlap = overlaps.Parts[p];
        some.Parts.push_back({ overlap.Volume, overlap.Centroid,
          GetDonorInBox(work, overlap.Cell, some.ElementAt(i)) });
      }
      ++n;
    }
    some.Offsets[i + 1] = static_cast<int>(some.Parts.size());
  }
  return some;
}

/// Sends parts in ghost cells to the owners of the cells. Returns the parts received for owned
/// cells, in the order of element ids. Collective among peers.
std::vector<SentPart> ExchangeParts(Work& work, const std::vector<DonorParts>& pieces)
{
  std::vector<std::vector<SentPart>> sent(work.Parts.Peers().size());
  for (const DonorParts& some : pieces)
  {
    for (std::size_t i = 0; i < some.Elements.size(); ++i)
    {
      for (int p = some.Offsets[i]; p < some.Offsets[i + 1]; ++p)
      {
        const DonorPart& part = some.Parts[p];
        Donor& donor = work.Donors[part.Donor];
        if (!donor.IsOwned)
        {
          donor.HasParts = true;
          const Index3 cell = work.Grid.Position(donor.Cell);
          const int peer = work.Parts.PeerOfCell(cell);
          sent[peer].push_back({ work.TheMesh.ElementIds[some.ElementAt(i)],
            work.Parts.CellKeyAtPeer(peer, cell), donor.Fragment, donor.Material, part.Volume,
            part.Centroid - work.Parts.TranslationOf(peer) });
        }
      }
    }
  }
  std::vector<SentPart> received = Joined(work.Parts.Exchange(sent));
  std::stable_sort(received.begin(), received.end(),
    [](const SentPart& a, const SentPart& b) { return a.Id < b.Id; });
  return received;
}

/// Sends the kinds of parts in ghost cells to the owners of the cells. Collective among peers.
void ExchangeKinds(Work& work)
{
  std::vector<std::vector<SentKinds>> sent(work.Parts.Peers().size());
  for (int s = 0; s < work.Donors.Count(); ++s)
  {
    Donor& donor = work.Donors[s];
    if (!donor.IsOwned && work.Kinds[s] != 0)
    {
      donor.HasParts = true;
      const Index3 cell = work.Grid.Position(donor.Cell);
      const int peer = work.Parts.PeerOfCell(cell);
      sent[peer].push_back(
        { work.Parts.CellKeyAtPeer(peer, cell), donor.Fragment, donor.Material, work.Kinds[s] });
    }
  }
  for (const SentKinds& other : Joined(work.Parts.Exchange(sent)))
  {
    const Index cell = work.Grid.Linear(work.Grid.CellOfKey(other.Key));
    const int donor = GetDonor(work, cell, other.Fragment, other.Material);
    work.Kinds[donor] |= other.Kinds;
  }
}

/// Adds parts to owned donors: regular tets first, then other elements in the order of their ids.
/// @param others  parts of other ranks
void AddParts(
  Work& work, const std::vector<SentPart>& others, const std::vector<DonorParts>& pieces)
{
  std::vector<int> donorOf;
  for (const SentPart& other : others)
  {
    donorOf.push_back(GetDonor(
      work, work.Grid.Linear(work.Grid.CellOfKey(other.Key)), other.Fragment, other.Material));
  }
  work.Shapes.resize(work.Donors.Count());
  RegularSums sums(0);
  for (int s = 0; s < work.Donors.Count(); ++s)
  {
    if (work.Donors[s].IsOwned && work.Kinds[s] != 0)
    {
      sums = sums.Kinds == work.Kinds[s] ? sums : RegularSums(work.Kinds[s]);
      AddRegular(
        sums, work.Grid, work.Grid.Position(work.Donors[s].Cell), work.Donors[s], work.Shapes[s]);
    }
  }
  std::size_t next = 0;
  const auto addBefore = [&](Index id)
  {
    for (; next < others.size() && others[next].Id < id; ++next)
    {
      const int s = donorOf[next];
      AddPart(others[next].Volume, others[next].Centroid, work.Donors[s], work.Shapes[s]);
    }
  };
  for (const DonorParts& some : pieces)
  {
    for (std::size_t i = 0; i < some.Elements.size(); ++i)
    {
      addBefore(work.TheMesh.ElementIds[some.ElementAt(i)]);
      for (int p = some.Offsets[i]; p < some.Offsets[i + 1]; ++p)
      {
        const DonorPart& part = some.Parts[p];
        if (work.Donors[part.Donor].IsOwned)
        {
          AddPart(part.Volume, part.Centroid, work.Donors[part.Donor], work.Shapes[part.Donor]);
        }
      }
    }
  }
  addBefore(std::numeric_limits<Index>::max());
}

} // namespace

std::vector<DonorParts> FindDonorParts(const Mesh& mesh,
  const std::function<bool(Index element)>& isNeeded, const CartesianGrid& grid,
  const RegularTets& regular, const Partition& partition, Runtime& runtime, DonorTable& donors,
  std::vector<DonorShape>& shapes)
{
  Work work{ mesh, grid, regular, partition, runtime, donors, shapes };
  std::vector<DonorParts> pieces;
  const Index count = static_cast<Index>(mesh.Material.size());
  for (Index first = 0; first < count; first += ElementsAtOnce)
  {
    std::vector<int> elements;
    for (Index e = first; e < std::min(count, first + ElementsAtOnce); ++e)
    {
      if (isNeeded(e))
      {
        elements.push_back(static_cast<int>(e - first));
      }
    }
    if (!elements.empty())
    {
      elements.shrink_to_fit();
      pieces.push_back(CutElements(work, first, std::move(elements)));
    }
  }
  std::vector<SentPart> others;
  if (!partition.Peers().empty())
  {
    ExchangeKinds(work);
    others = ExchangeParts(work, pieces);
  }
  AddParts(work, others, pieces);
  return pieces;
}

void CentreShapes(DonorTable& donors, std::vector<DonorShape>& shapes)
{
  for (int s = 0; s < donors.Count(); ++s)
  {
    Donor& donor = donors[s];
    if (donor.Overlap > 0.0)
    {
      DonorShape& shape = shapes[s];
      const Vector3 mean = (1.0 / donor.Overlap) * shape.First;
      donor.Centroid = donor.Centroid + mean;
      const double o = donor.Overlap;
      const Vector3& m = mean;
      const std::array<double, 6> moved{ { m[0] * m[0], m[1] * m[1], m[2] * m[2], m[0] * m[1],
        m[0] * m[2], m[1] * m[2] } };
      for (int i = 0; i < 6; ++i)
      {
        shape.Second[i] -= o * moved[i];
      }
      shape.Lower = shape.Lower - mean;
      shape.Upper = shape.Upper - mean;
    }
  }
}

} // namespace vfm
