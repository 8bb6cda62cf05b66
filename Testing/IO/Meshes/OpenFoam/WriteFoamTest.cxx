/// Cases of OpenFOAM: order and orientation of faces, patches, zones, and the addressing of
/// decomposed cases, read by a parser of its own.
#include "Meshes/OpenFoam/WriteFoam.h"
#include "FoamReader.h"
#include "Meshes/OpenFoam/FoamMesh.h"
#include "Meshes/OpenFoam/FoamSurfaces.h"
#include "Report/Sets/NamedSurfaces.h"

#include <numeric>

using namespace vfm;
using namespace vfm::testing;

namespace
{

using Point = std::array<double, 3>;

Point operator-(const Point& a, const Point& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point PointOf(const FoamContent& content, Index point)
{
  const double* x = content.Points.data() + 3 * point;
  return { { x[0], x[1], x[2] } };
}

Point CenterOf(const FoamContent& content, const std::vector<Index>& points)
{
  Point center{};
  for (Index point : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      center[axis] += PointOf(content, point)[axis] / static_cast<double>(points.size());
    }
  }
  return center;
}

/// Returns the normal of a face, whose length is its area.
Point AreaOf(const FoamContent& content, const std::vector<Index>& face)
{
  const Point first = PointOf(content, face[0]);
  Point area{};
  for (std::size_t i = 2; i < face.size(); ++i)
  {
    const Point a = PointOf(content, face[i - 1]) - first, b = PointOf(content, face[i]) - first;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      area[axis] += (a[next] * b[last] - a[last] * b[next]) / 2;
    }
  }
  return area;
}

Index CountCells(const FoamContent& content)
{
  return 1 + *std::max_element(content.Owners.begin(), content.Owners.end());
}

/// Returns the points of each cell, from its faces.
std::vector<std::vector<Index>> PointsOfCells(const FoamContent& content)
{
  std::vector<std::vector<Index>> cells(CountCells(content));
  const auto add = [&](Index cell, std::size_t face) {
    cells[cell].insert(cells[cell].end(), content.Faces[face].begin(), content.Faces[face].end());
  };
  for (std::size_t face = 0; face < content.Faces.size(); ++face)
  {
    add(content.Owners[face], face);
    if (face < content.Neighbours.size())
    {
      add(content.Neighbours[face], face);
    }
  }
  for (std::vector<Index>& points : cells)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
  return cells;
}

/// Checks that the cells of a case are closed, and that normals point out of the owners.
void CheckCells(const FoamContent& content)
{
  const std::vector<std::vector<Index>> cells = PointsOfCells(content);
  std::vector<Point> openings(cells.size(), Point{});
  for (std::size_t face = 0; face < content.Faces.size(); ++face)
  {
    const Point area = AreaOf(content, content.Faces[face]);
    const Point center = CenterOf(content, content.Faces[face]);
    const Index owner = content.Owners[face];
    EXPECT_GT(Dot(area, center - CenterOf(content, cells[owner])), 0) << face;
    for (int axis = 0; axis < 3; ++axis)
    {
      openings[owner][axis] += area[axis];
      if (face < content.Neighbours.size())
      {
        openings[content.Neighbours[face]][axis] -= area[axis];
      }
    }
    if (face < content.Neighbours.size())
    {
      EXPECT_LT(Dot(area, center - CenterOf(content, cells[content.Neighbours[face]])), 0) << face;
    }
  }
  for (const Point& opening : openings)
  {
    EXPECT_LT(std::sqrt(Dot(opening, opening)), 1e-13);
  }
}

/// Checks the upper triangular order of inner faces, and that patches cover the other faces.
void CheckOrder(const FoamContent& content)
{
  std::vector<std::array<Index, 2>> inner;
  for (std::size_t face = 0; face < content.Neighbours.size(); ++face)
  {
    EXPECT_LT(content.Owners[face], content.Neighbours[face]);
    inner.push_back({ { content.Owners[face], content.Neighbours[face] } });
  }
  EXPECT_TRUE(std::is_sorted(inner.begin(), inner.end()));
  Index next = static_cast<Index>(inner.size());
  for (const FoamPatchEntry& patch : content.Patches)
  {
    EXPECT_EQ(patch.First(), next) << patch.Name;
    next += patch.Count();
    EXPECT_TRUE(
      std::is_sorted(content.Owners.begin() + patch.First(), content.Owners.begin() + next) ||
      patch.Words.at("type") == "processor")
      << patch.Name;
  }
  EXPECT_EQ(next, static_cast<Index>(content.Faces.size()));
}

