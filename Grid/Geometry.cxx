#include "Geometry.h"

#include <algorithm>
#include <map>

namespace vfm
{
namespace
{

/// Corners (bits) of face f of a hex, around it, normal outward.
constexpr std::array<std::array<int, 4>, 6> FaceCorners{ { { { 0, 4, 6, 2 } }, { { 1, 3, 7, 5 } },
  { { 0, 1, 5, 4 } }, { { 2, 6, 7, 3 } }, { { 0, 2, 3, 1 } }, { { 4, 5, 7, 6 } } } };

/// A surface: the volumes on its two sides. 0 is void or unmeshed, -1 - side a side of the domain.
struct SurfaceKey
{
  int First, Second;
  bool operator<(const SurfaceKey& other) const
  {
    return this->First != other.First ? this->First < other.First : this->Second < other.Second;
  }
};

struct Quad
{
  std::array<Index, 4> Points;
  SurfaceKey Key;
  int Materials[2];
  int Side;
  bool IsOwned;
};

/// Numbers distinct keys from 1 in their order.
template <class Key>
class Numbering
{
public:
  explicit Numbering(std::vector<Key> keys) : Keys(std::move(keys))
  {
    std::sort(this->Keys.begin(), this->Keys.end());
    this->Keys.erase(std::unique(this->Keys.begin(), this->Keys.end(),
                       [](const Key& a, const Key& b) { return !(a < b) && !(b < a); }),
      this->Keys.end());
  }
  int Find(const Key& key) const
  {
    return static_cast<int>(
             std::lower_bound(this->Keys.begin(), this->Keys.end(), key) - this->Keys.begin()) +
      1;
  }
  Index Count() const { return static_cast<Index>(this->Keys.size()); }
  const std::vector<Key>& All() const { return this->Keys; }

private:
  std::vector<Key> Keys;
};

class GeometryFinder
{
public:
  GeometryFinder(const CartesianGrid& grid, const LabelArray& labels,
    const std::vector<Index>& mixed, const Fragments& fragments, const PointNumbering& numbering,
    const Partition& partition, HexMesh& mesh) :
    Grid(grid),
    Labels(labels),
    Mixed(mixed),
    Pieces(fragments),
    Points(numbering),
    Parts(partition),
    Box(grid.HexBox()),
    Mesh(mesh)
  {
  }

  void Run(HexMeshReport& report)
  {
    this->FillVolumes();
    this->AddInterfaceQuads();
    report.NumberOfFragments = this->Pieces.NumberOfFragments();
    report.NumberOfSurfaces = this->FillSurfaces();
    this->ClassifyPoints(report);
  }

private:
  using SurfaceSet = std::vector<int>;

  /// Fragments of hexes, and the quads on the sides of the domain.
  void FillVolumes()
  {
    HexMesh& mesh = this->Mesh;
    mesh.Fragment = Buffer<int>(mesh.HexIds.size());
    mesh.GeometryDimension = Buffer<int>(mesh.PointIds.size(), 3);
    mesh.GeometryId = Buffer<int>(mesh.PointIds.size());
    const IndexBox& box = this->Box;
    Index row = 0;
    for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
    {
      for (Index j = box.Lower[1]; j < box.Upper[1]; ++j, ++row)
      {
        this->FillRow(j, k, mesh.RowOffset[row], mesh.RowOffset[row + 1]);
      }
    }
    this->FillInnerPoints();
  }

  void FillRow(Index j, Index k, Index first, Index last)
  {
    HexMesh& mesh = this->Mesh;
    const Index key = this->Grid.CellKey({ { 0, j, k } });
    const Index3& n = this->Grid.Global().Upper;
    const bool rim = j == 0 || k == 0 || j == n[1] - 1 || k == n[2] - 1;
    Index runEnd = -1;
    int fragment = 0;
    for (Index h = first; h < last; ++h)
    {
      const Index id = mesh.HexIds[h] - 1;
      const Index i = id / 7 - key;
      if (i >= runEnd)
      {
        fragment = this->Pieces.FragmentOfCell({ { i, j, k } }, runEnd);
      }
      mesh.Fragment[h] = fragment;
      mesh.GeometryId[mesh.Hexes[8 * h]] = fragment; // enough for points G inside the domain
      if (rim || i == 0 || i == n[0] - 1)
      {
        this->AddDomainQuads(h, static_cast<int>(id % 7), { { i, j, k } });
      }
    }
  }

  /// Fragments of the points I.
  void FillInnerPoints()
  {
    for (Index node : this->Mixed)
    {
      const Index3 p = this->Grid.Position(node);
      for (int c = 0; this->Points.IsSplit(node) && c < 8; ++c)
      {
        const int label = this->Labels[this->Grid.CellOfNode(node, c)];
        const Index3 cell{ { p[0] - 1 + (c & 1), p[1] - 1 + (c >> 1 & 1),
          p[2] - 1 + (c >> 2 & 1) } };
        if (this->Points.IsMeshed(label) && this->Box.Contains(cell))
        {
          this->Mesh.GeometryId[this->Points.InnerPoint(node, label)] =
            this->Pieces.FragmentOfCell(cell);
        }
      }
    }
  }

