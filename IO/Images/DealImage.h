/**
 * DealImage: parts of an image file for all ranks.
 */
#pragma once

#include "Images/ImageFile.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Collective: the values in each rank's box, without a name; none where the box is empty. Where the file gives parts each rank reads
/// its own; else the first reads the whole and sends the others theirs. Throws InputError, maybe on some ranks alone.
TypedValues ReadPart(const ImageFile& file, const IndexBox& box, Ranks& ranks);

} // namespace vfm
