/**
 * Reads the header of a netCDF file, and its int variables if the file is long enough.
 */
#include "Harness.h"

#include "NetcdfHeader.h"

namespace vfm
{
namespace testing
{

void ReadBytes(const std::string& bytes)
{
  const std::string path = WriteInput("a.e", bytes);
  const auto header = ReadNetcdfHeader(path);
  if (!header || header->Size > static_cast<std::int64_t>(bytes.size()))
  {
    return;
  }
  for (const NetcdfHeader::Variable& variable : header->Variables)
  {
    if (variable.Type == static_cast<int>(NetcdfType::Int) && !variable.HasRecords)
    {
      ReadNetcdfInts(path, variable);
    }
  }
}

} // namespace testing
} // namespace vfm
