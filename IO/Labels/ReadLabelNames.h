/**
 * ReadLabelNames: reads names of labels from a table (LabelTable) or from an XML file (AtlasXml).
 */
#pragma once

#include "Input/LabelNames.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Reads the names of labels from a file.
/// @throws InputError  if the file cannot be read, a line has no label or no name, or a label or a
///   name occurs twice; the message contains path and line
LabelNames ReadLabelNames(const std::string& path);

/// Reads the names of labels on rank 0 and distributes them to all ranks.
/// @param path  file; if empty, no names are returned
/// @throws InputError  on all ranks, same conditions as ReadLabelNames
/// @pre Collective
LabelNames ShareLabelNames(const std::string& path, Ranks& ranks);

/// Returns the names of labels that any rank has. If ranks name a label differently, the name of
/// the lowest rank is used.
/// @pre Collective
LabelNames UniteLabelNames(const LabelNames& names, Ranks& ranks);

} // namespace vfm