/// A mesh without the elements of a material and without every tenth element, ordered by id.
class PartOfMesh
{
public:
  PartOfMesh(const MeshData& mesh, int removed)
  {
    this->Data = mesh;
    for (Index element = 0; element < mesh.NumberOfElements; ++element)
    {
      if (mesh.Material[element] != removed && mesh.ElementIds[element] % 10 != 0)
      {
        this->Elements.insert(
          this->Elements.end(), mesh.Element(element), mesh.Element(element + 1));
        this->Ids.push_back(mesh.ElementIds[element]);
        this->Material.push_back(mesh.Material[element]);
      }
    }
    this->Data.NumberOfElements = static_cast<Index>(this->Ids.size());
    this->Data.Elements = this->Elements.data();
    this->Data.ElementIds = this->Ids.data();
    this->Data.Material = this->Material.data();
    this->Data.Fragment = nullptr;
    this->Data.Facets = nullptr;
    this->Data.ElementArrays = { { "GlobalCellIds", ValueType::Long, 1, {}, this->Ids.data() },
      { "MaterialId", ValueType::Int, 1, {}, this->Material.data() } };
  }
  MeshData Data;

private:
  std::vector<Index> Elements, Ids;
  std::vector<int> Material;
};

/// Writes the grains, or a part of them with material 2 removed.
void WriteGrains(
  int count, MeshMaker make, bool isPart, const std::string& path, const FoamForm& form)
{
  WithMesh(count, make,
    [&](const FileCase& part, Ranks& ranks)
    {
      if (isPart)
      {
        WriteFoam(PartOfMesh(part.Mesh, 2).Data, path, ranks, form);
      }
      else
      {
        WriteFoam(part.Mesh, path, ranks, form);
      }
    });
}

/// Calls check(folder, form, make, isPart) for all forms of the grains.
template <class Check>
void ForCases(const Check& check)
{
  for (const MeshMaker make : { MakeHexMesh, MakeTetMesh })
  {
    for (const bool isBinary : { false, true })
    {
      for (const bool isPart : { false, true })
      {
        const Folder folder;
        WriteGrains(1, make, isPart, folder / "mesh.foam", { false, isBinary });
        check(folder, isBinary, make, isPart);
      }
    }
  }
}

/// Returns the points of a face in the whole mesh, from the first one.
std::vector<Index> PointsOf(
  const std::vector<Index>& places, const std::vector<Index>& points, bool isReversed)
{
  std::vector<Index> moved;
  for (Index point : points)
  {
    moved.push_back(places[point]);
  }
  if (isReversed)
  {
    std::reverse(moved.begin() + 1, moved.end());
  }
  return moved;
}

/// Checks a rank's mesh against the whole one. Counts its faces and cells.
void CheckPart(const FoamContent& whole, const FoamContent& part, std::vector<int>& faces,
  std::vector<int>& cells)
{
  const std::vector<Index>& places = part.Addressing.at("point");
  ASSERT_EQ(3 * places.size(), part.Points.size());
  for (std::size_t i = 0; i < part.Points.size(); ++i)
  {
    EXPECT_EQ(part.Points[i], whole.Points[3 * places[i / 3] + i % 3]);
  }
  const std::vector<Index>& cell = part.Addressing.at("cell");
  for (Index number : cell)
  {
    ++cells[number];
  }
  ASSERT_EQ(part.Addressing.at("face").size(), part.Faces.size());
  for (std::size_t f = 0; f < part.Faces.size(); ++f)
  {
    const Index number = part.Addressing.at("face")[f], face = std::abs(number) - 1;
    ASSERT_NE(number, 0);
    ++faces[face];
    EXPECT_EQ(PointsOf(places, part.Faces[f], number < 0), whole.Faces[face]);
    EXPECT_EQ(cell[part.Owners[f]], number < 0 ? whole.Neighbours.at(face) : whole.Owners[face]);
    if (f < part.Neighbours.size())
    {
      EXPECT_GT(number, 0);
      EXPECT_EQ(cell[part.Neighbours[f]], whole.Neighbours.at(face));
    }
  }
}

