/// Files of Gmsh: text of two cubes, the same content in both versions as text and binary, the same
/// bytes from any number of ranks.
#include "Meshes/Gmsh/WriteGmsh.h"
#include "Elements/ElementFaces.h"
#include "FileCases.h"
#include "Meshes/WriteMesh.h"

#include <fstream>
#include <sstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr GmshForm Forms[] = { { GmshVersion::V2_2, false }, { GmshVersion::V2_2, true },
  { GmshVersion::V4_1, false }, { GmshVersion::V4_1, true } };

std::string ReadAll(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

/// Reads numbers of a file as text or binary.
class Reader
{
public:
  explicit Reader(const std::string& path) : File(ReadAll(path)) { this->ReadHeader(); }

  bool IsVersion4() const { return this->Version == "4.1"; }
  bool IsBinary() const { return this->Binary; }
  Index Int() { return this->Number<std::int32_t, Index>(); }
  Index Size() { return this->Number<std::int64_t, Index>(); }
  double Real() { return this->Number<double, double>(); }
  /// Reads a number that is text in every form.
  Index Text()
  {
    Index number = 0;
    this->File >> number;
    return number;
  }
  std::string Line()
  {
    std::string line;
    std::getline(this->File, line);
    return line;
  }
  void Expect(const std::string& word)
  {
    std::string found;
    this->File >> found;
    EXPECT_EQ(found, word);
    EXPECT_EQ(this->Line(), "");
  }

private:
  void ReadHeader()
  {
    EXPECT_EQ(this->Line(), "$MeshFormat");
    int isBinary = 0, sizeOfReal = 0;
    this->File >> this->Version >> isBinary >> sizeOfReal;
    EXPECT_EQ(sizeOfReal, 8);
    EXPECT_EQ(this->Line(), "");
    this->Binary = isBinary == 1;
    if (this->Binary)
    {
      EXPECT_EQ(this->Int(), 1);
    }
    this->Expect("$EndMeshFormat");
  }

  template <class Stored, class Value>
  Value Number()
  {
    if (!this->Binary)
    {
      Value value{};
      this->File >> value;
      return value;
    }
    Stored stored{};
    this->File.read(reinterpret_cast<char*>(&stored), sizeof(stored));
    return static_cast<Value>(stored);
  }

  std::istringstream File;
  std::string Version;
  bool Binary = false;
};

struct Element
{
  Index Type, Group, Entity; ///< Group: the first one of the element
  std::vector<Index> Nodes;
  bool operator==(const Element& other) const
  {
    return std::tie(this->Type, this->Group, this->Entity, this->Nodes) ==
      std::tie(other.Type, other.Group, other.Entity, other.Nodes);
  }
};

/// Content of a file.
struct Content
{
  std::vector<std::string> Groups;
  std::map<Index, std::array<double, 3>> Nodes;
  std::map<Index, Element> Elements;
  // Only in version 4.1, by dimension and tag:
  using Key = std::array<Index, 2>;
  std::map<Key, std::vector<Index>> GroupsOfEntities, Bounds;
  std::map<Key, std::vector<double>> Boxes;
  std::map<Key, std::vector<Index>> NodesOfEntities;
};

std::array<double, 3> ReadPoint(Reader& file)
{
  std::array<double, 3> x{};
  std::generate(x.begin(), x.end(), [&file] { return file.Real(); });
  return x;
}

std::vector<Index> ReadList(Reader& file)
{
  std::vector<Index> list(file.Size());
  std::generate(list.begin(), list.end(), [&file] { return file.Int(); });
  return list;
}

Index CountNodes(Index type)
{
  const std::map<Index, Index> counts{ { 2, 3 }, { 3, 4 }, { 4, 4 }, { 5, 8 } };
  return counts.at(type);
}

void ReadGroups(Reader& file, Content& content)
{
  file.Expect("$PhysicalNames");
  content.Groups.resize(file.Text());
  file.Line();
  std::generate(content.Groups.begin(), content.Groups.end(), [&file] { return file.Line(); });
  file.Expect("$EndPhysicalNames");
}

void ReadVersion2(Reader& file, Content& content)
{
  file.Expect("$Nodes");
  const Index nodes = file.Text();
  file.Line();
  for (Index n = 0; n < nodes; ++n)
  {
    const Index id = file.Int();
    content.Nodes[id] = ReadPoint(file);
  }
  file.Expect("$EndNodes");
  file.Expect("$Elements");
  const Index elements = file.Text();
  file.Line();
  Index type = 0, left = 0;
  for (Index e = 0; e < elements; ++e, --left)
  {
    if (file.IsBinary() && left == 0)
    {
      type = file.Int();
      left = file.Int();
      EXPECT_EQ(file.Int(), 2);
    }
    const Index id = file.Int();
    if (!file.IsBinary())
    {
      type = file.Int();
      EXPECT_EQ(file.Int(), 2);
    }
    Element element{ type, file.Int(), 0, std::vector<Index>(CountNodes(type)) };
    element.Entity = file.Int();
    std::generate(element.Nodes.begin(), element.Nodes.end(), [&file] { return file.Int(); });
    EXPECT_TRUE(content.Elements.emplace(id, element).second) << id;
  }
  file.Expect("$EndElements");
}

void ReadEntities(Reader& file, Content& content)
{
  file.Expect("$Entities");
  std::array<Index, 4> counts{};
  std::generate(counts.begin(), counts.end(), [&file] { return file.Size(); });
  for (Index dimension = 0; dimension < 4; ++dimension)
  {
    for (Index entity = 0; entity < counts[dimension]; ++entity)
    {
      const Content::Key key{ { dimension, file.Int() } };
      for (int corner = 0; corner < (dimension == 0 ? 1 : 2); ++corner)
      {
        const std::array<double, 3> x = ReadPoint(file);
        content.Boxes[key].insert(content.Boxes[key].end(), x.begin(), x.end());
      }
      content.GroupsOfEntities[key] = ReadList(file);
      if (dimension > 0)
      {
        content.Bounds[key] = ReadList(file);
      }
    }
  }
  file.Expect("$EndEntities");
}

/// Reads the totals of a section and returns the number of blocks and of items, and the ids.
std::array<Index, 4> ReadTotals(Reader& file, const std::string& section)
{
  file.Expect(section);
  std::array<Index, 4> totals{};
  std::generate(totals.begin(), totals.end(), [&file] { return file.Size(); });
  return totals;
}

void ReadVersion4(Reader& file, Content& content)
{
  ReadEntities(file, content);
  const std::array<Index, 4> nodes = ReadTotals(file, "$Nodes");
  for (Index block = 0; block < nodes[0]; ++block)
  {
    const Index dimension = file.Int(), tag = file.Int();
    EXPECT_EQ(file.Int(), 0);
    std::vector<Index> ids(file.Size());
    std::generate(ids.begin(), ids.end(), [&file] { return file.Size(); });
    for (Index id : ids)
    {
      content.Nodes[id] = ReadPoint(file);
    }
    content.NodesOfEntities[{ { dimension, tag } }] = ids;
  }
  file.Expect("$EndNodes");
  EXPECT_EQ(nodes[1], static_cast<Index>(content.Nodes.size()));
  EXPECT_EQ(nodes[2], content.Nodes.begin()->first);
  EXPECT_EQ(nodes[3], content.Nodes.rbegin()->first);
  const std::array<Index, 4> elements = ReadTotals(file, "$Elements");
  for (Index block = 0; block < elements[0]; ++block)
  {
    const Index dimension = file.Int(), tag = file.Int(), type = file.Int(), count = file.Size();
    for (Index e = 0; e < count; ++e)
    {
      const Index id = file.Size();
      Element element{ type, content.GroupsOfEntities[{ { dimension, tag } }].at(0), tag,
        std::vector<Index>(CountNodes(type)) };
      std::generate(element.Nodes.begin(), element.Nodes.end(), [&file] { return file.Size(); });
      EXPECT_TRUE(content.Elements.emplace(id, element).second) << id;
    }
  }
  file.Expect("$EndElements");
  EXPECT_EQ(elements[1], static_cast<Index>(content.Elements.size()));
  EXPECT_EQ(elements[2], content.Elements.begin()->first);
  EXPECT_EQ(elements[3], content.Elements.rbegin()->first);
}

Content ReadMsh(const std::string& path)
{
  Reader file(path);
  Content content;
  ReadGroups(file, content);
  (file.IsVersion4() ? ReadVersion4 : ReadVersion2)(file, content);
  return content;
}

/// Returns the group of each face of a file, by its nodes.
std::map<std::set<Index>, Index> GroupsOfFaces(const Content& content)
{
  std::map<std::set<Index>, Index> groups;
  for (const auto& [id, element] : content.Elements)
  {
    if (element.Nodes.size() == 4)
    {
      groups[std::set<Index>(element.Nodes.begin(), element.Nodes.end())] = element.Group;
    }
  }
  return groups;
}

/// Returns the number of hexahedra at each face, by its nodes.
std::map<std::set<Index>, int> CountHexesOfFaces(const Content& content)
{
  const ElementFaces table(8);
  std::map<std::set<Index>, int> counts;
  for (const auto& [id, element] : content.Elements)
  {
    for (int side = 0; element.Nodes.size() == 8 && side < table.Count; ++side)
    {
      const std::array<Index, 4> nodes = table.PointsOf(element.Nodes.data(), side);
      ++counts[std::set<Index>(nodes.begin(), nodes.end())];
    }
  }
  return counts;
}

std::string WriteCubes(const TwoCubes& cubes, const GmshForm& form)
{
  const Folder folder;
  Ranks alone;
  WriteGmsh(cubes.Data, folder / "cubes.msh", alone, form);
  return ReadAll(folder / "cubes.msh");
}

constexpr const char* CubeGroups = R"($PhysicalNames
9
2 1 "x_min"
2 3 "y_min"
2 4 "y_max"
2 5 "z_min"
2 6 "z_max"
2 1002 "a _b__to_c"
2 2000 "c_to_Void"
3 1 "a _b_"
3 2 "c"
$EndPhysicalNames
)";

} // namespace

