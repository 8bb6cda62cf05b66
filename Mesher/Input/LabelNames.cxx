#include "Input/LabelNames.h"

#include "Input/InputFields.h"
#include "Ranks/Errors.h"

namespace vfm
{

void NameLabels(const LabelNames& names, Materials& table)
{
  std::map<std::string, int> used;
  for (std::size_t m = 1; !names.empty() && m < table.Labels.size(); ++m)
  {
    const auto found = names.find(table.Labels[m] == table.ZeroId ? 0 : table.Labels[m]);
    table.Names[m] = found == names.end() ? table.Names[m] : found->second;
    const auto other = used.emplace(table.Names[m], table.Labels[m]);
    if (!other.second)
    {
      throw InputError("Labels " + std::to_string(other.first->second) + " and " +
        std::to_string(table.Labels[m]) + " are both called '" + table.Names[m] + "'.");
    }
  }
}

} // namespace vfm