/// Checks that the patches of a rank are those of the whole mesh, then those to other ranks.
void CheckPatches(const FoamContent& whole, const FoamContent& part, int rank)
{
  for (std::size_t p = 0; p < part.Patches.size(); ++p)
  {
    const FoamPatchEntry& patch = part.Patches[p];
    const Index number = part.Addressing.at("boundary")[p];
    if (p >= whole.Patches.size())
    {
      EXPECT_EQ(number, -1);
      EXPECT_EQ(
        patch.Name, "procBoundary" + std::to_string(rank) + "to" + patch.Words.at("neighbProcNo"));
      EXPECT_EQ(patch.Words.at("myProcNo"), std::to_string(rank));
      continue;
    }
    EXPECT_EQ(number, static_cast<Index>(p));
    EXPECT_EQ(patch.Name, whole.Patches[p].Name);
    EXPECT_EQ(patch.Words.at("type"), whole.Patches[p].Words.at("type"));
    for (Index f = patch.First(); f < patch.First() + patch.Count(); ++f)
    {
      const Index face = part.Addressing.at("face")[f] - 1;
      EXPECT_GE(face, whole.Patches[p].First());
      EXPECT_LT(face, whole.Patches[p].First() + whole.Patches[p].Count());
    }
  }
}

/// Checks the zones of a rank: each member with its flag.
void CheckZones(const FoamContent& whole, const FoamContent& part)
{
  ASSERT_EQ(part.FaceZones.size(), whole.FaceZones.size());
  for (std::size_t z = 0; z < whole.FaceZones.size(); ++z)
  {
    const FoamZoneEntry &all = whole.FaceZones[z], &some = part.FaceZones[z];
    EXPECT_EQ(some.Name, all.Name);
    std::map<Index, char> flips;
    for (std::size_t i = 0; i < all.Members.size(); ++i)
    {
      flips[all.Members[i] + 1] = all.Flips[i];
    }
    Index members = 0;
    for (Index face : part.Addressing.at("face"))
    {
      members += flips.count(std::abs(face)) > 0 ? 1 : 0;
    }
    EXPECT_EQ(members, static_cast<Index>(some.Members.size())) << some.Name;
    for (std::size_t i = 0; i < some.Members.size(); ++i)
    {
      const Index face = part.Addressing.at("face")[some.Members[i]];
      EXPECT_EQ(some.Flips[i] != 0, (flips.at(std::abs(face)) != 0) != (face < 0));
    }
  }
  ASSERT_EQ(part.CellZones.size(), whole.CellZones.size());
  for (std::size_t z = 0; z < whole.CellZones.size(); ++z)
  {
    const std::vector<Index>& all = whole.CellZones[z].Members;
    EXPECT_EQ(part.CellZones[z].Name, whole.CellZones[z].Name);
    for (Index cell : part.CellZones[z].Members)
    {
      EXPECT_TRUE(std::binary_search(all.begin(), all.end(), part.Addressing.at("cell")[cell]));
    }
  }
}

/// Checks that two ranks have the faces between them in the same order.
void CheckPairs(const std::vector<FoamContent>& parts)
{
  for (std::size_t rank = 0; rank < parts.size(); ++rank)
  {
    for (const FoamPatchEntry& patch : parts[rank].Patches)
    {
      if (patch.Words.at("type") != "processor")
      {
        continue;
      }
      const FoamContent& other = parts.at(std::stoul(patch.Words.at("neighbProcNo")));
      const auto same = std::find_if(other.Patches.begin(), other.Patches.end(),
        [&](const FoamPatchEntry& entry)
        {
          return entry.Words.at("type") == "processor" &&
            entry.Words.at("neighbProcNo") == std::to_string(rank);
        });
      ASSERT_NE(same, other.Patches.end());
      ASSERT_EQ(same->Count(), patch.Count());
      for (Index f = 0; f < patch.Count(); ++f)
      {
        EXPECT_EQ(parts[rank].Addressing.at("face")[patch.First() + f],
          -other.Addressing.at("face")[same->First() + f]);
      }
    }
  }
}

