#include "RefinedChecks.h"

#include "Base/Vector3.h"
#include "Elements/Hex/HexTopology.h"
#include "Geometry/Quality.h"
#include "MeshChecks.h"

#include <map>
#include <numeric>
#include <random>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

RefinedCase MakeEmptyCase(const std::string& name, const Index3& n, int levels)
{
  RefinedCase made;
  made.Name = name;
  made.Grid = std::make_shared<CartesianGrid>(MakeUnitGrid(n[0], n[1], n[2]));
  made.Lattice = std::make_shared<OctreeKeys>(*made.Grid, levels);
  made.Requested.resize(levels);
  return made;
}

template <class Visitor>
void ForFamilies(const OctreeKeys& lattice, int level, const Visitor& visit)
{
  for (Index k = 0; k < lattice.Families(level, 2); ++k)
  {
    for (Index j = 0; j < lattice.Families(level, 1); ++j)
    {
      for (Index i = 0; i < lattice.Families(level, 0); ++i)
      {
        visit(Index3{ { i, j, k } });
      }
    }
  }
}

/// Returns whether a family is one of eight at corners of a grid of n families, or in the middle of
/// edges and faces along each axis.
bool IsOnDomain(const Index3& q, Index n)
{
  const std::set<Index3> families{ { { 0, 0, 0 } }, { { n - 1, n - 1, n - 1 } },
    { { n / 2, 0, 0 } }, { { n - 1, n / 2, 0 } }, { { 0, n - 1, n / 2 } }, { { n / 2, n / 2, 0 } },
    { { n - 1, n / 2, n / 2 } }, { { n / 2, n - 1, n / 2 } } };
  return families.count(q) > 0;
}

bool InBlock(const Index3& q, Index low, Index high)
{
  return std::all_of(q.begin(), q.end(), [&](Index i) { return i >= low && i < high; });
}

using Face = std::array<int, 4>; // ascending

Face FaceOf(const std::array<int, 8>& hex, int f)
{
  Face face;
  int n = 0;
  for (int c = 0; c < 8; ++c)
  {
    if ((c >> f / 2 & 1) == (f & 1))
    {
      face[n++] = hex[c];
    }
  }
  std::sort(face.begin(), face.end());
  return face;
}

bool IsOnDomainSide(const CartesianGrid& grid, const WholeMesh& mesh, const Face& face)
{
  int sides = 63;
  for (int p : face)
  {
    const Vector3& x = mesh.Points[p];
    int own = 0;
    for (int a = 0; a < 3; ++a)
    {
      own |= (x[a] == grid.Coordinates(a).front()) << (2 * a) |
        (x[a] == grid.Coordinates(a).back()) << (2 * a + 1);
    }
    sides &= own;
  }
  return sides != 0;
}

bool HasDuplicates(std::vector<Index> keys)
{
  std::sort(keys.begin(), keys.end());
  return std::adjacent_find(keys.begin(), keys.end()) != keys.end();
}

/// Triangles cut off from the hexes at a point, by the other ends of their edges.
using Link = std::vector<std::array<int, 3>>;

/// Returns whether a link is one sphere or one disc: connected, at most two triangles
/// per edge, Euler characteristic.
bool IsSphereOrDisc(const Link& link)
{
  std::map<std::array<int, 2>, std::vector<int>> edges;
  std::set<int> points;
  for (std::size_t t = 0; t < link.size(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      points.insert(link[t][e]);
      const auto ends = std::minmax(link[t][e], link[t][(e + 1) % 3]);
      edges[{ { ends.first, ends.second } }].push_back(static_cast<int>(t));
    }
  }
  std::vector<int> part(link.size());
  std::iota(part.begin(), part.end(), 0);
  const auto find = [&](int t)
  {
    while (part[t] != t)
    {
      t = part[t];
    }
    return t;
  };
  bool open = false;
  int parts = static_cast<int>(link.size());
  for (const auto& edge : edges)
  {
    if (edge.second.size() > 2)
    {
      return false;
    }
    open = open || edge.second.size() == 1;
    const int a = find(edge.second.front()), b = find(edge.second.back());
    parts -= a != b;
    part[a] = b;
  }
  const int euler = static_cast<int>(points.size()) - static_cast<int>(edges.size()) +
    static_cast<int>(link.size());
  return parts == 1 && euler == (open ? 1 : 2);
}

