/// Files of XDMF: text of two cubes, tags of all facets, the same bytes from any number of ranks.
#include "FileCases.h"
#include "Meshes/WriteMesh.h"
#include "Report/Sets/NamedSurfaces.h"

#include <sstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr const char* Head = R"(<?xml version="1.0" encoding="UTF-8"?>
<Xdmf Version="3.0">
<Domain>
)";
constexpr const char* Points = R"(<Geometry GeometryType="XYZ">
<DataItem Format="XML" NumberType="Float" Precision="8" Dimensions="12 3">
0 0 0
1 0 0
2 0 0
0 1 0
1 1 0
2 1 0
0 0 1
1 0 1
2 0 1
0 1 1
1 1 1
2 1 1
</DataItem>
</Geometry>
)";
constexpr const char* End = "</DataItem>\n</Attribute>\n</Grid>\n</Domain>\n</Xdmf>\n";

/// Returns the numbers of the array after a text.
std::vector<Index> ReadNumbers(const std::string& file, const std::string& before)
{
  const std::size_t array = file.find("<DataItem", file.find(before));
  std::istringstream text(file.substr(file.find('\n', array)));
  std::vector<Index> numbers;
  for (Index number; text >> number;)
  {
    numbers.push_back(number);
  }
  return numbers;
}

} // namespace

TEST(WriteXdmf, Text)
{
  const Folder folder;
  Ranks alone;
  TwoCubes cubes(100);
  cubes.Data.Fields[1] = { "MaterialNames", std::vector<std::string>{ "a \"b\"", "]]> & <c>" } };
  WriteMesh(cubes.Data, folder / "cubes.xdmf", alone);
  EXPECT_EQ(ReadBytes(folder / "cubes.xdmf"),
    std::string(Head) +
      R"(<Grid Name="mesh" GridType="Uniform">
<Information Name="MaterialNames" Value="{&quot;a _b_&quot;: 1, &quot;]]> &amp; &lt;c>&quot;: 2}">)"
      R"(<![CDATA[<main><map key="a _b_" dim="3">1</map>)"
      R"(<map key="]]&gt; &amp; &lt;c&gt;" dim="3">2</map></main>]]></Information>
<Topology TopologyType="Hexahedron" NumberOfElements="2" NodesPerElement="8">
<DataItem Format="XML" NumberType="Int" Precision="8" Dimensions="2 8">
0 1 4 3 6 7 10 9
1 2 5 4 7 8 11 10
</DataItem>
</Topology>
)" + Points +
      R"(<Attribute Name="MaterialId" AttributeType="Scalar" Center="Cell">
<DataItem Format="XML" NumberType="Int" Precision="4" Dimensions="2">
1
2
)" + End);
}

TEST(WriteXdmf, TextOfFacets)
{
  const Folder folder;
  Ranks alone;
  WriteMesh(TwoCubes().Data, folder / "cubes.XDMF", alone);
  const auto map = [](const char* name, const char* number)
  { return std::string("<map key=\"") + name + "\" dim=\"2\">" + number + "</map>"; };
  EXPECT_EQ(ReadBytes(folder / "cubes_facets.XDMF"),
    std::string(Head) +
      R"(<Grid Name="facets" GridType="Uniform">
<Information Name="SurfaceNames" Value="{&quot;x_min&quot;: 1, &quot;y_min&quot;: 3, )"
      R"(&quot;y_max&quot;: 4, &quot;z_min&quot;: 5, &quot;z_max&quot;: 6, )"
      R"(&quot;a _b__to_c&quot;: 1002, &quot;c_to_Void&quot;: 2000}"><![CDATA[<main>)" +
      map("x_min", "1") + map("y_min", "3") + map("y_max", "4") + map("z_min", "5") +
      map("z_max", "6") + map("a _b__to_c", "1002") + map("c_to_Void", "2000") +
      R"(</main>]]></Information>
<Topology TopologyType="Quadrilateral" NumberOfElements="11" NodesPerElement="4">
<DataItem Format="XML" NumberType="Int" Precision="8" Dimensions="11 4">
0 6 9 3
1 4 10 7
0 1 7 6
3 9 10 4
0 3 4 1
6 7 10 9
2 5 11 8
1 2 8 7
4 10 11 5
1 4 5 2
7 8 11 10
</DataItem>
</Topology>
)" + Points +
      R"(<Attribute Name="SurfaceId" AttributeType="Scalar" Center="Cell">
<DataItem Format="XML" NumberType="Int" Precision="4" Dimensions="11">
1
1002
3
4
5
6
2000
3
4
5
6
)" + End);
}

TEST(WriteXdmf, RanksWriteTheSameFiles)
{
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    const Folder folder;
    std::vector<std::string> files;
    for (int count : { 1, 3 })
    {
      WithMesh(count, make,
        [&](const FileCase& part, Ranks& ranks)
        { WriteMesh(part.Mesh, folder / "mesh.xdmf", ranks); });
      files.push_back(ReadBytes(folder / "mesh.xdmf"));
      files.push_back(ReadBytes(folder / "mesh_facets.xdmf"));
    }
    EXPECT_GT(ReadNumbers(files[0], "MaterialId").size(), 300u);
    EXPECT_GT(ReadNumbers(files[1], "\"SurfaceId").size(), 200u);
    EXPECT_EQ(files[0], files[2]);
    EXPECT_EQ(files[1], files[3]);
    EXPECT_EQ(folder.CountFiles(), 2u);
  }
}

TEST(WriteXdmf, SmoothSidesReplaceTheirInterface)
{
  const std::vector<ElementSide> both{ { 0, 1 }, { 1, 2 } };
  const std::vector<NamedSurface> surfaces{
    { SurfaceKind::DomainSide, 1, "x_min", 0, {}, {}, { { 1, 0 } } },
    { SurfaceKind::Interface, 1000, "a_to_Void", NoSide, { { 1, 0 } }, {}, both },
    { SurfaceKind::SmoothSide, 1000001, "a_to_Void_1", NoSide, { { 1, 0 } }, { 1 }, { both[1] } },
    { SurfaceKind::AllInterfaces, 7, "interfaces", NoSide, {}, {}, { { 2, 2 } } },
    { SurfaceKind::Skin, 8, "a_skin", NoSide, { { 1, 1 } }, {}, { { 0, 0 }, { 0, 1 }, { 1, 2 } } }
  };
  const TaggedFaces tagged = TagFaces(surfaces);
  EXPECT_EQ(tagged.Tags, (std::vector<int>{ 1000, 1, 1000001 }));
  EXPECT_EQ(tagged.Names.size(), 3u);
  EXPECT_EQ(tagged.Names.at(1000001), "a_to_Void_1");
  EXPECT_EQ(tagged.TagOf(both[1]), 1000001);
}

TEST(WriteXdmf, NoFileRemainsAfterAnError)
{
  const Folder folder;
  std::filesystem::create_directory(folder / "cubes_facets.xdmf");
  Ranks alone;
  try
  {
    WriteMesh(TwoCubes().Data, folder / "cubes.xdmf", alone);
    ADD_FAILURE();
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(std::string(error.what()),
      "Cannot write the output " + (folder / "cubes.xdmf") + ": Is a directory.");
  }
  EXPECT_EQ(folder.CountFiles(), 1u);
  TwoCubes cubes;
  cubes.Data.Material = nullptr;
  EXPECT_THROW(WriteMesh(cubes.Data, folder / "other.xdmf", alone), InputError);
  EXPECT_EQ(folder.CountFiles(), 1u);
}
