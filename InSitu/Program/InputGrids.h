/**
 * InputGrids: the data sets of a data object, and the cell arrays of all ranks.
 */
#pragma once

#include "Base/Ranks.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace vfm
{

/// Those with cells; data may be null.
std::vector<vtkDataSet*> GetGrids(vtkDataObject* data);

struct ArrayInfo
{
  std::string Name;
  int Type = 0; ///< VTK_FLOAT, ...
  int Components = 0;
  double Least = 0.0, Most = 0.0; ///< of the first component, NaN left out
};

/// Collective: the numeric cell arrays of all ranks in the order in which files list them, without vtkGhostType.
std::vector<ArrayInfo> FindCellArrays(vtkDataObject* data, Ranks& ranks);

/// For messages: "ball (double, 0 to 1), velocity (float, 3 components)".
std::string ListArrays(const std::vector<ArrayInfo>& arrays);

} // namespace vfm
