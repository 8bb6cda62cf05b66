#include "Meshes/Decks/WriteRadioss.h"

#include "Meshes/Decks/DeckCards.h"
#include "Meshes/Decks/DeckModel.h"
#include "Meshes/Decks/DeckParts.h"
#include "Meshes/Files/ElementNodes.h"
#include "Ranks/Errors.h"
#include "Report/Sets/NamedSurfaces.h"
#include "Report/UniqueNames.h"

namespace vfm
{
namespace
{

constexpr Index LargestNumber = 2147483647;
constexpr std::size_t LongestTitle = 100, NumbersInLine = 10;
constexpr std::size_t Normal = 10, Wide = 20; // widths of fields
constexpr std::size_t LongestPropertyTitle = 80;
constexpr int FormatVersion = 2019;
constexpr int TypeOfMass = 1, TypeOfVolume = 2; // of /SPHCEL

/// Writes the head. Equal units of the input and of the work leave all numbers as they are.
void WriteHead(DeckCards& cards, const DeckModel& model)
{
  cards.Line("#RADIOSS STARTER");
  cards.Line("# " + DescribeDeck(model));
  cards.Line("/BEGIN");
  cards.Line("mesh");
  cards.Integer(FormatVersion, Normal).Integer(0, Normal).End();
  for (int line = 0; line < 2; ++line)
  {
    cards.Line("                  kg                   m                   s");
  }
}

void WriteNodes(DeckCards& cards, const MeshData& mesh)
{
  cards.Line("/NODE");
  cards.Line("#  node_ID                  Xc                  Yc                  Zc");
  WriteNodeLines(cards, mesh, Normal, Wide);
}

void WriteTitle(DeckCards& cards, const char* keyword, int id, const std::string& title)
{
  cards.Line(keyword + std::to_string(id));
  cards.Line(title);
}

/// Writes the property of all parts: the default brick with one integration point.
void WriteProperty(DeckCards& cards)
{
  WriteTitle(cards, "/PROP/SOLID/", 1, "solid");
  cards.Line("#   Isolid    Ismstr               Icpre  Itetra10     Inpts   Itetra4    Iframe"
             "                  dn");
  cards.Line("         1         0                   0         0         0         0         0"
             "                   0");
  cards.Line("#                q_a                 q_b                   h            LAMBDA_V"
             "                MU_V");
  cards.Line("                   0                   0                   0                   0"
             "                   0");
  cards.Line("#             dt_min");
  cards.Line("                   0");
}

/// Writes the material of a bin, of linear elasticity.
void WriteElastic(
  DeckCards& cards, const ElasticConstants& elastic, int id, const std::string& title)
{
  WriteTitle(cards, "/MAT/ELAST/", id, title);
  cards.Line("#              RHO_I");
  cards.Real(elastic.Density, Wide).End();
  cards.Line("#                  E                  nu");
  cards.Real(elastic.Modulus, Wide).Real(elastic.Poisson, Wide).End();
}

/// Writes a part, which refers to a material of its number, and its elements.
void WritePart(
  DeckCards& cards, const MeshData& mesh, const MaterialPart& section, UniqueNames& names)
{
  const std::string title = names.Add(PlainTitle(section.Name, LongestTitle));
  if (section.Bin && section.Bin->Elastic)
  {
    WriteElastic(cards, *section.Bin->Elastic, section.Id, title);
  }
  WriteTitle(cards, "/PART/", section.Id, title);
  cards.Line("#  prop_ID    mat_ID subset_ID");
  cards.Integer(1, Normal).Integer(section.Id, Normal).Integer(0, Normal).End();
  cards.Line((mesh.HasHexes() ? "/BRICK/" : "/TETRA4/") + std::to_string(section.Id));
  for (Index element : section.Elements)
  {
    cards.Integer(element + 1, Normal);
    for (int c = 0; c < mesh.Corners; ++c)
    {
      cards.Integer(mesh.Element(element)[c] + 1, Normal);
    }
    cards.End();
  }
}

/// Writes a part of particles with a property of the same number. The masses of particles replace
/// the mass of the property, which must be positive: here their mean.
void WriteParticles(
  DeckCards& cards, const DeckModel& model, const ParticlePart& part, UniqueNames& names)
{
  const ParticleData& particles = *model.Mesh.Particles;
  double mean = 0.0;
  for (Index particle : part.Particles)
  {
    mean += model.HasMasses() ? particles.Mass[particle] : 0.0;
  }
  mean /= static_cast<double>(part.Particles.size());
  const std::string name = names.Add(PlainTitle(part.Name, LongestTitle));
  WriteTitle(cards, "/PROP/TYPE34/", part.Id, name.substr(0, LongestPropertyTitle));
  cards.Line("#                 Mp                  qa                  qb            Alpha_cs"
             "   skew_ID      h_1D");
  cards.Real(mean, Wide);
  cards.Line("                   0                   0                   0         0         0");
  cards.Line("#    Order                   h             Xi_Stab");
  cards.Line("         0                   0                   0");
  WriteTitle(cards, "/PART/", part.Id, name);
  cards.Line("#  prop_ID    mat_ID subset_ID");
  cards.Integer(part.Id, Normal).Integer(part.Material, Normal).Integer(0, Normal).End();
  cards.Line("/SPHCEL/" + std::to_string(part.Id));
  cards.Line("#  node_ID      Type                Mass");
  for (Index particle : part.Particles)
  {
    cards.Integer(model.NodeOf(particle), Normal);
    cards.Integer(model.HasMasses() ? TypeOfMass : TypeOfVolume, Normal);
    cards.Real((model.HasMasses() ? particles.Mass : particles.Volume)[particle], Wide).End();
  }
}

void WriteNodeSet(DeckCards& cards, const NodeSet& set, UniqueNames& names)
{
  WriteTitle(cards, "/GRNOD/NODE/", set.Id, names.Add(PlainTitle(set.Name, LongestTitle)));
  WriteNumbers(cards, set.Points, NumbersInLine, Normal);
}

void WriteSurface(
  DeckCards& cards, const MeshData& mesh, const NamedSurface& surface, UniqueNames& names)
{
  WriteTitle(cards, "/SURF/SEG/", surface.Id, names.Add(PlainTitle(surface.Name, LongestTitle)));
  for (std::size_t s = 0; s < surface.Sides.size(); ++s)
  {
    cards.Integer(static_cast<Index>(s) + 1, Normal);
    WriteFace(cards, mesh, surface.Sides[s], Normal);
  }
}

/// Writes velocities, with rotations of 0.
void WriteVelocities(DeckCards& cards, const MeshData& mesh, const MeshArray& velocity, Index first)
{
  WriteTitle(cards, "/INIVEL/NODE/", 1, PlainTitle(velocity.Name, LongestTitle));
  cards.Line("#  Node_ID   Skew_ID                 Vxt                 Vyt                 Vzt");
  for (Index point = first; point < mesh.NumberOfPoints; ++point)
  {
    cards.Integer(point + 1, Normal).Integer(0, Normal);
    for (int axis = 0; axis < 3; ++axis)
    {
      cards.Real(ValueAt(velocity, point, axis), Wide);
    }
    cards.End();
    cards.Line("                                       0                   0                   0");
  }
}

/// Writes the state of an element at its integration point. The energy is per volume.
void WriteElementState(DeckCards& cards, const DeckState& state, Index element)
{
  const double density = state.Density ? ValueAt(*state.Density, element) : 0;
  const double energy = state.Energy ? ValueAt(*state.Energy, element) * density : 0;
  cards.Real(energy, Wide).Real(density, Wide).End();
  std::array<double, 6> stress{};
  if (state.Stress)
  {
    stress = StressOf(*state.Stress, element);
  }
  for (int component = 0; component < 6; ++component)
  {
    cards.Real(stress[component], Wide);
    if (component % 3 == 2)
    {
      cards.End();
    }
  }
  cards.Real(state.PlasticStrain ? ValueAt(*state.PlasticStrain, element) : 0, Wide).End();
}

void WriteState(DeckCards& cards, const DeckModel& model)
{
  cards.Line("/INIBRI/STRS_FGLO");
  cards.Line("# brick_ID Nb_integr   Isolnod    Isolid      nptr      npts      nptt");
  for (Index element = 0; element < model.Mesh.NumberOfElements; ++element)
  {
    cards.Integer(element + 1, Normal).Integer(1, Normal).Integer(model.Mesh.Corners, Normal);
    cards.Line("         1         1         1         1");
    WriteElementState(cards, model.State, element);
  }
}

void WriteFile(const DeckModel& model, const std::string& path)
{
  const MeshData& mesh = model.Mesh;
  const DeckState& state = model.State;
  RequireNodes(mesh, {}, "OpenRadioss");
  RequireNumbers(model, LargestNumber, "OpenRadioss", ".e, .vtu, .msh of version 4.1");
  if (state.Energy && !state.Density)
  {
    throw InputError("The array " + state.Energy->Name +
      " is an energy per mass, but OpenRadioss requires it per volume: the mesh also needs an "
      "array of the density. Transfer the density, or leave out the energy.");
  }
  DeckCards cards(path, RealForm::Compact);
  WriteHead(cards, model);
  WriteNodes(cards, mesh);
  WriteProperty(cards);
  UniqueNames parts(LongestTitle), nodeNames(LongestTitle), names(LongestTitle);
  for (const MaterialPart& section : model.Materials)
  {
    WritePart(cards, mesh, section, parts);
  }
  for (const ParticlePart& part : model.Particles)
  {
    WriteParticles(cards, model, part, parts);
  }
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    WriteNodeSet(cards, set, nodeNames);
  }
  for (const NamedSurface& surface : SelectNamedSurfaces(model.Sets.SideSets))
  {
    WriteSurface(cards, mesh, surface, names);
  }
  if (state.Velocity)
  {
    WriteVelocities(cards, mesh, *state.Velocity, state.FirstVelocity);
  }
  if (state.Density || state.Stress || state.PlasticStrain)
  {
    WriteState(cards, model);
  }
  cards.Line("/END");
  cards.Close();
}

} // namespace

void WriteRadioss(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteDeck(mesh, ranks, IsState, [&](const DeckModel& model) { WriteFile(model, path); });
}

} // namespace vfm
