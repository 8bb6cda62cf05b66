/**
 * ReadSurface: reads surfaces of triangles from files: STL, OBJ, PLY, OFF, VTP and 3MF.
 */
#pragma once

#include "Surfaces/ClosedSurface.h"
#include "Surfaces/SurfaceTools.h"

#include <string>
#include <vector>

namespace vfm
{

/// Triangles of a body as a file stores them: corners may be repeated, and the surface may be open.
/// MakeBody of InputSurfaces.h makes a closed surface of them.
struct SurfaceFile
{
  std::string Name; ///< name of the body in the file; empty if it has none
  std::vector<Vector3> Points;
  std::vector<PointTriangle> Triangles;
  std::vector<int> Patches;            ///< patch of each triangle, from 0
  std::vector<std::string> PatchNames; ///< one or more; empty texts for patches without a name
  std::string Note;                    ///< warning about the file; or empty
};

/// Reads all triangles of a file by its suffix, which may be followed by .gz: .stl (text, or
/// binary, with colours), .obj, .ply, .off, .vtp, .3mf. Polygons are cut into triangles. Patches
/// are the solids of text STL, the colours of binary STL, the materials or groups of OBJ, and the
/// objects of 3MF.
/// @throws InputError  if the file cannot be read, is damaged, or has no triangles; the message
///   does not contain the path
SurfaceFile ReadSurface(const std::string& path, const SurfaceTools& tools = {});

/// Reads the bodies of a file: one, or each object that a 3MF file builds. Names may be empty, or
/// repeated.
/// @throws InputError  same conditions as ReadSurface
std::vector<SurfaceFile> ReadBodies(const std::string& path, const SurfaceTools& tools = {});

/// Returns the suffixes of the formats, for instance ".stl"; .gz may follow each.
std::vector<std::string> GetSurfaceSuffixes();
/// Returns whether the suffix of a path is one of those that ReadSurface reads.
bool IsSurfaceFile(const std::string& path);

} // namespace vfm
