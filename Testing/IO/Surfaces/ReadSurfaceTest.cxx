/// Surfaces of files of all formats, intact and damaged.
#include "Surfaces/ReadSurface.h"

#include "FileCases.h"
#include "Ranks/Errors.h"
#include "Surfaces/InputSurfaces.h"

#include <cstdint>
#include <cstring>

using namespace vfm;
using namespace vfm::testing;

namespace
{

const std::vector<Vector3> TetPoints{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
  { { 0, 0, 1 } } };
const std::vector<PointTriangle> TetTriangles{ { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } },
  { { 0, 3, 2 } } };

template <class Value>
std::string BytesOf(Value value)
{
  std::string bytes(sizeof(Value), '\0');
  std::memcpy(bytes.data(), &value, sizeof(Value));
  return bytes;
}

/// Returns a binary STL file of a tetrahedron.
std::string BinaryStl(const std::vector<int>& attributes = { 0, 0, 0, 0 },
  const std::string& header = "binary", std::uint32_t count = 4)
{
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes += BytesOf(count);
  for (std::size_t t = 0; t < 4; ++t)
  {
    bytes += std::string(12, '\0');
    for (Index p : TetTriangles[t])
    {
      for (double x : TetPoints[p])
      {
        bytes += BytesOf(static_cast<float>(x));
      }
    }
    bytes += BytesOf(static_cast<std::uint16_t>(attributes[t]));
  }
  return bytes;
}

std::string TextFacet(const std::string& corners)
{
  return "facet normal 0 0 0\nouter loop\n" + corners + "endloop\nendfacet\n";
}

/// Returns a text STL file of a tetrahedron of two solids.
std::string TextStl()
{
  std::string text = "solid three sides\n";
  for (std::size_t t = 0; t < 4; ++t)
  {
    std::string corners;
    for (Index p : TetTriangles[t])
    {
      const Vector3& x = TetPoints[p];
      corners += "vertex " + std::to_string(x[0]) + " " + std::to_string(x[1]) + " " +
        std::to_string(x[2]) + "\n";
    }
    text += (t == 3 ? "endsolid\nsolid last\n" : "") + TextFacet(corners);
  }
  return text + "endsolid last\n";
}

SurfaceFile ReadAs(const std::string& name, const std::string& bytes)
{
  const Folder folder;
  std::ofstream(folder / name, std::ios::binary) << bytes;
  return ReadSurface(folder / name);
}

double VolumeOf(const SurfaceFile& file)
{
  return MeasureVolume(
    MakeBody("a", file.Points, file.Triangles, file.Patches, file.PatchNames).Boundary);
}

/// Expects a message that contains a text.
void ExpectProblem(const std::string& name, const std::string& bytes, const std::string& text)
{
  try
  {
    ReadAs(name, bytes);
    ADD_FAILURE() << name << ": no error with '" << text << "'";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
  }
}

using Names = std::vector<std::string>;

TEST(ReadSurface, StlOfAllKinds)
{
  for (const std::string& bytes : { BinaryStl(), BinaryStl({ 0, 0, 0, 0 }, "solid but binary"),
         BinaryStl() + "trailing", TextStl() })
  {
    EXPECT_NEAR(VolumeOf(ReadAs("a.STL", bytes)), 1.0 / 6.0, 1e-15);
  }
  EXPECT_NE(ReadAs("a.stl", BinaryStl() + "trailing").Note.find("8 bytes"), std::string::npos);
  const SurfaceFile text = ReadAs("a.stl", TextStl());
  EXPECT_EQ(text.PatchNames, (Names{ "three sides", "last" }));
  EXPECT_EQ(text.Patches, (std::vector<int>{ 0, 0, 0, 1 }));
}

TEST(ReadSurface, ColoursOfStlArePatches)
{
  const SurfaceFile viscam = ReadAs("a.stl", BinaryStl({ 0x801f, 0x8000 | 31 << 10, 0, 0x801f }));
  EXPECT_EQ(viscam.PatchNames, (Names{ "", "colour_0000ff", "colour_ff0000" }));
  EXPECT_EQ(viscam.Patches, (std::vector<int>{ 1, 2, 0, 1 }));
  const SurfaceFile magics =
    ReadAs("a.stl", BinaryStl({ 0x8000, 31, 31 << 10, 0x8000 }, "COLOR=abcd"));
  EXPECT_EQ(magics.PatchNames, (Names{ "", "colour_0000ff", "colour_ff0000" }));
  EXPECT_EQ(magics.Patches, (std::vector<int>{ 0, 2, 1, 0 }));
}

TEST(ReadSurface, DamagedStl)
{
  ExpectProblem("a.stl", BinaryStl().substr(0, 200), "require 284 bytes, and it has 200");
  ExpectProblem("a.stl", BinaryStl({ 0, 0, 0, 0 }, "", 0xffffffff), "truncated");
  ExpectProblem("a.stl", "nothing of the kind", "not an STL file");
  ExpectProblem("a.stl", TextStl().substr(0, 120), "line");
  ExpectProblem("a.stl", "solid a\nfacet\nvertex 0 0 x\n", "line 3: 'x' is not a finite number");
  ExpectProblem("a.stl", "solid a\n" + TextFacet("vertex 0 0 0\n"), "has 1 vertices");
  ExpectProblem("a.stl", "solid a\nendsolid\n", "no polygons");
  ExpectProblem("a.xyz", "a", "supported are .stl");
}

} // namespace
