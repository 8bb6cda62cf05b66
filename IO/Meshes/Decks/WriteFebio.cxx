#include "Meshes/Decks/WriteFebio.h"

#include "Meshes/Decks/DeckModel.h"
#include "Meshes/Files/ElementNodes.h"
#include "Meshes/Files/OutputFile.h"
#include "Meshes/Particles/GatherParticles.h"
#include "Meshes/Particles/WriteParticles.h"
#include "Meshes/Vtk/VtuText.h"
#include "Report/MeshArrays.h"
#include "Report/Sets/NamedSurfaces.h"
#include "Report/UniqueNames.h"

#include <algorithm>
#include <numeric>

namespace vfm
{
namespace
{

constexpr std::size_t LongestName = 100;
constexpr const char* AllElements = "all_elements";

/// Returns a name without the characters that separate names in expressions of FEBio.
std::string FebioName(const std::string& name)
{
  const auto isPlain = [](char c)
  {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
      c == '.' || c == '_';
  };
  std::string plain;
  for (char c : name)
  {
    plain += isPlain(c) ? c : '_';
  }
  return plain.empty() ? "_" : plain;
}

/// Returns whether an array is one that MeshData holds: real numbers, one per element.
bool IsElementData(const MeshArray& array)
{
  return IsRealType(array.Type) && array.Components == 1;
}

std::string Quoted(const std::string& text)
{
  return "\"" + text + "\"";
}

void AddLine(OutputFile& file, const std::string& text)
{
  file.Add(text + "\n");
}

/// Adds numbers, counted from 1, with commas between them.
template <class Numbers>
void AddList(OutputFile& file, const Numbers& numbers)
{
  bool isFirst = true;
  for (const Index number : numbers)
  {
    file.Add(isFirst ? "" : ",");
    file.Add(number + 1);
    isFirst = false;
  }
}

/// Adds a set of numbers, in one line, because some readers take no spaces between them.
void AddSet(
  OutputFile& file, const char* kind, const std::string& name, const std::vector<Index>& numbers)
{
  file.Add(std::string("    <") + kind + " name=" + Quoted(name) + ">");
  AddList(file, numbers);
  AddLine(file, std::string("</") + kind + ">");
}

void AddNodes(OutputFile& file, const MeshData& mesh)
{
  AddLine(file, "    <Nodes name=\"all_nodes\">");
  for (Index point = 0; point < mesh.NumberOfPoints; ++point)
  {
    file.Add("      <node id=\"");
    file.Add(point + 1);
    file.Add("\">");
    for (int a = 0; a < 3; ++a)
    {
      file.Add(a > 0 ? "," : "");
      file.AddReal(mesh.Point(point)[a]);
    }
    AddLine(file, "</node>");
  }
  AddLine(file, "    </Nodes>");
}

const char* TypeOf(const MeshData& mesh)
{
  const bool isLinear = mesh.MidsPerElement == 0;
  return mesh.HasHexes() ? (isLinear ? "hex8" : "hex20") : (isLinear ? "tet4" : "tet10");
}

void AddElements(
  OutputFile& file, const MeshData& mesh, const MaterialPart& part, const std::string& name)
{
  ElementNodes nodes(mesh, {});
  AddLine(file,
    std::string("    <Elements type=") + Quoted(TypeOf(mesh)) + " name=" + Quoted(name) + ">");
  for (Index element : part.Elements)
  {
    const Index* points = nodes.Of(element);
    file.Add("      <elem id=\"");
    file.Add(element + 1);
    file.Add("\">");
    AddList(file, std::vector<Index>(points, points + nodes.Count()));
    AddLine(file, "</elem>");
  }
  AddLine(file, "    </Elements>");
}

void AddSurface(
  OutputFile& file, const MeshData& mesh, const NamedSurface& surface, const std::string& name)
{
  AddLine(file, "    <Surface name=" + Quoted(name) + ">");
  Index number = 0;
  for (const ElementSide& side : surface.Sides)
  {
    const std::vector<Index> points = NodesOfSide(mesh, side.Element, side.Side);
    const std::string type = (mesh.HasHexes() ? "quad" : "tri") + std::to_string(points.size());
    file.Add("      <" + type + " id=\"");
    file.Add(++number);
    file.Add("\">");
    AddList(file, points);
    AddLine(file, "</" + type + ">");
  }
  AddLine(file, "    </Surface>");
}

/// Returns the density of all elements of a part; nothing if they differ or have none.
std::optional<double> DensityOf(const DeckModel& model, const MaterialPart& part)
{
  const MeshArray* density = model.State.Density;
  const auto valueOf = [density](Index element) { return vfm::ValueAt(*density, element); };
  const bool isEqual = density && !part.Elements.empty() &&
    std::all_of(part.Elements.begin(), part.Elements.end(),
      [&](Index element) { return valueOf(element) == valueOf(part.Elements.front()); });
  return isEqual ? std::optional(valueOf(part.Elements.front())) : std::nullopt;
}

void AddConstant(OutputFile& file, const std::string& name, double value)
{
  file.Add("      <" + name + ">");
  file.AddReal(value);
  AddLine(file, "</" + name + ">");
}

/// Adds a material with the constants of a bin, or with some that the user replaces.
void AddMaterial(
  OutputFile& file, const DeckModel& model, const MaterialPart& part, const std::string& name)
{
  AddLine(file,
    "    <material id=" + Quoted(std::to_string(&part - model.Materials.data() + 1)) +
      " name=" + Quoted(name) + " type=\"isotropic elastic\">");
  const bool hasConstants = part.Bin && part.Bin->Elastic;
  // FEBio's own density is 1; readers of Python expect it before the other constants.
  AddConstant(file, "density",
    hasConstants ? part.Bin->Elastic->Density : DensityOf(model, part).value_or(1.0));
  AddConstant(file, "E", hasConstants ? part.Bin->Elastic->Modulus : 1.0);
  AddConstant(file, "v", hasConstants ? part.Bin->Elastic->Poisson : 0.3);
  AddLine(file, "    </material>");
}

void AddElementData(OutputFile& file, const MeshData& mesh, UniqueNames& names)
{
  for (const MeshArray& array : mesh.ElementArrays)
  {
    if (!IsElementData(array) || FindKnownArray(array.Name))
    {
      continue;
    }
    AddLine(file,
      "    <ElementData name=" + Quoted(names.Add(FebioName(array.Name))) +
        " data_type=\"scalar\" elem_set=" + Quoted(AllElements) + ">");
    for (Index element = 0; element < mesh.NumberOfElements; ++element)
    {
      file.Add("      <e lid=\"");
      file.Add(element + 1);
      file.Add("\">");
      file.AddReal(ValueAt(array, element));
      AddLine(file, "</e>");
    }
    AddLine(file, "    </ElementData>");
  }
}

/// Names of what belongs to the mesh, in the order of the model.
struct FebioNames
{
  std::vector<std::string> Parts, Undivided, NodeSets, Surfaces;
};

FebioNames MakeNames(const DeckModel& model, const std::vector<NamedSurface>& surfaces)
{
  FebioNames names;
  UniqueNames ofParts(LongestName), ofSets(LongestName), ofSurfaces(LongestName);
  ofParts.Add(AllElements);
  for (const MaterialPart& whole : model.Undivided)
  {
    names.Undivided.push_back(ofParts.Add(FebioName(whole.Name)));
  }
  for (const MaterialPart& part : model.Materials)
  {
    names.Parts.push_back(ofParts.Add(FebioName(part.Name)));
  }
  for (const NodeSet& set : model.Sets.NodeSets)
  {
    names.NodeSets.push_back(ofSets.Add(FebioName(set.Name)));
  }
  for (const NamedSurface& surface : surfaces)
  {
    names.Surfaces.push_back(ofSurfaces.Add(FebioName(surface.Name)));
  }
  return names;
}

void AddMesh(OutputFile& file, const DeckModel& model, const std::vector<NamedSurface>& surfaces,
  const FebioNames& names)
{
  const MeshData& mesh = model.Mesh;
  AddLine(file, "  <Mesh>");
  AddNodes(file, mesh);
  for (std::size_t p = 0; p < model.Materials.size(); ++p)
  {
    AddElements(file, mesh, model.Materials[p], names.Parts[p]);
  }
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    AddSurface(file, mesh, surfaces[s], names.Surfaces[s]);
  }
  std::vector<Index> elements(mesh.NumberOfElements);
  std::iota(elements.begin(), elements.end(), Index(0));
  AddSet(file, "ElementSet", AllElements, elements);
  for (std::size_t u = 0; u < names.Undivided.size(); ++u)
  {
    AddSet(file, "ElementSet", names.Undivided[u], model.Undivided[u].Elements);
  }
  for (std::size_t s = 0; s < names.NodeSets.size(); ++s)
  {
    AddSet(file, "NodeSet", names.NodeSets[s], model.Sets.NodeSets[s].Points);
  }
  AddLine(file, "  </Mesh>");
}

void WriteFile(const DeckModel& model, const std::string& path, OutputSet& files)
{
  RequireNodes(model.Mesh, { 6, 12 }, "FEBio");
  const std::vector<NamedSurface> surfaces = SelectNamedSurfaces(model.Sets.SideSets);
  const FebioNames names = MakeNames(model, surfaces);
  const bool hasAll = std::all_of(model.Materials.begin(), model.Materials.end(),
    [](const MaterialPart& part) { return part.Bin && part.Bin->Elastic; });
  OutputFile file(path, files);
  AddLine(file, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<febio_spec version=\"4.0\">");
  AddLine(
    file, "  <!-- " + XmlText(DescribeDeck(model)) + (hasAll ? "" : ". Replace E and v") + ". -->");
  AddLine(file, "  <Module type=\"solid\"/>\n  <Material>");
  for (std::size_t p = 0; p < model.Materials.size(); ++p)
  {
    AddMaterial(file, model, model.Materials[p], names.Parts[p]);
  }
  AddLine(file, "  </Material>");
  AddMesh(file, model, surfaces, names);
  AddLine(file, "  <MeshDomains>");
  for (const std::string& name : names.Parts)
  {
    AddLine(file, "    <SolidDomain name=" + Quoted(name) + " mat=" + Quoted(name) + "/>");
  }
  AddLine(file, "  </MeshDomains>\n  <MeshData>");
  UniqueNames ofData(LongestName);
  AddElementData(file, model.Mesh, ofData);
  AddLine(file, "  </MeshData>\n</febio_spec>");
  file.Close();
}

} // namespace

void WriteFebio(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  const std::shared_ptr<const ParticleData> particles = GatherParticles(mesh.Particles, ranks);
  MeshData elements = mesh;
  elements.Particles = nullptr;
  WriteDeck(elements, ranks, IsElementData,
    [&](const DeckModel& model)
    {
      OutputSet files(path);
      WriteFile(model, path, files);
      MeshData whole = model.Mesh;
      whole.Particles = particles.get();
      WriteParticlesBeside(whole, path, files);
      files.Rename();
    });
}

} // namespace vfm
