/**
 * NrrdFields: reads the lines of the header of an NRRD file.
 */
#pragma once

#include "Base/IndexBox.h"

#include <map>
#include <string>
#include <vector>

namespace vfm
{

/// Lines of the header.
struct NrrdFields
{
  std::map<std::string, std::string> Fields; ///< lines 'field: value'
  std::map<std::string, std::string> Pairs;  ///< lines 'key:=value'
  std::vector<std::string> List;             ///< names of files that follow 'data file: LIST'
  Index Length = 0; ///< length of the header, bytes; 0 if it has no empty line at its end

  bool Has(const std::string& name) const { return this->Fields.count(name) > 0; }
  /// Returns the value of a field, or `without` if the field is missing.
  std::string Find(const std::string& name, const std::string& without) const
  {
    const auto found = this->Fields.find(name);
    return found == this->Fields.end() ? without : found->second;
  }
};

/// Reads the lines of the header of an NRRD file.
/// @throws InputError  if it is not a header, or if a field occurs twice; the message does not
///   contain the path
NrrdFields ReadNrrdFields(const std::string& path);

} // namespace vfm
