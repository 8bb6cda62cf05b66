/// The functions of MeshChecks.h that check faces: how elements meet.
#include "MeshChecks.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace vfm
{
namespace testing
{
namespace
{

/// Points of a face; the last is -1 for triangles.
using Face = std::array<Index, 4>;

/// Local corners of the faces of an element, in cyclic order.
constexpr int HexFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
  { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
constexpr int TetFaces[4][4] = { { 1, 2, 3, -1 }, { 0, 3, 2, -1 }, { 0, 1, 3, -1 },
  { 0, 2, 1, -1 } };

int CountFaces(const Mesh& mesh)
{
  return mesh.Shape().Faces;
}

Face FaceOf(const Mesh& mesh, Index element, int side)
{
  const int* corners = mesh.HasHexes() ? HexFaces[side] : TetFaces[side];
  Face face;
  for (int c = 0; c < 4; ++c)
  {
    face[c] = corners[c] < 0 ? -1 : mesh.Elements[mesh.Corners * element + corners[c]];
  }
  return face;
}

/// An element and the number of its face.
struct Side
{
  Index Element;
  int Number;
};

/// Returns the elements of each face by its sorted points.
std::map<Face, std::vector<Side>> FacesOf(const Mesh& mesh)
{
  std::map<Face, std::vector<Side>> faces;
  for (Index element = 0; element < static_cast<Index>(mesh.ElementIds.size()); ++element)
  {
    for (int number = 0; number < CountFaces(mesh); ++number)
    {
      Face face = FaceOf(mesh, element, number);
      std::sort(face.begin(), face.end());
      faces[face].push_back({ element, number });
    }
  }
  return faces;
}

/// The faces of a closed surface by their edges and points.
class Surface
{
public:
  /// corners: per face
  Surface(const std::vector<Face>& faces, int corners) : Faces(faces), Corners(corners)
  {
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      for (int c = 0; c < corners; ++c)
      {
        this->Edges[this->EdgeOf(f, c)].push_back(f);
        this->Fans[faces[f][c]].push_back(f);
      }
    }
  }

  Index CountOddEdges() const
  {
    return std::count_if(this->Edges.begin(), this->Edges.end(),
      [](const auto& edge) { return edge.second.size() != 2; });
  }

  Index CountNonManifoldPoints() const
  {
    return std::count_if(this->Fans.begin(), this->Fans.end(),
      [this](const auto& fan) { return this->IsNonManifold(fan); });
  }

private:
  using Edge = std::pair<Index, Index>;

  Edge EdgeOf(std::size_t face, int corner) const
  {
    return std::minmax(this->Faces[face][corner], this->Faces[face][(corner + 1) % this->Corners]);
  }

  /// Returns whether the faces at a point are not connected over the edges at it.
  bool IsNonManifold(const std::pair<const Index, std::vector<std::size_t>>& fan) const
  {
    std::set<std::size_t> reached{ fan.second[0] };
    std::vector<std::size_t> front{ fan.second[0] };
    while (!front.empty())
    {
      const std::size_t face = front.back();
      front.pop_back();
      for (int c = 0; c < this->Corners; ++c)
      {
        const Edge edge = this->EdgeOf(face, c);
        if (edge.first != fan.first && edge.second != fan.first)
        {
          continue;
        }
        for (std::size_t other : this->Edges.at(edge))
        {
          if (reached.insert(other).second)
          {
            front.push_back(other);
          }
        }
      }
    }
    return reached.size() != fan.second.size();
  }

  const std::vector<Face>& Faces;
  int Corners;
  std::map<Edge, std::vector<std::size_t>> Edges;
  std::map<Index, std::vector<std::size_t>> Fans;
};

/// Returns whether all points of a face are on one side of the domain.
bool IsOnDomain(const CartesianGrid& grid, const Mesh& mesh, const Face& face)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double side : { grid.Coordinates(axis).front(), grid.Coordinates(axis).back() })
    {
      if (std::all_of(face.begin(), face.end(),
            [&](Index p) { return p < 0 || mesh.Points[3 * p + axis] == side; }))
      {
        return true;
      }
    }
  }
  return false;
}

using FragmentPairs = std::set<std::pair<int, int>>;

/// Returns the pairs of fragments that share a face; 0 is void without elements.
/// @param numberOf  number of each fragment of the mesh in the pairs
FragmentPairs ListPairs(
  const CartesianGrid& grid, const Mesh& mesh, const std::map<int, int>& numberOf)
{
  FragmentPairs pairs;
  for (const auto& face : FacesOf(mesh))
  {
    const Index first = face.second.front().Element, last = face.second.back().Element;
    if (first != last || !IsOnDomain(grid, mesh, face.first))
    {
      const int a = numberOf.at(mesh.Fragment[first]);
      const int b = first == last ? 0 : numberOf.at(mesh.Fragment[last]);
      pairs.insert(std::minmax(a, b));
    }
  }
  FragmentPairs different;
  std::copy_if(pairs.begin(), pairs.end(), std::inserter(different, different.end()),
    [](const auto& pair) { return pair.first != pair.second; });
  return different;
}

