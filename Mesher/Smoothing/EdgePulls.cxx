#include "Smoothing/EdgePulls.h"

#include "Base/ExactSum.h"
#include "Elements/GaussRule.h"
#include "Elements/PeriodicIds.h"
#include "Octree/RefinedGrid.h"
#include "Ranks/MergeByKey.h"

#include <Eigen/Cholesky>

#include <limits>

namespace vfm
{
namespace
{

using Labels = std::array<int, 2>;

constexpr int Steps = 3;                   // of Newton
constexpr double LargestPull = 0.25;       // per length of the edge
constexpr double LargestDifference = 0.25; // of the distances of both ends, per length of the edge
constexpr double Damping = 1e-9;           // of normal equations of parallel targets

/// An end of an edge with a pair of labels of a facet at the edge.
struct EdgeUse
{
  EdgeIds Edge;
  int End, Other; // points of the active mesh
  Labels Pair;    // ascending
  bool operator<(const EdgeUse& other) const
  {
    return std::tie(this->Edge, this->End, this->Pair) <
      std::tie(other.Edge, other.End, other.Pair);
  }
  bool operator==(const EdgeUse& other) const
  {
    return this->Edge == other.Edge && this->End == other.End && this->Pair == other.Pair;
  }
};

bool IsInterface(const Facet& facet)
{
  return facet.DomainSide < 0;
}

Labels Ascending(int a, int b)
{
  return { { std::min(a, b), std::max(a, b) } };
}

/// Returns the ends that this rank moves of all edges of interface facets, sorted.
std::vector<EdgeUse> ListUses(
  const std::vector<Facet>& facets, const Mesh& mesh, const ActiveMesh& active)
{
  std::vector<int> pointOf(mesh.PointIds.size(), -1);
  for (std::size_t p = 0; p < active.MeshPoint.size(); ++p)
  {
    pointOf[active.MeshPoint[p]] = static_cast<int>(p);
  }
  std::vector<unsigned char> isOwned(active.X.size(), 0);
  active.ForOwned([&](int point) { isOwned[point] = active.IsActive[point]; });
  std::vector<EdgeUse> uses;
  for (const Facet& facet : facets)
  {
    const Index corners = IsInterface(facet) ? CornersOf(facet.Points) : 0;
    for (Index c = 0; c < corners; ++c)
    {
      const Index points[2] = { facet.Points[c], facet.Points[(c + 1) % corners] };
      const EdgeIds edge = MakeEdgeIds(
        IdOfOwner(mesh, mesh.PointIds[points[0]]), IdOfOwner(mesh, mesh.PointIds[points[1]]));
      for (int e = 0; e < 2; ++e)
      {
        const int end = pointOf[points[e]], other = pointOf[points[1 - e]];
        if (end >= 0 && other >= 0 && isOwned[end])
        {
          uses.push_back({ edge, end, other, Ascending(facet.Materials[0], facet.Materials[1]) });
        }
      }
    }
  }
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  return uses;
}

/// Returns the material of each fragment at an interface; that of 0 is 0.
std::vector<int> FindMaterials(const std::vector<Facet>& facets)
{
  std::vector<int> materials(1, 0);
  for (const Facet& facet : facets)
  {
    for (int s = 0; s < 2; ++s)
    {
      const auto fragment = static_cast<std::size_t>(facet.Fragments[s]);
      if (fragment > 0)
      {
        materials.resize(std::max(materials.size(), fragment + 1), 0);
        materials[fragment] = facet.Materials[s];
      }
    }
  }
  return materials;
}

/// A target and the distance to it that the middle of an edge gets.
struct Aim
{
  Index Target;
  double Distance;
};

class EdgeCurver
{
public:
  EdgeCurver(const std::vector<Facet>& facets, const Mesh& mesh, const SurfaceTargets& targets,
    const ActiveMesh& active) :
    Grid(mesh.Levels->Finest()), Targets(targets), Active(active), Materials(FindMaterials(facets))
  {
  }

  /// Returns whether a point was put back to its start for good, because facets intersected. Only
  /// the rank that moves the point knows it.
  bool IsHeld(int point) const
  {
    return (this->Active.Fixed[point] & ~FixedOnSides(this->SidesOf(point)) &
             ~this->SeamsOf(point)) != 0;
  }

