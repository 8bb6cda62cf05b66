/**
 * Checks a file of VTK with the suffix VFM_FUZZ_SUFFIX, as before VTK's reader opens it.
 */
#include "Harness.h"

#include "VtkFiles/VtkFileCheck.h"

namespace vfm
{
namespace testing
{

void ReadBytes(const std::string& bytes)
{
  CheckVtkFile(WriteInput(std::string("a") + VFM_FUZZ_SUFFIX, bytes));
}

} // namespace testing
} // namespace vfm
