/**
 * ReadLabelNames: what a file calls the labels of an image: a table (LabelTable), or the XML of an atlas (AtlasXml).
 */
#pragma once

#include "Input/LabelNames.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Throws InputError with path and line: no file, no label (a whole number from 0), a label or a name twice, no name.
LabelNames ReadLabelNames(const std::string& path);

/// Collective: as the first rank reads them; an empty path names none.
LabelNames ShareLabelNames(const std::string& path, Ranks& ranks);

} // namespace vfm
