/**
 * GlueBlocks: equal labels on both sides of a flat seam, where the condition of flat seams needs
 * them.
 *
 * Where an interface crosses a flat seam at a small angle, many columns of two cells across the
 * seam have two labels, and the condition holds at none of their nodes. Flips of single cells move
 * the line where these columns end from column to column, but remove no violation until the last
 * of them. So all columns that break the condition get one label at once, the cheaper one. That can
 * break it at the next columns, so this is repeated.
 */
#pragma once

#include "Labels/LabelFlips.h"

namespace vfm
{

/// Glues blocks (SeamBlocks.h) until none breaks the condition of flat seams, or none can be glued
/// without the loss of a label. It ends because blocks remain glued along each axis. Does nothing
/// unless cells glued across a seam are units.
/// @return number of rounds
/// @pre Collective.
int GlueBlocks(LabelFlips& flips, Runtime& runtime);

} // namespace vfm
