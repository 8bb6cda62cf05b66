/// Surfaces of files of all formats, intact and damaged.
#include "Surfaces/ReadSurface.h"

#include "FileCases.h"
#include "Ranks/Errors.h"
#include "Surfaces/InputSurfaces.h"

#include <cstdint>
#include <cstring>
#include <zlib.h>

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

const std::string TetOff = "OFF # a comment\n4 4 6\n0 0 0\n1 0 0 255 0 0\n0 1 0\n0 0 1\n3 0 2 1 7\n"
                           "3 0 1 3\n3 1 2 3\n3 0 3 2\n";

TEST(ReadSurface, Off)
{
  EXPECT_NEAR(VolumeOf(ReadAs("a.off", TetOff)), 1.0 / 6.0, 1e-15);
  ExpectProblem("a.off", TetOff.substr(0, 60), "ends before");
  ExpectProblem("a.off", "OFF\n999999999 1 1\n", "line 2");
  ExpectProblem("a.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", "'1' is not an integer from 0 to 0");
  ExpectProblem("a.off", "OFF BINARY\n", "line 1: 'BINARY'");
  ExpectProblem("a.off", "4 4 6", "not an OFF file");
}

TEST(ReadSurface, ObjWithPatches)
{
  const std::string points = "# cube\nv 0 0 0\nv 1 0 0 0.5\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\n"
                             "v 0 1 1\nv 1 1 1\nvt 0 0\n";
  const std::string faces = "usemtl red\nf 1 3 4 2\nf 5/1 6/1 8/1 7/1\ng low\nf 1 2 6 \\\n5\n"
                            "usemtl blue\nf -6 -2 -1 -5\nf 1//1 5//1 7//1 3//1\nf 2 4 8 6\n";
  const SurfaceFile cube = ReadAs("a.obj", points + faces);
  EXPECT_NEAR(VolumeOf(cube), 1.0, 1e-15);
  EXPECT_EQ(cube.PatchNames, (Names{ "red", "blue" }));
  EXPECT_EQ(std::count(cube.Patches.begin(), cube.Patches.end(), 0), 6);
  const SurfaceFile grouped =
    ReadAs("a.obj", points + "o part\n" + faces.substr(faces.find("f 5")));
  EXPECT_EQ(grouped.PatchNames, (Names{ "", "blue" }));
  // an L of six corners, whose fan from the first corner would leave it
  const SurfaceFile bent =
    ReadAs("a.obj", "v 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nf 1 2 3 4 5 6\n");
  double area = 0.0;
  for (const PointTriangle& t : bent.Triangles)
  {
    area += 0.5 *
      Norm(Cross(bent.Points[t[1]] - bent.Points[t[0]], bent.Points[t[2]] - bent.Points[t[0]]));
  }
  EXPECT_NEAR(area, 3.0, 1e-15);
  ExpectProblem("a.obj", points + "f 1 2 9\n", "line 11: the face refers to the point '9'");
  ExpectProblem("a.obj", points + "f 1 2 x\n", "'x'");
  ExpectProblem("a.obj", points, "no polygons");
}

/// Returns a PLY file of a tetrahedron.
std::string Ply(const std::string& format, bool isBig)
{
  std::string bytes = "ply\nformat " + format +
    " 1.0\ncomment none\nelement vertex 4\n"
    "property double x\nproperty double y\nproperty double z\nproperty uchar red\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const bool isText = format == "ascii";
  const auto add = [&](auto value)
  {
    std::string plain = BytesOf(value);
    if (isBig)
    {
      std::reverse(plain.begin(), plain.end());
    }
    bytes += isText ? std::to_string(value) + " " : plain;
  };
  for (const Vector3& point : TetPoints)
  {
    add(point[0]);
    add(point[1]);
    add(point[2]);
    add(static_cast<unsigned char>(7));
  }
  for (const PointTriangle& t : TetTriangles)
  {
    add(static_cast<unsigned char>(3));
    for (Index p : t)
    {
      add(static_cast<std::int32_t>(p));
    }
  }
  return bytes;
}

