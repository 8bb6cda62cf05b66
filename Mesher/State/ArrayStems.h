/**
 * ArrayStems: names of arrays that differ only in the number or name of a material, as those of fractions do, or in an axis.
 *
 * "Material volume fraction - 1" and "Material volume fraction - 2" tell that 1 and 2 name the materials, so "Material density - 1" is the
 * material density of the first; "frac_steel" and "frac_copper" that "rho_steel" is that of steel. " - " and the number of a material
 * at the end of a name does so, whatever the fractions are called. A lone x, y or z tells components: "X velocity", "velocity_x".
 */
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

struct ArrayStem
{
  std::string Name;                 ///< what they share
  std::vector<std::string> Members; ///< of each material from 1, or of x, y, z
};

/// The arrays of a vector by that of a component; nothing where a name has no axis.
std::optional<ArrayStem> FindVector(const std::string& component);

/// Whether a name is that of a vector, or of a component of it; the vector may be named by that of a component.
bool IsOfVector(const std::string& name, const std::string& vector);

class MaterialStems
{
public:
  /// names, labels: of void and each material (Materials). Of fewer than two materials there are no stems.
  MaterialStems(const std::vector<std::string>& names, const std::vector<int>& labels);

  /// The stems that a name may be a member of, the likeliest first.
  std::vector<ArrayStem> FindStems(const std::string& name) const;

private:
  std::vector<std::string> Tokens;  // of each material from 1: what its fractions' name has alone
  std::vector<std::string> Numbers; // " - " and its number
};

} // namespace vfm
