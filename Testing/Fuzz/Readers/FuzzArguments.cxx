/**
 * Parses a command line of sculptor with one word per line.
 */
#include "Harness.h"

#include "Arguments.h"

namespace vfm
{
namespace testing
{

void ReadBytes(const std::string& bytes)
{
  std::vector<std::string> words;
  for (std::string left = bytes; !left.empty();)
  {
    words.push_back(TakeUntil(left, "\n"));
  }
  ParseArguments(words);
}

} // namespace testing
} // namespace vfm
