/**
 * FoamReader: reads the files of a mesh of OpenFOAM, text or binary, for tests.
 */
#pragma once

#include "FileCases.h"

#include <map>
#include <sstream>

namespace vfm
{
namespace testing
{

/// Numbers of a file after its header.
class FoamStream
{
public:
  explicit FoamStream(const std::string& path)
  {
    const std::string bytes = ReadBytes(path);
    const std::size_t end = bytes.find("}\n");
    EXPECT_NE(end, std::string::npos) << path;
    this->IsBinary = bytes.find("format      binary") < end;
    this->Stream.str(bytes.substr(end + 2));
  }

  Index Text()
  {
    Index number = -1;
    this->Stream >> number;
    return number;
  }
  std::string Word()
  {
    std::string word;
    this->Stream >> word;
    return word;
  }
  /// Reads a list of T, binary numbers of type Stored.
  template <class Stored, class T>
  std::vector<T> List(Index components = 1)
  {
    std::vector<T> values(static_cast<std::size_t>(components * this->Text()));
    if (this->IsBinary && values.empty())
    {
      return values;
    }
    this->Skip('(');
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = this->Number<Stored, T>();
    }
    this->Skip(')');
    return values;
  }
  std::vector<Index> Labels() { return this->List<std::int32_t, Index>(); }
  std::vector<char> Flags()
  {
    const std::vector<int> flags = this->List<char, int>();
    return { flags.begin(), flags.end() };
  }
  std::vector<std::vector<Index>> Faces()
  {
    if (this->IsBinary)
    {
      return this->CompactFaces();
    }
    std::vector<std::vector<Index>> faces(static_cast<std::size_t>(this->Text()));
    this->Skip('(');
    for (std::vector<Index>& face : faces)
    {
      face = this->Labels();
    }
    this->Skip(')');
    return faces;
  }

private:
  void Skip(char expected)
  {
    char found = 0;
    this->Stream >> found;
    EXPECT_EQ(found, expected);
  }

  template <class Stored, class T>
  T Number()
  {
    T value{};
    if (this->IsBinary)
    {
      Stored stored{};
      this->Stream.read(reinterpret_cast<char*>(&stored), sizeof(stored));
      return static_cast<T>(stored);
    }
    while (
      this->Stream.peek() == '(' || this->Stream.peek() == ')' || std::isspace(this->Stream.peek()))
    {
      this->Stream.get(); // between points
    }
    this->Stream >> value;
    return value;
  }

  std::vector<std::vector<Index>> CompactFaces()
  {
    const std::vector<Index> ends = this->Labels(), points = this->Labels();
    std::vector<std::vector<Index>> faces;
    for (std::size_t f = 1; f < ends.size(); ++f)
    {
      faces.emplace_back(points.begin() + ends[f - 1], points.begin() + ends[f]);
    }
    return faces;
  }

  std::istringstream Stream;
  bool IsBinary = false;
};

struct FoamPatchEntry
{
  std::string Name;
  std::map<std::string, std::string> Words;
  Index First() const { return std::stoll(this->Words.at("startFace")); }
  Index Count() const { return std::stoll(this->Words.at("nFaces")); }
};

struct FoamZoneEntry
{
  std::string Name;
  std::vector<Index> Members;
  std::vector<char> Flips;
};

/// A mesh in a folder.
struct FoamContent
{
  std::vector<double> Points;
  std::vector<std::vector<Index>> Faces;
  std::vector<Index> Owners, Neighbours;
  std::vector<FoamPatchEntry> Patches;
  std::vector<FoamZoneEntry> CellZones, FaceZones;
  std::map<std::string, std::vector<Index>> Addressing;
};

inline std::vector<FoamPatchEntry> ReadFoamPatches(const std::string& path)
{
  FoamStream file(path);
  std::vector<FoamPatchEntry> patches(static_cast<std::size_t>(file.Text()));
  EXPECT_EQ(file.Word(), "(");
  for (FoamPatchEntry& patch : patches)
  {
    patch.Name = file.Word();
    EXPECT_EQ(file.Word(), "{");
    for (std::string key = file.Word(); key != "}" && !key.empty(); key = file.Word())
    {
      std::string& value = patch.Words[key];
      do
      {
        value += (value.empty() ? "" : " ") + file.Word();
      } while (value.back() != ';');
      value.pop_back();
    }
  }
  return patches;
}

inline std::vector<FoamZoneEntry> ReadFoamZones(const std::string& path)
{
  FoamStream file(path);
  std::vector<FoamZoneEntry> zones(static_cast<std::size_t>(file.Text()));
  EXPECT_EQ(file.Word(), "(");
  for (FoamZoneEntry& zone : zones)
  {
    zone.Name = file.Word();
    EXPECT_EQ(file.Word(), "{");
    EXPECT_EQ(file.Word(), "type");
    const std::string type = file.Word();
    file.Word();
    EXPECT_EQ(file.Word(), "List<label>");
    zone.Members = file.Labels();
    EXPECT_EQ(file.Word(), ";");
    if (type == "faceZone;")
    {
      EXPECT_EQ(file.Word(), "flipMap");
      EXPECT_EQ(file.Word(), "List<bool>");
      zone.Flips = file.Flags();
      EXPECT_EQ(file.Word(), ";");
    }
    EXPECT_EQ(file.Word(), "}");
  }
  return zones;
}

/// Reads the mesh of a case, or of the folder of a rank.
inline FoamContent ReadFoam(const std::string& folder)
{
  const std::string path = folder + "/constant/polyMesh/";
  FoamContent content;
  content.Points = FoamStream(path + "points").List<double, double>(3);
  content.Faces = FoamStream(path + "faces").Faces();
  content.Owners = FoamStream(path + "owner").Labels();
  content.Neighbours = FoamStream(path + "neighbour").Labels();
  content.Patches = ReadFoamPatches(path + "boundary");
  content.CellZones = ReadFoamZones(path + "cellZones");
  content.FaceZones = ReadFoamZones(path + "faceZones");
  EXPECT_TRUE(ReadFoamZones(path + "pointZones").empty());
  for (const char* name : { "point", "face", "cell", "boundary" })
  {
    const std::string file = path + name + "ProcAddressing";
    if (std::filesystem::exists(file))
    {
      content.Addressing[name] = FoamStream(file).Labels();
    }
  }
  return content;
}

} // namespace testing
} // namespace vfm