TEST(ReadSurface, Ply)
{
  for (const std::string& bytes :
    { Ply("ascii", false), Ply("binary_little_endian", false), Ply("binary_big_endian", true) })
  {
    EXPECT_NEAR(VolumeOf(ReadAs("a.ply", bytes)), 1.0 / 6.0, 1e-15);
  }
  const std::string binary = Ply("binary_little_endian", false);
  ExpectProblem("a.ply", binary.substr(0, binary.size() - 1), "truncated");
  ExpectProblem("a.ply", binary.substr(0, 100), "line");
  ExpectProblem("a.ply", Ply("binary_little_endian", true), "damaged");
  ExpectProblem("a.ply", "ply\nformat ascii 1.0\nelement vertex 99999999\nend_header\n", "line 3");
  ExpectProblem("a.ply", "plz", "not a PLY file");
}

std::string Vtp(const std::string& type, const std::string& points)
{
  return "<?xml version='1.0'?><!-- a > b --><VTKFile type=\"" + type +
    "\" version=\"1.0\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"4\" "
    "NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"1\" NumberOfPolys=\"2\"><Points>"
    "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" +
    points +
    "</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\">0 2 1 0 3 2"
    "</DataArray><DataArray type=\"Int64\" Name=\"offsets\">3 6</DataArray></Polys><Strips>"
    "<DataArray type=\"Int64\" Name=\"connectivity\">0 1 3 2</DataArray>"
    "<DataArray type=\"Int64\" Name=\"offsets\">4</DataArray></Strips></Piece></PolyData>"
    "</VTKFile>";
}

TEST(ReadSurface, Vtp)
{
  const std::string points = "0 0 0 1 0 0 0 1 0 0 0 1";
  const std::string bytes = Vtp("PolyData", points);
  EXPECT_NEAR(VolumeOf(ReadAs("a.vtp", bytes)), 1.0 / 6.0, 1e-15);
  ExpectProblem("a.vtp", Vtp("PolyData", "0 0 0 1 0 0 0 1 0 0 0 x"), "'x'");
  ExpectProblem(
    "a.vtp", Vtp("UnstructuredGrid", points), "required is <VTKFile type=\"PolyData\">");
  ExpectProblem("a.vtp", bytes.substr(0, bytes.size() - 5), "not XML in line 1");
  ExpectProblem("a.vtp", "<!DOCTYPE a><a/>", "document type definition");
}

/// Packs bytes by zlib.
std::string Pack(const std::string& bytes, int windowBits)
{
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&stream, bytes.size()) + 64, '\0');
  std::string input = bytes;
  stream.next_in = reinterpret_cast<unsigned char*>(input.data());
  stream.avail_in = static_cast<unsigned int>(input.size());
  stream.next_out = reinterpret_cast<unsigned char*>(packed.data());
  stream.avail_out = static_cast<unsigned int>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

