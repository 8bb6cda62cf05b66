/**
 * BodyFields: what a mesh keeps of the surfaces of the input, as arrays and as a warning.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Elements/MeshReport.h"
#include "Input/ImageFrame.h"
#include "Report/MeshFields.h"

namespace vfm
{

/// Lists columns with one value per material, void only if meshed, 0 without a surface; nothing if
/// the input has no surfaces:
/// - SurfaceThickness: thickness that 5 % of the area do not exceed, in mean widths of the finest
///   cells
/// - SuggestedWidth: width of cells that are CellsOfThickness times in it, length units
/// - LostSurface: share of the area without elements near
/// - Solids: number of closed outer surfaces in the domain
/// @param width  mean width of the finest cells, length units
FieldArrays ListBodies(
  const MeshReport& report, const Materials& table, double width, bool meshVoid);

/// Returns sentences with the bodies that lose parts: solids or parts of the surface without
/// elements, or that fall into more fragments than they have solids; with the cell width that keeps
/// them. "" if there are none. Does not name materials without elements.
/// @param frame  axes of the grid
std::string DescribeLostBodies(
  const MeshReport& report, const Materials& table, double width, const ImageFrame& frame);

} // namespace vfm
