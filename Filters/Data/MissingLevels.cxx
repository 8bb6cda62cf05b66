#include "MissingLevels.h"

#include "VtkVersions.h"

#include <algorithm>

namespace vfm
{

std::string DescribeMissingLevels(vtkDataObject* input, Ranks& ranks)
{
  constexpr std::size_t maximumLevels = 64;
  std::vector<std::int64_t> counts(
    2 * maximumLevels, 0); // boxes of each level, then boxes with data
  RefinedGrids* amr = RefinedGrids::SafeDownCast(input);
  const std::size_t levels = amr ? amr->GetNumberOfLevels() : 0;
  for (std::size_t level = 0; level < std::min(levels, maximumLevels); ++level)
  {
    const unsigned int number = static_cast<unsigned int>(level);
    const unsigned int boxes = NumberOfBoxes(amr, number);
    counts[level] = boxes;
    for (unsigned int box = 0; box < boxes; ++box)
    {
      counts[maximumLevels + level] += GetBox(amr, number, box) != nullptr;
    }
  }
  ranks.Sum(counts);
  std::string missing;
  for (std::size_t level = 0; level < maximumLevels; ++level)
  {
    if (counts[level] > 0 && counts[maximumLevels + level] == 0)
    {
      missing += (missing.empty() ? "" : ", ") + std::to_string(level);
    }
  }
  return missing.empty() ? ""
                         : "The reader has not loaded all levels of the refined grid (AMR): there "
                           "are boxes without data on level " +
      missing +
      ". Set Default Number Of Levels of the reader to 0, which reads all, or its Level "
      "to a larger number.";
}

} // namespace vfm
