/**
 * MeshArrays: the arrays of a mesh that the filters made, also when it comes from a file.
 */
#pragma once

#include "vtkSmartPointer.h"

#include <string>

class vtkDataArray;
class vtkDataSetAttributes;
class vtkIdTypeArray;

namespace vfm
{

/// The array of that name, of a mesh's points or cells. Throws InputError when it is missing.
vtkDataArray* FindMeshArray(vtkDataSetAttributes* data, const std::string& name);

/// An array of integers as ids, exact to 64 bits: itself, or a copy when it has another type. Throws InputError when it is missing.
vtkSmartPointer<vtkIdTypeArray> FindMeshIds(vtkDataSetAttributes* data, const std::string& name);

} // namespace vfm
