/**
 * NameMaterials: writes the names of materials into the colour map of an array of material ids.
 */
#pragma once

#include <map>
#include <string>

class vtkSMProxy;

namespace vfm
{

/// Names by material id.
using MaterialNames = std::map<int, std::string>;

/// Adds colours and names for missing ids to a colour map of categories. A colour map that the user
/// has not changed becomes one of categories. Entries of the user stay; names written before follow
/// the data.
/// @param given names that were written into the map before; updated
/// @return whether the map became one of categories
bool NameMaterials(vtkSMProxy* colourMap, const MaterialNames& names, MaterialNames& given);

} // namespace vfm
