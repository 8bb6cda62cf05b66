#include "ArgumentWords.h"

#include "Base/ParseText.h"

namespace vfm
{

void RefuseArguments(const std::string& message)
{
  throw ProgramError(ExitCode::WrongArguments, message + " See sculptor --help.");
}

ArgumentWords::ArgumentWords(const std::vector<std::string>& words)
{
  for (const std::string& word : words)
  {
    const std::size_t equals = IsOption(word) ? word.find('=') : std::string::npos;
    this->Left.push_back(word.substr(0, equals));
    if (equals != std::string::npos)
    {
      this->Joined.insert(this->Left.size());
      this->Left.push_back(word.substr(equals + 1));
    }
  }
}

std::string ArgumentWords::TakeValue(const std::string& option)
{
  if (!this->HasValue() || this->Left[this->Next].empty())
  {
    RefuseArguments(option + " needs a value.");
  }
  return this->Take();
}

std::vector<std::string> ArgumentWords::TakeList(const std::string& option)
{
  const std::vector<std::string> list = SplitText(this->TakeValue(option));
  std::set<std::string> seen;
  for (const std::string& item : list)
  {
    if (item.empty() || !seen.insert(item).second)
    {
      RefuseArguments(option +
        (item.empty() ? " has an empty name in its list." : " names '" + item + "' twice."));
    }
  }
  return list;
}

} // namespace vfm
