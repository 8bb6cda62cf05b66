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

/// Sums of the shares of all elements of all ranks at each point, in the order of element ids.
struct Work
{
  const Mesh& TheMesh;
  const CartesianGrid& Grid;
  const Buffer<double>&Mass, &Velocity;
  std::vector<Momentum> Sums = std::vector<Momentum>(TheMesh.PointIds.size()); // one per point
};

/// Calls body(point, element) for all corners of all elements.
template <class Body>
void ForShares(const Work& work, const Body& body)
{
  const Index corners = work.TheMesh.Corners;
  for (std::size_t i = 0; i < work.TheMesh.Elements.size(); ++i)
  {
    body(work.TheMesh.Elements[i], static_cast<Index>(i) / corners);
  }
}

Momentum GivenBy(const Work& work, Index element)
{
  const double mass = work.Mass[element] / work.TheMesh.Corners;
  return { mass, mass * VectorAt(work.Velocity, element) };
}

/// @param id  id of the point that gets the share
Share MakeShare(const Work& work, Index id, Index element)
{
  return { id, work.TheMesh.ElementIds[element], GivenBy(work, element) };
}

/// Returns whether no other rank has a point, because TetGen made it.
bool IsAlone(const Work& work, Index id)
{
  return work.TheMesh.Ids.ElementSlots == 0 &&
    id >= EndOfPointIds(*work.TheMesh.Levels, work.TheMesh.Ids.PointSlots);
}

/// Returns the position in Peers() of the owner of each point; -1 for this rank.
std::vector<int> FindOwners(const Work& work, const Partition& partition)
{
  std::vector<int> owners(work.TheMesh.PointIds.size(), -1);
  for (std::size_t p = 0; p < owners.size(); ++p)
  {
    const Index id = work.TheMesh.PointIds[p];
    if (!IsAlone(work, id))
    {
      const Index3 node = NodeOfPoint(work.Grid, work.TheMesh, id);
      owners[p] = partition.OwnsNode(node) ? -1 : partition.PeerOfNode(node);
    }
  }
  return owners;
}

/// Returns the index of a point, or -1 if this rank does not have it.
Index FindPoint(const Work& work, Index id)
{
  const Buffer<Index>& ids = work.TheMesh.PointIds;
  const Index* at = std::lower_bound(ids.begin(), ids.end(), id);
  return at != ids.end() && *at == id ? at - ids.begin() : -1;
}

/// Adds the shares of this rank at all points that have shares in the list.
void AddOwnShares(const Work& work, std::vector<Share>& shares)
{
  std::vector<char> isRequested(work.TheMesh.PointIds.size(), 0);
  for (const Share& share : shares)
  {
    const Index point = FindPoint(work, share.Point);
    if (point >= 0)
    {
      isRequested[point] = 1;
    }
  }
  ForShares(work,
    [&](Index point, Index element)
    {
      if (isRequested[point])
      {
        shares.push_back(MakeShare(work, work.TheMesh.PointIds[point], element));
      }
    });
}

void WriteOwn(Work& work, const Share& sum)
{
  const Index point = FindPoint(work, sum.Point);
  if (point >= 0)
  {
    work.Sums[point] = sum.Given;
  }
}

/// Returns the sums over all ranks at the points of each peer, in the order of its shares.
std::vector<std::vector<Momentum>> Answer(
  Work& work, const std::vector<std::vector<Share>>& requested)
{
  std::vector<Share> all;
  for (const std::vector<Share>& shares : requested)
  {
    all.insert(all.end(), shares.begin(), shares.end());
  }
  AddOwnShares(work, all);
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
    WriteOwn(work, sum);
  }
  return answers;
}

/// Adds the shares of other ranks and at copies. The owner of a point receives all shares and
/// returns their sum, even if it has no element at the point.
void AddOfPeers(Work& work, const Partition& partition)
{
  const std::vector<int> owners = FindOwners(work, partition);
  std::vector<std::vector<Share>> mine(partition.Peers().size());
  std::vector<std::vector<Index>> points(mine.size()); // of the shares
  ForShares(work,
    [&](Index point, Index element)
    {
      const int peer = owners[point];
      if (peer >= 0)
      {
        const Index id = IdAtPeer(work.TheMesh, partition, peer, work.TheMesh.PointIds[point]);
        mine[peer].push_back(MakeShare(work, id, element));
        points[peer].push_back(point);
      }
    });
  const std::vector<std::vector<Momentum>> sums =
    partition.Exchange(Answer(work, partition.Exchange(mine)));
  for (std::size_t peer = 0; peer < sums.size(); ++peer)
  {
    for (std::size_t i = 0; i < sums[peer].size(); ++i)
    {
      work.Sums[points[peer][i]] = sums[peer][i];
    }
  }
}

} // namespace

NodalVelocity FindNodalVelocity(const Mesh& mesh, const CartesianGrid& grid,
  const Buffer<double>& mass, const Buffer<double>& velocity, Runtime& runtime)
{
  Work work{ mesh, grid, mass, velocity };
  ForShares(
    work, [&](Index point, Index element) { work.Sums[point].Add(GivenBy(work, element)); });
  const Partition partition(grid, runtime.Group());
  if (!partition.Peers().empty())
  {
    AddOfPeers(work, partition);
  }
  const std::vector<Momentum>& sums = work.Sums;
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
