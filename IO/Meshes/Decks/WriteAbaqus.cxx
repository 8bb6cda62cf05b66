#include "Meshes/Decks/WriteAbaqus.h"

#include "Meshes/Decks/AbaqusText.h"
#include "Meshes/Decks/DeckCards.h"
#include "Meshes/Decks/DeckModel.h"
#include "Meshes/Decks/WriteConnections.h"
#include "Meshes/Decks/WriteEquations.h"
#include "Meshes/Files/ElementNodes.h"
#include "Meshes/Files/OutputFile.h"
#include "Report/FlatData.h"

#include <filesystem>

namespace vfm
{
namespace
{

constexpr Index LargestNumber = 999999999;
constexpr std::size_t NumbersInLine = 8; // Abaqus reads 16
constexpr int NodesInLine = 16;          // numbers in a line of an element, with its own
/// Number of characters of a number that Abaqus and CalculiX read; they ignore further ones.
constexpr std::size_t NumberLength = 20;
/// Numbers of the faces in Abaqus, indexed by the numbers in VTK. S1 of a hexahedron has its
/// corners 1 to 4.
constexpr int HexFaces[6] = { 6, 4, 3, 5, 1, 2 };
constexpr int TetFaces[4] = { 2, 3, 4, 1 };
constexpr int FlatFaces[4] = { 1, 2, 3, 4 };

/// Names of the element sets of a section.
struct SectionNames
{
  std::string Block; ///< EB and the id
  std::string Set;   ///< name of the material
};

std::string BlockName(const MaterialPart& section)
{
  return "EB" + std::to_string(section.Id);
}

/// Returns the surfaces of all sides of the domain, or all other surfaces.
std::vector<DeckSurface> MakeSurfaces(
  const std::vector<SideSet>& sets, AbaqusNames& names, bool ofDomain)
{
  std::vector<DeckSurface> surfaces;
  for (const SideSet& set : sets)
  {
    if ((set.DomainSide != NoSide) == ofDomain)
    {
      surfaces.push_back({ names.Add(set.Name), &set });
    }
  }
  return surfaces;
}

void WriteHeading(OutputFile& file, const DeckModel& model, const std::vector<SectionNames>& names)
{
  constexpr std::size_t longest = 120;
  file.Add("*HEADING\n" + DescribeDeck(model) + "\n");
  for (std::size_t s = 0; s < names.size(); ++s)
  {
    const MaterialPart& section = model.Materials[s];
    file.Add("** " + names[s].Set + ": material " + std::to_string(section.Id) + ", " +
      PlainTitle(section.Name, longest) + "\n");
  }
}

void WriteNodes(OutputFile& file, const MeshData& mesh)
{
  file.Add("*NODE, NSET=NALL\n");
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    file.Add(point + 1);
    for (int axis = 0; axis < 3; ++axis)
    {
      file.Add(",");
      file.Add(DeckReal(mesh.Point(point)[axis], NumberLength, RealForm::Plain).Text());
    }
    file.Add("\n");
  }
}

std::string TypeOfElements(const MeshData& mesh, const AbaqusForm& form)
{
  if (IsFlat(mesh))
  {
    return (form.IsPlaneStress ? "CPS" : "CPE") + std::to_string(mesh.Corners);
  }
  return "C3D" + std::to_string(mesh.NodesPerElement()) +
    (form.IsReduced && mesh.MidsPerElement == 12 ? "R" : "");
}

/// Writes the elements of a section. Nodes have the same order as in VTK.
void WriteElements(OutputFile& file, const MeshData& mesh, const MaterialPart& section,
  const std::string& type, const std::string& set)
{
  file.Add("*ELEMENT, TYPE=" + type + ", ELSET=" + set + "\n");
  ElementNodes nodes(mesh, {});
  for (Index element : section.Elements)
  {
    file.Add(element + 1);
    const Index* points = nodes.Of(element);
    for (int n = 0; n < nodes.Count(); ++n)
    {
      file.Add(n + 1 == NodesInLine ? ",\n" : ",");
      file.Add(points[n] + 1);
    }
    file.Add("\n");
  }
}

/// Writes the cohesive elements of all blocks, numbered after the elements of the mesh.
void WriteCohesive(OutputFile& file, const DeckModel& model, AbaqusNames& names)
{
  const auto corners = static_cast<std::size_t>(CohesiveCorners(model.Mesh));
  Index number = model.Mesh.NumberOfElements;
  for (const CohesiveBlock& block : model.Cohesive)
  {
    file.Add("*ELEMENT, TYPE=");
    file.Add(corners == 8 ? "COH3D8" : "COH3D6");
    file.Add(", ELSET=" + names.Add(block.Name) + "\n");
    for (std::size_t c = 0; c < block.Points.size(); ++c)
    {
      if (c % corners == 0)
      {
        file.Add(++number);
      }
      file.Add(",");
      file.Add(block.Points[c] + 1);
      file.Add(c % corners + 1 == corners ? "\n" : "");
    }
  }
}

/// Writes lines of numbers. deal.II requires a comma after a single one.
void WriteNumbers(OutputFile& file, const std::vector<Index>& indices)
{
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    file.Add(indices[i] + 1);
    file.Add((i + 1) % NumbersInLine == 0 || i + 1 == indices.size() ? ",\n" : ",");
  }
}

