#include "State/Transfer/NodalVelocity.h"

#include "Base/Partition.h"
#include "Base/Vector3.h"
#include "Elements/PeriodicIds.h"
#include "Octree/LevelIds.h"

namespace vfm
{
namespace
{

// Fraction of a kinetic energy by which it and its velocity may differ by rounding.
constexpr double Rounding = 1e-14;

/// Mass and momentum of a point.
struct Momentum
{
  double Mass = 0.0;
  Vector3 Vector{};

  void Add(const Momentum& other)
  {
    this->Mass += other.Mass;
    this->Vector = this->Vector + other.Vector;
  }
};

/// Mass and momentum that an element gives to a point.
struct Share
{
  Index Point, Element; ///< ids
  Momentum Given;
  bool operator<(const Share& other) const
  {
    return this->Point != other.Point ? this->Point < other.Point : this->Element < other.Element;
  }
};

Vector3 VectorAt(const Buffer<double>& vectors, Index i)
{
  return { { vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2] } };
}

/// Shares that the elements of this rank give to their corners.
struct ElementShares
{
  const Mesh& TheMesh;
  const Buffer<double>&Mass, &Velocity;

  Momentum Of(Index element) const
  {
    const double mass = this->Mass[element] / this->TheMesh.Corners;
    return { mass, mass * VectorAt(this->Velocity, element) };
  }
  /// @param id  id of the point that gets the share
  Share Make(Index id, Index element) const
  {
    return { id, this->TheMesh.ElementIds[element], this->Of(element) };
  }
};

/// Calls body(point, element) for all corners of all elements.
template <class Body>
void ForShares(const Mesh& mesh, const Body& body)
{
  const Index corners = mesh.Corners;
  for (std::size_t i = 0; i < mesh.Elements.size(); ++i)
  {
    body(mesh.Elements[i], static_cast<Index>(i) / corners);
  }
}

/// Returns whether no other rank has a point, because TetGen made it.
bool IsAlone(const Mesh& mesh, Index id)
{
  return mesh.Ids.ElementSlots == 0 && id >= EndOfPointIds(*mesh.Levels, mesh.Ids.PointSlots);
}

/// Returns the position in Peers() of the owner of each point; -1 for this rank.
std::vector<int> FindOwners(const Mesh& mesh, const CartesianGrid& grid, const Partition& partition)
{
  std::vector<int> owners(mesh.PointIds.size(), -1);
  for (std::size_t p = 0; p < owners.size(); ++p)
  {
    const Index id = mesh.PointIds[p];
    if (!IsAlone(mesh, id))
    {
      const Index3 node = NodeOfPoint(grid, mesh, id);
      owners[p] = partition.OwnsNode(node) ? -1 : partition.PeerOfNode(node);
    }
  }
  return owners;
}

/// Returns the index of a point, or -1 if this rank does not have it.
/// @param ids  ids of the points of this rank, ascending
Index FindPoint(const Buffer<Index>& ids, Index id)
{
  const Index* at = std::lower_bound(ids.begin(), ids.end(), id);
  return at != ids.end() && *at == id ? at - ids.begin() : -1;
}

/// Adds the shares of this rank at all points that have shares in the list.
void AddOwnShares(const ElementShares& own, std::vector<Share>& shares)
{
  const Buffer<Index>& ids = own.TheMesh.PointIds;
  std::vector<char> isRequested(ids.size(), 0);
  for (const Share& share : shares)
  {
    const Index point = FindPoint(ids, share.Point);
    if (point >= 0)
    {
      isRequested[point] = 1;
    }
  }
  ForShares(own.TheMesh,
    [&](Index point, Index element)
    {
      if (isRequested[point])
      {
        shares.push_back(own.Make(ids[point], element));
      }
    });
}

/// Returns the sums over all ranks at the points of each peer, in the order of its shares.
/// @param[out] momenta  sums at the points of this rank that peers request
std::vector<std::vector<Momentum>> Answer(const std::vector<std::vector<Share>>& requested,
  const ElementShares& own, std::vector<Momentum>& momenta)
{
  std::vector<Share> all;
  for (const std::vector<Share>& shares : requested)
  {
    all.insert(all.end(), shares.begin(), shares.end());
  }
  AddOwnShares(own, all);
  std::sort(all.begin(), all.end());
  std::vector<Share> sums; // one per point
  for (const Share& share : all)
  {
    if (sums.empty() || sums.back().Point != share.Point)
    {
      sums.push_back({ share.Point, 0, {} });
    }
    sums.back().Given.Add(share.Given);
  }
  std::vector<std::vector<Momentum>> answers;
  for (const std::vector<Share>& shares : requested)
  {
    answers.emplace_back();
    for (const Share& share : shares)
    {
      const Share first{ share.Point, 0, {} };
      answers.back().push_back(std::lower_bound(sums.begin(), sums.end(), first)->Given);
    }
  }
  for (const Share& sum : sums)
  {
    const Index point = FindPoint(own.TheMesh.PointIds, sum.Point);
    if (point >= 0)
    {
      momenta[point] = sum.Given;
    }
  }
  return answers;
}

/// Adds the shares of other ranks and at copies. The owner of a point receives all shares and
/// returns their sum, even if it has no element at the point.
/// @param momenta  sum at each point of this rank
void AddOfPeers(const ElementShares& own, const CartesianGrid& grid, const Partition& partition,
  std::vector<Momentum>& momenta)
{
  const Mesh& mesh = own.TheMesh;
  const std::vector<int> owners = FindOwners(mesh, grid, partition);
  std::vector<std::vector<Share>> mine(partition.Peers().size());
  std::vector<std::vector<Index>> points(mine.size()); // of the shares
  ForShares(mesh,
    [&](Index point, Index element)
    {
      const int peer = owners[point];
      if (peer >= 0)
      {
        const Index id = IdAtPeer(mesh, partition, peer, mesh.PointIds[point]);
        mine[peer].push_back(own.Make(id, element));
        points[peer].push_back(point);
      }
    });
  const std::vector<std::vector<Momentum>> sums =
    partition.Exchange(Answer(partition.Exchange(mine), own, momenta));
  for (std::size_t peer = 0; peer < sums.size(); ++peer)
  {
    for (std::size_t i = 0; i < sums[peer].size(); ++i)
    {
      momenta[points[peer][i]] = sums[peer][i];
    }
  }
}

} // namespace

