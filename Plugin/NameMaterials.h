/**
 * Writes the names of materials into the colour map of an array of material ids.
 */
#pragma once

#include <map>
#include <string>

class vtkSMProxy;

namespace vfm
{

/// Names by ids.
using MaterialNames = std::map<int, std::string>;

/// Makes a colour map that nobody has changed one of categories; in one of categories each id that it lacks gets a colour and its
/// name. What else is in it is of the user and stays, but for names that were given here: those follow the data.
/// given: the names that this wrote into the map before; updated.
/// Returns whether the map has now become one of categories.
bool NameMaterials(vtkSMProxy* colourMap, const MaterialNames& names, MaterialNames& given);

} // namespace vfm