std::vector<FoamContent> ReadParts(const Folder& folder, int count)
{
  std::vector<FoamContent> parts;
  for (int rank = 0; rank < count; ++rank)
  {
    parts.push_back(ReadFoam(folder / ("processor" + std::to_string(rank))));
  }
  return parts;
}

std::string Body(const std::string& path)
{
  const std::string text = ReadBytes(path);
  return text.substr(text.find("}\n") + 3);
}

/// Returns the bytes of all files of a folder by name.
std::map<std::string, std::string> ReadFolder(const std::string& folder)
{
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      files[std::filesystem::relative(entry.path(), folder)] = ReadBytes(entry.path());
    }
  }
  return files;
}

} // namespace

TEST(WriteFoam, TextOfTwoCubes)
{
  const Folder folder;
  Ranks alone;
  WriteFoam(TwoCubes().Data, folder / "mesh.foam", alone);
  const std::string path = folder / "constant/polyMesh/";
  EXPECT_EQ(Body(path + "faces"),
    "11\n(\n4(1 4 10 7)\n4(0 6 9 3)\n4(0 1 7 6)\n4(1 2 8 7)\n4(3 9 10 4)\n4(4 10 11 5)\n"
    "4(0 3 4 1)\n4(1 4 5 2)\n4(6 7 10 9)\n4(7 8 11 10)\n4(2 5 11 8)\n)\n");
  EXPECT_EQ(Body(path + "owner"), "11\n(\n0\n0\n0\n1\n0\n1\n0\n1\n0\n1\n1\n)\n");
  EXPECT_EQ(Body(path + "neighbour"), "1\n(\n1\n)\n");
  EXPECT_EQ(Body(path + "points").substr(0, 35), "12\n(\n(0 0 0)\n(1 0 0)\n(2 0 0)\n(0 1 0");
  EXPECT_EQ(Body(path + "cellZones"),
    "2\n(\na__b_\n{\n    type cellZone;\n    cellLabels List<label>\n1\n(\n0\n)\n;\n}\n"
    "c\n{\n    type cellZone;\n    cellLabels List<label>\n1\n(\n1\n)\n;\n}\n)\n");
  EXPECT_EQ(Body(path + "faceZones"),
    "1\n(\na__b__to_c\n{\n    type faceZone;\n    faceLabels List<label>\n1\n(\n0\n)\n;\n"
    "    flipMap List<bool>\n1\n(\n0\n)\n;\n}\n)\n");
  const std::vector<FoamPatchEntry> patches = ReadFoamPatches(path + "boundary");
  ASSERT_EQ(patches.size(), 6u);
  EXPECT_EQ(patches[5].Name, "c_to_Void");
  EXPECT_EQ(patches[5].Words,
    (std::map<std::string, std::string>{
      { "type", "wall" }, { "inGroups", "(wall)" }, { "nFaces", "1" }, { "startFace", "10" } }));
  EXPECT_EQ(patches[0].Words,
    (std::map<std::string, std::string>{
      { "type", "patch" }, { "nFaces", "1" }, { "startFace", "1" } }));
}

TEST(WriteFoam, CellsAreClosedAndFacesOrdered)
{
  ForCases(
    [](const Folder& folder, bool, MeshMaker make, bool)
    {
      const FoamContent content = ReadFoam(folder / "");
      const std::size_t sides = make == &MakeHexMesh ? 6 : 4;
      EXPECT_EQ(content.Faces.size() + content.Neighbours.size(), sides * CountCells(content));
      CheckCells(content);
      CheckOrder(content);
    });
}

