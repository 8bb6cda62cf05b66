/**
 * ChosenArray: an array of the input, by its name and what its values belong to.
 */
#ifndef ChosenArray_h
#define ChosenArray_h

#include <string>
#include <vector>

namespace vfm
{

/// The cells' array of a name, or where cells have none the points'.
constexpr int AnyAssociation = -1;

struct ChosenArray
{
  std::string Name;
  int Association = AnyAssociation; ///< or vtkDataObject::FIELD_ASSOCIATION_CELLS, _POINTS

  bool operator==(const ChosenArray& other) const
  {
    return this->Name == other.Name && this->Association == other.Association;
  }
};

/// The arrays of the input that are read.
struct ArraysToRead
{
  std::vector<ChosenArray> Materials, Others;
};

inline std::vector<std::string> NamesOf(const std::vector<ChosenArray>& arrays)
{
  std::vector<std::string> names;
  for (const ChosenArray& array : arrays)
  {
    names.push_back(array.Name);
  }
  return names;
}

} // namespace vfm

#endif
