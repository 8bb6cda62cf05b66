#include "Geometry/LeaveCovering.h"

#include "Base/Sorted.h"
#include "Elements/PeriodicIds.h"
#include "Octree/LevelIds.h"
#include "Ranks/MergeByKey.h"

#include <limits>

namespace vfm
{
namespace
{

using LevelIndex = OctreeKeys::LevelIndex;

/// The refined grid of the domain, and ids on it.
class DomainIds
{
public:
  /// Collective.
  DomainIds(const Mesh& mesh, Ranks& ranks) :
    Covering(*mesh.Levels), Lower(Covering.Finest().Domain().Lower), Ids(mesh.Ids)
  {
    LevelPlan plan;
    plan.FineInterfaces = this->Covering.HasFineInterfaces();
    plan.Unit = this->Covering.Families().UnitOfSets();
    plan.Refinements = this->Covering.NumberOfRefinements();
    const CartesianGrid finest = this->Covering.Finest().OfDomain(GhostLayers);
    const CartesianGrid base = this->Covering.Base().OfDomain();
    plan.Families = this->ListFamilies(OctreeKeys(base, plan.Refinements));
    this->Domain = std::make_shared<const RefinedGrid>(finest, plan, std::vector<Index>(), ranks);
  }

  const std::shared_ptr<const RefinedGrid>& Levels() const { return this->Domain; }

  /// Returns whether a point was added by TetGen.
  bool IsAdded(Index id) const { return id >= EndOfPointIds(this->Covering, this->Ids.PointSlots); }

  Index OfPoint(Index id) const
  {
    const Index slots = this->Ids.PointSlots;
    if (this->IsAdded(id))
    {
      return id - EndOfPointIds(this->Covering, slots) + EndOfPointIds(*this->Domain, slots);
    }
    if (!IsCoarsePoint(this->Covering, id, slots))
    {
      const Index3 node = this->Covering.Finest().NodeOfKey((id - 1) / slots);
      return this->Domain->Finest().NodeKey(Minus(node, this->Lower)) * slots + (id - 1) % slots +
        1;
    }
    if (IsCoarseCentre(this->Covering, id, slots))
    {
      return CentreId(
        *this->Domain, this->HexKey(CellOfCoarseCentre(this->Covering, id, slots)), slots);
    }
    const LevelIndex node =
      this->Shifted(this->Covering.Lattice().NodeOfKey(KeyOfPoint(this->Covering, id, slots)));
    return CoarsePointId(*this->Domain,
      this->Domain->Lattice().NodeKey(node.Level, node.At, node.Slot), slots,
      static_cast<int>((id - 1) % slots));
  }

  Index OfHex(Index id) const
  {
    const Index slots = this->Ids.ElementSlots;
    const int slot = static_cast<int>((id - 1) % slots);
    if (IsCoarseElement(this->Covering, id, slots))
    {
      return ElementId(
        *this->Domain, this->HexKey(CellOfCoarseElement(this->Covering, id, slots)), slots, slot);
    }
    const Index3 cell = this->Covering.Finest().CellOfKey((id - 1) / slots);
    return this->Domain->Finest().CellKey(Minus(cell, this->Lower)) * slots + slot + 1;
  }

  Index OfTet(Index id) const
  {
    const Index slots = this->Ids.ElementSlots;
    if (slots == 0)
    {
      return id; // TetGen's
    }
    if (IsCoarseTet(this->Covering, id, slots))
    {
      const Index number = (id - TetId(this->Covering, 0, 0, slots)) % TetsOfCell;
      return TetId(
        *this->Domain, this->HexKey(CellOfCoarseTet(this->Covering, id, slots)), number, slots);
    }
    const Index3 block = this->Covering.Finest().NodeOfKey((id - 1) / slots);
    return this->Domain->Finest().NodeKey(Minus(block, this->Lower)) * slots + (id - 1) % slots + 1;
  }

private:
  static Index3 Minus(const Index3& p, const Index3& q)
  {
    return { { p[0] - q[0], p[1] - q[1], p[2] - q[2] } };
  }
  /// Returns a cell or node of a level of the covering grid, counted in the domain.
  LevelIndex Shifted(const LevelIndex& at) const
  {
    return Below(at, this->Lower, this->Covering.NumberOfRefinements());
  }
  Index HexKey(const LevelIndex& covering) const
  {
    const LevelIndex cell = this->Shifted(covering);
    return this->Domain->Lattice().HexKey(cell.Level, cell.At, cell.Slot);
  }
  /// Returns the families of the covering grid that this rank owns, with keys of the domain.
  std::vector<std::vector<Index>> ListFamilies(const OctreeKeys& domain) const
  {
    std::vector<std::vector<Index>> families(this->Covering.NumberOfRefinements());
    for (int level = 0; level < this->Covering.NumberOfRefinements(); ++level)
    {
      const int own = this->Covering.Families().FamilyLevel(level);
      const IndexBox owned = ChangeLevel(domain.Base().Owned(), own);
      for (Index key : this->Covering.Families().Keys(level))
      {
        const Index3 first =
          ChangeLevel(BoxOfCell(this->Covering.Lattice().FamilyOfKey(own, key)), 1).Lower;
        const Index3 cell = this->Shifted({ own, first, 0 }).At;
        if (owned.Contains(cell))
        {
          families[level].push_back(domain.FamilyKey(own, ParentOfCell(cell)));
        }
      }
    }
    return families;
  }

