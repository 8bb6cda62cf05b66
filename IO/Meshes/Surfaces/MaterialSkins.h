/**
 * MaterialSkins: the closed surface of each material as triangles, for the writers of surfaces.
 *
 * The surface of a material consists of the faces of its elements at other materials, at the void
 * and on the boundary of the domain. It is closed and oriented: normals point out of the material.
 * A face between two materials belongs to both surfaces, in opposite orientations.
 *
 * A quadrilateral becomes four triangles around the mean of its corners, which enclose the same
 * volume as its bilinear surface. So the volume of the surface is that of the linear elements.
 */
#pragma once

#include "Meshes/Files/OutputFile.h"
#include "Ranks/Ranks.h"
#include "Report/MeshData.h"
#include "Report/MeshFacets.h"
#include "Report/UniqueNames.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Part of a file name that the name of a material replaces.
constexpr const char* MaterialPlace = "{}";

struct MaterialSkin
{
  std::string Name;
  std::vector<FaceIds> Faces; ///< counterclockwise seen from outside
};

/// Returns the reason why surfaces cannot be written to a path; "" if they can. The suffix is .stl
/// or .obj, and `{}` may occur once, in the name of the file.
std::string FindSurfaceProblem(const std::string& path);

/// Returns the folder that a path means, without '/' at its end: the path ends with '/', or its
/// name has no dot. "" if it means a file.
std::string FindSurfaceFolder(const std::string& path);

/// Returns the number of corners of a face, 3 or 4.
inline int CountCorners(const FaceIds& face)
{
  return face.back() < 0 ? 3 : 4;
}

/// Returns the mean of the corners of a quadrilateral. It has the same bits for the same face of a
/// neighbour, which begins at another corner and has the opposite orientation.
Vector3 CentreOfFace(const MeshData& whole, const FaceIds& face);

/// Writes the surfaces of all materials, also of a meshed void, on rank 0.
/// - a path without {}: one file with all of them, in ascending order of ids
/// - a path with {}, such as bones_{}.stl: one file per material, {} replaced by its name
/// Particles are in a file of their own, NAME_particles.vtp or bones_particles.vtp.
/// The files do not depend on the number of ranks.
/// @param mesh  part of this rank
/// @param form  converts the name of a material to that of a surface
/// @param add  adds surfaces to a file
/// @throws InputError  if the mesh is empty, if opposite sides of a periodic mesh are joined, or if
///   a file cannot be written; on all ranks
/// @pre Collective
void WriteSkins(const MeshData& mesh, const std::string& path, Ranks& ranks,
  std::string (*form)(const std::string&),
  const std::function<void(OutputFile&, const MeshData&, const std::vector<MaterialSkin>&)>& add);

} // namespace vfm