std::string FindLinkProblem(const WholeMesh& mesh)
{
  std::vector<Link> links(mesh.Points.size());
  for (const auto& hex : mesh.Hexes)
  {
    for (int c = 0; c < 8; ++c)
    {
      links[hex[c]].push_back({ { hex[c ^ 1], hex[c ^ 2], hex[c ^ 4] } });
    }
  }
  for (const Link& link : links)
  {
    if (link.empty())
    {
      return "unused points";
    }
    if (!IsSphereOrDisc(link))
    {
      return "the hexes at a point do not form a ball";
    }
  }
  return "";
}

std::array<int, 8> ByBits(const Index* vtk)
{
  std::array<int, 8> hex;
  for (int c = 0; c < 8; ++c)
  {
    hex[c] = static_cast<int>(vtk[VtkCorner[c]]);
  }
  return hex;
}

/// Integrates the trilinear map exactly: two Gauss points per axis.
double HexVolume(const WholeMesh& mesh, const std::array<int, 8>& hex)
{
  double volume = 0.0;
  for (int g = 0; g < 8; ++g)
  {
    Vector3 derivative[3]{};
    for (int c = 0; c < 8; ++c)
    {
      for (int a = 0; a < 3; ++a)
      {
        double weight = c >> a & 1 ? 1.0 : -1.0;
        for (int b = 0; b < 3; ++b)
        {
          const double t = 0.5 + (g >> b & 1 ? 0.5 : -0.5) / std::sqrt(3.0);
          weight *= a == b ? 1.0 : (c >> b & 1 ? t : 1.0 - t);
        }
        derivative[a] = derivative[a] + weight * mesh.Points[hex[c]];
      }
    }
    volume += 0.125 * Dot(derivative[0], Cross(derivative[1], derivative[2]));
  }
  return volume;
}

} // namespace

RefinedCase MakeFamilyCase(
  const std::string& name, const Index3& n, const std::function<bool(const Index3&)>& requested)
{
  RefinedCase made = MakeEmptyCase(name, n, 1);
  ForFamilies(*made.Lattice, 0,
    [&](const Index3& q)
    {
      if (requested(q))
      {
        made.Requested[0].push_back(made.Lattice->FamilyKey(0, q));
      }
    });
  return made;
}

RefinedCase MakeRandomCase(const Index3& n, int levels, double chance, unsigned seed)
{
  char name[64];
  std::snprintf(
    name, sizeof name, "random %g, %d, %d levels", chance, static_cast<int>(n[0]), levels);
  RefinedCase made = MakeEmptyCase(name, n, levels);
  std::mt19937 random(seed);
  ForFamilies(*made.Lattice, levels - 1,
    [&](const Index3& q)
    {
      if (random() < chance * 4294967296.0)
      {
        made.Requested[levels - 1].push_back(made.Lattice->FamilyKey(levels - 1, q));
      }
    });
  return made;
}

RefinedCase MakeShellCase(Index n, int levels)
{
  const std::string name = "sphere shell, " + std::to_string(n) + ", " + std::to_string(levels) +
    (levels > 1 ? " levels" : " level");
  RefinedCase made = MakeEmptyCase(name, { { n, n, n } }, levels);
  const int level = levels - 1;
  ForFamilies(*made.Lattice, level,
    [&](const Index3& q)
    {
      double nearest = 0.0, farthest = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const double low = made.Lattice->Coordinate(level, a, 2 * q[a]) - 0.5 * n;
        const double high = low + std::ldexp(2.0, -level);
        const double inner = std::max({ low, -high, 0.0 }),
                     outer = std::max(std::fabs(low), std::fabs(high));
        nearest += inner * inner;
        farthest += outer * outer;
      }
      const double radius = 0.36 * n;
      if (nearest < radius * radius && farthest > radius * radius)
      {
        made.Requested[level].push_back(made.Lattice->FamilyKey(level, q));
      }
    });
  return made;
}