TEST(WriteFoam, PatchesAndZonesAreTheNamedSurfaces)
{
  ForCases(
    [](const Folder& folder, bool, MeshMaker make, bool isPart)
    {
      const FoamContent content = ReadFoam(folder / "");
      WithMesh(1, make,
        [&](const FileCase& grains, Ranks& ranks)
        {
          const PartOfMesh part(grains.Mesh, 2);
          const MeshData& mesh = isPart ? part.Data : grains.Mesh;
          std::map<std::string, Index> expected, found;
          for (const NamedSurface& surface : FindNamedSurfaces(mesh, ranks))
          {
            if (surface.Kind == SurfaceKind::DomainSide || surface.Kind == SurfaceKind::Interface)
            {
              expected[FoamWord(surface.Name)] = static_cast<Index>(surface.Sides.size());
            }
          }
          for (const FoamPatchEntry& patch : content.Patches)
          {
            found[patch.Name] += patch.Count();
            const bool isWall = patch.Name.find("_to_Void") != std::string::npos;
            EXPECT_EQ(patch.Words.at("type"), isWall ? "wall" : "patch");
          }
          for (const FoamZoneEntry& zone : content.FaceZones)
          {
            found[zone.Name] += static_cast<Index>(zone.Members.size());
          }
          EXPECT_EQ(found.erase("defaultFaces"), isPart ? 1u : 0u);
          EXPECT_EQ(found, expected);
          EXPECT_EQ(found.count("one_to_Void"), isPart ? 1u : 0u);
          ASSERT_EQ(content.CellZones.size(), isPart ? 2u : 3u);
          for (const FoamZoneEntry& zone : content.CellZones)
          {
            const int material = zone.Name == "one" ? 1 : zone.Name == "three" ? 3 : 2;
            EXPECT_EQ(static_cast<Index>(zone.Members.size()),
              std::count(mesh.Material, mesh.Material + mesh.NumberOfElements, material));
            for (Index cell : zone.Members)
            {
              EXPECT_EQ(mesh.Material[cell], material);
            }
          }
        });
    });
}

TEST(WriteFoam, FaceZonesPointToTheSecondMaterial)
{
  const Folder folder;
  WriteGrains(1, MakeHexMesh, false, folder / "mesh.foam", {});
  const FoamContent content = ReadFoam(folder / "");
  std::vector<std::string> names(CountCells(content));
  for (const FoamZoneEntry& zone : content.CellZones)
  {
    for (Index cell : zone.Members)
    {
      names[cell] = zone.Name;
    }
  }
  ASSERT_EQ(content.FaceZones.size(), 3u);
  std::array<int, 2> flips{};
  for (const FoamZoneEntry& zone : content.FaceZones)
  {
    for (std::size_t i = 0; i < zone.Members.size(); ++i)
    {
      std::array<Index, 2> cells{ { content.Owners[zone.Members[i]],
        content.Neighbours.at(zone.Members[i]) } };
      ++flips[zone.Flips[i]];
      if (zone.Flips[i])
      {
        std::swap(cells[0], cells[1]);
      }
      EXPECT_EQ(names[cells[0]] + "_to_" + names[cells[1]], zone.Name);
    }
  }
  EXPECT_GT(flips[0], 0);
  EXPECT_GT(flips[1], 0);
}

TEST(WriteFoam, RanksWriteTheDecomposedCase)
{
  ForCases(
    [](const Folder& folder, bool isBinary, MeshMaker make, bool isPart)
    {
      const FoamContent whole = ReadFoam(folder / "");
      EXPECT_TRUE(whole.Addressing.empty());
      constexpr int count = 3;
      WriteGrains(count, make, isPart, folder / "mesh.foam", { false, isBinary });
      const std::vector<FoamContent> parts = ReadParts(folder, count);
      std::vector<int> faces(whole.Faces.size()), cells(CountCells(whole));
      for (int rank = 0; rank < count; ++rank)
      {
        CheckPart(whole, parts[rank], faces, cells);
        CheckPatches(whole, parts[rank], rank);
        CheckZones(whole, parts[rank]);
        CheckCells(parts[rank]);
        CheckOrder(parts[rank]);
      }
      CheckPairs(parts);
      EXPECT_EQ(std::count(cells.begin(), cells.end(), 1), CountCells(whole));
      EXPECT_EQ(std::count(faces.begin(), faces.end(), 0), 0);
      EXPECT_GT(std::count(faces.begin(), faces.end(), 2), 0);
      EXPECT_NE(ReadBytes(folder / "system/decomposeParDict").find("numberOfSubdomains 3;"),
        std::string::npos);
    });
}

