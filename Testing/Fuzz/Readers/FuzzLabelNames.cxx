/**
 * Reads names of labels from a text, or from XML, which begins with '<'.
 */
#include "Harness.h"

#include "Labels/ReadLabelNames.h"

namespace vfm
{
namespace testing
{

void ReadBytes(const std::string& bytes)
{
  ReadLabelNames(WriteInput("a.txt", bytes));
}

} // namespace testing
} // namespace vfm