std::vector<RefinedCase> MakeShapeCases()
{
  const auto inBox = [](const Index3& q) { return InBlock(q, 1, 5); };
  const Index3 twelve{ { 12, 12, 12 } };
  return {
    MakeFamilyCase("one family", { { 8, 8, 8 } },
      [](const Index3& q) {
        return q == Index3{ { 1, 2, 1 } };
      }),
    MakeFamilyCase("box", twelve, inBox),
    MakeFamilyCase(
      "L", twelve, [&](const Index3& q) { return inBox(q) && (q[0] < 3 || q[1] < 3); }),
    MakeFamilyCase("L3", twelve, [&](const Index3& q) { return inBox(q) && !InBlock(q, 3, 5); }),
    MakeFamilyCase("all but one family", twelve,
      [](const Index3& q) {
        return q != Index3{ { 3, 2, 3 } };
      }),
    MakeFamilyCase(
      "checkerboard", twelve, [](const Index3& q) { return (q[0] + q[1] + q[2]) % 2 == 0; }),
    MakeFamilyCase("every third diagonal", twelve,
      [](const Index3& q) { return (q[0] + q[1] + q[2]) % 3 == 0; }),
    MakeFamilyCase("two diagonal lines", { { 24, 24, 24 } },
      [](const Index3& q)
      { return q[2] == 5 && InBlock(q, 2, 10) && (q[0] == q[1] || q[0] == q[1] + 4); }),
    MakeFamilyCase(
      "domain corner, edges, faces", twelve, [](const Index3& q) { return IsOnDomain(q, 6); }),
    MakeFamilyCase(
      "the same, odd", { { 11, 11, 11 } }, [](const Index3& q) { return IsOnDomain(q, 6); }),
    MakeFamilyCase(
      "one cell thick", { { 9, 8, 1 } }, [](const Index3& q) { return q[0] == 2 && q[1] < 3; }),
    MakeFamilyCase("all, odd", { { 5, 4, 3 } }, [](const Index3&) { return true; }),
  };
}

WholeMesh AddUntouchedCells(const OctreeKeys& lattice, const RefinedMesh& mesh)
{
  WholeMesh whole;
  whole.PointKeys = mesh.PointKeys;
  whole.HexKeys = mesh.HexKeys;
  whole.IsTransition = mesh.IsTransition;
  std::map<Index, int> points;
  for (Index p = 0; p < mesh.NumberOfPoints(); ++p)
  {
    const double* x = mesh.Points.data() + 3 * p;
    whole.Points.push_back({ { x[0], x[1], x[2] } });
    points[mesh.PointKeys[p]] = static_cast<int>(p);
  }
  for (Index h = 0; h < mesh.NumberOfHexes(); ++h)
  {
    whole.Hexes.push_back(ByBits(mesh.Hexes.data() + 8 * h));
  }
  const CartesianGrid& grid = lattice.Base();
  ForUntouchedCells(grid, grid.Global(), mesh,
    [&](const Index3& cell)
    {
      std::array<int, 8> hex;
      for (int c = 0; c < 8; ++c)
      {
        const Index3 node{ { cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2) } };
        const Index key = lattice.LatticeKey(0, node);
        const auto at = points.emplace(key, static_cast<int>(whole.Points.size()));
        if (at.second)
        {
          whole.Points.push_back(grid.NodePoint(node));
          whole.PointKeys.push_back(key);
        }
        hex[c] = at.first->second;
      }
      whole.Hexes.push_back(hex);
      whole.HexKeys.push_back(lattice.HexKey(0, cell, 0));
      whole.IsTransition.push_back(0);
    });
  return whole;
}

