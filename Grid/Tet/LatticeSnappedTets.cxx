#include "Tet/LatticeSnappedTets.h"

#include "Mesh/Mesh.h"

namespace vfm
{
namespace
{

constexpr int Rounds = 10;

class SnappedTetLabels
{
public:
  SnappedTetLabels(std::vector<SnappedTet>& tets, const std::vector<SnappedFace>& faces,
    const CartesianGrid& grid, const Partition& partition) :
    Tets(tets), Grid(grid), Parts(partition), Around(tets.size())
  {
    this->FindNeighbours(faces);
    this->FindOwners();
  }

  /// Collective.
  void Settle()
  {
    std::vector<int> next;
    bool changed = true;
    for (int round = 0; round < Rounds && changed; ++round)
    {
      next.clear();
      for (int tet : this->Owned)
      {
        next.push_back(this->Majority(tet));
      }
      changed = false;
      for (std::size_t i = 0; i < next.size(); ++i)
      {
        int& label = this->Tets[this->Owned[i]].Label;
        changed = changed || label != next[i];
        label = next[i];
      }
      changed = this->Parts.Group().Any(changed);
      if (changed)
      {
        this->Exchange();
      }
    }
  }

private:
  /// What lies across a face: another tet of the list, else a label or nothing.
  struct Neighbour
  {
    int Tet = -1;
    int Label = -1;
  };

  void FindNeighbours(const std::vector<SnappedFace>& faces)
  {
    struct Side
    {
      Index Face;
      int Tet, Node;
    };
    std::vector<Side> sides;
    for (std::size_t t = 0; t < this->Tets.size(); ++t)
    {
      for (int i = 0; i < 4; ++i)
      {
        sides.push_back({ this->Tets[t].Faces[i], static_cast<int>(t), i });
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
        this->Around[a.Tet][a.Node].Tet = b.Tet;
        this->Around[b.Tet][b.Node].Tet = a.Tet;
      }
    }
    for (const SnappedFace& face : faces)
    {
      const auto side = std::lower_bound(
        sides.begin(), sides.end(), face.Id, [](const Side& s, Index id) { return s.Face < id; });
      if (side != sides.end() && side->Face == face.Id)
      {
        this->Around[side->Tet][side->Node].Label = face.Label;
      }
    }
  }

  /// Of the tets of other ranks the labels are asked for.
  void FindOwners()
  {
    std::vector<std::vector<Index>> wanted(this->Parts.Peers().size());
    this->Incoming.resize(wanted.size());
    for (std::size_t t = 0; t < this->Tets.size(); ++t)
    {
      const SnappedTet& tet = this->Tets[t];
      const Index3 cell = this->Grid.CellOfBlock(tet.Block);
      if (this->Parts.OwnsCell(cell))
      {
        this->Owned.push_back(static_cast<int>(t));
        continue;
      }
      const int peer = this->Parts.PeerOfCell(cell);
      wanted[peer].push_back(tet.Id);
      this->Incoming[peer].push_back(static_cast<int>(t));
    }
    for (const std::vector<Index>& ids : this->Parts.Exchange(wanted))
    {
      this->Outgoing.emplace_back();
      for (Index id : ids)
      {
        const auto tet = std::lower_bound(this->Tets.begin(), this->Tets.end(), id,
          [](const SnappedTet& t, Index key) { return t.Id < key; });
        this->Outgoing.back().push_back(static_cast<int>(tet - this->Tets.begin()));
      }
    }
  }

  int Majority(int tet) const
  {
    const int own = this->Tets[tet].Label;
    std::array<int, 4> shown;
    for (int i = 0; i < 4; ++i)
    {
      const Neighbour& neighbour = this->Around[tet][i];
      shown[i] = neighbour.Tet >= 0 ? this->Tets[neighbour.Tet].Label : neighbour.Label;
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

  void Exchange()
  {
    std::vector<std::vector<int>> labels;
    for (const std::vector<int>& tets : this->Outgoing)
    {
      labels.emplace_back();
      for (int tet : tets)
      {
        labels.back().push_back(this->Tets[tet].Label);
      }
    }
    labels = this->Parts.Exchange(labels);
    for (std::size_t peer = 0; peer < labels.size(); ++peer)
    {
      for (std::size_t i = 0; i < labels[peer].size(); ++i)
      {
        this->Tets[this->Incoming[peer][i]].Label = labels[peer][i];
      }
    }
  }

  std::vector<SnappedTet>& Tets; // by id
  const CartesianGrid& Grid;
  const Partition& Parts;
  std::vector<std::array<Neighbour, 4>> Around;
  std::vector<int> Owned;                           // tets
  std::vector<std::vector<int>> Incoming, Outgoing; // tets, by peer
};

} // namespace

void SettleSnappedTets(std::vector<SnappedTet>& tets, const std::vector<SnappedFace>& faces,
  const CartesianGrid& grid, const Partition& partition)
{
  SnappedTetLabels(tets, faces, grid, partition).Settle();
}

} // namespace vfm
