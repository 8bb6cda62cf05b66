/**
 * NamedFile: finds the files that a header names.
 */
#pragma once

#include "InputTrust.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <filesystem>
#include <string>

namespace vfm
{

/// Returns the path of a file that a header names, relative to the folder of the header.
/// @param header  path of the header
/// @param name  file name in the header
/// @throws InputError  if the name is empty, or if the file is outside of the folder and the input
///   is not trusted, links followed; the message does not contain the path of the header
inline std::string FindNamedFile(const std::string& header, const std::string& name)
{
  namespace fs = std::filesystem;
  if (name.empty() || name.find('\0') != std::string::npos)
  {
    throw InputError("the name of one of its data files is empty.");
  }
  const fs::path folder = fs::path(header).parent_path(), path = folder / name;
  if (InputTrust::IsGiven())
  {
    return path.string();
  }
  std::error_code error;
  const fs::path here = fs::current_path(error); // missing relative paths would stay relative
  const fs::path top = fs::canonical(here / folder, error);
  const fs::path there = error ? fs::path() : fs::weakly_canonical(here / path, error);
  const auto end = std::mismatch(top.begin(), top.end(), there.begin(), there.end()).first;
  if (error || end != top.end())
  {
    throw InputError("it names the file '" + name + "', " +
      (error ? "which cannot be found: " + error.message() + "."
             : std::string("which is outside of its folder. Move the file into the folder. ") +
            InputTrust::Advice));
  }
  return path.string();
}

} // namespace vfm
