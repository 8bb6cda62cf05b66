/**
 * AbaqusText: formats names for Abaqus and CalculiX.
 */
#pragma once

#include "Report/UniqueNames.h"

#include <string>

namespace vfm
{

/// List of unique names of sets. Surfaces and element sets must share one list: if a surface and an
/// element set have the same name, CalculiX ignores the load on the surface without a message.
class AbaqusNames
{
public:
  /// Returns a valid name that was not returned before. It is in capitals and has at most 80
  /// characters. Characters other than ASCII letters and digits become '_', several of them only
  /// one. "S_" is prepended if it would not begin with a letter. A name that exists gets the ending
  /// _2, _3 and so on.
  std::string Add(const std::string& name);

private:
  UniqueNames Used{ 80 };
};

} // namespace vfm
