#include "Meshes/Decks/WriteNastran.h"

#include "Meshes/Decks/DeckCards.h"
#include "Meshes/Decks/DeckModel.h"
#include "Meshes/Files/ElementNodes.h"
#include "Report/FlatData.h"
#include "Report/Sets/NamedSurfaces.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace vfm
{
namespace
{

constexpr int LargestNumber = 99999999;
constexpr std::size_t Narrow = 8, Wide = 16; // widths of fields
constexpr std::size_t FieldsInLine = 8, LongestComment = 70;
constexpr const char* OtherFormats = ".rad, .inp, .e";
constexpr const char* Continuation = "+       ";
/// Corner of a tetrahedron that is not on a side, by number of the side in VTK.
constexpr int OppositeCorners[4] = { 2, 0, 1, 3 };

void WriteComment(DeckCards& cards, const std::string& text)
{
  cards.Line("$ " + PlainTitle(text, LongestComment));
}

void WriteNodes(DeckCards& cards, const MeshData& mesh)
{
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    const double* x = mesh.Point(point);
    cards.Text("GRID*   ").Integer(point + 1, Wide).Blank(Wide).Real(x[0], Wide).Real(x[1], Wide);
    cards.End();
    cards.Text("*       ").Real(x[2], Wide).End();
  }
}

/// Returns the name of the elements as a field.
const char* EntryOf(const MeshData& mesh)
{
  if (IsFlat(mesh))
  {
    return mesh.Corners == 4 ? "CQUAD4  " : "CTRIA3  ";
  }
  return mesh.HasHexes() ? "CHEXA   " : "CTETRA  ";
}

void WriteElements(DeckCards& cards, const MeshData& mesh, const MaterialPart& section)
{
  constexpr int inFirstLine = 6;
  const char* entry = EntryOf(mesh);
  for (Index element : section.Elements)
  {
    cards.Text(entry);
    cards.Integer(element + 1, Narrow).Integer(section.Id, Narrow);
    for (int c = 0; c < mesh.Corners; ++c)
    {
      if (c == inFirstLine)
      {
        cards.End();
        cards.Text(Continuation);
      }
      cards.Integer(mesh.Element(element)[c] + 1, Narrow);
    }
    cards.End();
  }
}

/// Writes a property and the elements of a material. MID2 of a PSHELL is -1 for plane strain.
void WriteSection(
  DeckCards& cards, const MeshData& mesh, const MaterialPart& section, bool isPlaneStress)
{
  WriteComment(cards, "Material " + std::to_string(section.Id) + ": " + section.Name);
  cards.Text(IsFlat(mesh) ? "PSHELL  " : "PSOLID  ");
  cards.Integer(section.Id, Narrow).Integer(section.Id, Narrow);
  cards.Text(!IsFlat(mesh) ? "" : isPlaneStress ? "      1." : "      1.      -1").End();
  if (section.Bin && section.Bin->Elastic)
  {
    const ElasticConstants& elastic = *section.Bin->Elastic;
    cards.Text("MAT1*   ").Integer(section.Id, Wide).Real(elastic.Modulus, Wide).Blank(Wide);
    cards.Real(elastic.Poisson, Wide).End();
    cards.Text("*       ").Real(elastic.Density, Wide).End();
  }
  WriteElements(cards, mesh, section);
}

/// Writes a point mass at each particle that has a mass, numbered after all elements.
void WriteMasses(DeckCards& cards, const DeckModel& model, const ParticlePart& part)
{
  WriteComment(cards, "Particles " + std::to_string(part.Id) + ": " + part.Name);
  const Index elements = model.Mesh.NumberOfElements + CountElements(model.Cohesive);
  for (std::size_t p = 0; model.HasMasses() && p < part.Particles.size(); ++p)
  {
    const Index particle = part.Particles[p];
    cards.Text("CONM2*  ").Integer(elements + particle + 1, Wide);
    cards.Integer(model.NodeOf(particle), Wide).Integer(0, Wide);
    cards.Real(model.Mesh.Particles->Mass[particle], Wide).End();
    cards.Line("*       ");
  }
}

/// Writes a list of nodes. The number of the set is the first field.
void WriteNodeSet(DeckCards& cards, const NodeSet& set, int id)
{
  WriteComment(cards, "Nodes " + std::to_string(id) + ": " + set.Name);
  cards.Text("SET1    ").Integer(id, Narrow);
  std::size_t field = 1;
  for (Index point : set.Points)
  {
    if (field++ % FieldsInLine == 0)
    {
      cards.End();
      cards.Text(Continuation);
    }
    cards.Integer(point + 1, Narrow);
  }
  cards.End();
}

/// Writes a pressure of 1 on the faces of a surface. A face of a hexahedron is given by opposite
/// corners, of a tetrahedron by one of its corners and the corner that is not on it.
void WriteSurface(DeckCards& cards, const MeshData& mesh, const NamedSurface& surface, int id)
{
  WriteComment(cards, "Surface " + std::to_string(id) + ": " + surface.Name);
  for (const ElementSide& side : surface.Sides)
  {
    const FaceIds points = PointsOfSide(mesh, side);
    const Index other =
      mesh.HasHexes() ? points[2] : mesh.Element(side.Element)[OppositeCorners[side.Side]];
    cards.Text("PLOAD4  ").Integer(id, Narrow).Integer(side.Element + 1, Narrow).Text("      1.");
    cards.Blank(3 * Narrow).Integer(points[0] + 1, Narrow).Integer(other + 1, Narrow).End();
  }
}

/// Returns the nodes of the edges of a surface as a set.
NodeSet NodesOfSurface(const MeshData& mesh, const NamedSurface& surface)
{
  NodeSet set{ surface.Id, surface.Name, {} };
  for (const ElementSide& side : surface.Sides)
  {
    const FaceIds points = PointsOfSide(mesh, side);
    set.Points.insert(set.Points.end(), points.begin(), points.begin() + CornersOfSide(mesh));
  }
  std::sort(set.Points.begin(), set.Points.end());
  set.Points.erase(std::unique(set.Points.begin(), set.Points.end()), set.Points.end());
  return set;
}

/// Replaces surfaces of edges by sets of their nodes. Those of a node set are left out.
void MakeNodeSets(
  const MeshData& mesh, std::vector<NamedSurface>& surfaces, std::vector<NodeSet>& sets)
{
  const std::size_t own = sets.size();
  for (const NamedSurface& surface : std::exchange(surfaces, {}))
  {
    const bool isKnown = std::any_of(sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(own),
      [&surface](const NodeSet& set) { return set.Id == surface.Id; });
    if (!isKnown)
    {
      sets.push_back(NodesOfSurface(mesh, surface));
    }
  }
}

/// Returns whether all ids of sets have at most eight digits.
template <class Set>
bool HaveShortIds(const std::vector<Set>& sets)
{
  return std::all_of(
    sets.begin(), sets.end(), [](const Set& set) { return set.Id <= LargestNumber; });
}

template <class Set>
int LargestId(const std::vector<Set>& sets, int least)
{
  return std::accumulate(sets.begin(), sets.end(), least,
    [](int largest, const Set& set) { return std::max(largest, set.Id); });
}

void WriteFile(const DeckModel& model, const std::string& path, bool isPlaneStress)
{
  const MeshData& mesh = model.Mesh;
  RequireNodes(mesh, {}, "Nastran");
  RequireNumbers(model, LargestNumber, "Nastran", OtherFormats);
  RequireIds(model, LargestNumber, "Nastran", OtherFormats);
  DeckCards cards(path, RealForm::Nastran);
  cards.Line("$pyNastran: punch=True"); // tells this reader that there is no case control
  WriteComment(cards, DescribeDeck(model));
  WriteNodes(cards, mesh);
  for (const MaterialPart& section : model.Materials)
  {
    WriteSection(cards, mesh, section, isPlaneStress);
  }
  for (const ParticlePart& part : model.Particles)
  {
    WriteMasses(cards, model, part);
  }
  std::vector<NamedSurface> surfaces = SelectNamedSurfaces(model.Sets.SideSets);
  std::vector<NodeSet> nodeSets = model.Sets.NodeSets;
  if (IsFlat(mesh))
  {
    MakeNodeSets(mesh, surfaces, nodeSets);
  }
  const bool keepsIds = HaveShortIds(surfaces) && HaveShortIds(nodeSets);
  int next = 0;
  for (const NodeSet& set : nodeSets)
  {
    WriteNodeSet(cards, set, keepsIds ? set.Id : ++next);
  }
  for (const NamedSurface& surface : surfaces)
  {
    WriteSurface(cards, mesh, surface, keepsIds ? surface.Id : ++next);
  }
  next = keepsIds ? LargestId(surfaces, LargestId(nodeSets, 0)) : next;
  for (const ParticlePart& part : model.Particles)
  {
    WriteNodeSet(cards, { 0, part.Name, model.PointsOf(part) }, ++next);
  }
  cards.Close();
}

} // namespace

void WriteNastran(const MeshData& mesh, const std::string& path, Ranks& ranks, bool isPlaneStress)
{
  WriteDeck(mesh, ranks, IsVelocity,
    [&](const DeckModel& model) { WriteFile(model, path, isPlaneStress); });
}

} // namespace vfm
