#include "BlocksInput.h"

#include "Blocks/BlockFile.h"
#include "Input/ArrayNames.h"
#include "Ranks/WorkTogether.h"

#include <algorithm>

namespace vfm
{
namespace
{

std::vector<std::string> ChooseNames(
  const Arguments& arguments, const std::vector<std::string>& there)
{
  const bool isAny =
    arguments.Task == Command::List || (arguments.Fractions.empty() && arguments.Labels.empty());
  const std::vector<std::string> named = ListNamedArrays(arguments, there);
  std::vector<std::string> chosen;
  std::copy_if(there.begin(), there.end(), std::back_inserter(chosen),
    [&](const std::string& name)
    {
      return (isAny && IsSpyPlotFraction(name)) ||
        std::find(named.begin(), named.end(), name) != named.end();
    });
  const bool hasFractions = !isAny || std::any_of(chosen.begin(), chosen.end(), IsSpyPlotFraction);
  // If a named array is missing, all arrays are read, so that the message can list them.
  const bool hasAll = std::all_of(named.begin(), named.end(),
    [&there](const std::string& name)
    { return std::find(there.begin(), there.end(), name) != there.end(); });
  return arguments.Task != Command::List && hasFractions && hasAll ? chosen : there;
}

} // namespace

Input ReadBlocks(const Arguments& arguments, Ranks& ranks)
{
  Input input;
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&]
    {
      std::unique_ptr<BlockFile> file;
      CheckInput(arguments.Input, [&] { file = OpenBlockFile(arguments.Input, ranks); });
      const std::vector<double>& times = file->Times();
      const std::optional<double> time = ChooseTime(arguments, times);
      const auto step = std::find(times.begin(), times.end(), *time) - times.begin();
      const std::vector<std::string> names = ChooseNames(arguments, file->Names());
      CheckInput(arguments.Input,
        [&] {
          input = MakeInput({ file->Read(step, names, ranks), {} }, false);
        });
      input.Times = times;
      input.Time = time;
    });
  return input;
}

} // namespace vfm
