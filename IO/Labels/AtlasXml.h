/**
 * AtlasXml: reads names of labels from the XML file of an FSL atlas. In images of a probabilistic
 * atlas the labels are the indices of the XML file plus 1.
 */
#pragma once

#include "LabelTable.h"

namespace vfm
{

/// Adds the labels and names of an atlas to a table.
/// @param text  content of the XML file
/// @throws InputError  if the text is not an atlas, if a label has no index or no name, or if the
///   build has no expat
void ReadAtlasXml(const std::string& text, LabelTable& table);

} // namespace vfm
