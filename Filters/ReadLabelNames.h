/**
 * ReadLabelNames: what a text table calls the labels of an image.
 *
 * A line is a label and its name, with blanks, a tab, a comma or a semicolon between; lines of # are comments, and a first line that begins
 * with id, index, label, number or value is a title. What follows the name is left out: after a comma or semicolon where such a one stands
 * before the name, else after a tab; outside of double quotes (label files of ITK-SNAP); and where all names are one word followed
 * by as many numbers, if these are one (an index; where the names differ without it), three or four (a colour, lookup tables of
 * FreeSurfer). Or the XML of an atlas of FSL, the images of which hold one more than its indices where it is of probabilities.
 */
#pragma once

#include "Base/Ranks.h"
#include "LabelNames.h"

namespace vfm
{

/// Throws InputError with path and line: no file, no label (a whole number from 0), a label or a name twice, no name.
LabelNames ReadLabelNames(const std::string& path);

/// Collective: as the first rank reads them; an empty path names none.
LabelNames ShareLabelNames(const std::string& path, Ranks& ranks);

} // namespace vfm
