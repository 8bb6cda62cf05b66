#include "Meshes/Decks/WriteConnections.h"

#include "Base/DisjointSets.h"
#include "Base/Sorted.h"
#include "Report/MeshMaterials.h"

#include <algorithm>
#include <tuple>

namespace vfm
{
namespace
{

using Pair = std::array<int, 2>;

/// A node of the first side of a face, and its copy on the second side.
struct Link
{
  Pair Materials;
  Index First, Second; // points of the mesh

  auto operator<=>(const Link&) const = default;
};

Index PointOf(const MeshData& mesh, Index id)
{
  return std::lower_bound(mesh.PointIds, mesh.PointIds + mesh.NumberOfPoints, id) - mesh.PointIds;
}

std::vector<Link> ListLinks(const MeshData& mesh, const std::vector<SplitFace>& faces)
{
  std::vector<Link> links;
  for (const SplitFace& face : faces)
  {
    for (std::size_t p = 0; p < face.Points[0].size(); ++p)
    {
      if (face.Points[0][p] != face.Points[1][p])
      {
        links.push_back(
          { face.Materials, PointOf(mesh, face.Points[0][p]), PointOf(mesh, face.Points[1][p]) });
      }
    }
  }
  SortUnique(links);
  return links;
}

/// Returns the pairs of materials of faces, ascending.
std::vector<Pair> ListPairs(const std::vector<SplitFace>& faces)
{
  std::vector<Pair> pairs;
  for (const SplitFace& face : faces)
  {
    pairs.push_back(face.Materials);
  }
  SortUnique(pairs);
  return pairs;
}

/// Returns the name of the surface of a pair of materials.
const std::string& NameOf(const std::vector<DeckSurface>& surfaces, const Pair& materials)
{
  return std::find_if(surfaces.begin(), surfaces.end(),
    [&materials](const DeckSurface& surface)
    { return surface.Set->Kind == SurfaceKind::Interface && surface.Set->Materials == materials; })
    ->Name;
}

void WriteContact(const DeckModel& model, const std::vector<DeckSurface>& surfaces,
  AbaqusNames& names, OutputFile& file)
{
  const std::map<int, std::string> materials = NamesOfMaterials(model.Mesh);
  for (const Pair& pair : ListPairs(model.SplitFaces))
  {
    const std::string name = names.Add(NameOfMaterial(materials, pair[0]) + "_to_" +
      NameOfMaterial(materials, pair[1]) + "_contact");
    file.Add("*SURFACE INTERACTION, NAME=" + name + "\n");
    file.Add("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD\n");
    file.Add("*CONTACT PAIR, INTERACTION=" + name + ", TYPE=SURFACE TO SURFACE\n");
    file.Add(NameOf(surfaces, pair) + "," + NameOf(surfaces, { { pair[1], pair[0] } }) + "\n");
  }
}

/// Writes the equation u(first) - u(second) = 0 for each component.
void WriteEqual(const std::array<Index, 2>& nodes, OutputFile& file)
{
  for (int axis = 1; axis <= 3; ++axis)
  {
    file.Add("*EQUATION\n2\n");
    file.Add(nodes[0] + 1);
    file.Add(",");
    file.Add(axis);
    file.Add(",1,");
    file.Add(nodes[1] + 1);
    file.Add(",");
    file.Add(axis);
    file.Add(",-1\n");
  }
}

void WriteTies(const DeckModel& model, const NodeTies& ties,
  const std::vector<DeckSurface>& surfaces, AbaqusNames& names, OutputFile& file)
{
  const std::map<int, std::string> materials = NamesOfMaterials(model.Mesh);
  ForRuns(
    ties.Nodes.begin(), ties.Nodes.end(),
    [](const TiedNode& a, const TiedNode& b) { return a.Materials == b.Materials; },
    [&](auto begin, auto end)
    {
      const Pair& pair = begin->Materials;
      const std::string name = names.Add(
        NameOfMaterial(materials, pair[0]) + "_to_" + NameOfMaterial(materials, pair[1]) + "_tied");
      file.Add("*SURFACE, NAME=" + name + ", TYPE=NODE\n");
      for (auto node = begin; node != end; ++node)
      {
        file.Add(node->Node + 1);
        file.Add("\n");
      }
      file.Add("*TIE, NAME=T_" + name + ", ADJUST=NO\n");
      file.Add(name + "," + NameOf(surfaces, { { pair[1], pair[0] } }) + "\n");
    });
  for (const std::array<Index, 2>& nodes : ties.Equal)
  {
    WriteEqual(nodes, file);
  }
}

} // namespace

NodeTies FindNodeTies(const DeckModel& model)
{
  NodeTies ties;
  if (model.Connection != ConnectionKind::Tied)
  {
    return ties;
  }
  const MeshData& mesh = model.Mesh;
  std::vector<Index> sets = MakeSets(mesh.NumberOfPoints); // copies that ties connect
  std::vector<char> isTied(mesh.NumberOfPoints, 0);
  const std::vector<Link> links = ListLinks(mesh, model.SplitFaces);
  for (const Link& link : links)
  {
    if (isTied[link.First] == 0)
    {
      isTied[link.First] = 1;
      ties.Nodes.push_back({ link.Materials, link.First });
      Join(sets, link.First, link.Second);
    }
  }
  std::vector<Index> freeOf(mesh.NumberOfPoints); // the node of a set that is not tied
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    if (isTied[point] == 0)
    {
      freeOf[FindRoot(sets, point)] = point;
    }
  }
  for (const Link& link : links)
  {
    const Index first = FindRoot(sets, link.First), second = FindRoot(sets, link.Second);
    if (first != second)
    {
      ties.Equal.push_back({ { freeOf[first], freeOf[second] } });
      Join(sets, first, second);
      freeOf[FindRoot(sets, first)] = ties.Equal.back()[1];
    }
  }
  return ties;
}

NodeSet RemoveTiedNodes(NodeSet set, const NodeTies& ties)
{
  std::vector<Index> tied;
  for (const TiedNode& node : ties.Nodes)
  {
    tied.push_back(node.Node);
  }
  for (const std::array<Index, 2>& nodes : ties.Equal)
  {
    tied.push_back(nodes[0]);
  }
  std::sort(tied.begin(), tied.end());
  set.Points.erase(std::remove_if(set.Points.begin(), set.Points.end(),
                     [&tied](Index point) { return FindSorted(tied, point) >= 0; }),
    set.Points.end());
  return set;
}

void WriteConnections(const DeckModel& model, const NodeTies& ties,
  const std::vector<DeckSurface>& surfaces, AbaqusNames& names, OutputFile& file)
{
  if (model.Connection == ConnectionKind::Contact)
  {
    WriteContact(model, surfaces, names, file);
  }
  WriteTies(model, ties, surfaces, names, file);
}

} // namespace vfm
