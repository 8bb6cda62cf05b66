/**
 * InputSurfaces: the closed surfaces from which the volume fractions of an input were computed.
 */
#pragma once

#include "Surfaces/ClosedSurface.h"

#include <string>

namespace vfm
{

/// Surface of one body, in length units of the grid.
struct BodySurface
{
  std::string Name;                    ///< name of the array of its fractions
  ClosedSurface Boundary;              ///< canonical: equal for any order of the input
  std::vector<int> Patches;            ///< patch of each triangle, from 0
  std::vector<std::string> PatchNames; ///< names of the patches that the input defines, one or more
};

/// Surfaces of all bodies. Where bodies overlap, the first one keeps its volume. Equal on all
/// ranks.
struct InputSurfaces
{
  std::vector<BodySurface> Bodies;
};

/// Makes a body: the single way to get from triangles of any source to a BodySurface. CloseSurface
/// repairs and orients the triangles. Patches without triangles are dropped.
/// @param patches  patch of each triangle, from 0; empty for one patch
/// @param patchNames  names of the patches; texts may be empty
/// @param note  receives a warning about repairs, or an empty text; or null
/// @throws InputError  if CloseSurface does, or if a patch has no name; the message does not
/// contain
///   the name of the body
BodySurface MakeBody(const std::string& name, std::vector<Vector3> points,
  std::vector<PointTriangle> triangles, std::vector<int> patches = {},
  std::vector<std::string> patchNames = { "" }, std::string* note = nullptr);

} // namespace vfm