/// Material and fragment of each cell that has elements, by its linear index.
using CellFragments = std::map<Index, std::pair<int, int>>;

CellFragments ListCells(const CartesianGrid& grid, const Mesh& cells)
{
  CellFragments fragments;
  for (std::size_t e = 0; e < cells.ElementIds.size(); ++e)
  {
    ForCells(CellsOfElement(grid, cells, cells.ElementIds[e]),
      [&](const Index3& cell) {
        fragments[grid.Linear(cell)] = { cells.Material[e], cells.Fragment[e] };
      });
  }
  return fragments;
}

/// Returns the cells that an element may overlap: those from which it was made. A tet belongs to
/// the face of the grid below its cell along an axis, so the cell below is added.
std::vector<Index> CellsNear(const CartesianGrid& grid, const Mesh& mesh, Index id)
{
  const IndexBox box = CellsOfElement(grid, mesh, id);
  std::vector<Index> cells{ grid.Linear(box.Lower) };
  for (int axis = 0; mesh.Corners == 4 && axis < 3; ++axis)
  {
    Index3 below = box.Lower;
    --below[axis];
    const bool isOfFace = (id - 1) % mesh.Ids.ElementSlots / (4 * PiecesPerTet) == axis;
    if (isOfFace && box.NumberOfCells() == 1 && grid.InDomain(below))
    {
      cells.push_back(grid.Linear(below));
    }
  }
  return cells;
}

/// Returns the fragment of the cells of each fragment of a mesh; -1 if there are several.
std::map<int, int> MatchFragments(
  const CartesianGrid& grid, const Mesh& mesh, const CellFragments& cells)
{
  std::map<int, int> numberOf;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    for (Index cell : CellsNear(grid, mesh, mesh.ElementIds[e]))
    {
      const auto at = cells.find(cell);
      if (at != cells.end() && at->second.first == mesh.Material[e])
      {
        const int fragment = at->second.second;
        int& number = numberOf.emplace(mesh.Fragment[e], fragment).first->second;
        number = number == fragment ? fragment : -1;
      }
    }
  }
  return numberOf;
}

template <class T>
bool AreUnique(const Buffer<T>& ids)
{
  return std::set<T>(ids.begin(), ids.end()).size() == ids.size();
}

} // namespace

std::string FindConformityProblem(const Mesh& mesh)
{
  if (!AreUnique(mesh.ElementIds) || !AreUnique(mesh.PointIds))
  {
    return "global ids are not unique";
  }
  const std::set<Index> used(mesh.Elements.begin(), mesh.Elements.end());
  if (used.size() != mesh.PointIds.size() || (used.size() && *used.begin() < 0))
  {
    return "unused points";
  }
  for (const auto& face : FacesOf(mesh))
  {
    if (face.second.size() > 2)
    {
      return "a face on more than two elements";
    }
  }
  return "";
}

std::map<int, SurfaceDefects> CountBoundaryDefects(const Mesh& mesh)
{
  std::map<int, std::vector<Face>> boundaries;
  for (const auto& face : FacesOf(mesh))
  {
    const Side& side = face.second[0];
    const int first = mesh.Material[side.Element];
    const int last = face.second.size() == 2 ? mesh.Material[face.second[1].Element] : -1;
    for (int material : { first, last })
    {
      if (first != last && material >= 0)
      {
        boundaries[material].push_back(FaceOf(mesh, side.Element, side.Number));
      }
    }
  }
  std::map<int, SurfaceDefects> defects;
  for (const auto& boundary : boundaries)
  {
    const Surface surface(boundary.second, mesh.CornersOfFacet());
    defects[boundary.first] = { surface.CountOddEdges(), surface.CountNonManifoldPoints() };
  }
  return defects;
}

std::string FindTopologyProblem(const Mesh& mesh)
{
  const std::string problem = FindConformityProblem(mesh);
  if (!problem.empty())
  {
    return problem;
  }
  for (const auto& material : CountBoundaryDefects(mesh))
  {
    const SurfaceDefects& defects = material.second;
    if (defects.OddEdges + defects.NonManifoldPoints > 0)
    {
      return "boundary of material " + std::to_string(material.first) + ": " +
        std::to_string(defects.OddEdges) + " edges not on two faces, " +
        std::to_string(defects.NonManifoldPoints) + " non-manifold points";
    }
  }
  return "";
}

