/**
 * WriteStl: the surface of each material as closed triangles in text files of STL.
 *
 * The surface of a material consists of the faces of its elements at other materials, at the void
 * and on the boundary of the domain. It is closed and oriented: normals point out of the material.
 * A face between two materials belongs to both surfaces, in opposite orientations. Coordinates are
 * written such that they are read back as the same numbers.
 *
 * A quadrilateral becomes four triangles around the mean of its corners, which enclose the same
 * volume as its bilinear surface. So the volume of the surface is that of the linear elements.
 */
#pragma once

#include "Ranks/Ranks.h"
#include "Report/MeshData.h"

#include <string>

namespace vfm
{

/// Part of a file name that the name of a material replaces.
constexpr const char* MaterialPlace = "{}";

/// Returns the reason why surfaces cannot be written to a path; "" if they can. The suffix is .stl,
/// and `{}` may occur once, in the name of the file.
std::string FindStlProblem(const std::string& path);

/// Writes the surface of each material, also of a meshed void.
/// - NAME.stl: one file with one solid per material, with its name, in ascending order of ids
/// - a path with {}, such as bones_{}.stl: one file per material, {} replaced by its name
/// Particles are in a file of their own, NAME_particles.vtp or bones_particles.vtp.
/// The files do not depend on the number of ranks.
/// @param mesh  part of this rank
/// @throws InputError  if the mesh is empty, if opposite sides of a periodic mesh are joined, or if
///   a file cannot be written; on all ranks
/// @pre Collective
void WriteStl(const MeshData& mesh, const std::string& path, Ranks& ranks);

} // namespace vfm
