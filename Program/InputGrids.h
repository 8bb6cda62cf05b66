/**
 * InputGrids: the data sets of a data object, and the arrays of all ranks.
 */
#pragma once

#include "Input/ArrayInfo.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkDataSetAttributes;

namespace vfm
{

/// Those with cells; data may be null.
std::vector<vtkDataSet*> GetGrids(vtkDataObject* data);

/// What the values of an array belong to.
enum class ArrayPlace
{
  Cells,
  Points
};

/// Of a data set.
vtkDataSetAttributes* GetAttributes(vtkDataSet* grid, ArrayPlace place);

/// Collective: whether all grids are images, the points of which can be meshed as cells around them.
bool AreImages(vtkDataObject* data, Ranks& ranks);

/// Collective: the numeric arrays of all ranks in the order in which files list them, without vtkGhostType.
std::vector<ArrayInfo> FindArrays(vtkDataObject* data, ArrayPlace place, Ranks& ranks);

/// Collective, for messages: "Its cell arrays: ball (double, 0 to 1), velocity (float, 3 components)." and, if there are, those of
/// points, and whether they can be meshed.
std::string DescribeArrays(vtkDataObject* data, Ranks& ranks);

} // namespace vfm