/// Writes the sets named after bins and materials, and of all elements. deal.II fails to read sets
/// of sets, and meshio sets of several ranges.
void WriteElementSets(OutputFile& file, const DeckModel& model,
  const std::vector<SectionNames>& names, const std::vector<std::string>& undivided)
{
  for (std::size_t s = 0; s < names.size(); ++s)
  {
    file.Add("*ELSET, ELSET=" + names[s].Set + "\n");
    WriteNumbers(file, model.Materials[s].Elements);
  }
  for (std::size_t u = 0; u < undivided.size(); ++u)
  {
    file.Add("*ELSET, ELSET=" + undivided[u] + "\n");
    WriteNumbers(file, model.Undivided[u].Elements);
  }
  file.Add("*ELSET, ELSET=EALL, GENERATE\n1,");
  file.Add(model.Mesh.NumberOfElements);
  file.Add(",1\n");
}

void WriteNodeSet(OutputFile& file, const std::string& name, const std::vector<Index>& points)
{
  file.Add("*NSET, NSET=" + name + "\n");
  WriteNumbers(file, points);
}

/// Writes the nodes of the particles of each material as a set, and a point mass at each, numbered
/// after all elements. Abaqus and CalculiX both read these; each mass needs an element set of its
/// own. Particles of Abaqus/Explicit have one volume (PC3D) per section, so they would lose mass,
/// or are rigid and of a density that only distributions give (PD3D); CalculiX refuses both.
void WriteParticles(
  OutputFile& file, const DeckModel& model, AbaqusNames& names, AbaqusNames& nodeNames)
{
  const Index elements = model.Mesh.NumberOfElements + CountElements(model.Cohesive);
  for (const ParticlePart& part : model.Particles)
  {
    WriteNodeSet(file, nodeNames.Add(part.Name), model.PointsOf(part));
    if (!model.HasMasses())
    {
      continue;
    }
    std::vector<Index> numbers; // from 0
    for (Index particle : part.Particles)
    {
      numbers.push_back(elements + particle);
      const std::string set = names.Add("PARTICLE_" + std::to_string(particle + 1));
      file.Add("*ELEMENT, TYPE=MASS, ELSET=" + set + "\n");
      file.Add(numbers.back() + 1);
      file.Add(",");
      file.Add(model.NodeOf(particle));
      file.Add("\n*MASS, ELSET=" + set + "\n");
      file.Add(
        DeckReal(model.Mesh.Particles->Mass[particle], NumberLength, RealForm::Plain).Text());
      file.Add("\n");
    }
    file.Add("*ELSET, ELSET=" + names.Add(part.Name) + "\n");
    WriteNumbers(file, numbers);
  }
}

/// Writes lines with a node, a direction from 1, and the component of the velocity.
void WriteVelocity(OutputFile& file, const MeshData& mesh, const MeshArray& velocity, Index first)
{
  file.Add("*INITIAL CONDITIONS, TYPE=VELOCITY\n");
  for (Index point = first; point < mesh.NumberOfPoints; ++point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      file.Add(point + 1);
      file.Add(",");
      file.Add(axis + 1);
      file.Add(",");
      file.Add(DeckReal(ValueAt(velocity, point, axis), NumberLength, RealForm::Plain).Text());
      file.Add("\n");
    }
  }
}

void WriteSurface(OutputFile& file, const DeckSurface& surface, const MeshData& mesh)
{
  const int* faces = IsFlat(mesh) ? FlatFaces : mesh.HasHexes() ? HexFaces : TetFaces;
  file.Add("*SURFACE, NAME=" + surface.Name + ", TYPE=ELEMENT\n");
  for (const ElementSide& side : surface.Set->Sides)
  {
    file.Add(side.Element + 1);
    file.Add(",S");
    file.Add(faces[side.Side]);
    file.Add("\n");
  }
}

