/// CoarseTets::Improve: moves centres and free points of transition hexes where tets are poor.
#include "Tet/CoarseTets.h"

#include "Base/Vector3.h"
#include "Hex/TransitionSmoothing.h"
#include "Mesh/TetQuality.h"
#include "Smoothing/Smoother.h"
#include "Tet/TetImprove.h"

namespace vfm
{

/// Of one level: the points that may move, and the tets at them.
class CoarseTets::Improver
{
public:
  Improver(CoarseTets& tets, int level) :
    Tets(tets), Level(level), IndexOf(tets.Local.Points.size() / 3, -1)
  {
  }

  /// Collective.
  void Run(const Partition& partition, Runtime& runtime)
  {
    this->AddCandidates(partition);
    this->AddTets();
    this->Activate(partition);
    if (!runtime.Group().Any(this->IsPoor))
    {
      return;
    }
    const CartesianGrid& grid = this->Tets.Grid.Finest();
    ActiveMesh& active = this->Active;
    active.Start = active.X;
    active.AttachmentOffset.assign(active.X.size() + 1, 0);
    active.FixOnDomain(grid, this->Tets.Local);
    active.ListCorners();
    const PointExchange exchange(this->ListEntries(), partition);
    Smoother smoother(active, nullptr, exchange, this->Tets.Energy, runtime);
    for (const SmoothingStage& stage : TetRamp())
    {
      smoother.RunStage(stage, [](double) {});
    }
    active.CopyTo(this->Tets.Local, grid);
  }

private:
  static constexpr double PoorAngle = 20.0; // degrees off 0 or 180, of a dihedral angle

  void AddPoint(int point)
  {
    this->IndexOf[point] = static_cast<int>(this->Active.X.size());
    this->Active.AddPoint(this->Tets.Grid.Finest(), this->Tets.Local, point, false);
  }

  void AddCandidates(const Partition& partition);
  void AddTets();
  void Activate(const Partition& partition);
  bool HasPoorAngle(std::size_t position) const;
  std::vector<PointExchange::Entry> ListEntries() const;