std::string FindTopologyProblem(const CartesianGrid& grid, const WholeMesh& mesh)
{
  if (HasDuplicates(mesh.PointKeys) || HasDuplicates(mesh.HexKeys))
  {
    return "keys are not unique";
  }
  std::map<Face, int> faces;
  std::set<std::array<int, 2>> edges;
  for (const auto& hex : mesh.Hexes)
  {
    for (int f = 0; f < 6; ++f)
    {
      ++faces[FaceOf(hex, f)];
    }
    for (int at = 0; at < 24; ++at)
    {
      const auto ends = std::minmax(hex[at / 3], hex[at / 3 ^ 1 << at % 3]);
      edges.insert({ { ends.first, ends.second } });
    }
  }
  for (const auto& face : faces)
  {
    if (face.second > 2)
    {
      return "a face on more than two hexes";
    }
    if (face.second == 1 && !IsOnDomainSide(grid, mesh, face.first))
    {
      return "a single face inside the domain";
    }
  }
  const Index euler = static_cast<Index>(mesh.Points.size()) - static_cast<Index>(edges.size()) +
    static_cast<Index>(faces.size()) - static_cast<Index>(mesh.Hexes.size());
  return euler == 1 ? FindLinkProblem(mesh) : "Euler characteristic " + std::to_string(euler);
}

std::string FindChildProblem(const OctantFamilies& sets, const WholeMesh& mesh)
{
  const OctreeKeys& lattice = sets.Lattice();
  std::map<Index, std::size_t> hexes;
  std::size_t regular = 0;
  for (std::size_t h = 0; h < mesh.HexKeys.size(); ++h)
  {
    hexes[mesh.HexKeys[h]] = h;
    regular += !mesh.IsTransition[h] && lattice.HexOfKey(mesh.HexKeys[h]).Level > 0;
  }
  for (int level = 0; level < sets.NumberOfRefinements(); ++level)
  {
    for (Index key : sets.Keys(level))
    {
      const Index3 q = lattice.FamilyOfKey(level, key);
      for (int n = 0; n < 64; ++n)
      {
        const Index3 cell{ { 4 * q[0] + n % 4, 4 * q[1] + n / 4 % 4, 4 * q[2] + n / 16 } };
        if (!lattice.HasCell(level + 1, cell) || sets.IsTouched(level + 1, cell))
        {
          continue;
        }
        const auto found = hexes.find(lattice.HexKey(level + 1, cell, 0));
        if (found == hexes.end() || mesh.IsTransition[found->second])
        {
          return "a child of a refined cell is missing";
        }
        --regular;
        for (int c = 0; c < 8; ++c)
        {
          const Index3 node{ { cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2) } };
          const int point = mesh.Hexes[found->second][c];
          if (mesh.PointKeys[point] != lattice.LatticeKey(level + 1, node) ||
            mesh.Points[point] != lattice.NodePoint(level + 1, node))
          {
            return "a child of a refined cell is not exact";
          }
        }
      }
    }
  }
  return regular == 0 ? "" : "cells of a level without refined parents";
}

double SmallestCornerDeterminant(const CartesianGrid& grid, const WholeMesh& mesh)
{
  double smallest = 1e300;
  for (const auto& hex : mesh.Hexes)
  {
    for (int c = 0; c < 8; ++c)
    {
      Vector3 edge[3];
      for (int a = 0; a < 3; ++a)
      {
        edge[a] = mesh.Points[hex[c | 1 << a]] - mesh.Points[hex[c & ~(1 << a)]];
      }
      smallest = std::min(smallest, Dot(edge[0], Cross(edge[1], edge[2])));
    }
  }
  return smallest / std::pow(grid.MeanWidth(), 3);
}

double VolumeError(const CartesianGrid& grid, const WholeMesh& mesh)
{
  double box = 1.0;
  for (int a = 0; a < 3; ++a)
  {
    box *= grid.Coordinates(a).back() - grid.Coordinates(a).front();
  }
  long double volume = 0.0;
  for (const auto& hex : mesh.Hexes)
  {
    volume += HexVolume(mesh, hex);
  }
  return static_cast<double>(volume / box - 1.0);
}

TransitionQuality MeasureTransitions(const RefinedMesh& mesh)
{
  std::vector<double> values;
  for (Index h = 0; h < mesh.NumberOfHexes(); ++h)
  {
    if (mesh.IsTransition[h])
    {
      values.push_back(HexScaledJacobian(mesh.Points.data(), mesh.Hexes.data() + 8 * h));
    }
  }
  if (values.empty())
  {
    return {};
  }
  std::sort(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return { static_cast<Index>(values.size()), values.front(), values[values.size() / 100],
    sum / static_cast<double>(values.size()) };
}

} // namespace testing
} // namespace vfm
