/**
 * CellWidths: widths of the cells along each axis, the option CellWidth.
 */
#pragma once

#include "Options/MesherOptions.h"

#include <optional>

namespace vfm
{

/// Parses widths: one for all axes, or three with commas or spaces between them; 0: cells as read.
/// @return nothing if the text has another form, or if a width is negative; zeros if it is empty
std::optional<Vector3> ParseWidths(const std::string& text);

/// Returns whether the cells of the input are replaced.
bool HasCellWidth(const MesherOptions& options);

} // namespace vfm
