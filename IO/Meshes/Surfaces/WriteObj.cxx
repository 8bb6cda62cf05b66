#include "Meshes/Surfaces/WriteObj.h"

#include <algorithm>
#include <map>

namespace vfm
{
namespace
{

/// Returns the corners of a face in ascending order, which is the same for its neighbour.
FaceIds KeyOfFace(FaceIds face)
{
  std::sort(face.begin(), face.end());
  return face;
}

/// The vertices of a file: the points of surfaces, and then the centres of quadrilaterals.
struct Vertices
{
  std::vector<Index> OfPoint;        ///< from 1; 0: not in the file
  std::map<FaceIds, Index> OfCentre; ///< by KeyOfFace
};

void AddVertex(OutputFile& file, const Vector3& point)
{
  file.Add("v");
  for (int a = 0; a < 3; ++a)
  {
    file.Add(" ");
    file.AddReal(point[a]);
  }
  file.Add("\n");
}

/// Adds the vertices of all surfaces: points in ascending order, then centres.
Vertices AddVertices(
  OutputFile& file, const MeshData& whole, const std::vector<MaterialSkin>& skins)
{
  Vertices vertices;
  vertices.OfPoint.assign(whole.NumberOfPoints, 0);
  for (const MaterialSkin& skin : skins)
  {
    for (const FaceIds& face : skin.Faces)
    {
      for (int c = 0; c < CountCorners(face); ++c)
      {
        vertices.OfPoint[face[c]] = 1;
      }
    }
  }
  Index count = 0;
  for (Index p = 0; p < whole.NumberOfPoints; ++p)
  {
    if (vertices.OfPoint[p] != 0)
    {
      vertices.OfPoint[p] = ++count;
      AddVertex(file, whole.PointAt(p));
    }
  }
  for (const MaterialSkin& skin : skins)
  {
    for (const FaceIds& face : skin.Faces)
    {
      if (CountCorners(face) == 4 && vertices.OfCentre.emplace(KeyOfFace(face), count + 1).second)
      {
        ++count;
        AddVertex(file, CentreOfFace(whole, face));
      }
    }
  }
  return vertices;
}

void AddTriangle(OutputFile& file, Index first, Index second, Index third)
{
  file.Add("f");
  for (const Index vertex : { first, second, third })
  {
    file.Add(" ");
    file.Add(static_cast<std::int64_t>(vertex));
  }
  file.Add("\n");
}

void AddGroup(OutputFile& file, const MaterialSkin& skin, const Vertices& vertices)
{
  file.Add("g " + skin.Name + "\n");
  for (const FaceIds& face : skin.Faces)
  {
    const auto corner = [&](int c) { return vertices.OfPoint[face[c % 4]]; };
    if (CountCorners(face) == 3)
    {
      AddTriangle(file, corner(0), corner(1), corner(2));
      continue;
    }
    const Index centre = vertices.OfCentre.at(KeyOfFace(face));
    for (int c = 0; c < 4; ++c)
    {
      AddTriangle(file, corner(c), corner(c + 1), centre);
    }
  }
}

/// Returns a name without blanks, which separate the names of groups.
std::string NameOfGroup(const std::string& name)
{
  std::string plain = PlainName(name);
  std::replace(plain.begin(), plain.end(), ' ', '_');
  return plain;
}

} // namespace

void WriteObj(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteSkins(mesh, path, ranks, NameOfGroup,
    [](OutputFile& file, const MeshData& whole, const std::vector<MaterialSkin>& skins)
    {
      const Vertices vertices = AddVertices(file, whole, skins);
      for (const MaterialSkin& skin : skins)
      {
        AddGroup(file, skin, vertices);
      }
    });
}

} // namespace vfm
