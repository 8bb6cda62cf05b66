#include "Meshes/Surfaces/WriteStl.h"

#include "FileSuffix.h"
#include "Meshes/Files/MeshModel.h"
#include "Meshes/Files/OutputFile.h"
#include "Meshes/Files/WriteWhole.h"
#include "Meshes/Particles/WriteParticles.h"
#include "Ranks/WorkTogether.h"
#include "Report/MeshFacets.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace vfm
{
namespace
{

constexpr std::size_t LongestFileName = 200; // bytes of the name of a material in a file name

using Triangle = std::array<Vector3, 3>;

struct Solid
{
  std::string Name;
  std::vector<FaceIds> Faces; ///< counterclockwise seen from outside
};

/// Returns the surface of each material, with unique names.
std::vector<Solid> FindSolids(
  const MeshData& whole, std::string (*form)(const std::string&), UniqueNames used)
{
  Ranks alone;
  std::map<int, std::vector<FaceIds>> skins;
  for (const MeshFacet& facet : FindMeshFacets(whole, alone))
  {
    skins[whole.Material[facet.Element]].push_back(PointsOfSide(whole, facet));
  }
  std::vector<int> materials;
  std::transform(skins.begin(), skins.end(), std::back_inserter(materials),
    [](const auto& skin) { return skin.first; });
  std::vector<Solid> solids;
  for (auto& [material, name] : NameMaterials(whole, materials, form, used))
  {
    solids.push_back({ name, std::move(skins[material]) });
  }
  return solids;
}

/// Calls add for each triangle of a face. The result does not depend on the corner that is first.
template <class Add>
void CutFace(const MeshData& whole, const FaceIds& face, const Add& add)
{
  std::array<Vector3, 4> corners{};
  const int count = face.back() < 0 ? 3 : 4;
  for (int c = 0; c < count; ++c)
  {
    corners[c] = whole.PointAt(face[c]);
  }
  if (count == 3)
  {
    add({ corners[0], corners[1], corners[2] });
    return;
  }
  const Vector3 centre = 0.25 * ((corners[0] + corners[2]) + (corners[1] + corners[3]));
  for (int c = 0; c < 4; ++c)
  {
    add({ corners[c], corners[(c + 1) % 4], centre });
  }
}

/// Returns the unit normal of a triangle, in six digits: readers compute it from the corners.
Vector3 NormalOf(const Triangle& triangle)
{
  constexpr double digits = 1e6;
  const Vector3 normal = Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double length = Norm(normal);
  Vector3 rounded{};
  for (int a = 0; a < 3 && length > 0.0; ++a)
  {
    rounded[a] = std::round(normal[a] / length * digits) / digits + 0.0; // no -0
  }
  return rounded;
}

void AddVector(OutputFile& file, const char* before, const Vector3& vector)
{
  file.Add(before);
  for (int a = 0; a < 3; ++a)
  {
    file.Add(" ");
    file.AddReal(vector[a]);
  }
  file.Add("\n");
}

void AddSolid(OutputFile& file, const MeshData& whole, const Solid& solid)
{
  file.Add("solid " + solid.Name + "\n");
  for (const FaceIds& face : solid.Faces)
  {
    CutFace(whole, face,
      [&file](const Triangle& triangle)
      {
        AddVector(file, "facet normal", NormalOf(triangle));
        file.Add("outer loop\n");
        for (const Vector3& corner : triangle)
        {
          AddVector(file, "vertex", corner);
        }
        file.Add("endloop\nendfacet\n");
      });
  }
  file.Add("endsolid " + solid.Name + "\n");
}

/// Writes all surfaces into one file.
void WriteSolids(const MeshData& whole, const std::string& path)
{
  OutputSet files(path);
  OutputFile file(path, files);
  for (const Solid& solid : FindSolids(whole, PlainName, UniqueNames()))
  {
    AddSolid(file, whole, solid);
  }
  file.Close();
  WriteParticlesBeside(whole, path, files);
  files.Rename();
}

/// Returns a name without the separator of folders.
std::string NameInFile(const std::string& name)
{
  std::string plain = PlainName(name);
  std::replace(plain.begin(), plain.end(), '/', '_');
  return plain;
}

/// Writes each surface into a file of its own.
void WriteEachSolid(const MeshData& whole, const std::string& path, std::size_t place)
{
  for (const Solid& solid : FindSolids(whole, NameInFile, UniqueNames(LongestFileName)))
  {
    const std::string filled = std::string(path).replace(place, 2, solid.Name);
    PrefixErrors(filled + ": ",
      [&]
      {
        OutputFile file(filled);
        AddSolid(file, whole, solid);
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

std::string FindStlProblem(const std::string& path)
{
  if (!HasSuffix(path, ".stl"))
  {
    return "The surfaces " + path + " are of an unknown format. Supported format: .stl.";
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

void WriteStl(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteWhole(mesh, ranks,
    [&path](const MeshData& whole)
    {
      if (!whole.PeriodicPartner && FindField(whole.Fields, "PeriodLengths"))
      {
        throw InputError("Opposite sides of the mesh are joined, so its materials have no closed "
                         "surfaces. Set PeriodicSides to Flat or Free.");
      }
      const std::size_t place = path.find(MaterialPlace);
      if (place == std::string::npos)
      {
        WriteSolids(whole, path);
      }
      else
      {
        WriteEachSolid(whole, path, place);
      }
    });
}

} // namespace vfm