TEST(WriteGmsh, TextOfVersion2)
{
  const std::string nodes = "$Nodes\n12\n1 0 0 0\n11 1 0 0\n21 2 0 0\n31 0 1 0\n41 1 1 0\n"
                            "51 2 1 0\n61 0 0 1\n71 1 0 1\n81 2 0 1\n91 0 1 1\n101 1 1 1\n"
                            "111 2 1 1\n$EndNodes\n";
  // Surfaces: z_max, z_min, y_max, y_min of both cubes from the largest side down, and so on.
  EXPECT_EQ(WriteCubes(TwoCubes(), {}),
    std::string("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n") + CubeGroups + nodes +
      "$Elements\n13\n"
      "9 3 2 6 1 61 71 101 91\n"
      "10 3 2 6 2 71 81 111 101\n"
      "11 3 2 5 3 1 31 41 11\n"
      "12 3 2 5 4 11 41 51 21\n"
      "13 3 2 4 5 31 91 101 41\n"
      "14 3 2 4 6 41 101 111 51\n"
      "15 3 2 3 7 1 11 71 61\n"
      "16 3 2 3 8 11 21 81 71\n"
      "17 3 2 1 9 1 61 91 31\n"
      "18 3 2 2000 10 21 51 111 81\n"
      "19 3 2 1002 11 11 41 101 71\n"
      "5 5 2 1 1 1 11 41 31 61 71 101 91\n"
      "8 5 2 2 2 11 21 51 41 71 81 111 101\n"
      "$EndElements\n");
}