  /// slot: 0 core hex, 1 + face buffer hex, whose faces along its own axis are not on the boundary.
  void AddDomainQuads(Index h, int slot, const Index3& cell)
  {
    for (int a = 0; a < 3; ++a)
    {
      if (slot > 0 && (slot - 1) / 2 == a)
      {
        continue;
      }
      if (cell[a] == 0)
      {
        this->AddDomainQuad(h, 2 * a, this->Parts.OwnsCell(cell));
      }
      if (cell[a] == this->Grid.Global().Upper[a] - 1)
      {
        this->AddDomainQuad(h, 2 * a + 1, this->Parts.OwnsCell(cell));
      }
    }
  }

  void AddDomainQuad(Index h, int side, bool owned)
  {
    Quad quad;
    for (int c = 0; c < 4; ++c)
    {
      quad.Points[c] = this->Mesh.Hexes[8 * h + VtkCorner[FaceCorners[side][c]]];
    }
    quad.Key = { -1 - side, this->Mesh.Fragment[h] };
    quad.Materials[0] = 0;
    quad.Materials[1] = this->Mesh.Material[h];
    quad.Side = side;
    quad.IsOwned = owned;
    this->Quads.push_back(quad);
  }

  void AddInterfaceQuads()
  {
    for (Index node : this->Mixed)
    {
      const Index3 upper = this->Grid.Position(node);
      for (int axis = 0; axis < 3; ++axis)
      {
        Index3 lower = upper;
        --lower[axis];
        const int a = this->Labels[node - this->Grid.Stride(axis)], b = this->Labels[node];
        if (a == b || !this->Box.Contains(upper) || !this->Box.Contains(lower))
        {
          continue;
        }
        this->AddInterfaceQuad(node, axis, a < b,
          a < b ? this->Pieces.FragmentOfCell(lower) : this->Pieces.FragmentOfCell(upper),
          a < b ? this->Pieces.FragmentOfCell(upper) : this->Pieces.FragmentOfCell(lower));
        this->Quads.back().Materials[0] = std::min(a, b);
        this->Quads.back().Materials[1] = std::max(a, b);
        this->Quads.back().IsOwned = this->Parts.OwnsCell(this->Points.IsMeshed(a) ? lower : upper);
      }
    }
  }

  /// first, second: the fragments of the smaller and of the larger label. downward: the smaller label lies below.
  void AddInterfaceQuad(Index node, int axis, bool downward, int first, int second)
  {
    const Index b = this->Grid.Stride((axis + 1) % 3), c = this->Grid.Stride((axis + 2) % 3);
    Quad quad;
    quad.Points = { { this->Points.FirstPoint(node), this->Points.FirstPoint(node + b),
      this->Points.FirstPoint(node + b + c), this->Points.FirstPoint(node + c) } };
    if (downward)
    {
      std::swap(quad.Points[1], quad.Points[3]);
    }
    quad.Key = { std::min(first, second), std::max(first, second) };
    quad.Side = -1;
    this->Quads.push_back(quad);
  }

  Index FillSurfaces()
  {
    std::vector<SurfaceKey> keys;
    for (const Quad& quad : this->Quads)
    {
      keys.push_back(quad.Key);
    }
    const Numbering<SurfaceKey> numbers(this->GatherDistinct(keys));
    SurfaceQuads& surfaces = this->Mesh.Surfaces;
    const std::size_t count = this->Quads.size();
    surfaces.Points = Buffer<Index>(4 * count);
    surfaces.SurfaceId = Buffer<int>(count);
    surfaces.MaterialPair = Buffer<int>(2 * count);
    surfaces.DomainSide = Buffer<int>(count);
    for (std::size_t q = 0; q < count; ++q)
    {
      const Quad& quad = this->Quads[q];
      std::copy(quad.Points.begin(), quad.Points.end(), surfaces.Points.data() + 4 * q);
      surfaces.SurfaceId[q] = numbers.Find(quad.Key);
      std::copy(quad.Materials, quad.Materials + 2, surfaces.MaterialPair.data() + 2 * q);
      surfaces.DomainSide[q] = quad.Side;
      surfaces.IsOwned.push_back(quad.IsOwned);
    }
    return numbers.Count();
  }

