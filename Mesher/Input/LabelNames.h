/**
 * LabelNames: what labels are called.
 */
#pragma once

#include <map>
#include <string>

namespace vfm
{

struct Materials;

/// By label.
using LabelNames = std::map<int, std::string>;

/// Labels above 0; those without a name keep theirs, and names of labels that are not there are left out. Throws InputError where a name
/// is then that of another label too ("Material 7").
void NameLabels(const LabelNames& names, Materials& table);

} // namespace vfm
