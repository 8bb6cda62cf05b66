/// Paths of surfaces, and centres of faces. WriteStlTest and WriteObjTest test the files.
#include "Meshes/Surfaces/MaterialSkins.h"

#include <gtest/gtest.h>

using namespace vfm;

TEST(MaterialSkins, Folders)
{
  for (const char* path : { "parts", "a.b/parts", ".", "..", "a/.." })
  {
    EXPECT_EQ(FindSurfaceFolder(path), path);
  }
  EXPECT_EQ(FindSurfaceFolder("parts/"), "parts");
  EXPECT_EQ(FindSurfaceFolder("a.stl/"), "a.stl");
  EXPECT_EQ(FindSurfaceFolder("/"), "/");
  for (const char* path : { "", "a.stl", "parts/a.obj", "{}.stl", "a.vtp" })
  {
    EXPECT_EQ(FindSurfaceFolder(path), "");
  }
}

TEST(MaterialSkins, Problems)
{
  for (const char* path : { "a.stl", "A.OBJ", "a_{}.obj", "a/{}.stl" })
  {
    EXPECT_EQ(FindSurfaceProblem(path), "");
  }
  EXPECT_NE(FindSurfaceProblem("a.ply").find("formats: .stl, .obj."), std::string::npos);
  EXPECT_NE(FindSurfaceProblem("{}/a.obj").find("in its folder or twice"), std::string::npos);
}

/// Neighbours see a face from another corner and in the opposite orientation.
TEST(MaterialSkins, CentreIsThatOfTheNeighbour)
{
  const double points[] = { 0.1, 0.2, 0.3, 1.7, 0.21, 0.33, 1.9, 1.1, 1e-9, 0.05, 1.3, 0.7 };
  MeshData mesh;
  mesh.Points = points;
  const Vector3 centre = CentreOfFace(mesh, { 0, 1, 2, 3 });
  EXPECT_DOUBLE_EQ(centre[0], (0.1 + 1.7 + 1.9 + 0.05) / 4);
  for (const FaceIds& face :
    { FaceIds{ 1, 2, 3, 0 }, FaceIds{ 3, 2, 1, 0 }, FaceIds{ 2, 1, 0, 3 } })
  {
    EXPECT_EQ(CentreOfFace(mesh, face), centre);
    EXPECT_EQ(CountCorners(face), 4);
  }
  EXPECT_EQ(CountCorners({ 0, 1, 2, -1 }), 3);
}
