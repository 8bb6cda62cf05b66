/**
 * MaterialPairs: pairs of materials that the user selects by names or ids.
 */
#pragma once

#include "Options/FindMaterial.h"

#include <array>
#include <vector>

namespace vfm
{

class MaterialPairs
{
public:
  /// Parses "all", or pairs with commas between them: steel/copper, 1/3, steel/\*. A material is a
  /// name, or an id; \* is any material, 0 or Void a meshed void.
  /// @param option name of the option, for messages
  /// @param names names of all materials by id
  /// @throws InputError if a text is not a pair of two different materials
  MaterialPairs(const std::string& option, const std::string& text, const NamesById& names);

  /// Returns whether the user selected two different materials.
  bool Contains(int one, int other) const;
  /// Returns whether the user selected two different materials in this order.
  bool IsFirst(int first, int second) const;

private:
  static constexpr int Any = -1;
  using Pair = std::array<int, 2>;

  std::vector<Pair> Pairs;
};

/// Returns the pairs of materials in an option, or nothing if its text is empty.
inline std::optional<MaterialPairs> ReadPairs(
  const std::string& option, const std::string& text, const NamesById& names)
{
  return text.empty() ? std::nullopt
                      : std::optional<MaterialPairs>(MaterialPairs(option, text, names));
}

} // namespace vfm
