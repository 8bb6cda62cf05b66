/**
 * DistributeImage: distributes an image file over the ranks.
 */
#pragma once

#include "Images/ImageFile.h"
#include "Ranks/Ranks.h"

namespace vfm
{

/// Reads the values in the box of each rank. If the file can be read in parts, each rank reads its
/// own part. Otherwise rank 0 reads the whole file and sends each rank its part.
/// @param box  box of this rank, which may be empty; boxes of different ranks may overlap
/// @return values in the box, x fastest, without a name; no values if the box is empty
/// @throws InputError  possibly only on some ranks
/// @pre Collective
TypedValues ReadPart(const ImageFile& file, const IndexBox& box, Ranks& ranks);

} // namespace vfm
