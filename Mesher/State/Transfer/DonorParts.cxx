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
// Tets per donor, or fewer. There are 12 in a cell, and cells at interfaces have several donors.
constexpr std::size_t LeastTetsOfDonor = 9;

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

/// Finds and makes the donors of parts, and collects the kinds of their regular parts.
class DonorSearch
{
public:
  DonorSearch(const Mesh& mesh, const CartesianGrid& grid, DonorTable& donors) :
    TheMesh(mesh), Grid(grid), Donors(donors), Kinds(donors.Count(), 0)
  {
  }

  /// Returns the donor of a fragment in a cell.
  int Get(Index cell, int fragment, int material)
  {
    return this->Recent.Find(cell, fragment,
      [&]
      {
        const int donor = this->Donors.Get(cell, fragment, material);
        this->Kinds.resize(this->Donors.Count());
        return donor;
      });
  }
  /// Returns the donor of an element in a cell.
  int GetOfElement(Index cell, Index element)
  {
    return this->Get(cell, this->TheMesh.Fragment[element], this->TheMesh.Material[element]);
  }
  /// Returns the donor of an element in a cell of the local box (IndexInBox).
  int GetInBox(Index cell, Index element)
  {
    return this->RecentInBox.Find(cell, this->TheMesh.Fragment[element],
      [&]
      {
        const Index3 place = CellInBox(this->Grid.Local(), cell);
        return this->GetOfElement(this->Grid.Linear(place), element);
      });
  }
  /// Adds kinds to the regular parts of a donor, one bit per kind.
  void AddKinds(int donor, std::uint64_t kinds) { this->Kinds[donor] |= kinds; }
  std::uint64_t KindsOf(int donor) const { return this->Kinds[donor]; }

private:
  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  DonorTable& Donors;
  std::vector<std::uint64_t> Kinds; // per donor
  RecentDonors Recent{};            // by linear index of the cell
  RecentDonors RecentInBox{};       // by index of the cell in the local box
};

/// Finds the parts of regular tets and their donors. Returns the positions of the other elements.
std::vector<Index> FindRegular(
  const RegularTets& regular, Runtime& runtime, DonorSearch& search, DonorParts& some)
{
  const std::size_t count = some.Elements.size();
  std::vector<std::array<RegularPart, 2>> found(regular.IsUsed() ? count : 0);
  ForEach(runtime, found.size(), [&](Index i) { regular.Find(some.ElementAt(i), found[i]); });
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
      const int donor = search.GetOfElement(part.Cell, some.ElementAt(i));
      some.Regular[i].Donor[p] = donor;
      some.Regular[i].Kind[p] = static_cast<std::uint8_t>(part.Kind);
      search.AddKinds(donor, std::uint64_t(1) << part.Kind);
    }
  }
  return others;
}

/// Cuts elements that are not regular, and makes the donors of their parts.
/// @param others  their positions in the list
void CutElements(
  const std::vector<Index>& others, OverlapFinder& finder, DonorSearch& search, DonorParts& some)
{
  std::vector<Index> cut;
  for (Index i : others)
  {
    cut.push_back(some.ElementAt(i));
  }
  const Overlaps& overlaps = finder.Find(cut);
  some.Offsets.assign(some.Elements.size() + 1, 0);
  some.Parts.reserve(overlaps.Parts.size());
  for (std::size_t i = 0, n = 0; i < some.Elements.size(); ++i)
  {
    if (n < others.size() && others[n] == static_cast<Index>(i))
    {
      for (Index p = overlaps.Offsets[n]; p < overlaps.Offsets[n + 1]; ++p)
      {
        const OverlapPart& overlap = overlaps.Parts[p];
        some.Parts.push_back(
          { overlap.Volume, overlap.Centroid, search.GetInBox(overlap.Cell, some.ElementAt(i)) });
      }
      ++n;
    }
    some.Offsets[i + 1] = static_cast<int>(some.Parts.size());
  }
}

/// Lists the elements for which isNeeded(element) is true, some at a time.
std::vector<DonorParts> ListElements(
  Index count, const std::function<bool(Index element)>& isNeeded)
{
  std::vector<DonorParts> pieces;
  for (Index first = 0; first < count; first += ElementsAtOnce)
  {
    DonorParts some;
    some.First = first;
    for (Index e = first; e < std::min(count, first + ElementsAtOnce); ++e)
    {
      if (isNeeded(e))
      {
        some.Elements.push_back(static_cast<int>(e - first));
      }
    }
    if (!some.Elements.empty())
    {
      some.Elements.shrink_to_fit();
      pieces.push_back(std::move(some));
    }
  }
  return pieces;
}

/// Calls body(id, part) for the parts of elements that are not regular.
/// @param ids  ids of all elements of the mesh
template <class Body>
void ForCutParts(const std::vector<DonorParts>& pieces, const Buffer<Index>& ids, const Body& body)
{
  for (const DonorParts& some : pieces)
  {
    for (std::size_t i = 0; i < some.Elements.size(); ++i)
    {
      const Index id = ids[some.ElementAt(i)];
      for (int p = some.Offsets[i]; p < some.Offsets[i + 1]; ++p)
      {
        body(id, some.Parts[p]);
      }
    }
  }
}

