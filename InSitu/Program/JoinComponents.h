/**
 * JoinComponents: vectors of codes that keep their components apart.
 */
#pragma once

#include <string>
#include <vector>

class vtkDataObject;

namespace vfm
{

/// What components of a vector may be called, x y z: "X velocity", "Y velocity", "Z velocity" as CTH does, or x_velocity and so on; nothing
/// of no name.
std::vector<std::vector<std::string>> ListComponentNames(const std::string& vector);

/// Adds the vector to grids that hold cell arrays of its three components instead.
void JoinComponents(vtkDataObject* data, const std::string& vector);

} // namespace vfm
