/**
 * LabelNames: names of labels.
 */
#pragma once

#include <map>
#include <string>

namespace vfm
{

struct Materials;

/// Names by label.
using LabelNames = std::map<int, std::string>;

/// Sets the names of labels above 0, and of label 0 if it is a material (Materials::ZeroId). Labels
/// without an entry keep their names; other entries are ignored.
/// @throws InputError if two labels then have the same name, such as "Material 7"
void NameLabels(const LabelNames& names, Materials& table);

} // namespace vfm