  /// Returns the displacement of the middle, in grid coordinates, from the uses of one edge and
  /// end.
  Vector3 Find(const EdgeUse* first, const EdgeUse* last) const
  {
    const Vector3 &p = this->Active.X[first->End], &q = this->Active.X[first->Other];
    std::vector<Aim> aims;
    for (const EdgeUse* use = first; use < last; ++use)
    {
      this->AddAims(*use, Norm(q - p), aims);
    }
    const int held = FixedOnSides(this->SidesOf(first->End) & this->SidesOf(first->Other)) |
      (this->SeamsOf(first->End) & this->SeamsOf(first->Other));
    const Vector3 middle = 0.5 * (p + q);
    const Vector3 pull = this->Inside(middle, this->Approach(aims, middle, held) - middle, held);
    const double length = Norm(pull), longest = LargestPull * Norm(q - p);
    return length > longest ? (longest / length) * pull : pull;
  }

private:
  int SidesOf(int point) const
  {
    return FindDomainSides(this->Grid, this->Active.InMeshPoints(point));
  }

  /// Returns the axes (bits) along which a point is on a flat seam.
  int SeamsOf(int point) const
  {
    const double* x = this->Active.InMeshPoints(point);
    return this->Grid.FlatSeams(Vector3{ { x[0], x[1], x[2] } });
  }

  void AddAims(const EdgeUse& use, double length, std::vector<Aim>& aims) const
  {
    const std::vector<CornerPosition>& offsets = this->Active.AttachmentOffset;
    for (Index i = offsets[use.End]; i < offsets[use.End + 1]; ++i)
    {
      const Attachment& a = this->Active.Attachments[i];
      if (Ascending(this->MaterialOf(a.Fragments[0]), this->MaterialOf(a.Fragments[1])) != use.Pair)
      {
        continue;
      }
      Vector3 gradient;
      const double own = this->Targets.Distance(a.Target, this->Active.X[use.End], gradient);
      const double other = this->Targets.Distance(a.Target, this->Active.X[use.Other], gradient);
      const double scale = length * this->Targets.LocalScale(a.Target);
      if (std::fabs(other - own) <= LargestDifference * scale)
      {
        aims.push_back({ a.Target, 0.5 * (own + other) });
      }
    }
  }

  int MaterialOf(int fragment) const
  {
    return fragment < static_cast<int>(this->Materials.size()) ? this->Materials[fragment] : -1;
  }

  /// Moves x by Newton steps until it has all distances.
  Vector3 Approach(const std::vector<Aim>& aims, Vector3 x, int held) const
  {
    for (int step = 0; step < Steps && !aims.empty(); ++step)
    {
      Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
      Eigen::Vector3d lack = Eigen::Vector3d::Zero();
      for (const Aim& aim : aims)
      {
        Vector3 gradient;
        const double distance = this->Targets.Distance(aim.Target, x, gradient);
        Eigen::Vector3d g(gradient[0], gradient[1], gradient[2]);
        for (int a = 0; a < 3; ++a)
        {
          g[a] = held >> a & 1 ? 0.0 : g[a];
        }
        normal += g * g.transpose();
        lack += (aim.Distance - distance) * g;
      }
      const double trace = normal.trace();
      if (!(trace > 0.0))
      {
        break;
      }
      normal += Damping * trace * Eigen::Matrix3d::Identity();
      const Eigen::Vector3d move = normal.ldlt().solve(lack);
      for (int a = 0; a < 3; ++a)
      {
        x[a] += held >> a & 1 ? 0.0 : move[a];
      }
    }
    return x;
  }

  /// Returns a displacement shortened so that it does not leave the bounds of the mesh, and exactly
  /// 0 along held axes.
  Vector3 Inside(const Vector3& middle, Vector3 pull, int held) const
  {
    for (int a = 0; a < 3; ++a)
    {
      const double low = std::min(this->Active.Bounds.Lower[a], middle[a]) - middle[a];
      const double high = std::max(this->Active.Bounds.Upper[a], middle[a]) - middle[a];
      pull[a] = held >> a & 1 ? 0.0 : std::min(std::max(pull[a], low), high);
    }
    return pull;
  }

