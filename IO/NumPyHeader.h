/**
 * NumPyHeader: reads the header of a .npy file, versions 1.0, 2.0 and 3.0 (numpy.lib.format).
 */
#pragma once

#include "Base/CartesianGrid.h"

#include <string>
#include <vector>

namespace vfm
{

/// Type and shape of the array of a .npy file, and the place of its values.
struct NumPyHeader
{
  char Kind = 0; ///< type code of NumPy: b bool, u unsigned, i signed, f real, or any other
  int Size = 0;  ///< bytes per value
  bool SwapBytes = false;   ///< the values are not in the byte order of this machine
  bool Fortran = false;     ///< the first index changes fastest
  std::vector<Index> Shape; ///< number of values along each index
  Index Offset = 0;         ///< place of the first value in the file, bytes
  std::string Type;         ///< type as written in the header, for instance "<i4"
};

/// Reads the header of a .npy file, without its values. Any type and shape are accepted.
/// @throws InputError  if the file cannot be opened, is not a NumPy file or has a damaged header;
///   the message does not contain the path
NumPyHeader ReadNumPyHeader(const std::string& path);

} // namespace vfm
