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
    words.emplace_back(TakeUntil(left, "\n").c_str()); // words of a program end at a zero
  }
  ParseArguments(words);
}

} // namespace testing
} // namespace vfm
