#include "Meshes/Surfaces/MaterialSkins.h"

#include "FileSuffix.h"
#include "Meshes/Files/MeshModel.h"
#include "Meshes/Files/WriteWhole.h"
#include "Meshes/Particles/WriteParticles.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>
#include <map>

namespace vfm
{
namespace
{

constexpr std::size_t LongestFileName = 200; // bytes of the name of a material in a file name

using NameForm = std::string (*)(const std::string&);
using AddSkins =
  std::function<void(OutputFile&, const MeshData&, const std::vector<MaterialSkin>&)>;

/// Returns the surface of each material, with unique names.
std::vector<MaterialSkin> FindSkins(const MeshData& whole, NameForm form, UniqueNames used)
{
  Ranks alone;
  std::map<int, std::vector<FaceIds>> faces;
  for (const MeshFacet& facet : FindMeshFacets(whole, alone))
  {
    faces[whole.Material[facet.Element]].push_back(PointsOfSide(whole, facet));
  }
  std::vector<int> materials;
  std::transform(faces.begin(), faces.end(), std::back_inserter(materials),
    [](const auto& skin) { return skin.first; });
  std::vector<MaterialSkin> skins;
  for (auto& [material, name] : NameMaterials(whole, materials, form, used))
  {
    skins.push_back({ name, std::move(faces[material]) });
  }
  return skins;
}

/// Writes all surfaces into one file.
void WriteTogether(
  const MeshData& whole, const std::string& path, NameForm form, const AddSkins& add)
{
  OutputSet files(path);
  OutputFile file(path, files);
  add(file, whole, FindSkins(whole, form, UniqueNames()));
  file.Close();
  WriteParticlesBeside(whole, path, files);
  files.Rename();
}

/// Writes each surface into a file of its own. Names of files have no separator of folders.
void WriteApart(const MeshData& whole, const std::string& path, NameForm form, const AddSkins& add)
{
  std::vector<MaterialSkin> skins = FindSkins(whole, form, UniqueNames());
  UniqueNames used(LongestFileName);
  for (MaterialSkin& skin : skins)
  {
    std::replace(skin.Name.begin(), skin.Name.end(), '/', '_');
    skin.Name = used.Add(skin.Name);
    const std::string filled = std::string(path).replace(path.find(MaterialPlace), 2, skin.Name);
    PrefixErrors(filled + ": ",
      [&]
      {
        OutputFile file(filled);
        add(file, whole, { skin });
        file.Close();
      });
  }
  PrefixErrors(PathOfParticles(path) + ": ",
    [&]
    {
      OutputSet files(path);
      WriteParticlesBeside(whole, path, files);
      files.Rename();
    });
}

} // namespace

std::string FindSurfaceProblem(const std::string& path)
{
  if (!HasSuffix(path, ".stl") && !HasSuffix(path, ".obj"))
  {
    return "The surfaces " + path +
      " are of an unknown format. Supported formats: .stl, .obj. A name without a dot is a folder.";
  }
  const std::size_t place = path.find(MaterialPlace);
  if (place == std::string::npos)
  {
    return "";
  }
  const bool isInFolder = path.find('/', place) != std::string::npos;
  return !isInFolder && path.find(MaterialPlace, place + 1) == std::string::npos
    ? ""
    : "The output " + path +
      " has {} for the name of a material in its folder or twice. Use it once, in the name of the "
      "file, as in bones_{}.stl.";
}

std::string FindSurfaceFolder(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  if (name.find('.') != std::string::npos && name != "." && name != "..")
  {
    return "";
  }
  return path.size() > 1 && name.empty() ? path.substr(0, path.size() - 1) : path;
}

Vector3 CentreOfFace(const MeshData& whole, const FaceIds& face)
{
  return 0.25 *
    ((whole.PointAt(face[0]) + whole.PointAt(face[2])) +
      (whole.PointAt(face[1]) + whole.PointAt(face[3])));
}

void WriteSkins(
  const MeshData& mesh, const std::string& path, Ranks& ranks, NameForm form, const AddSkins& add)
{
  WriteWhole(mesh, ranks,
    [&](const MeshData& whole)
    {
      if (!whole.PeriodicPartner && FindField(whole.Fields, "PeriodLengths"))
      {
        throw InputError("Opposite sides of the mesh are joined, so its materials have no closed "
                         "surfaces. Set PeriodicSides to Flat or Free.");
      }
      const bool isApart = path.find(MaterialPlace) != std::string::npos;
      isApart ? WriteApart(whole, path, form, add) : WriteTogether(whole, path, form, add);
    });
}

} // namespace vfm
