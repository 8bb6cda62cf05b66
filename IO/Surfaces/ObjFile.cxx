#include "Surfaces/ObjFile.h"

#include "Surfaces/PatchList.h"
#include "Surfaces/PolygonTriangles.h"
#include "Surfaces/TextScan.h"

#include <array>

namespace vfm
{
namespace
{

/// Names that divide the faces, by the preference of their use.
enum Division
{
  Material,
  Group,
  Object,
  Divisions
};

/// Patches of the faces for each way to divide them.
struct FacePatches
{
  std::array<PatchList, Divisions> Lists;
  std::array<int, Divisions> Current{};
  std::array<std::vector<int>, Divisions> Patches;

  /// Faces before the first name are in a patch without a name.
  FacePatches()
  {
    for (PatchList& list : this->Lists)
    {
      list.Find("");
    }
  }
  void Name(Division division, std::string_view name)
  {
    this->Current[division] = this->Lists[division].Find(std::string(name));
  }
};

/// Returns the number of the point of a corner such as 7, 7/1 or -1//2.
Index FindPoint(TextScan& text, std::string_view word, Index points)
{
  Index number = 0;
  const std::string_view first = word.substr(0, word.find('/'));
  if (!ReadInteger(first, number) || number == 0 || number > points || number < -points)
  {
    text.Reject("the face refers to the point " + QuoteText(first) + ", but there are " +
      std::to_string(points) + " points.");
  }
  return number > 0 ? number - 1 : points + number;
}

void ReadFace(TextScan& text, FacePatches& patches, SurfaceFile& file)
{
  std::vector<Index> corners;
  for (std::string_view word = text.WordOfLine(); !word.empty(); word = text.WordOfLine())
  {
    if (word == "\\") // the line goes on
    {
      text.RestOfLine();
      continue;
    }
    corners.push_back(FindPoint(text, word, static_cast<Index>(file.Points.size())));
  }
  AddPolygon(corners, 0, file);
  for (int d = 0; d < Divisions; ++d)
  {
    patches.Patches[d].resize(file.Triangles.size(), patches.Current[d]);
  }
}

/// Selects the first way that makes several patches, or else one that has names.
void SelectPatches(const FacePatches& patches, SurfaceFile& file)
{
  for (std::size_t least : { 2, 1 })
  {
    for (int d = 0; d < Divisions; ++d)
    {
      file.Patches = patches.Patches[d];
      patches.Lists[d].Finish(file);
      if (file.PatchNames.size() >= least && (least == 2 || !file.PatchNames[0].empty()))
      {
        return;
      }
    }
  }
}

} // namespace

SurfaceFile ReadObj(std::string_view bytes)
{
  SurfaceFile file;
  FacePatches patches;
  TextScan text(bytes);
  while (!text.IsAtEnd())
  {
    const std::string_view word = text.WordOfLine();
    if (word == "v")
    {
      Vector3 point{};
      for (double& x : point)
      {
        x = text.Number("coordinate of a point");
      }
      file.Points.push_back(point);
      text.RestOfLine();
    }
    else if (word == "f")
    {
      ReadFace(text, patches, file);
    }
    else
    {
      const std::string_view name = text.RestOfLine();
      if (word == "usemtl" || word == "g" || word == "o")
      {
        patches.Name(word == "g" ? Group : word == "o" ? Object : Material, name);
      }
    }
  }
  SelectPatches(patches, file);
  return file;
}

} // namespace vfm
