#include "AgreeOnErrors.h"

#include <fstream>

namespace vfm
{

void AddLine(std::string& text, const std::string& line)
{
  text += (text.empty() ? "" : "\n") + line;
}

const std::string& Failures::Tell()
{
  this->All = this->LeftOut;
  if (!this->Failed.empty())
  {
    AddLine(this->All, this->Failed);
  }
  return this->All;
}

bool CanRead(const std::string& script, Ranks& ranks, std::string& errors)
{
  const auto read = [&script]
  {
    if (!std::ifstream(script).good())
    {
      throw InputError("Script " + script + " cannot be read.");
    }
  };
  return Agree(ranks, read, errors);
}

} // namespace vfm
