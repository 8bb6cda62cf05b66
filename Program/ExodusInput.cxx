#include "ExodusInput.h"

#include "Base/ParseText.h"
#include "Blocks/ExodusCase.h"
#include "Ranks/WorkTogether.h"
#include "ReaderSteps.h"

#include <algorithm>

namespace vfm
{
namespace
{

/// Returns the variables that the arguments name, or all if they name no materials.
std::vector<std::string> ChooseNames(const Arguments& arguments, const ExodusCase& file)
{
  const std::vector<std::string>& known = file.Names();
  const std::vector<std::string> requested = ListNamedArrays(arguments, known);
  for (const std::string& name : requested)
  {
    if (!file.Has(name))
    {
      RejectInput("The input " + arguments.Input + " has no element variable '" + name +
        "'. It has: " + (known.empty() ? "none" : JoinTexts(known)) + ".");
    }
  }
  return arguments.Fractions.empty() && arguments.Labels.empty() ? known : requested;
}

/// Describes the elements of a block.
CellsInfo Describe(const ElementBlock& block)
{
  CellsInfo info;
  info.Count = block.Count;
  const auto& points = *block.Points;
  bool isFirst = true;
  for (const Index corner : block.Corners)
  {
    if (corner < 0 || corner >= static_cast<Index>(points.size()))
    {
      continue; // rejected later
    }
    for (int a = 0; a < 3; ++a)
    {
      const double x = points[corner][a];
      info.Lower[a] = isFirst ? x : std::min(info.Lower[a], x);
      info.Upper[a] = isFirst ? x : std::max(info.Upper[a], x);
    }
    isFirst = false;
  }
  return info;
}

Input MakeInput(std::vector<ElementBlock> elements)
{
  const auto kept = std::make_shared<const std::vector<ElementBlock>>(std::move(elements));
  Input input;
  for (const ElementBlock& block : *kept)
  {
    input.Pieces.push_back(
      { block.Arrays, nullptr, false, [&block](ArrayPlace) { return Describe(block); } });
  }
  input.Collect = [kept](const ArraysToRead&, Ranks& ranks) {
    return CollectedBlocks{ FindBlocks(*kept, ranks), {} };
  };
  return input;
}

} // namespace

Input ReadExodus(const Arguments& arguments, Ranks& ranks)
{
  Input input;
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&]
    {
      std::unique_ptr<ExodusCase> file;
      CheckInput(
        arguments.Input, [&] { file = std::make_unique<ExodusCase>(arguments.Input, ranks); });
      const std::vector<double>& times = file->Times();
      const std::vector<std::string> names = ChooseNames(arguments, *file);
      const std::optional<double> time = ChooseTime(arguments, times);
      const auto step =
        time ? std::find(times.begin(), times.end(), *time) - times.begin() : std::ptrdiff_t(0);
      CheckInput(arguments.Input, [&] { input = MakeInput(file->ReadElements(step, names)); });
      input.Times = times;
      input.Time = time;
    });
  return input;
}

} // namespace vfm
