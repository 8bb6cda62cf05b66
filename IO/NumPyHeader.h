/**
 * NumPyHeader: the header of a .npy file, versions 1.0, 2.0 and 3.0 (numpy.lib.format).
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <string>
#include <vector>

namespace vfm
{

struct NumPyHeader
{
  char Kind = 0;          ///< b bool, u unsigned, i signed, f real; of other types the first letter
  int Size = 0;           ///< bytes a value
  bool SwapBytes = false; ///< the values are not in the byte order of this machine
  bool Fortran = false;   ///< the first index changes fastest
  std::vector<Index> Shape;
  Index Offset = 0; ///< of the first value, in bytes
  std::string Type; ///< as written, "<i4"
};

/// Throws InputError, without the path, when it cannot be opened, is no NumPy file or has another header.
NumPyHeader ReadNumPyHeader(const std::string& path);

} // namespace vfm