/// Writes a material and a section for each bin that has elastic constants.
void WriteConstants(
  OutputFile& file, const DeckModel& model, const std::vector<SectionNames>& names)
{
  const auto real = [](double value)
  { return std::string(DeckReal(value, NumberLength, RealForm::Plain).Text()); };
  for (std::size_t s = 0; s < names.size(); ++s)
  {
    const std::optional<MaterialBin>& bin = model.Materials[s].Bin;
    if (bin && bin->Elastic)
    {
      file.Add("*MATERIAL, NAME=" + names[s].Set + "\n*ELASTIC\n" + real(bin->Elastic->Modulus) +
        "," + real(bin->Elastic->Poisson) + "\n*DENSITY\n" + real(bin->Elastic->Density) +
        ",\n*SOLID SECTION, ELSET=" + names[s].Block + ", MATERIAL=" + names[s].Set + "\n");
    }
  }
}

/// Returns the names of the sets of each section.
std::vector<SectionNames> NameSections(const DeckModel& model, AbaqusNames& names)
{
  std::vector<SectionNames> sections;
  for (const MaterialPart& section : model.Materials)
  {
    sections.push_back({ BlockName(section), names.Add(section.Name) });
  }
  return sections;
}

/// Returns the names of the sets of materials that have bins, which they get before their bins.
std::vector<std::string> NameUndivided(const DeckModel& model, AbaqusNames& names)
{
  std::vector<std::string> sets;
  for (const MaterialPart& part : model.Undivided)
  {
    sets.push_back(names.Add(part.Name));
  }
  return sets;
}

/// Writes the whole mesh. The sides of the domain get their names first, so that X_MIN is a side of
/// the domain even if a material has this name.
void WriteFile(const DeckModel& model, const std::string& path, const AbaqusForm& form)
{
  const MeshData& mesh = model.Mesh;
  RequireNodes(mesh, { 12, 6 }, "Abaqus");
  RequirePlaneOfXY(model, "Abaqus");
  RequireNumbers(model, LargestNumber, "Abaqus", ".e, .msh, .vtu");
  AbaqusNames names, nodeNames;
  names.Add("EALL");
  nodeNames.Add("NALL");
  for (const MaterialPart& section : model.Materials)
  {
    names.Add(BlockName(section));
  }
  std::vector<DeckSurface> surfaces = MakeSurfaces(model.Sets.SideSets, names, true);
  const std::vector<std::string> undivided = NameUndivided(model, names);
  const std::vector<SectionNames> sections = NameSections(model, names);
  for (DeckSurface& surface : MakeSurfaces(model.Sets.SideSets, names, false))
  {
    surfaces.push_back(std::move(surface));
  }

  OutputSet files(path);
  OutputFile file(path, files);
  WriteHeading(file, model, sections);
  WriteNodes(file, mesh);
  for (std::size_t s = 0; s < sections.size(); ++s)
  {
    WriteElements(file, mesh, model.Materials[s], TypeOfElements(mesh, form), sections[s].Block);
  }
  WriteElementSets(file, model, sections, undivided);
  WriteConstants(file, model, sections);
  WriteCohesive(file, model, names);
  const NodeTies ties = FindNodeTies(model);
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    WriteNodeSet(file, nodeNames.Add(set.Name), RemoveTiedNodes(set, ties).Points);
  }
  for (const DeckSurface& surface : surfaces)
  {
    WriteSurface(file, surface, mesh);
  }
  WriteConnections(model, ties, surfaces, names, file);
  WriteParticles(file, model, names, nodeNames);
  if (model.State.Velocity)
  {
    WriteVelocity(file, mesh, *model.State.Velocity, model.State.FirstVelocity);
  }
  std::filesystem::path equations(path);
  equations.replace_filename(
    equations.stem().string() + "_periodic" + equations.extension().string());
  if (WriteEquations(mesh, equations.string(), files))
  {
    file.Add("*INCLUDE, INPUT=" + equations.filename().string() + "\n");
  }
  file.Close();
  files.Rename();
}

} // namespace

void WriteAbaqus(
  const MeshData& mesh, const std::string& path, Ranks& ranks, const AbaqusForm& form)
{
  WriteDeck(mesh, ranks, IsVelocity, [&](const DeckModel& model) { WriteFile(model, path, form); });
}

} // namespace vfm
