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

/// Describes the cells that are meshed in few words, for panels: "24 x 24 x 24 of width 2",
/// "24 x 16 x 48 of 2 x 3 x 1".
/// @param widths a value of the option
/// @param lengths of the domain along each axis
/// @param cells of the input along each axis; 0: unknown
std::string DescribeCells(const std::string& widths, const Vector3& lengths, const Index3& cells);

/// Returns whether the cells of the input are replaced.
bool HasCellWidth(const MesherOptions& options);

} // namespace vfm
