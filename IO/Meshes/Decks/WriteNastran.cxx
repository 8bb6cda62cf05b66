#include "Meshes/Decks/WriteNastran.h"

#include "Meshes/Decks/DeckCards.h"
#include "Meshes/Decks/DeckModel.h"
#include "Meshes/Files/ElementNodes.h"
#include "Report/Sets/NamedSurfaces.h"

#include <algorithm>
#include <numeric>

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

void WriteElements(DeckCards& cards, const MeshData& mesh, const MaterialPart& section)
{
  constexpr int inFirstLine = 6;
  for (Index element : section.Elements)
  {
    cards.Text(mesh.HasHexes() ? "CHEXA   " : "CTETRA  ");
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

void WriteSection(DeckCards& cards, const MeshData& mesh, const MaterialPart& section)
{
  WriteComment(cards, "Material " + std::to_string(section.Id) + ": " + section.Name);
  cards.Text("PSOLID  ").Integer(section.Id, Narrow).Integer(section.Id, Narrow).End();
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

void WriteFile(const DeckModel& model, const std::string& path)
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
    WriteSection(cards, mesh, section);
  }
  for (const ParticlePart& part : model.Particles)
  {
    WriteMasses(cards, model, part);
  }
  const std::vector<NamedSurface> surfaces = SelectNamedSurfaces(model.Sets.SideSets);
  const bool keepsIds = HaveShortIds(surfaces) && HaveShortIds(model.Sets.NodeSets);
  int next = 0;
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    WriteNodeSet(cards, set, keepsIds ? set.Id : ++next);
  }
  for (const NamedSurface& surface : surfaces)
  {
    WriteSurface(cards, mesh, surface, keepsIds ? surface.Id : ++next);
  }
  next = keepsIds ? LargestId(surfaces, LargestId(model.Sets.NodeSets, 0)) : next;
  for (const ParticlePart& part : model.Particles)
  {
    WriteNodeSet(cards, { 0, part.Name, model.PointsOf(part) }, ++next);
  }
  cards.Close();
}

} // namespace

void WriteNastran(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteDeck(mesh, ranks, IsVelocity, [&](const DeckModel& model) { WriteFile(model, path); });
}

} // namespace vfm
