/**
 * AtlasXml: the names of labels in the XML of an atlas of FSL. The images of such an atlas hold one more than its indices where it is of
 * probabilities.
 */
#pragma once

#include "LabelTable.h"

namespace vfm
{

/// Adds the labels of the file's text. Throws InputError when it is no such file, when a label has no index or name, and in a build
/// without expat.
void ReadAtlasXml(const std::string& text, LabelTable& table);

} // namespace vfm
