#include "Surfaces/PatchList.h"

namespace vfm
{

void PatchList::Finish(SurfaceFile& file) const
{
  std::vector<int> numbers(this->Names.size() + 1, -1);
  for (int patch : file.Patches)
  {
    numbers[patch] = 0;
  }
  file.PatchNames.clear();
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    if (numbers[p] == 0)
    {
      numbers[p] = static_cast<int>(file.PatchNames.size());
      file.PatchNames.push_back(p < this->Names.size() ? this->Names[p] : "");
    }
  }
  for (int& patch : file.Patches)
  {
    patch = numbers[patch];
  }
}

} // namespace vfm
