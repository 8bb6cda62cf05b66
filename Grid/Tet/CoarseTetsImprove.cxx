/// CoarseTets::Improve: moves centres and free points of transition hexes where tets are poor.
#include "Tet/CoarseTets.h"

#include "Base/Vector3.h"
#include "Hex/TransitionSmoothing.h"
#include "Mesh/TetQuality.h"
#include "Smoothing/ActiveMeshBuilder.h"
#include "Smoothing/Smoother.h"
#include "Tet/TetImprove.h"

namespace vfm
{

/// Of one level: the points that may move, and the tets at them.
class CoarseTets::Improver
{
public:
  /// Collective among peers.
  Improver(CoarseTets& tets, int level, const Partition& partition) : Tets(tets)
  {
    ActiveMeshBuilder builder(4, tets.Local.Points.size() / 3, this->FindMovers(level));
    std::vector<Vector3> widths;
    this->AddTets(builder, widths);
    this->Active = builder.Finish(&partition);
    this->Active.Widths = std::move(widths);
    this->Active.PlacePoints(tets.Grid.Finest(), tets.Local);
  }

  /// Collective.
  void Run(Runtime& runtime)
  {
    if (runtime.Group().Any(this->ActivatePoor()))
    {
      Smoother(this->Active, nullptr, this->Tets.Energy, runtime).RunRamp(TetRamp());
      this->Active.CopyTo(this->Tets.Local, this->Tets.Grid.Finest());
    }
  }

private:
  static constexpr double PoorAngle = 20.0; // degrees off 0 or 180, of a dihedral angle

  std::vector<Mover> FindMovers(int level) const;
  void AddTets(ActiveMeshBuilder& builder, std::vector<Vector3>& widths) const;
  bool ActivatePoor();
  bool HasPoorAngle(std::size_t position) const;

  CoarseTets& Tets;
  ActiveMesh Active;
};

/// Copies of lattice nodes go with their node, centres of transition hexes with the upper node of their cell: so points of
/// one colour share no tet unless they go with one node, and the owner of a cell has all tets at its points.
std::vector<Mover> CoarseTets::Improver::FindMovers(int level) const
{
  const OctreeKeys& lattice = this->Tets.Grid.Lattice();
  const Mesh& local = this->Tets.Local;
  std::vector<Mover> movers;
  const auto add = [&](int point, const OctreeKeys::LevelIndex& node)
  {
    movers.push_back({ point, local.PointIds[point], lattice.NodeKey(level, node.At, 0),
      OwnerNode(node), CartesianGrid::Colour(node.At) });
  };
  for (int p = 0; p < this->Tets.HexPoints; ++p)
  {
    const OctreeKeys::LevelIndex node =
      lattice.NodeOfKey(this->Tets.Grid.KeyOfPoint(local.PointIds[p], TetIds.PointSlots));
    if (node.Level == level && node.Slot > 0)
    {
      add(p, node);
    }
  }
  for (std::size_t h = 0; h < this->Tets.Hexes.size(); ++h)
  {
    OctreeKeys::LevelIndex cell = this->Tets.Hexes[h].Cell;
    if (cell.Level == level && !this->Tets.Hexes[h].IsWhole)
    {
      cell.At = { { cell.At[0] + 1, cell.At[1] + 1, cell.At[2] + 1 } };
      add(this->Tets.HexPoints + static_cast<int>(h), cell);
    }
  }
  return movers;
}

/// Those at movers.
void CoarseTets::Improver::AddTets(ActiveMeshBuilder& builder, std::vector<Vector3>& widths) const
{
  for (const Face& face : this->Tets.Faces)
  {
    Tet tets[4];
    const int count = face.IsPlain ? 0 : this->Tets.TetsOf(face, face.Way, tets);
    for (int t = 0; t < count; ++t)
    {
      if (builder.HasMover(tets[t].data()))
      {
        builder.Add(tets[t].data());
        widths.push_back(this->Tets.WidthsOf(face));
      }
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

/// Of the movers of this rank those of poor tets move; returns whether there are poor tets.
bool CoarseTets::Improver::ActivatePoor()
{
  std::vector<unsigned char> isPoor(this->Active.X.size(), 0);
  bool found = false;
  for (std::size_t t = 0; t < this->Active.Elements.size(); t += 4)
  {
    if (this->HasPoorAngle(t))
    {
      found = true;
      std::for_each(this->Active.Elements.begin() + t, this->Active.Elements.begin() + t + 4,
        [&](int point) { isPoor[point] = 1; });
    }
  }
  for (const MoveOrder::Group& group : this->Active.Order.Groups())
  {
    std::copy(isPoor.begin() + group.First, isPoor.begin() + group.Last,
      this->Active.IsActive.begin() + group.First);
  }
  return found;
}

/// Level by level: points of one colour and different levels might share a tet. Collective.
void CoarseTets::Improve(Runtime& runtime)
{
  const Partition partition(this->Grid.Base(), runtime.Group());
  for (int level = 0; level < this->Grid.NumberOfRefinements(); ++level)
  {
    Improver(*this, level, partition).Run(runtime);
  }
}

} // namespace vfm
