/**
 * RunValues: the arrays of a mesh that leaves out hexes, part by part with the values of these.
 */
#pragma once

#include "Elements/MeshWithRuns.h"
#include "Report/MeshData.h"

#include <optional>
#include <string_view>

namespace vfm
{

/// Receives consecutive parts of the bytes of an array.
using AddBytes = std::function<void(std::string_view)>;

///@{ Add the coordinates of points, shape (points, 3), and the corners of hexes, shape (hexes, 8).
void AddPoints(const MeshWithRuns& mesh, const AddBytes& add);
void AddCorners(const MeshWithRuns& mesh, const AddBytes& add);
///@}

///@{ Add the values of an array of the mesh that is one of MeshArrays.h.
/// @param material  of the elements; none: all elements
void AddPointValues(const MeshWithRuns& mesh, const MeshArray& array, const AddBytes& add);
void AddElementValues(const MeshWithRuns& mesh, const MeshArray& array, const AddBytes& add,
  std::optional<int> material = {});
///@}

} // namespace vfm
