#include "ArgumentWords.h"

#include "ArgumentOptions.h"
#include "Surfaces/ReadSurface.h"

#include <algorithm>
#include <string_view>

namespace vfm
{
namespace
{

const ArgumentOption& FindArgument(std::string_view name)
{
  const std::vector<ArgumentOption>& options = GetArgumentOptions();
  const auto found = std::find_if(options.begin(), options.end(),
    [&](const ArgumentOption& option) { return option.Name == (name == "-h" ? "--help" : name); });
  if (found == options.end())
  {
    RejectArguments("'" + std::string(name) + "' is not an option.");
  }
  return *found;
}

/// Adds the words that are not options. The last one is the output, unless it is the only file, or
/// the output is already given. Surfaces alone are inputs: no output may replace one by accident.
void AddFiles(std::vector<std::string> files, GivenArguments& given)
{
  std::vector<std::string> inputs;
  if (given.count("--input") > 0)
  {
    inputs = given["--input"];
  }
  inputs.insert(inputs.end(), files.begin(), files.end());
  const bool areSurfaces = std::all_of(inputs.begin(), inputs.end(), IsSurfaceFile);
  if (!files.empty() && inputs.size() > 1 && given.count("--output") == 0 && !areSurfaces)
  {
    given["--output"] = { inputs.back() };
    inputs.pop_back();
  }
  if (!files.empty() && inputs.size() > 1 &&
    std::none_of(inputs.begin(), inputs.end(), IsSurfaceFile))
  {
    RejectArguments(
      "'" + files.back() + "' is one file too many: the input and the output are already given.");
  }
  if (!inputs.empty())
  {
    given["--input"] = std::move(inputs);
  }
}

using Word = std::vector<std::string>::const_iterator;

/// Returns the values of the option at `word` and moves `word` behind them.
std::vector<std::string> TakeValues(
  Word& word, Word end, const ArgumentOption& option, bool takesValue)
{
  std::vector<std::string> values;
  const std::size_t equals = word->find('=');
  if (equals != std::string::npos)
  {
    values.push_back(word->substr(equals + 1));
  }
  const bool takesSeveral = option.Value.find(" ..") != std::string::npos;
  const auto isValue = [](const std::string& next) { return next.compare(0, 2, "--") != 0; };
  for (++word; word != end && isValue(*word) && takesValue && (values.empty() || takesSeveral);
       ++word)
  {
    values.push_back(*word);
  }
  if (!takesValue && !values.empty())
  {
    RejectArguments(option.Name + " takes no value, but '" + values[0] + "' is given.");
  }
  if (takesValue && (values.empty() ? option.Value[0] != '[' : values.back().empty()))
  {
    RejectArguments(option.Name + " needs a value.");
  }
  return values;
}

} // namespace

void RejectArguments(const std::string& message)
{
  throw InputError(ErrorCode::WrongArguments, message + " See sculptor --help.");
}

GivenArguments ReadWords(const std::vector<std::string>& words, bool isTest)
{
  GivenArguments given;
  std::vector<std::string> files;
  for (auto word = words.begin(); word != words.end();)
  {
    if (!word->empty() && word->front() != '-')
    {
      files.push_back(*word++);
      continue;
    }
    const ArgumentOption& option = FindArgument(word->substr(0, word->find('=')));
    if (!option.MayRepeat && given.count(option.Name) > 0)
    {
      RejectArguments(option.Name + " is given twice.");
    }
    const bool takesValue = !option.Value.empty() && !(isTest && option.Name == "--refine-cells");
    const std::vector<std::string> values = TakeValues(word, words.end(), option, takesValue);
    if (option.Name == "--help" || option.Name == "--version")
    {
      return { { option.Name, {} } };
    }
    std::vector<std::string>& to = given[option.Name];
    to.insert(to.end(), values.begin(), values.end());
  }
  AddFiles(files, given);
  return given;
}

} // namespace vfm
