#include "Meshes/Surfaces/WriteStl.h"

#include <cmath>

namespace vfm
{
namespace
{

using Triangle = std::array<Vector3, 3>;

/// Calls add for each triangle of a face. The result does not depend on the corner that is first.
template <class Add>
void CutFace(const MeshData& whole, const FaceIds& face, const Add& add)
{
  std::array<Vector3, 4> corners{};
  const int count = CountCorners(face);
  for (int c = 0; c < count; ++c)
  {
    corners[c] = whole.PointAt(face[c]);
  }
  if (count == 3)
  {
    add({ corners[0], corners[1], corners[2] });
    return;
  }
  const Vector3 centre = CentreOfFace(whole, face);
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

void AddSolid(OutputFile& file, const MeshData& whole, const MaterialSkin& solid)
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

} // namespace

void WriteStl(const MeshData& mesh, const std::string& path, Ranks& ranks)
{
  WriteSkins(mesh, path, ranks, PlainName,
    [](OutputFile& file, const MeshData& whole, const std::vector<MaterialSkin>& skins)
    {
      for (const MaterialSkin& skin : skins)
      {
        AddSolid(file, whole, skin);
      }
    });
}

} // namespace vfm
