#include "Tet/LatticeSnappedTets.h"

#include "Mesh/Mesh.h"

namespace vfm
{
namespace
{

constexpr int Rounds = 10;

/// Neighbour across a face.
struct Neighbour
{
  int Tet = -1;   // a snapped tet, or -1
  int Label = -1; // label of any other tet; -1 if there is none
};

struct Work
{
  std::vector<SnappedTet>& Tets; // ordered by id
  const CartesianGrid& Grid;
  const Partition& Parts;
  std::vector<std::array<Neighbour, 4>> Around;
  std::vector<int> Owned{};                             // tets of this rank
  std::vector<std::vector<int>> Incoming{}, Outgoing{}; // tets per peer
};

/// Returns the most frequent label of the neighbours of a tet, or its own label if no other is
/// more frequent.
int Majority(const Work& work, int tet)
{
  const int own = work.Tets[tet].Label;
  std::array<int, 4> shown;
  for (int i = 0; i < 4; ++i)
  {
    const Neighbour& neighbour = work.Around[tet][i];
    shown[i] = neighbour.Tet >= 0 ? work.Tets[neighbour.Tet].Label : neighbour.Label;
  }
  const auto count = [&](int label) { return std::count(shown.begin(), shown.end(), label); };
  int best = own;
  auto most = count(own);
  for (int label : shown)
  {
    const auto times = count(label);
    if (label >= 0 && (times > most || (times == most && best != own && label < best)))
    {
      best = label;
      most = times;
    }
  }
  return best;
}

void Exchange(Work& work)
{
  const std::vector<std::vector<int>> labels =
    work.Parts.Exchange(MapLists(work.Outgoing, [&](int tet) { return work.Tets[tet].Label; }));
  for (std::size_t peer = 0; peer < labels.size(); ++peer)
  {
    for (std::size_t i = 0; i < labels[peer].size(); ++i)
    {
      work.Tets[work.Incoming[peer][i]].Label = labels[peer][i];
    }
  }
}

void FindNeighbours(Work& work, const std::vector<SnappedFace>& faces)
{
  struct Side
  {
    Index Face;
    int Tet, Node;
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t < work.Tets.size(); ++t)
  {
    for (int i = 0; i < 4; ++i)
    {
      sides.push_back({ work.Tets[t].Faces[i], static_cast<int>(t), i });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return a.Face != b.Face ? a.Face < b.Face : a.Tet < b.Tet; });
  for (std::size_t s = 1; s < sides.size(); ++s)
  {
    const Side &a = sides[s - 1], &b = sides[s];
    if (a.Face == b.Face)
    {
      work.Around[a.Tet][a.Node].Tet = b.Tet;
      work.Around[b.Tet][b.Node].Tet = a.Tet;
    }
  }
  for (const SnappedFace& face : faces)
  {
    const auto side = std::lower_bound(
      sides.begin(), sides.end(), face.Id, [](const Side& s, Index id) { return s.Face < id; });
    if (side != sides.end() && side->Face == face.Id)
    {
      work.Around[side->Tet][side->Node].Label = face.Label;
    }
  }
}

/// Lists the owned tets, and the tets whose labels are exchanged with each peer.
void FindOwners(Work& work)
{
  std::vector<std::vector<Index>> requested(work.Parts.Peers().size());
  work.Incoming.resize(requested.size());
  for (std::size_t t = 0; t < work.Tets.size(); ++t)
  {
    const SnappedTet& tet = work.Tets[t];
    const Index3 cell = work.Grid.CellOfBlock(tet.Block);
    if (work.Parts.OwnsCell(cell))
    {
      work.Owned.push_back(static_cast<int>(t));
      continue;
    }
    const int peer = work.Parts.PeerOfCell(cell);
    requested[peer].push_back(tet.Id);
    work.Incoming[peer].push_back(static_cast<int>(t));
  }
  const auto find = [&](Index id)
  {
    const auto tet = std::lower_bound(work.Tets.begin(), work.Tets.end(), id,
      [](const SnappedTet& t, Index key) { return t.Id < key; });
    return static_cast<int>(tet - work.Tets.begin());
  };
  work.Outgoing = MapLists(work.Parts.Exchange(requested), find);
}

} // namespace

void SettleSnappedTets(std::vector<SnappedTet>& tets, const std::vector<SnappedFace>& faces,
  const CartesianGrid& grid, const Partition& partition)
{
  Work work{ tets, grid, partition, std::vector<std::array<Neighbour, 4>>(tets.size()) };
  FindNeighbours(work, faces);
  FindOwners(work);
  std::vector<int> next;
  bool changed = true;
  for (int round = 0; round < Rounds && changed; ++round)
  {
    next.clear();
    for (int tet : work.Owned)
    {
      next.push_back(Majority(work, tet));
    }
    changed = false;
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      int& label = work.Tets[work.Owned[i]].Label;
      changed = changed || label != next[i];
      label = next[i];
    }
    changed = work.Parts.Group().Any(changed);
    if (changed)
    {
      Exchange(work);
    }
  }
}

} // namespace vfm
