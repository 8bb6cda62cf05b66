#include "Meshes/Decks/WriteRadioss.h"

#include "Meshes/Decks/DeckCards.h"
#include "Meshes/Decks/DeckModel.h"
#include "Meshes/Decks/DeckParts.h"
#include "Meshes/Files/ElementNodes.h"
#include "Ranks/Errors.h"
#include "Report/DomainSides.h"
#include "Report/FlatData.h"
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

/// Axes of the mesh that are the axes of the file.
using FileAxes = std::array<int, 3>;

FileAxes AxesOf(const MeshData& mesh)
{
  if (!IsFlat(mesh))
  {
    return { { 0, 1, 2 } };
  }
  const int across = static_cast<int>(NumbersOfField(mesh.Fields, FlatAxisName).at(0));
  return { { across, (across + 1) % 3, (across + 2) % 3 } };
}

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
  if (IsFlat(model.Mesh))
  {
    cards.Line("/ANALY");
    cards.Line("#    N2D3D             IPARITH      ISUB");
    cards.Line("         2                   0         0");
  }
}

void WriteNodes(DeckCards& cards, const MeshData& mesh)
{
  cards.Line("/NODE");
  cards.Line("#  node_ID                  Xc                  Yc                  Zc");
  if (!IsFlat(mesh))
  {
    return WriteNodeLines(cards, mesh, Normal, Wide);
  }
  const FileAxes axes = AxesOf(mesh);
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    const double* x = mesh.Point(point);
    cards.Integer(point + 1, Normal).Real(0.0, Wide);
    cards.Real(x[axes[1]], Wide).Real(x[axes[2]], Wide).End();
  }
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
  const std::string keyword = IsFlat(mesh) ? "/QUAD/" : mesh.HasHexes() ? "/BRICK/" : "/TETRA4/";
  cards.Line(keyword + std::to_string(section.Id));
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
    if (IsFlat(mesh))
    {
      const FaceIds points = PointsOfSide(mesh, surface.Sides[s]);
      cards.Integer(points[0] + 1, Normal).Integer(points[1] + 1, Normal).End();
      continue;
    }
    WriteFace(cards, mesh, surface.Sides[s], Normal);
  }
}

/// Writes velocities, with rotations of 0.
void WriteVelocities(DeckCards& cards, const MeshData& mesh, const MeshArray& velocity, Index first)
{
  WriteTitle(cards, "/INIVEL/NODE/", 1, PlainTitle(velocity.Name, LongestTitle));
  cards.Line("#  Node_ID   Skew_ID                 Vxt                 Vyt                 Vzt");
  const FileAxes axes = AxesOf(mesh);
  for (Index point = first; point < mesh.NumberOfPoints; ++point)
  {
    cards.Integer(point + 1, Normal).Integer(0, Normal);
    for (int axis : axes)
    {
      cards.Real(ValueAt(velocity, point, axis), Wide);
    }
    cards.End();
    cards.Line("                                       0                   0                   0");
  }
}

/// Returns the energy per volume.
double EnergyOf(const DeckState& state, Index element)
{
  return state.Energy ? ValueAt(*state.Energy, element) * ValueAt(*state.Density, element) : 0;
}

/// Writes the state of an element at its integration point.
void WriteElementState(DeckCards& cards, const DeckState& state, Index element)
{
  const double density = state.Density ? ValueAt(*state.Density, element) : 0;
  cards.Real(EnergyOf(state, element), Wide).Real(density, Wide).End();
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

/// Writes a value of each quad.
template <class Value>
void WriteQuadValues(
  DeckCards& cards, const DeckModel& model, const char* keyword, const Value& value)
{
  cards.Line(keyword);
  cards.Line("#  quad_ID               Value");
  for (Index element = 0; element < model.Mesh.NumberOfElements; ++element)
  {
    cards.Integer(element + 1, Normal).Real(value(element), Wide).End();
  }
}

/// Writes stresses yy, zz, xx and yz of quads, in axes of the file.
void WriteQuadStresses(DeckCards& cards, const DeckModel& model)
{
  constexpr int Shears[3] = { 4, 5, 3 }; // yz, xz, xy in StressOf, by the axis without it
  const FileAxes axes = AxesOf(model.Mesh);
  cards.Line("/INIQUA/STRESS");
  cards.Line("#  quad_ID             Sigma_y             Sigma_z             Sigma_x"
             "            Sigma_yz");
  for (Index element = 0; element < model.Mesh.NumberOfElements; ++element)
  {
    const std::array<double, 6> stress = StressOf(*model.State.Stress, element);
    cards.Integer(element + 1, Normal);
    cards.Real(stress[axes[1]], Wide).Real(stress[axes[2]], Wide).Real(stress[axes[0]], Wide);
    cards.Real(stress[Shears[axes[0]]], Wide).End();
  }
}

void WriteQuadState(DeckCards& cards, const DeckModel& model)
{
  const DeckState& state = model.State;
  if (state.Density)
  {
    WriteQuadValues(
      cards, model, "/INIQUA/DENS", [&](Index e) { return ValueAt(*state.Density, e); });
  }
  if (state.Energy)
  {
    WriteQuadValues(cards, model, "/INIQUA/ENER", [&](Index e) { return EnergyOf(state, e); });
  }
  if (state.PlasticStrain)
  {
    WriteQuadValues(
      cards, model, "/INIQUA/EPSP", [&](Index e) { return ValueAt(*state.PlasticStrain, e); });
  }
  if (state.Stress)
  {
    WriteQuadStresses(cards, model);
  }
}

void WriteState(DeckCards& cards, const DeckModel& model)
{
  if (IsFlat(model.Mesh))
  {
    return WriteQuadState(cards, model);
  }
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
  if (IsFlat(mesh) && !FrameOfDomain(mesh).IsIdentity())
  {
    throw InputError("OpenRadioss has elements of the plane of y and z only: make the mesh with "
                     "ImageAxes. Formats that have others: .e, .vtu, .bdf, .xdmf.");
  }
  if (IsFlat(mesh) && mesh.Corners == 3)
  {
    throw InputError("OpenRadioss has triangles of a plane for one law of fluids only: make "
                     "quadrilaterals. Formats that have triangles: .k, .inp, .bdf, .e.");
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
