#include "Report/FragmentTargets.h"

#include "Base/Sorted.h"
#include "Report/MeshData.h"

#include <algorithm>
#include <cmath>

namespace vfm
{
namespace
{

constexpr char AllName[] = "FragmentTargetVolume", IdsName[] = "RankFragments",
               VolumesName[] = "RankTargetVolume";

struct Target
{
  int Fragment;
  double Volume;
};

void AddTargets(const MeshReport::FragmentTargets& from, std::vector<Target>& to)
{
  for (std::size_t f = 0; f < from.Ids.size(); ++f)
  {
    to.push_back({ from.Ids[f], from.Volumes[f] });
  }
}

/// Returns the volumes of fragments 1, 2, ..; NaN where no target is given.
std::vector<double> PutInOrder(const std::vector<Target>& targets, Index count)
{
  std::vector<double> volumes(count, std::nan(""));
  for (const Target& target : targets)
  {
    if (target.Fragment >= 1 && target.Fragment <= count)
    {
      volumes[target.Fragment - 1] = target.Volume;
    }
  }
  return volumes;
}

template <class T>
const std::vector<T>* ValuesOf(const std::vector<FieldArray>& fields, const char* name)
{
  const FieldArray* field = FindField(fields, name);
  return field ? std::get_if<std::vector<T>>(&field->Values) : nullptr;
}

} // namespace

std::vector<FieldArray> ListFragmentTargets(
  const MeshReport::FragmentTargets& own, TableMode mode, Index count, Ranks& ranks)
{
  if (ranks.Count() == 1 || HasWholeTable(mode, count))
  {
    return { { AllName, GatherFragmentTargets(own, count, ranks) } };
  }
  return { { IdsName, own.Ids }, { VolumesName, own.Volumes } };
}

bool HasFragmentTargets(const std::vector<FieldArray>& fields)
{
  return ValuesOf<double>(fields, AllName) || ValuesOf<double>(fields, VolumesName);
}

std::vector<int> ListRankFragments(const std::vector<FieldArray>& fields)
{
  const std::vector<int>* ids = ValuesOf<int>(fields, IdsName);
  return ids ? *ids : std::vector<int>();
}

std::vector<double> FindFragmentTargets(
  const std::vector<FieldArray>& fields, const std::vector<int>& fragments)
{
  const std::vector<double>* all = ValuesOf<double>(fields, AllName);
  const std::vector<double>* volumes = all ? all : ValuesOf<double>(fields, VolumesName);
  const std::vector<int>* ids = all ? nullptr : ValuesOf<int>(fields, IdsName);
  std::vector<double> found;
  found.reserve(fragments.size());
  for (int fragment : fragments)
  {
    const std::int64_t at = ids ? FindSorted(*ids, fragment) : fragment - 1;
    const bool isListed =
      volumes && (all || ids) && at >= 0 && at < static_cast<std::int64_t>(volumes->size());
    found.push_back(isListed ? (*volumes)[at] : -1.0);
  }
  return found;
}

std::vector<double> GatherFragmentTargets(
  const MeshReport::FragmentTargets& own, Index count, Ranks& ranks)
{
  if (ranks.Count() == 1)
  {
    return own.Volumes;
  }
  std::vector<Target> mine;
  AddTargets(own, mine);
  return PutInOrder(GatherItems(ranks, mine), count);
}

bool IsFieldOfRank(const std::string& name)
{
  return name == IdsName || name == VolumesName;
}

std::vector<FieldArray> JoinFields(const std::vector<const std::vector<FieldArray>*>& parts)
{
  std::vector<FieldArray> fields = *parts[0];
  const auto at = std::find_if(fields.begin(), fields.end(),
    [](const FieldArray& field) { return IsFieldOfRank(field.Name); });
  if (at == fields.end())
  {
    return fields;
  }
  std::vector<Target> targets;
  for (const std::vector<FieldArray>* part : parts)
  {
    const std::vector<int> ids = ListRankFragments(*part);
    AddTargets({ ids, FindFragmentTargets(*part, ids) }, targets);
  }
  const std::vector<double> count = NumbersOfField(fields, "NumberOfFragments");
  std::vector<double> volumes = PutInOrder(targets, count.empty() ? 0 : std::llround(count[0]));
  if (std::none_of(volumes.begin(), volumes.end(), [](double v) { return std::isnan(v); }))
  {
    fields.insert(at, { AllName, std::move(volumes) });
  }
  std::erase_if(fields, [](const FieldArray& field) { return IsFieldOfRank(field.Name); });
  return fields;
}

} // namespace vfm