TEST(WriteGmsh, EntitiesOfVersion4)
{
  const Folder folder;
  Ranks alone;
  const TwoCubes cubes;
  const std::string path = folder / "cubes.msh";
  WriteGmsh(cubes.Data, path, alone, { GmshVersion::V4_1, false });
  const Content content = ReadMsh(path);
  using List = std::vector<Index>;
  // Faces 1 to 10: z_max .. x_min and the free side; 11 is between the cubes.
  EXPECT_EQ(content.GroupsOfEntities.at({ { 2, 11 } }), (List{ 1002, 7, 8, 9 }));
  EXPECT_EQ(content.GroupsOfEntities.at({ { 2, 10 } }), (List{ 2000, 9 }));
  EXPECT_EQ(content.GroupsOfEntities.at({ { 2, 9 } }), (List{ 1, 8 }));
  EXPECT_EQ(content.GroupsOfEntities.at({ { 3, 2 } }), (List{ 2 }));
  EXPECT_EQ(content.Bounds.at({ { 3, 1 } }), (List{ 1, 3, 5, 7, 9, 11 }));
  EXPECT_EQ(content.Bounds.at({ { 3, 2 } }), (List{ 2, 4, 6, 8, 10, -11 }));
  EXPECT_EQ(content.Boxes.at({ { 3, 2 } }), (std::vector<double>{ 1, 0, 0, 2, 1, 1 }));
  EXPECT_EQ(content.Boxes.at({ { 2, 11 } }), (std::vector<double>{ 1, 0, 0, 1, 1, 1 }));
  std::array<std::size_t, 4> counts{};
  for (const auto& entry : content.Boxes)
  {
    ++counts[entry.first[0]];
  }
  EXPECT_EQ(counts, (std::array<std::size_t, 4>{ 12, 20, 11, 2 }));
  for (Index curve = 1; curve <= 20; ++curve)
  {
    EXPECT_EQ(content.Bounds.at({ { 1, curve } }).size(), 2u);
  }
  for (Index surface = 1; surface <= 11; ++surface)
  {
    EXPECT_EQ(content.Bounds.at({ { 2, surface } }).size(), 4u);
  }
  EXPECT_EQ(content.NodesOfEntities.size(), 12u);
}

