#include "Meshes/Decks/WriteLsDyna.h"

#include "Meshes/Decks/DeckCards.h"
#include "Meshes/Decks/DeckModel.h"
#include "Meshes/Decks/DeckParts.h"
#include "Meshes/Files/ElementNodes.h"
#include "Report/FlatData.h"
#include "Report/Sets/NamedSurfaces.h"
#include "Report/UniqueNames.h"

#include <algorithm>
#include <iterator>

namespace vfm
{
namespace
{

constexpr int LargestNumber = 99999999;
constexpr std::size_t LongestTitle = 70, NumbersInLine = 8;
constexpr std::size_t Narrow = 8, Normal = 10, Wide = 16; // widths of fields
constexpr const char* OtherFormats = ".rad, .inp, .e";
/// Formulations of *SECTION_SOLID: constant stress, tetrahedron with one point; of 20 nodes, of 10.
constexpr int HexForm = 1, TetForm = 10, Hex20Form = 23, Tet10Form = 16;
/// Formulations of *SECTION_SHELL in the plane of x and y.
constexpr int PlaneStressForm = 12, PlaneStrainForm = 13;
constexpr int NodesInLine = 10; // of an element with mid nodes

int FormOf(const MeshData& mesh)
{
  const bool isLinear = mesh.MidsPerElement == 0;
  return mesh.HasHexes() ? (isLinear ? HexForm : Hex20Form) : (isLinear ? TetForm : Tet10Form);
}

void WriteNodes(DeckCards& cards, const MeshData& mesh)
{
  cards.Line("*NODE");
  cards.Line("$    NID               X               Y               Z");
  WriteNodeLines(cards, mesh, Narrow, Wide);
}

void WritePart(DeckCards& cards, const std::string& name, int id, int section, int material)
{
  cards.Line("*PART");
  cards.Line(name);
  cards.Line("$      PID     SECID       MID");
  cards.Integer(id, Normal).Integer(section, Normal).Integer(material, Normal).End();
}

void WriteSection(DeckCards& cards, const MeshData& mesh, bool isPlaneStress)
{
  const bool isFlat = IsFlat(mesh);
  cards.Line(isFlat ? "*SECTION_SHELL" : "*SECTION_SOLID");
  cards.Line("$    SECID    ELFORM");
  const int formOfPlane = isPlaneStress ? PlaneStressForm : PlaneStrainForm;
  cards.Integer(1, Normal).Integer(isFlat ? formOfPlane : FormOf(mesh), Normal).End();
  if (isFlat)
  {
    cards.Line("$       T1        T2        T3        T4");
    cards.Line("         1         1         1         1");
  }
}

/// Writes the parts; each refers to a material of its number. Parts of particles come last, and
/// refer to the materials of the particles.
void WriteParts(DeckCards& cards, const DeckModel& model, bool isPlaneStress)
{
  WriteSection(cards, model.Mesh, isPlaneStress);
  UniqueNames names(LongestTitle);
  for (const MaterialPart& section : model.Materials)
  {
    WritePart(cards, names.Add(PlainTitle(section.Name, LongestTitle)), section.Id, 1, section.Id);
  }
  if (model.Particles.empty())
  {
    return;
  }
  cards.Line("*SECTION_SPH");
  cards.Line("$    SECID");
  cards.Integer(2, Normal).End();
  for (const ParticlePart& part : model.Particles)
  {
    WritePart(cards, names.Add(PlainTitle(part.Name, LongestTitle)), part.Id, 2, part.Material);
  }
}

/// Writes a material for each bin that has elastic constants, and each material that has bins as a
/// set of parts.
void WriteBins(DeckCards& cards, const DeckModel& model)
{
  for (const MaterialPart& section : model.Materials)
  {
    if (section.Bin && section.Bin->Elastic)
    {
      const ElasticConstants& elastic = *section.Bin->Elastic;
      cards.Line("*MAT_ELASTIC");
      cards.Line("$      MID        RO         E        PR");
      cards.Integer(section.Id, Normal).Real(elastic.Density, Normal);
      cards.Real(elastic.Modulus, Normal).Real(elastic.Poisson, Normal).End();
    }
  }
  UniqueNames names(LongestTitle);
  for (const MaterialPart& whole : model.Undivided)
  {
    cards.Line("*SET_PART_LIST_TITLE");
    cards.Line(names.Add(PlainTitle(whole.Name, LongestTitle)));
    cards.Integer(whole.Id, Normal).End();
    std::vector<Index> ids; // from 0, as WriteNumbers takes them
    for (const MaterialPart& section : model.Materials)
    {
      if (section.Material == whole.Material)
      {
        ids.push_back(section.Id - 1);
      }
    }
    WriteNumbers(cards, ids, NumbersInLine, Normal);
  }
}

/// Writes the particles with their masses, or with volumes, which are negative.
void WriteParticles(DeckCards& cards, const DeckModel& model)
{
  if (model.Particles.empty())
  {
    return;
  }
  const ParticleData& particles = *model.Mesh.Particles;
  cards.Line("*ELEMENT_SPH");
  cards.Line("$    NID     PID            MASS");
  for (const ParticlePart& part : model.Particles)
  {
    for (Index particle : part.Particles)
    {
      cards.Integer(model.NodeOf(particle), Narrow).Integer(part.Id, Narrow);
      cards.Real(model.HasMasses() ? particles.Mass[particle] : -particles.Volume[particle], Wide);
      cards.End();
    }
  }
}

void WriteElements(DeckCards& cards, const MeshData& mesh, const MaterialPart& section)
{
  const int nodes = IsFlat(mesh) ? 4 : 8;
  for (Index element : section.Elements)
  {
    cards.Integer(element + 1, Narrow).Integer(section.Id, Narrow);
    for (int n = 0; n < nodes; ++n)
    {
      cards.Integer(mesh.Element(element)[std::min(n, mesh.Corners - 1)] + 1, Narrow);
    }
    cards.End();
  }
}

/// Writes elements of 20 or 10 nodes, in VTK's order, each on lines of its own.
void WriteCurvedElements(DeckCards& cards, const MeshData& mesh, const MaterialPart& section)
{
  ElementNodes nodes(mesh, {});
  for (Index element : section.Elements)
  {
    cards.Integer(element + 1, Narrow).Integer(section.Id, Narrow).End();
    const Index* points = nodes.Of(element);
    for (int n = 0; n < nodes.Count(); ++n)
    {
      cards.Integer(points[n] + 1, Narrow);
      if ((n + 1) % NodesInLine == 0)
      {
        cards.End();
      }
    }
  }
}

void WriteNodeSet(DeckCards& cards, const NodeSet& set, UniqueNames& names)
{
  cards.Line("*SET_NODE_LIST_TITLE");
  cards.Line(names.Add(PlainTitle(set.Name, LongestTitle)));
  cards.Integer(set.Id, Normal).End();
  WriteNumbers(cards, set.Points, NumbersInLine, Normal);
}

void WriteSurface(
  DeckCards& cards, const MeshData& mesh, const NamedSurface& surface, UniqueNames& names)
{
  cards.Line("*SET_SEGMENT_TITLE");
  cards.Line(names.Add(PlainTitle(surface.Name, LongestTitle)));
  cards.Integer(surface.Id, Normal).End();
  for (const ElementSide& side : surface.Sides)
  {
    WriteFace(cards, mesh, side, Normal);
  }
}

void WriteVelocities(DeckCards& cards, const MeshData& mesh, const MeshArray& velocity, Index first)
{
  cards.Line("*INITIAL_VELOCITY_NODE");
  cards.Line("$      NID        VX        VY        VZ");
  for (Index point = first; point < mesh.NumberOfPoints; ++point)
  {
    cards.Integer(point + 1, Normal);
    for (int axis = 0; axis < 3; ++axis)
    {
      cards.Real(ValueAt(velocity, point, axis), Normal);
    }
    cards.End();
  }
}

/// Writes numbers in wide fields, five in a line.
void WriteWide(DeckCards& cards, const std::vector<double>& numbers)
{
  constexpr std::size_t inLine = 5;
  for (std::size_t n = 0; n < numbers.size(); ++n)
  {
    cards.Real(numbers[n], Wide);
    if ((n + 1) % inLine == 0 || n + 1 == numbers.size())
    {
      cards.End();
    }
  }
}

/// Writes stresses and plastic strains, at one integration point and in wide fields. Those of a
/// plane begin with the position of the point across it.
void WriteStresses(DeckCards& cards, const DeckModel& model)
{
  const DeckState& state = model.State;
  const bool isFlat = IsFlat(model.Mesh);
  cards.Line(isFlat ? "*INITIAL_STRESS_SHELL" : "*INITIAL_STRESS_SOLID");
  cards.Line(isFlat ? "$      EID    NPLANE    NTHICK     NHISV    NTENSR     LARGE"
                    : "$      EID      NINT     NHISV     LARGE");
  for (Index element = 0; element < model.Mesh.NumberOfElements; ++element)
  {
    cards.Integer(element + 1, Normal);
    cards.Line(isFlat ? "         1         1         0         0         1"
                      : "         1         0         1");
    std::vector<double> numbers(isFlat ? 1 : 0, 0.0);
    const std::array<double, 6> stress =
      state.Stress ? StressOf(*state.Stress, element) : std::array<double, 6>{};
    numbers.insert(numbers.end(), stress.begin(), stress.end());
    numbers.push_back(state.PlasticStrain ? ValueAt(*state.PlasticStrain, element) : 0);
    WriteWide(cards, numbers);
  }
}

/// Returns the surfaces of the file: of a split interface those of both sides, for contact.
std::vector<NamedSurface> SelectSurfaces(const DeckModel& model)
{
  const auto isSplit = [&model](const SideSet& set)
  {
    const std::array<int, 2> pair{ { set.Materials[1], set.Materials[0] } };
    return set.Kind == SurfaceKind::Interface &&
      std::any_of(model.SplitFaces.begin(), model.SplitFaces.end(),
        [&pair](const SplitFace& face) { return face.Materials == pair; });
  };
  std::vector<NamedSurface> surfaces = SelectNamedSurfaces(model.Sets.SideSets);
  std::copy_if(
    model.Sets.SideSets.begin(), model.Sets.SideSets.end(), std::back_inserter(surfaces), isSplit);
  return surfaces;
}

void WriteFile(const DeckModel& model, const std::string& path, bool isPlaneStress)
{
  const MeshData& mesh = model.Mesh;
  RequireNodes(mesh, { 12, 6 }, "LS-DYNA");
  RequireNumbers(model, LargestNumber, "LS-DYNA", OtherFormats);
  RequireIds(model, LargestNumber, "LS-DYNA", OtherFormats);
  RequirePlaneOfXY(model, "LS-DYNA");
  DeckCards cards(path, RealForm::Compact);
  cards.Line("*KEYWORD");
  cards.Line("$ " + DescribeDeck(model));
  WriteNodes(cards, mesh);
  WriteParts(cards, model, isPlaneStress);
  WriteBins(cards, model);
  const bool isLinear = mesh.MidsPerElement == 0;
  cards.Line(IsFlat(mesh)         ? "*ELEMENT_SHELL"
      : mesh.MidsPerElement == 12 ? "*ELEMENT_SOLID_H20"
                                  : "*ELEMENT_SOLID");
  cards.Line(IsFlat(mesh) ? "$    EID     PID      N1      N2      N3      N4"
      : isLinear
      ? "$    EID     PID      N1      N2      N3      N4      N5      N6      N7      N8"
      : "$    EID     PID");
  for (const MaterialPart& section : model.Materials)
  {
    (isLinear ? WriteElements : WriteCurvedElements)(cards, mesh, section);
  }
  WriteParticles(cards, model);
  UniqueNames nodeNames(LongestTitle), names(LongestTitle);
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    WriteNodeSet(cards, set, nodeNames);
  }
  for (const NamedSurface& surface : SelectSurfaces(model))
  {
    WriteSurface(cards, mesh, surface, names);
  }
  if (model.State.Velocity)
  {
    WriteVelocities(cards, mesh, *model.State.Velocity, model.State.FirstVelocity);
  }
  if (model.State.Stress || model.State.PlasticStrain)
  {
    WriteStresses(cards, model);
  }
  cards.Line("*END");
  cards.Close();
}

} // namespace

void WriteLsDyna(const MeshData& mesh, const std::string& path, Ranks& ranks, bool isPlaneStress)
{
  WriteDeck(
    mesh, ranks, IsState, [&](const DeckModel& model) { WriteFile(model, path, isPlaneStress); });
}

} // namespace vfm
