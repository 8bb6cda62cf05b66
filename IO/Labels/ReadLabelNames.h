/**
 * ReadLabelNames: reads names of labels from a table (LabelTable) or from an XML file (AtlasXml).
 */
#pragma once

#include "Input/LabelNames.h"
#include "Ranks/Ranks.h"

#include <functional>
#include <string>

namespace vfm
{

/// Reads the names of labels from a file.
/// @throws InputError  if the file cannot be read, a line has no label or no name, or a label or a
///   name occurs twice, or the text is neither UTF-8 nor Windows-1252; the message contains path
///   and line
/// @param[out] note  remark about names that are not in UTF-8, else ""; may be null
LabelNames ReadLabelNames(const std::string& path, std::string* note = nullptr);

/// Reads the names of labels on rank 0 and distributes them to all ranks.
/// @param path  file; if empty, no names are returned
/// @param warn  receives the note of ReadLabelNames on all ranks, if there is one
/// @throws InputError  on all ranks, same conditions as ReadLabelNames
/// @pre Collective
LabelNames ShareLabelNames(
  const std::string& path, Ranks& ranks, const std::function<void(const std::string&)>& warn);

/// Returns the names of labels that any rank has. If ranks name a label differently, the name of
/// the lowest rank is used.
/// @pre Collective
LabelNames UniteLabelNames(const LabelNames& names, Ranks& ranks);

} // namespace vfm