TEST(WriteGmsh, AllFormsHaveTheSameContent)
{
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    const Folder folder;
    std::vector<Content> contents;
    for (const GmshForm& form : Forms)
    {
      std::vector<std::string> files;
      for (int count : { 1, 3 })
      {
        WithMesh(count, make,
          [&](const FileCase& part, Ranks& ranks)
          {
            WriteMesh(part.Mesh, folder / "mesh.msh", ranks,
              { .Version = form.Version, .IsBinary = form.IsBinary });
          });
        files.push_back(ReadAll(folder / "mesh.msh"));
      }
      EXPECT_EQ(files[0], files[1]);
      contents.push_back(ReadMsh(folder / "mesh.msh"));
    }
    EXPECT_GT(contents[0].Elements.size(), 500u);
    EXPECT_EQ(contents[0].Groups.size() + 4, contents[2].Groups.size()); // interfaces, skins
    EXPECT_EQ(contents[0].Groups, contents[1].Groups);
    EXPECT_EQ(contents[2].Groups, contents[3].Groups);
    for (const Content& content : contents)
    {
      EXPECT_EQ(content.Nodes, contents[0].Nodes);
      EXPECT_EQ(content.Elements, contents[0].Elements);
    }
    EXPECT_EQ(contents[2].Bounds, contents[3].Bounds);
    EXPECT_EQ(contents[2].Boxes, contents[3].Boxes);
    EXPECT_EQ(contents[2].GroupsOfEntities, contents[3].GroupsOfEntities);
    EXPECT_EQ(contents[2].NodesOfEntities, contents[3].NodesOfEntities);
  }
}