  const RefinedGrid& Covering;
  const Index3 Lower; // first finest cell of the domain
  const IdScheme Ids;
  std::shared_ptr<const RefinedGrid> Domain;
};

/// Returns whether a point may have copies.
bool MayHaveCopies(const Mesh& mesh, const DomainIds& domain, Index id)
{
  const CartesianGrid& grid = mesh.Levels->Finest();
  return !domain.IsAdded(id) && HasCopies(grid, NodeOfPoint(grid, mesh, id));
}

/// Returns the points that may have copies.
std::vector<Index> ListCopies(const Mesh& mesh, const DomainIds& domain)
{
  std::vector<Index> points;
  for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
  {
    if (MayHaveCopies(mesh, domain, mesh.PointIds[p]))
    {
      points.push_back(static_cast<Index>(p));
    }
  }
  return points;
}

/// Returns the ids of the ends of pulls that may have copies, ascending. They are ids of owners.
std::vector<Index> ListEnds(const Mesh& mesh, const DomainIds& domain)
{
  std::vector<Index> ends;
  for (const EdgePull& pull : mesh.Pulls)
  {
    for (Index end : pull.Edge)
    {
      if (MayHaveCopies(mesh, domain, end))
      {
        ends.push_back(end);
      }
    }
  }
  SortUnique(ends);
  return ends;
}

/// Finds the partners of the points of this rank and of the ends of its pulls.
class PartnerIds
{
public:
  /// Collective.
  /// @param points  those that may have copies
  /// @param ids  ids of the points of the mesh on the grid of the domain
  PartnerIds(const Mesh& mesh, const DomainIds& domain, const std::vector<Index>& points,
    const Buffer<Index>& ids, Partner partner, Ranks& ranks) :
    Domain(domain)
  {
    if (partner == Partner::Upper)
    {
      return;
    }
    std::vector<Index> owners, copies, questions = ListEnds(mesh, domain);
    for (Index point : points)
    {
      owners.push_back(IdOfOwner(mesh, mesh.PointIds[point]));
      copies.push_back(ids[point]);
    }
    questions.insert(questions.end(), owners.begin(), owners.end());
    SortUnique(questions);
    this->Lowest = AskByKey(
      std::move(owners), std::move(copies), questions, std::numeric_limits<Index>::max(),
      [](Index a, Index b) { return std::min(a, b); }, ranks);
    this->Owners = std::move(questions);
  }

  /// Returns the partner from the id of the owner.
  Index Of(Index owner) const
  {
    const Index found = FindSorted(this->Owners, owner);
    const bool isKnown = found >= 0 && this->Lowest[found] < std::numeric_limits<Index>::max();
    return isKnown ? this->Lowest[found] : this->Domain.OfPoint(owner);
  }

private:
  const DomainIds& Domain;
  std::vector<Index> Owners; // ids of owners, ascending; empty if partners are owners
  std::vector<Index> Lowest; // lowest id of a copy in the mesh on the grid of the domain
};

/// Names the edges of pulls by the partners of their ends.
void RenamePulls(const PartnerIds& partners, std::vector<EdgePull>& pulls)
{
  for (EdgePull& pull : pulls)
  {
    pull.End = partners.Of(pull.End);
    pull.Edge = MakeEdgeIds(partners.Of(pull.Edge[0]), partners.Of(pull.Edge[1]));
    pull.Group = pull.Edge;
  }
}

} // namespace

void LeaveCovering(const Partition& covering, Partner partner, Mesh& mesh)
{
  Ranks& ranks = covering.Group();
  const DomainIds domain(mesh, ranks);
  Buffer<Index> ids(mesh.PointIds.size());
  std::transform(mesh.PointIds.begin(), mesh.PointIds.end(), ids.begin(),
    [&domain](Index id) { return domain.OfPoint(id); });
  const std::vector<Index> points = ListCopies(mesh, domain);
  const PartnerIds partners(mesh, domain, points, ids, partner, ranks);
  mesh.PeriodicPartner = Buffer<Index>(ids.size());
  std::copy(ids.begin(), ids.end(), mesh.PeriodicPartner.begin());
  for (Index point : points)
  {
    mesh.PeriodicPartner[point] = partners.Of(IdOfOwner(mesh, mesh.PointIds[point]));
  }
  RenamePulls(partners, mesh.Pulls);
  mesh.PointIds = std::move(ids);
  for (Index& id : mesh.ElementIds)
  {
    id = mesh.HasHexes() ? domain.OfHex(id) : domain.OfTet(id);
  }
  mesh.Levels = domain.Levels();
}

} // namespace vfm
