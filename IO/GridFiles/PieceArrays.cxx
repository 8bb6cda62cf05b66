#include "GridFiles/PieceArrays.h"

#include "GridFiles/VtkExtents.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Checks that an attribute of two arrays is the same.
void CheckSame(const OutlineElement& array, const OutlineElement& wanted, const std::string& name,
  const std::string& preset)
{
  const auto get = [&](const OutlineElement& element)
  { return element.Attributes.count(name) > 0 ? element.Get(name) : preset; };
  if (get(array) != get(wanted))
  {
    RejectVtkFile("the array '" + array.Get("Name") + "' of one of its pieces has the " + name +
      " " + get(array) + ", " + get(wanted) + " is required");
  }
}

/// Returns the array of a name, or of the same number if order counts; null if there is none.
const OutlineElement* FindArray(
  const OutlineElement& list, const OutlineElement& like, std::size_t number, bool inOrder)
{
  const auto& arrays = list.Children;
  if (inOrder)
  {
    return number < arrays.size() ? &arrays[number] : nullptr;
  }
  const auto found = std::find_if(arrays.begin(), arrays.end(),
    [&like](const OutlineElement& array) { return array.Get("Name") == like.Get("Name"); });
  return found == arrays.end() ? nullptr : &*found;
}

void CheckList(const OutlineElement* list, const OutlineElement& like, bool isNamed, bool inOrder)
{
  for (std::size_t a = 0; a < like.Children.size(); ++a)
  {
    const OutlineElement& wanted = like.Children[a];
    const OutlineElement* array = list ? FindArray(*list, wanted, a, inOrder) : nullptr;
    if (!array || (isNamed && array->Get("Name") != wanted.Get("Name")))
    {
      RejectVtkFile(
        "one of its pieces has no array '" + wanted.Get("Name") + "' in its place, as others have");
    }
    CheckSame(*array, wanted, "type", "");
    CheckSame(*array, wanted, "NumberOfComponents", "1");
  }
}

} // namespace

void CheckPieceArrays(
  const OutlineElement& piece, const OutlineElement& like, const std::string& prefix)
{
  for (const char* name : { "PointData", "CellData", "Points", "Coordinates" })
  {
    const bool isNamed = std::string(name).find("Data") != std::string::npos;
    if (const OutlineElement* list = like.Find(prefix + name))
    {
      CheckList(piece.Find(name), *list, isNamed, !isNamed || prefix.empty());
    }
  }
}

} // namespace vfm
