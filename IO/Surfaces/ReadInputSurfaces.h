/**
 * ReadInputSurfaces: reads the surfaces of an input from files, with the names of their materials.
 */
#pragma once

#include "Surfaces/InputSurfaces.h"
#include "Surfaces/SurfaceTools.h"

#include <functional>
#include <string>
#include <vector>

namespace vfm
{

/// Reads the bodies of files; earlier ones have priority. A body has the name of its file without
/// folder and suffixes. Bodies of one file of several have their own names, or that of the file
/// with a number.
/// @param warn  receives notes about files, with their paths; may be empty
/// @throws InputError  if ReadBodies or MakeBody does; the message begins with the path. If two
///   files would give bodies the same name.
InputSurfaces ReadInputSurfaces(const std::vector<std::string>& paths,
  const std::function<void(const std::string&)>& warn, const SurfaceTools& tools = {});

} // namespace vfm