TEST(WriteFoam, WholeMeshFromRanksHasTheSameBytes)
{
  ForCases(
    [](const Folder& folder, bool isBinary, MeshMaker make, bool isPart)
    {
      const std::map<std::string, std::string> files = ReadFolder(folder / "");
      EXPECT_EQ(files.size(), 12u);
      EXPECT_EQ(files.at("mesh.foam"), "");
      std::filesystem::remove_all(folder / "constant");
      WriteGrains(3, make, isPart, folder / "mesh.foam", { true, isBinary });
      EXPECT_EQ(ReadFolder(folder / ""), files);
    });
}

TEST(WriteFoam, RanksWithoutElements)
{
  const Folder folder;
  Ranks alone;
  const TwoCubes cubes;
  WriteFoam(cubes.Data, folder / "mesh.foam", alone, { false, true });
  const FoamContent whole = ReadFoam(folder / "");
  RunOnRanks(2,
    [&](Ranks& ranks)
    {
      WriteFoam(
        ranks.Rank() == 1 ? cubes.Data : MeshData(), folder / "mesh.foam", ranks, { false, true });
    });
  const std::vector<FoamContent> parts = ReadParts(folder, 2);
  EXPECT_TRUE(parts[0].Faces.empty() && parts[0].Points.empty());
  CheckPatches(whole, parts[0], 0);
  CheckZones(whole, parts[0]);
  std::vector<int> faces(whole.Faces.size()), cells(2);
  CheckPart(whole, parts[1], faces, cells);
  EXPECT_EQ(faces, std::vector<int>(faces.size(), 1));
  const std::string path = folder / "processor0/constant/polyMesh/";
  EXPECT_EQ(Body(path + "points"), "0\n");
  EXPECT_EQ(Body(path + "faces").substr(0, 3), "1\n(");
}

TEST(WriteFoam, DictionariesOfTheUserRemain)
{
  const Folder folder;
  std::filesystem::create_directory(folder / "system");
  std::ofstream(folder / "system/fvSchemes") << "mine";
  Ranks alone;
  WriteFoam(TwoCubes().Data, folder / "mesh.foam", alone);
  EXPECT_EQ(ReadBytes(folder / "system/fvSchemes"), "mine");
  EXPECT_NE(ReadBytes(folder / "system/controlDict").find("deltaT"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "system/decomposeParDict"));
}

TEST(WriteFoam, AFailureRemovesTheFilesOfAllRanks)
{
  const Folder folder;
  std::ofstream(folder / "processor1") << "a file, not a folder";
  std::vector<std::string> messages(3);
  WithMesh(3, MakeHexMesh,
    [&](const FileCase& part, Ranks& ranks)
    {
      try
      {
        WriteFoam(part.Mesh, folder / "mesh.foam", ranks);
      }
      catch (const InputError& error)
      {
        messages[ranks.Rank()] = error.what();
      }
    });
  EXPECT_NE(messages[0].find("processor1: Not a directory."), std::string::npos) << messages[0];
  EXPECT_EQ(messages, std::vector<std::string>(3, messages[0]));
  EXPECT_EQ(folder.CountFiles(), 1u);
}

TEST(WriteFoam, LabelsHave32Bits)
{
  const TwoCubes cubes;
  FoamMesh foam;
  foam.Mesh = cubes.Data;
  foam.TotalFaces = 2147483647;
  EXPECT_NO_THROW(CheckSizes(foam));
  ++foam.TotalFaces;
  EXPECT_THROW(CheckSizes(foam), InputError);
}

TEST(WriteFoam, LargeIdsArePositions)
{
  const Folder folder;
  Ranks alone;
  WriteFoam(TwoCubes().Data, folder / "mesh.foam", alone);
  const std::map<std::string, std::string> files = ReadFolder(folder / "");
  WriteFoam(TwoCubes(Index{ 1 } << 40).Data, folder / "mesh.foam", alone);
  EXPECT_EQ(ReadFolder(folder / ""), files);
}

TEST(WriteFoam, Words)
{
  EXPECT_EQ(FoamWord("steel"), "steel");
  EXPECT_EQ(FoamWord("Material 7"), "Material_7");
  EXPECT_EQ(FoamWord("3 \"a\"; {b}/c"), "_3__a____b__c");
  EXPECT_EQ(FoamWord("gr\xc3\xb6\xc3\x9f"), "gr__");
  EXPECT_EQ(FoamWord(""), "_");
}