  CoarseTets& Tets;
  int Level;
  std::vector<int> IndexOf;          // of local points in Active
  std::vector<Candidate> Candidates; // the first points of Active
  ActiveMesh Active;
  bool IsPoor = false;
};

/// Copies of lattice nodes go with their node, centres of transition hexes with the upper node of their cell: so points of
/// one colour share no tet unless they go with one node, and the owner of a cell has all tets at its points.
void CoarseTets::Improver::AddCandidates(const Partition& partition)
{
  const OctreeKeys& lattice = this->Tets.Grid.Lattice();
  const Mesh& local = this->Tets.Local;
  for (int p = 0; p < this->Tets.HexPoints; ++p)
  {
    const OctreeKeys::LevelIndex node =
      lattice.NodeOfKey(this->Tets.Grid.KeyOfPoint(local.PointIds[p], TetIds.PointSlots));
    if (node.Level == this->Level && node.Slot > 0)
    {
      this->Candidates.push_back({ node, local.PointIds[p], p });
    }
  }
  for (std::size_t h = 0; h < this->Tets.Hexes.size(); ++h)
  {
    OctreeKeys::LevelIndex cell = this->Tets.Hexes[h].Cell;
    if (cell.Level == this->Level && !this->Tets.Hexes[h].IsWhole)
    {
      const int p = this->Tets.HexPoints + static_cast<int>(h);
      cell.At = { { cell.At[0] + 1, cell.At[1] + 1, cell.At[2] + 1 } };
      this->Candidates.push_back({ cell, local.PointIds[p], p });
    }
  }
  const auto keyOf = [&](const Candidate& c) { return lattice.NodeKey(this->Level, c.Node.At, 0); };
  std::sort(this->Candidates.begin(), this->Candidates.end(),
    [&](const Candidate& a, const Candidate& b)
    {
      const Index first = keyOf(a), second = keyOf(b);
      return first != second ? first < second : a.Id < b.Id;
    });
  for (std::size_t first = 0, last = 0; first < this->Candidates.size(); first = last)
  {
    const Index3& node = this->Candidates[first].Node.At;
    for (last = first; last < this->Candidates.size() && this->Candidates[last].Node.At == node;
         ++last)
    {
      this->AddPoint(this->Candidates[last].Point);
    }
    if (partition.OwnsNode(OwnerNode(this->Candidates[first].Node)))
    {
      this->Active.Colours[CartesianGrid::Colour(node)].push_back(
        { static_cast<int>(first), static_cast<int>(last) });
    }
  }
}

void CoarseTets::Improver::AddTets()
{
  const int candidates = static_cast<int>(this->Candidates.size());
  this->Active.Corners = 4;
  for (const Face& face : this->Tets.Faces)
  {
    Tet tets[4];
    const int count = face.IsPlain ? 0 : this->Tets.TetsOf(face, face.Way, tets);
    for (int t = 0; t < count; ++t)
    {
      if (std::none_of(tets[t].begin(), tets[t].end(),
            [&](int p) { return this->IndexOf[p] >= 0 && this->IndexOf[p] < candidates; }))
      {
        continue;
      }
      for (int p : tets[t])
      {
        if (this->IndexOf[p] < 0)
        {
          this->AddPoint(p);
        }
        this->Active.Elements.push_back(this->IndexOf[p]);
      }
      this->Active.Widths.push_back(this->Tets.WidthsOf(face));
    }
  }
}

/// Measured like the energy, in widths of its cell. position: of the tet in Active.Elements.
bool CoarseTets::Improver::HasPoorAngle(std::size_t position) const
{
  const Index corners[4] = { 0, 1, 2, 3 };
  double points[12], angles[6];
  for (int c = 0; c < 4; ++c)
  {
    const Vector3 x = Divided(this->Active.X[this->Active.Elements[position + c]],
      this->Active.WidthsAt(static_cast<Index>(position)));
    std::copy(x.begin(), x.end(), points + 3 * c);
  }
  DihedralAngles(points, corners, angles);
  return std::any_of(
    angles, angles + 6, [](double angle) { return std::min(angle, 180.0 - angle) < PoorAngle; });
}

/// The candidates of poor tets move. Those of other ranks count as moving here: their owners know.
void CoarseTets::Improver::Activate(const Partition& partition)
{
  const std::size_t candidates = this->Candidates.size();
  std::vector<unsigned char>& isActive = this->Active.IsActive;
  for (std::size_t t = 0; t < this->Active.Elements.size(); t += 4)
  {
    const bool isPoor = this->HasPoorAngle(t);
    this->IsPoor = this->IsPoor || isPoor;
    for (int c = 0; isPoor && c < 4; ++c)
    {
      const int p = this->Active.Elements[t + c];
      isActive[p] = static_cast<std::size_t>(p) < candidates;
    }
  }
  for (std::size_t p = 0; p < candidates; ++p)
  {
    isActive[p] = isActive[p] || !partition.OwnsNode(OwnerNode(this->Candidates[p].Node));
  }
}

std::vector<PointExchange::Entry> CoarseTets::Improver::ListEntries() const
{
  std::vector<PointExchange::Entry> entries;
  for (std::size_t p = 0; p < this->Candidates.size(); ++p)
  {
    const Candidate& candidate = this->Candidates[p];
    entries.push_back({ static_cast<int>(p), candidate.Id, OwnerNode(candidate.Node),
      CartesianGrid::Colour(candidate.Node.At), true });
  }
  std::sort(
    entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.Id < b.Id; });
  return entries;
}

/// Level by level: points of one colour and different levels might share a tet. Collective.
void CoarseTets::Improve(Runtime& runtime)
{
  const Partition partition(this->Grid.Base(), runtime.Group());
  for (int level = 0; level < this->Grid.NumberOfRefinements(); ++level)
  {
    Improver(*this, level).Run(partition, runtime);
  }
}

} // namespace vfm
