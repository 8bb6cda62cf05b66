#include "Tet/TetAttach.h"

#include "Base/Vector3.h"

#include <limits>

namespace vfm
{
namespace
{

/// A pair of labels that meets at a point.
struct PairAt
{
  int Point; // active
  std::array<int, 2> Labels;
  bool operator<(const PairAt& other) const
  {
    return this->Point != other.Point ? this->Point < other.Point : this->Labels < other.Labels;
  }
  bool operator==(const PairAt& other) const
  {
    return this->Point == other.Point && this->Labels == other.Labels;
  }
};

std::array<int, 2> LabelsOf(const Mesh& mesh, const TetFacet& facet)
{
  return { { facet.Outer < 0 ? 0 : mesh.Material[facet.Outer], mesh.Material[facet.Inner] } };
}

/// All pairs at the active points, sorted.
std::vector<PairAt> ListPairs(const Mesh& mesh, const TetFaces& faces, const ActiveTets& active)
{
  std::vector<PairAt> pairs;
  for (const TetFacet& facet : faces.Facets)
  {
    for (Index p : facet.Points)
    {
      if (facet.DomainSide < 0 && active.PointOf[p] >= 0)
      {
        pairs.push_back({ active.PointOf[p], LabelsOf(mesh, facet) });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// The surface point of the pair nearest to x among the nodes from one below a block to two above; -1: none.
Index FindNearestTarget(const Interface& interface, const Index3& block, const Vector3& x,
  const std::array<int, 2>& labels)
{
  const CartesianGrid& grid = interface.Grid();
  const std::vector<Index>& nodes = interface.Nodes();
  Index3 low, high; // nodes
  for (int a = 0; a < 3; ++a)
  {
    low[a] = std::max(block[a] - 1, grid.Local().Lower[a]);
    high[a] = std::min(block[a] + 2, grid.Local().Upper[a]);
  }
  Index best = -1;
  double nearest = std::numeric_limits<double>::max();
  for (Index k = low[2]; k <= high[2]; ++k)
  {
    for (Index j = low[1]; j <= high[1]; ++j)
    {
      const Index last = grid.Linear({ { high[0], j, k } });
      auto node = std::lower_bound(nodes.begin(), nodes.end(), grid.Linear({ { low[0], j, k } }));
      for (; node != nodes.end() && *node <= last; ++node)
      {
        const SurfacePoint* point = interface.FindPoint(node - nodes.begin(), labels[0], labels[1]);
        const double distance = point ? Dot(point->Point - x, point->Point - x) : nearest;
        if (distance < nearest)
        {
          nearest = distance;
          best = point - interface.Points().data();
        }
      }
    }
  }
  return best;
}

} // namespace

void AttachTets(const Interface& interface, const Mesh& mesh, const TetFaces& faces,
  TetMethod method, ActiveTets& active)
{
  const CartesianGrid& grid = interface.Grid();
  const std::vector<PairAt> pairs = ListPairs(mesh, faces, active);
  std::size_t next = 0;
  for (int p = 0; p < static_cast<int>(active.X.size()); ++p)
  {
    for (; next < pairs.size() && pairs[next].Point == p; ++next)
    {
      const std::array<int, 2>& labels = pairs[next].Labels;
      const Index3 block = NodeOfPoint(grid, mesh, mesh.PointIds[active.MeshPoint[p]]);
      const Index node = method == TetMethod::Lattice ? -1 : interface.Find(grid.Linear(block));
      const SurfacePoint* own =
        node < 0 ? nullptr : interface.FindPoint(node, labels[0], labels[1]);
      const Index target = own ? own - interface.Points().data()
                               : FindNearestTarget(interface, block, active.Start[p], labels);
      if (target >= 0)
      {
        active.Attachments.push_back({ target });
      }
    }
    active.AttachmentOffset[p + 1] = static_cast<Index>(active.Attachments.size());
  }
}

void MeasureWithFaces(const Interface& interface, const Mesh& mesh, const TetFaces& faces,
  const CartesianGrid& grid, const Partition& partition, ActiveTets& active)
{
  active.Facets.clear();
  for (const TetFacet& facet : faces.Facets)
  {
    std::array<int, 4> points;
    for (int c = 0; c < 4; ++c)
    {
      points[c] = active.PointOf[facet.Points[std::min(c, 2)]];
    }
    if (facet.DomainSide >= 0 || *std::min_element(points.begin(), points.end()) < 0)
    {
      continue;
    }
    const int inner = mesh.Fragment[facet.Inner];
    const int outer = facet.Outer < 0 ? 0 : mesh.Fragment[facet.Outer];
    active.Facets.push_back({ points, inner, outer,
      partition.OwnsCell(CellOfElement(grid, mesh, mesh.ElementIds[facet.Inner])) });
    const std::array<int, 2> labels = LabelsOf(mesh, facet);
    for (int c = 0; c < 3; ++c)
    {
      for (Index i = active.AttachmentOffset[points[c]]; i < active.AttachmentOffset[points[c] + 1];
           ++i)
      {
        Attachment& a = active.Attachments[i];
        const SurfacePoint& target = interface.Points()[a.Target];
        const std::array<int, 2> fragments{ { outer, inner } };
        if (target.First == labels[0] && target.Second == labels[1] &&
          (a.Fragments == std::array<int, 2>{} || fragments < a.Fragments))
        {
          a.Fragments = fragments;
        }
      }
    }
  }
}

} // namespace vfm
