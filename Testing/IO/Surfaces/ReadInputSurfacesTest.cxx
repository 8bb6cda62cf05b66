/// Surfaces of several files: names, priority and messages.
#include "Surfaces/ReadInputSurfaces.h"

#include "FileCases.h"
#include "Ranks/Errors.h"

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Writes a tetrahedron as .off.
std::string WriteTet(const std::string& path, int triangles = 4)
{
  const char* const lines[] = { "3 0 2 1", "3 0 1 3", "3 1 2 3", "3 0 3 2" };
  std::ofstream file(path);
  file << "OFF\n4 " << triangles << " 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  for (int t = 0; t < triangles; ++t)
  {
    file << lines[t] << "\n";
  }
  return path;
}

std::string MessageOf(const std::vector<std::string>& paths)
{
  try
  {
    ReadInputSurfaces(paths, {});
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(ReadInputSurfaces, BodiesHaveTheNamesOfTheirFiles)
{
  const Folder folder;
  const InputSurfaces found =
    ReadInputSurfaces({ WriteTet(folder / "shaft.v2.off"), WriteTet(folder / "housing.OFF") }, {});
  ASSERT_EQ(found.Bodies.size(), 2u);
  EXPECT_EQ(found.Bodies[0].Name, "shaft.v2");
  EXPECT_EQ(found.Bodies[1].Name, "housing");
  EXPECT_NEAR(MeasureVolume(found.Bodies[0].Boundary), 1.0 / 6.0, 1e-15);
}

TEST(ReadInputSurfaces, MessagesNameTheFile)
{
  const Folder folder;
  const std::string part = WriteTet(folder / "part.off"), open = WriteTet(folder / "open.off", 3);
  std::filesystem::create_directory(folder / "more");
  const std::string same = WriteTet(folder / "more/part.off");
  EXPECT_EQ(MessageOf({ part, same }),
    "The surfaces " + part + " and " + same +
      " would both be the material part: rename one of the files.");
  EXPECT_EQ(MessageOf({ part, open }).find("Cannot read the surface " + open + ": "), 0u);
  EXPECT_NE(MessageOf({ folder / "none.off" }).find("none.off: "), std::string::npos);
}
