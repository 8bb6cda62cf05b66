#include "Input/ArrayInfo.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vfm
{

void AddArray(std::vector<ArrayInfo>& list, const ArrayInfo& info)
{
  const auto found = std::find_if(
    list.begin(), list.end(), [&info](const ArrayInfo& other) { return other.Name == info.Name; });
  if (found == list.end())
  {
    list.push_back(info);
    return;
  }
  found->Least = std::min(found->Least, info.Least);
  found->Most = std::max(found->Most, info.Most);
  found->Count += info.Count;
  found->HasOneType = found->HasOneType && info.HasOneType && found->Type == info.Type;
  found->HoldsIds = found->HoldsIds || info.HoldsIds;
  found->AreWhole = found->AreWhole && info.AreWhole;
  found->NotWhole = found->NotWhole == 0.0 ? info.NotWhole : found->NotWhole;
}

namespace
{

/// An ArrayInfo in a message, without its name.
struct Packed
{
  int Type, Components, HasOneType, HoldsIds, AreWhole;
  double Least, Most, NotWhole;
  Index Count;
  std::size_t NameLength;
};

Bytes Pack(const std::vector<ArrayInfo>& list)
{
  Bytes bytes;
  for (const ArrayInfo& info : list)
  {
    const Bytes numbers =
      ToBytes(std::vector<Packed>{ { info.Type, info.Components, info.HasOneType, info.HoldsIds,
        info.AreWhole, info.Least, info.Most, info.NotWhole, info.Count, info.Name.size() } });
    bytes.insert(bytes.end(), numbers.begin(), numbers.end());
    bytes.insert(bytes.end(), info.Name.begin(), info.Name.end());
  }
  return bytes;
}

void Unpack(const Bytes& bytes, std::vector<ArrayInfo>& list)
{
  for (auto at = bytes.begin(); at != bytes.end();)
  {
    const Packed numbers = FromBytes<Packed>(Bytes(at, at + sizeof(Packed)))[0];
    at += sizeof(Packed);
    AddArray(list,
      { std::string(at, at + numbers.NameLength), numbers.Type, numbers.Components, numbers.Least,
        numbers.Most, numbers.Count, numbers.HasOneType != 0, numbers.HoldsIds != 0,
        numbers.AreWhole != 0, numbers.NotWhole });
    at += numbers.NameLength;
  }
}

} // namespace

std::vector<ArrayInfo> UnionOfArrays(const std::vector<ArrayInfo>& mine, Ranks& ranks)
{
  std::vector<ArrayInfo> list;
  for (const Bytes& bytes : ranks.Gather(Pack(mine)))
  {
    Unpack(bytes, list);
  }
  return list;
}

namespace
{

/// Sets the range of the first component, and AreWhole.
void FindRange(const BlockArray& array, ArrayInfo& info)
{
  info.Least = std::numeric_limits<double>::max();
  info.Most = std::numeric_limits<double>::lowest();
  const auto visit = [&](const auto& valueOf)
  {
    for (Index tuple = 0; tuple < array.Tuples; ++tuple)
    {
      const double value = valueOf(tuple);
      info.Least = value < info.Least ? value : info.Least;
      info.Most = value > info.Most ? value : info.Most;
    }
    info.AreWhole = true;
    for (Index tuple = 0; IsRealType(array.Type) && info.AreWhole && tuple < array.Tuples; ++tuple)
    {
      const double value = valueOf(tuple);
      info.AreWhole = std::abs(value - std::round(value)) <= LabelTolerance; // false for NaN
      info.NotWhole = info.AreWhole ? 0.0 : value;
    }
  };
  if (!array.Memory)
  {
    visit([&array](Index tuple) { return array.Get(tuple, 0); });
    return;
  }
  VisitType(array.Type,
    [&](auto tag)
    {
      const auto* values = static_cast<const typename decltype(tag)::Type*>(array.Memory);
      visit([&](Index tuple) { return static_cast<double>(values[tuple * array.Components]); });
    });
}

} // namespace

ArrayLists ListsOf(const std::vector<InputBlock>& blocks)
{
  ArrayLists lists;
  for (const InputBlock& block : blocks)
  {
    lists.push_back(block.Arrays);
  }
  return lists;
}

std::vector<ArrayInfo> ListArrays(const ArrayLists& lists)
{
  std::vector<ArrayInfo> list;
  for (const std::shared_ptr<const BlockArrays>& arrays : lists)
  {
    for (const std::string& name : arrays->Names())
    {
      const std::shared_ptr<const BlockArray> array = arrays->Find(name);
      if (array && array->Tuples > 0)
      {
        ArrayInfo info{ name, array->Type, array->Components, 0.0, 0.0, 1, true,
          arrays->HoldsIds(name) };
        FindRange(*array, info);
        AddArray(list, info);
      }
    }
  }
  return list;
}

} // namespace vfm