NodalVelocity FindNodalVelocity(const Mesh& mesh, const CartesianGrid& grid,
  const Buffer<double>& mass, const Buffer<double>& velocity, Runtime& runtime)
{
  const ElementShares own{ mesh, mass, velocity };
  // Sums over the elements of all ranks at each point, in the order of element ids.
  std::vector<Momentum> sums(mesh.PointIds.size());
  ForShares(mesh, [&](Index point, Index element) { sums[point].Add(own.Of(element)); });
  const Partition partition(grid, runtime.Group());
  if (!partition.Peers().empty())
  {
    AddOfPeers(own, grid, partition, sums);
  }
  NodalVelocity nodal{ Buffer<double>(3 * sums.size()), Buffer<double>(sums.size()),
    Buffer<double>(mass.size()) };
  ForEach(runtime, sums.size(),
    [&](Index p)
    {
      nodal.Mass[p] = sums[p].Mass;
      for (int a = 0; a < 3; ++a)
      {
        nodal.Velocity[3 * p + a] = sums[p].Mass > 0.0 ? sums[p].Vector[a] / sums[p].Mass : 0.0;
      }
    });
  ForEach(runtime, mass.size(),
    [&](Index e)
    {
      double squares = 0.0;
      for (int c = 0; c < mesh.Corners; ++c)
      {
        const Vector3 difference =
          VectorAt(velocity, e) - VectorAt(nodal.Velocity, mesh.Elements[mesh.Corners * e + c]);
        squares += Dot(difference, difference);
      }
      nodal.Lost[e] = 0.5 * mass[e] / mesh.Corners * squares;
    });
  return nodal;
}

Buffer<double> FindLostKineticEnergy(const Buffer<double>& mass, const Buffer<double>& velocity,
  const Buffer<double>& kinetic, Runtime& runtime)
{
  Buffer<double> lost(mass.size());
  ForEach(runtime, mass.size(),
    [&](Index e)
    {
      const Vector3 u = VectorAt(velocity, e);
      const double difference = kinetic[e] - 0.5 * Dot(u, u);
      const bool isRounding = std::fabs(difference) <= Rounding * kinetic[e];
      lost[e] = isRounding ? 0.0 : mass[e] * difference;
    });
  return lost;
}

} // namespace vfm