/// Sends parts in ghost cells to the owners of the cells. Returns the parts received for owned
/// cells, in the order of element ids. Collective among peers.
/// @param ids  ids of all elements of the mesh
std::vector<SentPart> ExchangeParts(const std::vector<DonorParts>& pieces, const Buffer<Index>& ids,
  const CartesianGrid& grid, const Partition& partition, DonorTable& donors)
{
  std::vector<std::vector<SentPart>> sent(partition.Peers().size());
  ForCutParts(pieces, ids,
    [&](Index id, const DonorPart& part)
    {
      Donor& donor = donors[part.Donor];
      if (!donor.IsOwned)
      {
        donor.HasParts = true;
        const Index3 cell = grid.Position(donor.Cell);
        const int peer = partition.PeerOfCell(cell);
        sent[peer].push_back({ id, partition.CellKeyAtPeer(peer, cell), donor.Fragment,
          donor.Material, part.Volume, part.Centroid - partition.TranslationOf(peer) });
      }
    });
  std::vector<SentPart> received = Joined(partition.Exchange(sent));
  std::stable_sort(received.begin(), received.end(),
    [](const SentPart& a, const SentPart& b) { return a.Id < b.Id; });
  return received;
}

/// Sends the kinds of parts in ghost cells to the owners of the cells. Collective among peers.
void ExchangeKinds(
  const CartesianGrid& grid, const Partition& partition, DonorTable& donors, DonorSearch& search)
{
  std::vector<std::vector<SentKinds>> sent(partition.Peers().size());
  for (int s = 0; s < donors.Count(); ++s)
  {
    Donor& donor = donors[s];
    const std::uint64_t kinds = search.KindsOf(s);
    if (!donor.IsOwned && kinds != 0)
    {
      donor.HasParts = true;
      const Index3 cell = grid.Position(donor.Cell);
      const int peer = partition.PeerOfCell(cell);
      sent[peer].push_back(
        { partition.CellKeyAtPeer(peer, cell), donor.Fragment, donor.Material, kinds });
    }
  }
  for (const SentKinds& other : Joined(partition.Exchange(sent)))
  {
    const Index cell = grid.Linear(grid.CellOfKey(other.Key));
    search.AddKinds(search.Get(cell, other.Fragment, other.Material), other.Kinds);
  }
}

/// Adds the parts of regular tets to owned donors.
void AddRegularParts(
  const DonorSearch& search, const CartesianGrid& grid, DonorTable& donors, DonorShapes& shapes)
{
  RegularSums sums(0);
  for (int s = 0; s < donors.Count(); ++s)
  {
    const std::uint64_t kinds = search.KindsOf(s);
    if (donors[s].IsOwned && kinds != 0)
    {
      sums = sums.Kinds == kinds ? sums : RegularSums(kinds);
      AddRegular(sums, grid, grid.Position(donors[s].Cell), donors[s], shapes[s]);
    }
  }
}

/// Adds other parts to owned donors in the order of the ids of elements.
/// @param ids  ids of all elements of the mesh
/// @param others,donorOf  parts of other ranks and their donors
void AddCutParts(const std::vector<DonorParts>& pieces, const Buffer<Index>& ids,
  const std::vector<SentPart>& others, const std::vector<int>& donorOf, DonorTable& donors,
  DonorShapes& shapes)
{
  const auto add = [&](int s, double volume, const Vector3& centroid)
  { AddPart(volume, centroid, donors[s], shapes[s]); };
  std::size_t next = 0;
  const auto addBefore = [&](Index id)
  {
    for (; next < others.size() && others[next].Id < id; ++next)
    {
      add(donorOf[next], others[next].Volume, others[next].Centroid);
    }
  };
  ForCutParts(pieces, ids,
    [&](Index id, const DonorPart& part)
    {
      addBefore(id);
      if (donors[part.Donor].IsOwned)
      {
        add(part.Donor, part.Volume, part.Centroid);
      }
    });
  addBefore(std::numeric_limits<Index>::max());
}

} // namespace

std::vector<DonorParts> FindDonorParts(const Mesh& mesh,
  const std::function<bool(Index element)>& isNeeded, const CartesianGrid& grid,
  const RegularTets& regular, const Partition& partition, Runtime& runtime, DonorTable& donors,
  DonorShapes& shapes)
{
  DonorSearch search(mesh, grid, donors);
  OverlapFinder finder(mesh, grid, runtime);
  std::vector<DonorParts> pieces = ListElements(static_cast<Index>(mesh.Material.size()), isNeeded);
  if (regular.IsUsed())
  {
    donors.Reserve(mesh.Material.size() / LeastTetsOfDonor);
  }
  for (DonorParts& some : pieces)
  {
    CutElements(FindRegular(regular, runtime, search, some), finder, search, some);
  }
  std::vector<SentPart> others;
  if (!partition.Peers().empty())
  {
    ExchangeKinds(grid, partition, donors, search);
    others = ExchangeParts(pieces, mesh.ElementIds, grid, partition, donors);
  }
  std::vector<int> donorOf; // of the parts of other ranks
  for (const SentPart& other : others)
  {
    const Index cell = grid.Linear(grid.CellOfKey(other.Key));
    donorOf.push_back(search.Get(cell, other.Fragment, other.Material));
  }
  shapes.resize(donors.Count());
  AddRegularParts(search, grid, donors, shapes);
  AddCutParts(pieces, mesh.ElementIds, others, donorOf, donors, shapes);
  return pieces;
}

void CentreShapes(DonorTable& donors, DonorShapes& shapes)
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