std::string FindFragmentProblem(const Mesh& mesh)
{
  const std::size_t count = mesh.ElementIds.size();
  std::vector<std::vector<Index>> joined(count);
  for (const auto& face : FacesOf(mesh))
  {
    if (face.second.size() == 2)
    {
      const Index a = face.second[0].Element, b = face.second[1].Element;
      const bool sameMaterial = mesh.Material[a] == mesh.Material[b];
      if (sameMaterial != (mesh.Fragment[a] == mesh.Fragment[b]))
      {
        return sameMaterial ? "two fragments of one material share a face"
                            : "a fragment has two materials";
      }
      if (sameMaterial)
      {
        joined[a].push_back(b);
        joined[b].push_back(a);
      }
    }
  }
  std::set<int> seen;
  std::vector<bool> reached(count, false);
  for (std::size_t first = 0; first < count; ++first)
  {
    if (reached[first])
    {
      continue;
    }
    if (!seen.insert(mesh.Fragment[first]).second)
    {
      return "fragment " + std::to_string(mesh.Fragment[first]) + " is not connected by faces";
    }
    std::vector<Index> front{ static_cast<Index>(first) };
    reached[first] = true;
    while (!front.empty())
    {
      const Index at = front.back();
      front.pop_back();
      for (Index other : joined[at])
      {
        if (!reached[other])
        {
          reached[other] = true;
          front.push_back(other);
        }
      }
    }
  }
  return "";
}

std::string FindFacetProblem(const Mesh& mesh)
{
  const SurfaceFacets& surfaces = mesh.Surfaces;
  const int corners = mesh.CornersOfFacet();
  std::map<Face, std::size_t> facets;
  for (std::size_t f = 0; f < surfaces.SurfaceId.size(); ++f)
  {
    Face facet{ { -1, -1, -1, -1 } };
    std::copy_n(surfaces.Points.data() + corners * f, corners, facet.begin());
    std::sort(facet.begin(), facet.end());
    if (!facets.emplace(facet, f).second)
    {
      return "a facet twice";
    }
  }
  for (const auto& face : FacesOf(mesh))
  {
    const Index first = face.second.front().Element, last = face.second.back().Element;
    if (first != last && mesh.Fragment[first] == mesh.Fragment[last])
    {
      continue;
    }
    const auto at = facets.find(face.first);
    if (at == facets.end())
    {
      return "face " + std::to_string(last - first) + " between fragments is not a facet";
    }
    const int a = first == last ? 0 : mesh.Material[first], b = mesh.Material[last];
    const int* own = surfaces.MaterialPair.data() + 2 * at->second;
    if (own[0] != std::min(a, b) || own[1] != std::max(a, b))
    {
      return "a facet has other materials than its elements";
    }
    facets.erase(at);
  }
  return facets.empty() ? "" : "a facet is not a face between fragments";
}

Index CountFreeFaces(const Mesh& mesh)
{
  const auto faces = FacesOf(mesh);
  return std::count_if(
    faces.begin(), faces.end(), [](const auto& face) { return face.second.size() == 1; });
}

Index CountLocked(const Mesh& mesh)
{
  Index count = 0;
  for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
  {
    const Index* points = mesh.Elements.data() + mesh.Corners * e;
    count += std::all_of(points, points + mesh.Corners,
      [&](Index point) { return mesh.GeometryDimension[point] < 3; });
  }
  return count;
}

Mesh MakeCells(
  const CartesianGrid& grid, const FractionField& fractions, const MeshOptions& options)
{
  MeshOptions own = options;
  own.StairStep = true;
  Runtime runtime;
  MeshReport report;
  return MakeHexMesh(grid, fractions, own, runtime, report);
}

std::string FindCellProblem(const CartesianGrid& grid, const Mesh& mesh, const Mesh& cells)
{
  const std::set<int> all(cells.Fragment.begin(), cells.Fragment.end());
  std::map<int, int> unchanged;
  for (int fragment : all)
  {
    unchanged[fragment] = fragment;
  }
  const std::set<int> own(mesh.Fragment.begin(), mesh.Fragment.end());
  if (own.size() != all.size())
  {
    return std::to_string(own.size()) + " fragments, of the cells " + std::to_string(all.size());
  }
  const bool knowsCells = mesh.Ids.ElementSlots > 0;
  const std::map<int, int> numberOf =
    knowsCells ? MatchFragments(grid, mesh, ListCells(grid, cells)) : unchanged;
  std::set<int> matched;
  for (const auto& pair : numberOf)
  {
    matched.insert(pair.second);
  }
  if (numberOf.size() != own.size() || matched != all)
  {
    return "fragments are not those of the cells";
  }
  const FragmentPairs pairs = ListPairs(grid, mesh, numberOf);
  const FragmentPairs expected = ListPairs(grid, cells, unchanged);
  return pairs == expected ? ""
                           : std::to_string(pairs.size()) +
      " pairs of fragments touch, of the cells " + std::to_string(expected.size());
}

} // namespace testing
} // namespace vfm
