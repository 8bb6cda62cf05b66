/**
 * Checks a file of VTK with the suffix VFM_FUZZ_SUFFIX, as before VTK's reader opens it.
 */
#include "Harness.h"

#include "GridFiles/ParseOutline.h"
#include "GridFiles/VtkFileCheck.h"

#include <zlib.h>

namespace vfm
{
namespace testing
{
namespace
{

/// Unpacks blocks of zlib; all others count as damaged.
bool Unpack(const std::string& compressor, const std::vector<unsigned char>& packed,
  std::vector<unsigned char>& unpacked)
{
  uLongf size = unpacked.size();
  return compressor == "vtkZLibDataCompressor" &&
    uncompress(unpacked.data(), &size, packed.data(), packed.size()) == Z_OK &&
    size == unpacked.size();
}

} // namespace

void ReadBytes(const std::string& bytes)
{
  CheckVtkFile(WriteInput(std::string("a") + VFM_FUZZ_SUFFIX, bytes), { ParseVtkOutline, Unpack });
}

} // namespace testing
} // namespace vfm
