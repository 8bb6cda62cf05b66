/**
 * ArrayStems: finds arrays whose names differ only in the number or name of a material, or in
 * an axis.
 *
 * The names of the fractions show which tokens name materials. "Material volume fraction - 1" and
 * "Material volume fraction - 2": 1 and 2 name materials, so "Material density - 1" belongs to
 * material 1. "frac_steel" and "frac_copper": "rho_steel" belongs to steel. A name that ends with
 * " - " and the number of a material always belongs to this material. A separate x, y or z marks a
 * component: "X velocity", "velocity_x".
 */
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// The common part of array names, and the names.
struct ArrayStem
{
  std::string Name;                 ///< common part of the names
  std::vector<std::string> Members; ///< array of each material from 1, or of x, y, z
};

/// Returns the arrays of all components of a vector from one of them; nothing if its name has
/// no axis.
std::optional<ArrayStem> FindVector(const std::string& component);

/// Returns whether a name is that of a vector or of one of its components. The vector may be given
/// by the name of a component.
bool IsOfVector(const std::string& name, const std::string& vector);

/// Tokens that name materials in array names.
class MaterialStems
{
public:
  /// Finds the tokens. There are none for fewer than two materials.
  /// @param names,labels names and labels of void and each material (Materials)
  MaterialStems(const std::vector<std::string>& names, const std::vector<int>& labels);

  /// Returns the stems that may have a name as member, the most likely first.
  std::vector<ArrayStem> FindStems(const std::string& name) const;

private:
  std::vector<std::string> Tokens;  // part of the name of each material that the others lack
  std::vector<std::string> Numbers; // " - " and the number of each material
};

} // namespace vfm