TEST(WriteGmsh, FacesOfInterfacesCanBeLeftOut)
{
  const Folder folder;
  const auto read = [&folder](GmshForm form, bool hasInterfaces)
  {
    form.HasInterfaces = hasInterfaces;
    WithMesh(1, MakeHexMesh,
      [&](const FileCase& part, Ranks& ranks)
      { WriteGmsh(part.Mesh, folder / "mesh.msh", ranks, form); });
    return ReadMsh(folder / "mesh.msh");
  };
  for (const GmshForm& form : Forms)
  {
    const Content all = read(form, true), some = read(form, false);
    const std::map<std::set<Index>, int> hexes = CountHexesOfFaces(all);
    std::map<std::set<Index>, Index> outer; // groups of faces without a second hex
    for (const auto& [nodes, group] : GroupsOfFaces(all))
    {
      if (hexes.at(nodes) == 1)
      {
        outer[nodes] = group;
      }
    }
    EXPECT_LT(outer.size(), GroupsOfFaces(all).size());
    EXPECT_EQ(GroupsOfFaces(some), outer);
    EXPECT_EQ(CountHexesOfFaces(some), hexes);
    EXPECT_EQ(some.Nodes, all.Nodes);
    EXPECT_LT(some.Groups.size(), all.Groups.size());
  }
}

TEST(WriteGmsh, LargeIdsNeedVersion4)
{
  const TwoCubes cubes(Index{ 1 } << 31);
  EXPECT_EQ(WriteCubes(cubes, {}).substr(0, 15), "$MeshFormat\n4.1");
  EXPECT_EQ(WriteCubes(TwoCubes(), {}).substr(0, 15), "$MeshFormat\n2.2");
  const Folder folder;
  try
  {
    Ranks alone;
    WriteGmsh(cubes.Data, folder / "cubes.msh", alone, { GmshVersion::V2_2, false });
    ADD_FAILURE();
  }
  catch (const InputError& error)
  {
    EXPECT_STREQ(error.what(),
      "The id 2147483758 exceeds 2147483647, the largest one in version 2.2 of Gmsh's format. "
      "Write version 4.1.");
  }
  EXPECT_EQ(folder.CountFiles(), 0u);
}

TEST(WriteGmsh, FragmentsOfSeveralMaterialsAreRejected)
{
  TwoCubes cubes;
  for (const auto& [fragment, reason] : { std::pair<int, const char*>{ 3, "several materials" },
         std::pair<int, const char*>{ 0, "FragmentId 0 is below 1" } })
  {
    const std::vector<int> fragments(2, fragment);
    cubes.Data.Fragment = fragments.data();
    const Folder folder;
    try
    {
      Ranks alone;
      WriteGmsh(cubes.Data, folder / "cubes.msh", alone);
      ADD_FAILURE() << fragment;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
    EXPECT_EQ(folder.CountFiles(), 0u);
  }
}

TEST(WriteGmsh, OtherFormatsHaveOneForm)
{
  const OutputForm binary{ .IsBinary = true }, old{ .Version = GmshVersion::V2_2 };
  EXPECT_EQ(FindOutputProblem("a.msh", binary), "");
  const OutputForm boundary{ .HasInterfaces = false };
  EXPECT_EQ(FindOutputProblem("a.msh", boundary), "");
  EXPECT_EQ(FindOutputProblem("a.e", boundary),
    "The output a.e has no faces of interfaces to leave out. Formats that have them: .msh.");
  EXPECT_EQ(FindOutputProblem("a.inp", binary),
    "The output a.inp has no binary form. Formats that have it: .msh, .foam.");
  EXPECT_EQ(FindOutputProblem("a.inp", old),
    "The output a.inp has no choice of version. Formats that have it: .msh.");
  EXPECT_EQ(FindOutputProblem("a.msh", { .IsReduced = true }),
    "The output a.msh has no elements of reduced integration. Only .inp has them.");
  EXPECT_EQ(FindOutputProblem("a.k", { .IsSingle = true }), "");
  EXPECT_EQ(FindOutputProblem("a.pvtu", { .IsSingle = true }),
    "The output a.pvtu always consists of several files.");
}