TEST(ReadSurface, Gzip)
{
  constexpr int gzip = 31;
  const std::string packed = Pack(BinaryStl(), gzip);
  EXPECT_NEAR(VolumeOf(ReadAs("a.stl.gz", packed)), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(VolumeOf(ReadAs("a.vtp.gz", Pack(Vtp("PolyData", "0 0 0 1 0 0 0 1 0 0 0 1"), gzip))),
    1.0 / 6.0, 1e-15);
  const std::string first = Pack(TetOff.substr(0, 40), gzip), rest = Pack(TetOff.substr(40), gzip);
  EXPECT_NEAR(VolumeOf(ReadAs("a.off.gz", first + rest)), 1.0 / 6.0, 1e-15);
  ExpectProblem("a.stl.gz", packed.substr(0, packed.size() - 9), "truncated");
  std::string damaged = packed;
  damaged[damaged.size() - 6] ^= 1;
  ExpectProblem("a.stl.gz", damaged, "damaged");
}

/// Returns a zip archive.
std::string Zip(const std::vector<std::pair<std::string, std::string>>& files, bool isPacked)
{
  std::string bytes, list;
  for (const auto& [name, content] : files)
  {
    const std::string packed = isPacked ? Pack(content, -15) : content;
    const auto sum = crc32(0, reinterpret_cast<const unsigned char*>(content.data()),
      static_cast<unsigned int>(content.size()));
    const std::string common = BytesOf<std::uint16_t>(20) + BytesOf<std::uint16_t>(0) +
      BytesOf<std::uint16_t>(isPacked ? 8 : 0) + BytesOf<std::uint32_t>(0) +
      BytesOf(static_cast<std::uint32_t>(sum)) +
      BytesOf(static_cast<std::uint32_t>(packed.size())) +
      BytesOf(static_cast<std::uint32_t>(content.size())) +
      BytesOf(static_cast<std::uint16_t>(name.size())) + BytesOf<std::uint16_t>(0);
    list += "PK\1\2" + BytesOf<std::uint16_t>(20) + common + std::string(10, '\0') +
      BytesOf(static_cast<std::uint32_t>(bytes.size())) + name;
    bytes += "PK\3\4" + common + name + packed;
  }
  const std::string end = "PK\5\6" + BytesOf<std::uint32_t>(0) +
    BytesOf(static_cast<std::uint16_t>(files.size())) +
    BytesOf(static_cast<std::uint16_t>(files.size())) +
    BytesOf(static_cast<std::uint32_t>(list.size())) +
    BytesOf(static_cast<std::uint32_t>(bytes.size())) + BytesOf<std::uint16_t>(0);
  return bytes + list + end;
}

/// Returns a model whose second item is two tetrahedra of twice the size, apart from each other.
std::string ThreeMf(const std::string& component = "1")
{
  std::string mesh = "<mesh><vertices>";
  for (const Vector3& x : TetPoints)
  {
    mesh += "<vertex x='" + std::to_string(x[0]) + "' y='" + std::to_string(x[1]) + "' z='" +
      std::to_string(x[2]) + "'/>";
  }
  mesh += "</vertices><triangles>";
  for (const PointTriangle& t : TetTriangles)
  {
    mesh += "<triangle v1='" + std::to_string(t[0]) + "' v2='" + std::to_string(t[1]) + "' v3='" +
      std::to_string(t[2]) + "'" + (t[0] == 1 ? " pid='9' p1='1'" : "") + "/>";
  }
  mesh += "</triangles></mesh>";
  return "<?xml version='1.0'?><model><resources><basematerials id='9'><base name='steel'/>"
         "<base name='A &amp; B'/></basematerials><object id='1' name='tet'>" +
    mesh + "</object><object id='2' name='pair'><components><component objectid='" + component +
    "' transform='2 0 0 0 2 0 0 0 2 0 0 0'/><component objectid='1' "
    "transform='2 0 0 0 2 0 0 0 2 5 0 0'/></components></object></resources>"
    "<build><item objectid='1'/><item objectid='2' transform='1 0 0 0 1 0 0 0 1 0 0 9'/></build>"
    "</model>";
}

TEST(ReadSurface, ThreeMf)
{
  const std::string place = "3D/3dmodel.model";
  for (bool isPacked : { false, true })
  {
    const Folder folder;
    std::ofstream(folder / "a.3mf", std::ios::binary) << Zip({ { place, ThreeMf() } }, isPacked);
    const std::vector<SurfaceFile> bodies = ReadBodies(folder / "a.3mf");
    ASSERT_EQ(bodies.size(), 2u);
    EXPECT_EQ(bodies[0].Name, "tet");
    EXPECT_EQ(bodies[0].PatchNames, (Names{ "tet", "A & B" }));
    EXPECT_NEAR(VolumeOf(bodies[0]), 1.0 / 6.0, 1e-15);
    EXPECT_EQ(bodies[1].Name, "pair");
    EXPECT_NEAR(VolumeOf(bodies[1]), 2 * 8.0 / 6.0, 1e-14);
    EXPECT_EQ(bodies[1].Points[0], (Vector3{ { 0, 0, 9 } }));
    const SurfaceFile all = ReadSurface(folder / "a.3mf");
    EXPECT_NEAR(VolumeOf(all), 17.0 / 6.0, 1e-14);
    EXPECT_EQ(all.PatchNames.size(), 4u);
  }
  const std::string link = "<a><b Type='x/3dmodel' Target='/other/m.model'/></a>";
  EXPECT_NEAR(VolumeOf(ReadAs(
                "a.3mf", Zip({ { "_rels/.rels", link }, { "other/m.model", ThreeMf() } }, false))),
    17.0 / 6.0, 1e-14);
  ExpectProblem("a.3mf", Zip({ { place, ThreeMf("2") } }, false), "too deeply");
  ExpectProblem("a.3mf", Zip({ { place, ThreeMf("7") } }, false), "no object 7");
  ExpectProblem("a.3mf", Zip({ { "b", "" } }, false), "has no model");
  std::string damaged = Zip({ { place, ThreeMf() } }, false);
  damaged[300] ^= 1;
  ExpectProblem("a.3mf", damaged, "checksum");
  ExpectProblem("a.3mf", damaged.substr(0, 200), "not a zip archive");
}

} // namespace