  const CartesianGrid& Grid;
  const SurfaceTargets& Targets;
  const ActiveMesh& Active;
  const std::vector<int> Materials;
};

} // namespace

std::vector<EdgePull> FindEdgePulls(const std::vector<Facet>& facets, const Mesh& mesh,
  const SurfaceTargets& targets, const ActiveMesh& active, Runtime& runtime)
{
  const std::vector<EdgeUse> uses = ListUses(facets, mesh, active);
  std::vector<std::size_t> starts;
  for (std::size_t u = 0; u < uses.size(); ++u)
  {
    if (u == 0 || uses[u].Edge != uses[u - 1].Edge || uses[u].End != uses[u - 1].End)
    {
      starts.push_back(u);
    }
  }
  std::vector<EdgePull> pulls(starts.size());
  starts.push_back(uses.size());
  const EdgeCurver curver(facets, mesh, targets, active);
  ForEach(runtime, pulls.size(),
    [&](Index i)
    {
      const EdgeUse* use = uses.data() + starts[i];
      pulls[i] = { use->Edge, mesh.PointIds[active.MeshPoint[use->End]],
        active.Scale * curver.Find(use, uses.data() + starts[i + 1]), curver.IsHeld(use->End),
        use->Edge };
    });
  return pulls;
}

namespace
{

/// Pull at an end of an edge.
struct PullAtEnd
{
  Index End;
  Vector3 Pull;
  auto operator<=>(const PullAtEnd&) const = default;
};

constexpr PullAtEnd NoPull{ std::numeric_limits<Index>::max(), {} };

/// Pulls of an edge.
struct PullsOfEdge
{
  std::array<PullAtEnd, 2> Ends; // ascending, with NoPull last
  EdgeIds Group;                 // of the first end
  bool IsHeld;
};

/// Joins the pulls that two ranks have for an edge. Of several pulls at an end the lowest counts.
PullsOfEdge JoinPulls(const PullsOfEdge& a, const PullsOfEdge& b)
{
  std::array<PullAtEnd, 4> all{ { a.Ends[0], a.Ends[1], b.Ends[0], b.Ends[1] } };
  std::sort(all.begin(), all.end());
  const auto second = std::find_if(
    all.begin(), all.end(), [&all](const PullAtEnd& pull) { return pull.End != all[0].End; });
  const bool isGroupOfA = std::tie(a.Ends[0], a.Group) < std::tie(b.Ends[0], b.Group);
  return { { { all[0], second == all.end() ? NoPull : *second } }, isGroupOfA ? a.Group : b.Group,
    a.IsHeld || b.IsHeld };
}

EdgeMove MoveBy(const PullsOfEdge& pulls)
{
  EdgeMove move{};
  for (std::size_t e = 0; !pulls.IsHeld && e < 2 && pulls.Ends[e].End != NoPull.End; ++e)
  {
    move = { move.Move + 0.5 * pulls.Ends[e].Pull, pulls.Group };
  }
  return move;
}

} // namespace

std::vector<EdgeMove> CombinePulls(
  const std::vector<EdgePull>& pulls, const std::vector<EdgeIds>& edges, Ranks& ranks)
{
  std::vector<EdgeIds> keys;
  std::vector<PullsOfEdge> values;
  for (const EdgePull& pull : pulls)
  {
    keys.push_back(pull.Edge);
    values.push_back({ { { { pull.End, pull.Pull }, NoPull } }, pull.Group, pull.IsHeld });
  }
  const PullsOfEdge none{ { { NoPull, NoPull } }, {}, false };
  std::vector<EdgeMove> moves;
  for (const PullsOfEdge& ofEdge :
    AskByKey(std::move(keys), std::move(values), edges, none, JoinPulls, ranks))
  {
    moves.push_back(MoveBy(ofEdge));
  }
  return moves;
}

namespace
{

constexpr double Nodes2[2] = { 0.2113248654051871, 0.7886751345948129 };

/// A point of a facet and of its curved counterpart, with derivatives along u and v.
struct FacetPoint
{
  Vector3 Along[2], Pull, PullAlong[2];
};

void AddShape(const Vector3& x, double value, double alongU, double alongV, Vector3 (&sums)[3])
{
  sums[0] = sums[0] + value * x;
  sums[1] = sums[1] + alongU * x;
  sums[2] = sums[2] + alongV * x;
}

/// u, v in [0, 1]; pulls of the edges 01, 12, 23, 30.
FacetPoint PointOfQuad(const Vector3 (&x)[4], const Vector3 (&pulls)[4], double u, double v)
{
  Vector3 at[3]{}, pull[3]{};
  AddShape(x[0], (1 - u) * (1 - v), v - 1, u - 1, at);
  AddShape(x[1], u * (1 - v), 1 - v, -u, at);
  AddShape(x[2], u * v, v, u, at);
  AddShape(x[3], (1 - u) * v, -v, 1 - u, at);
  const double bu = 4 * u * (1 - u), bv = 4 * v * (1 - v), du = 4 - 8 * u, dv = 4 - 8 * v;
  AddShape(pulls[0], bu * (1 - v), du * (1 - v), -bu, pull);
  AddShape(pulls[1], bv * u, bv, dv * u, pull);
  AddShape(pulls[2], bu * v, du * v, bu, pull);
  AddShape(pulls[3], bv * (1 - u), -bv, dv * (1 - u), pull);
  return { { at[1], at[2] }, pull[0], { pull[1], pull[2] } };
}

/// u, v and 1 - u - v in [0, 1]; pulls of the edges 01, 12, 20.
FacetPoint PointOfTriangle(const Vector3 (&x)[4], const Vector3 (&pulls)[4], double u, double v)
{
  Vector3 pull[3]{};
  const double w = 1 - u - v;
  AddShape(pulls[0], 4 * w * u, 4 * (w - u), -4 * u, pull);
  AddShape(pulls[1], 4 * u * v, 4 * v, 4 * u, pull);
  AddShape(pulls[2], 4 * v * w, -4 * v, 4 * (w - v), pull);
  return { { x[1] - x[0], x[2] - x[0] }, pull[0], { pull[1], pull[2] } };
}

/// Returns the volume between a straight facet and the facet with pulled edges. The Gauss rules are
/// exact.
double VolumeOfBulge(const Vector3 (&x)[4], const Vector3 (&pulls)[4], bool isTriangle)
{
  double volume = 0.0;
  for (int n = 0; n < 9; ++n)
  {
    const double u = GaussPoints[n % 3];
    const double narrow =
      isTriangle ? 1.0 - u : 1.0; // a triangle is a quad with an edge of length 0
    const double v = GaussPoints[n / 3] * narrow;
    const FacetPoint p = isTriangle ? PointOfTriangle(x, pulls, u, v) : PointOfQuad(x, pulls, u, v);
    for (double s : Nodes2)
    {
      const Vector3 normal =
        Cross(p.Along[0] + s * p.PullAlong[0], p.Along[1] + s * p.PullAlong[1]);
      volume += 0.5 * GaussWeights[n % 3] * GaussWeights[n / 3] * narrow * Dot(p.Pull, normal);
    }
  }
  return volume;
}

} // namespace

std::vector<double> MeasureBulges(const std::vector<EdgePull>& pulls, const Mesh& mesh,
  const ActiveMesh& active, const FragmentShare& share, Runtime& runtime)
{
  const auto idOf = [&](Index point)
  { return IdOfOwner(mesh, mesh.PointIds[active.MeshPoint[point]]); };
  std::vector<EdgeIds> edges;
  for (const ActiveFacet& facet : active.Facets)
  {
    const Index corners = CornersOf(facet.Points);
    for (Index c = 0; c < corners; ++c)
    {
      edges.push_back(MakeEdgeIds(idOf(facet.Points[c]), idOf(facet.Points[(c + 1) % corners])));
    }
  }
  const std::vector<EdgeMove> moves = CombinePulls(pulls, edges, runtime.Group());
  std::vector<ExactSum> sums(share.Size());
  std::size_t at = 0;
  for (const ActiveFacet& facet : active.Facets)
  {
    const Index corners = CornersOf(facet.Points);
    Vector3 x[4]{}, ofEdges[4]{};
    for (Index c = 0; c < corners; ++c)
    {
      x[c] = active.X[facet.Points[c]];
      ofEdges[c] = (1.0 / active.Scale) * moves[at++].Move;
    }
    ExactSum volume;
    volume.Add(VolumeOfBulge(x, ofEdges, corners == 3));
    sums[facet.Fragments[0]].Add(volume);
    sums[facet.Fragments[1]].Subtract(volume);
  }
  return share.Sum(std::move(sums));
}

} // namespace vfm
