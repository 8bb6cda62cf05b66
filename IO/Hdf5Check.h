/**
 * Hdf5Check: checks the structure of an HDF5 file before the HDF5 library opens it. Libraries up to
 * 1.10 read beyond their memory, or recurse without end, if groups or attributes are damaged.
 */
#pragma once

#include <string>

namespace vfm
{

/// Checks headers of objects, attributes, and groups in the form of symbol tables. Chunks of values
/// and fractal heaps, which have checksums, are left to the library.
/// @throws InputError  if the file is no HDF5 file or is damaged; the message does not contain the
///   path
void CheckHdf5(const std::string& path);

} // namespace vfm
