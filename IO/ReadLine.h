/**
 * ReadLine: reads a line of bounded length, so that a file without line ends does not fill the
 * memory.
 */
#pragma once

#include "InputTrust.h"
#include "Ranks/Errors.h"

#include <istream>
#include <string>

namespace vfm
{

constexpr std::size_t LongestLine = 100000; ///< length of a line, bytes

/// Reads a line without its end, like std::getline. Returns whether there is one.
/// @throws InputError  if the line is longer than LongestLine, unless the input is trusted; the
///   message does not contain the path
inline bool ReadLine(std::istream& stream, std::string& line)
{
  line.clear();
  for (int c = stream.get(); c != std::istream::traits_type::eof(); c = stream.get())
  {
    if (c == '\n')
    {
      return true;
    }
    if (line.size() == LongestLine && !InputTrust::IsGiven())
    {
      throw InputError("it has a line of more than " + std::to_string(LongestLine) +
        " bytes, so it is no text of this format. " + InputTrust::Advice);
    }
    line += static_cast<char>(c);
  }
  if (!line.empty()) // the last line has no end: eof is set, but a line was read
  {
    stream.clear(std::ios::eofbit);
  }
  return !line.empty();
}

} // namespace vfm
