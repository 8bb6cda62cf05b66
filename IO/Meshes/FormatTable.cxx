#include "Meshes/FormatTable.h"

#include "Base/ParseText.h"
#include "FileSuffix.h"
#include "Meshes/Surfaces/MaterialSkins.h"

#include <algorithm>

namespace vfm
{
namespace
{

constexpr FormatOption FormatOptions[] = {
  { "single_file", "--single-file", "",
    "write one Exodus file or OpenFOAM mesh from several ranks; rank 0 gathers the mesh",
    [](const OutputForm& form) { return form.IsSingle; }, "always consists of several files.",
    false, true },
  { "version", "--msh-version", "2.2|4.1",
    "version of a .msh file; default 2.2, or 4.1 if an id exceeds 2147483647",
    [](const OutputForm& form) { return form.Version != GmshVersion::Automatic; },
    "has no choice of version. Formats that have it: " },
  { "binary", "--binary", "",
    "write a .msh file or an OpenFOAM case in binary form instead of text",
    [](const OutputForm& form) { return form.IsBinary; },
    "has no binary form. Formats that have it: " },
  { "reduced", "--reduced", "", "write C3D20R instead of C3D20 in an .inp file",
    [](const OutputForm& form) { return form.IsReduced; },
    "has no elements of reduced integration. Only .inp has them.", false },
  { "plane", "--plane", "strain|stress",
    "elements of a mesh of a plane in .inp, .k and .bdf files: plane strain (default) or stress",
    [](const OutputForm& form) { return form.IsPlaneStress; },
    "has no choice of plane stress. Formats that have it: " },
  { "interfaces", "--no-interfaces", "",
    "leave the faces between elements out of a .msh file, for deal.II",
    [](const OutputForm& form) { return !form.HasInterfaces; },
    "has no faces of interfaces to leave out. Formats that have them: " },
  { "polyhedra", "--polyhedra", "",
    "write polyhedra around the nodes of tetrahedra to an OpenFOAM case or a .vtu file",
    [](const OutputForm& form) { return form.IsDual; },
    "has no polyhedra. Formats that have them: " },
  { "time", "", "", "", nullptr, "" },
  { "texts", "", "", "", nullptr, "" },
};

/// Returns the suffixes of all formats, or of those that have an option.
std::string ListSuffixes(const FormatOption* option = nullptr)
{
  std::vector<std::string> suffixes;
  for (const FormatRow& format : GetFormatTable())
  {
    if (!option || format.Has(*option))
    {
      suffixes.insert(suffixes.end(), format.Suffixes.begin(), format.Suffixes.end());
    }
  }
  return JoinTexts(suffixes);
}

} // namespace

bool FormatRow::Has(const FormatOption& option) const
{
  return option.IsOfWholeFiles
    ? !this->IsPerRank
    : std::find(this->Options.begin(), this->Options.end(), option.Name) != this->Options.end();
}

std::optional<bool> ParsePlaneStress(const std::string& name)
{
  if (name == "strain" || name == "stress")
  {
    return name == "stress";
  }
  return std::nullopt;
}

std::span<const FormatOption> GetFormatOptions()
{
  return FormatOptions;
}

const std::vector<FormatRow>& GetFormatTable()
{
  static const std::vector<FormatRow> table{
    { MeshFormat::Vtu, { ".vtu" }, "VTK", "all arrays and field data",
      { "time", "texts", "polyhedra" } },
    { MeshFormat::Pvtu, { ".pvtu" }, "VTK",
      "the same, with one piece per rank in a folder next to it", { "time" }, true },
    { MeshFormat::Exodus, { ".e", ".ex2", ".exo" }, "Exodus",
      "named blocks, side sets, node sets, ids, variables and particles; N ranks write one file "
      "each, FILE.N.RANK",
      { "time" } },
    { MeshFormat::Abaqus, { ".inp" }, "Abaqus and CalculiX",
      "sets of elements and nodes, surfaces; velocities of nodes as initial conditions; particles "
      "as point masses",
      { "time", "reduced", "plane" } },
    { MeshFormat::LsDyna, { ".k", ".key" }, "LS-DYNA",
      "parts, sets of nodes and segments, velocities, stresses, particles", { "time", "plane" } },
    { MeshFormat::Radioss, { ".rad" }, "OpenRadioss",
      "parts, groups of nodes, surfaces, velocities, state of elements, particles", { "time" } },
    { MeshFormat::Nastran, { ".bdf", ".nas" }, "Nastran",
      "properties, sets of nodes, a unit pressure on each surface, particles as point masses",
      { "time", "plane" } },
    { MeshFormat::Febio, { ".feb" }, "FEBio",
      "version 4.0: elements of each material, sets of nodes, surfaces, element data", {} },
    { MeshFormat::Gmsh, { ".msh" }, "Gmsh",
      "version 2.2 or 4.1, text or binary: named volumes, domain sides and interfaces",
      { "version", "binary", "interfaces" } },
    { MeshFormat::Xdmf, { ".xdmf" }, "XDMF",
      "for dolfinx: materials, and a second file of tagged facets, FILE_facets.xdmf", {} },
    { MeshFormat::Foam, { ".foam" }, "OpenFOAM",
      "the folder of the file is a case with patches, zones and a cloud of particles; N ranks "
      "write a folder processorRANK each",
      { "binary", "polyhedra" } },
    { MeshFormat::Stl, { ".stl" }, "STL",
      "only the closed surface of each material; with {} in the name one file per material, as in "
      "bones_{}.stl",
      {} },
    { MeshFormat::Obj, { ".obj" }, "OBJ",
      "the same surfaces, one group per material, with common vertices", {} },
    { MeshFormat::Vtp, { ".vtp" }, "VTK particles", "only the particles, with all arrays",
      { "time" }, false, false }, // the package writes surfaces by this suffix
    { MeshFormat::Lammps, { ".data" }, "LAMMPS",
      "only the particles, as spheres with diameter, density and velocity", {} },
  };
  return table;
}

const FormatRow* FindMeshFormat(const std::string& path)
{
  const std::vector<FormatRow>& table = GetFormatTable();
  const auto found = std::find_if(table.begin(), table.end(),
    [&path](const FormatRow& format) { return HasSuffix(path, format.Suffixes); });
  return found == table.end() ? nullptr : &*found;
}

std::string FindOutputProblem(const std::string& path, const OutputForm& form)
{
  const FormatRow* format = FindMeshFormat(path);
  if (!format)
  {
    return "The output " + path + " is of an unknown format. Supported formats: " + ListSuffixes() +
      ".";
  }
  for (const FormatOption& option : FormatOptions)
  {
    if (option.IsGiven && option.IsGiven(form) && !format->Has(option))
    {
      return "The output " + path + " " + option.Lack +
        (option.ListsFormats ? ListSuffixes(&option) + "." : "");
    }
  }
  const bool isSurface = format->Format == MeshFormat::Stl || format->Format == MeshFormat::Obj;
  return isSurface ? FindSurfaceProblem(path) : "";
}

} // namespace vfm