  void ClassifyPoints(HexMeshReport& report)
  {
    const SurfaceQuads& surfaces = this->Mesh.Surfaces;
    std::vector<std::pair<Index, int>> on; // (point, surface)
    for (std::size_t q = 0; q < this->Quads.size(); ++q)
    {
      for (Index point : this->Quads[q].Points)
      {
        on.emplace_back(point, surfaces.SurfaceId[q]);
        this->Mesh.GeometryDimension[point] = 2;
        this->Mesh.GeometryId[point] = surfaces.SurfaceId[q];
      }
    }
    std::sort(on.begin(), on.end());
    on.erase(std::unique(on.begin(), on.end()), on.end());
    std::map<Index, SurfaceSet> junctions; // points on several surfaces
    for (std::size_t first = 0, last = 0; first < on.size(); first = last)
    {
      while (last < on.size() && on[last].first == on[first].first)
      {
        ++last;
      }
      for (std::size_t i = first; last - first > 1 && i < last; ++i)
      {
        junctions[on[first].first].push_back(on[i].second);
      }
    }
    this->ClassifyJunctions(junctions, report);
  }

  void ClassifyJunctions(const std::map<Index, SurfaceSet>& junctions, HexMeshReport& report)
  {
    std::map<Index, int> edgesAlike, edges; // curve edges at a point with its own set, and all
    for (const auto& edge : this->FindCurveEdges(junctions))
    {
      for (Index point : { edge.first.first, edge.first.second })
      {
        ++edges[point];
        edgesAlike[point] += edge.second == junctions.at(point);
      }
    }
    std::vector<SurfaceSet> sets;
    std::vector<Index> ids;
    for (const auto& junction : junctions)
    {
      const Index id = this->Mesh.PointIds[junction.first];
      if (!this->Parts.OwnsNode(NodeOfPoint(this->Grid, id)))
      {
        continue;
      }
      if (edges[junction.first] == 2 && edgesAlike[junction.first] == 2)
      {
        sets.push_back(junction.second);
      }
      else
      {
        ids.push_back(id);
      }
    }
    const Numbering<SurfaceSet> curves(this->GatherSets(sets));
    const Numbering<Index> vertices(GatherItems(this->Parts.Group(), ids));
    for (const auto& junction : junctions)
    {
      const bool curve = edges[junction.first] == 2 && edgesAlike[junction.first] == 2;
      this->Mesh.GeometryDimension[junction.first] = curve ? 1 : 0;
      this->Mesh.GeometryId[junction.first] =
        curve ? curves.Find(junction.second) : vertices.Find(this->Mesh.PointIds[junction.first]);
    }
    report.NumberOfCurves = curves.Count();
    report.NumberOfVertices = vertices.Count();
  }

  template <class Key>
  std::vector<Key> GatherDistinct(const std::vector<Key>& keys) const
  {
    return GatherItems(this->Parts.Group(), Numbering<Key>(keys).All());
  }

  /// The distinct sets of all ranks, sent as their sizes and members one after another.
  std::vector<SurfaceSet> GatherSets(const std::vector<SurfaceSet>& sets) const
  {
    const Numbering<SurfaceSet> distinct(sets);
    std::vector<int> flat;
    for (const SurfaceSet& set : distinct.All())
    {
      flat.push_back(static_cast<int>(set.size()));
      flat.insert(flat.end(), set.begin(), set.end());
    }
    flat = GatherItems(this->Parts.Group(), flat);
    std::vector<SurfaceSet> all;
    for (auto at = flat.begin(); at != flat.end(); at += 1 + *at)
    {
      all.emplace_back(at + 1, at + 1 + *at);
    }
    return all;
  }

  /// The edges of quads where several surfaces meet, with those surfaces.
  std::map<std::pair<Index, Index>, SurfaceSet> FindCurveEdges(
    const std::map<Index, SurfaceSet>& junctions) const
  {
    std::map<std::pair<Index, Index>, SurfaceSet> edges;
    for (std::size_t q = 0; q < this->Quads.size(); ++q)
    {
      for (int c = 0; c < 4; ++c)
      {
        const Index a = this->Quads[q].Points[c], b = this->Quads[q].Points[(c + 1) % 4];
        if (junctions.count(a) && junctions.count(b))
        {
          SurfaceSet& set = edges[std::minmax(a, b)];
          const int surface = this->Mesh.Surfaces.SurfaceId[q];
          const auto at = std::lower_bound(set.begin(), set.end(), surface);
          if (at == set.end() || *at != surface)
          {
            set.insert(at, surface);
          }
        }
      }
    }
    for (auto edge = edges.begin(); edge != edges.end();)
    {
      edge = edge->second.size() < 2 ? edges.erase(edge) : std::next(edge);
    }
    return edges;
  }

  const CartesianGrid& Grid;
  const LabelArray& Labels;
  const std::vector<Index>& Mixed;
  const Fragments& Pieces;
  const PointNumbering& Points;
  const Partition& Parts;
  IndexBox Box;
  HexMesh& Mesh;
  std::vector<Quad> Quads;
};

} // namespace

void FindGeometry(const CartesianGrid& grid, const LabelArray& labels,
  const std::vector<Index>& mixed, const Fragments& fragments, const PointNumbering& numbering,
  const Partition& partition, HexMesh& mesh, HexMeshReport& report)
{
  GeometryFinder(grid, labels, mixed, fragments, numbering, partition, mesh).Run(report);
}

} // namespace vfm
