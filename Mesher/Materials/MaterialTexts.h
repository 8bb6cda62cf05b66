/**
 * MaterialTexts: parts of messages about materials.
 */
#pragma once

#include "Input/InputFields.h"

namespace vfm
{

/// Returns a material for a message: its name and id.
std::string NameMaterial(const Materials& table, std::size_t material);

/// Returns the first items in a sequence, and how many more there are.
std::string Enumerate(const std::vector<std::string>& items);

/// Returns a number of materials and a verb: `one` for one material, else `several`.
std::string CountMaterials(std::size_t count, const char* one, const char* several);

/// Returns a positive number with three digits, which is not larger.
double RoundDown(double number);

/// Returns a share in percent: two digits, above 100 % all before the point.
std::string PercentOf(double share, bool showsPlus = false);

/// Returns the values of the materials that are meshed.
template <class Value>
std::vector<Value> TakeMeshed(const std::vector<Value>& values, bool meshVoid)
{
  const std::size_t first = meshVoid ? 0 : 1;
  return { values.begin() + std::min(first, values.size()), values.end() };
}

} // namespace vfm
