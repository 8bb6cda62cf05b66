/**
 * ChosenArray: an array of the input, given by its name and association.
 */
#ifndef ChosenArray_h
#define ChosenArray_h

#include <string>
#include <vector>

namespace vfm
{

/// Means the cell array with a name or, if there is none, the point array.
constexpr int AnyAssociation = -1;

struct ChosenArray
{
  std::string Name;
  /// AnyAssociation, vtkDataObject::FIELD_ASSOCIATION_CELLS or _POINTS.
  int Association = AnyAssociation;

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
