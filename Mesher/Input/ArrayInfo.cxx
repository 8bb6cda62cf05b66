#include "Input/ArrayInfo.h"

#include <algorithm>
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
}

namespace
{

/// All of an array but its name, as one message.
struct Packed
{
  int Type, Components, HasOneType, HoldsIds;
  double Least, Most;
  Index Count;
  std::size_t NameLength;
};

Bytes Pack(const std::vector<ArrayInfo>& list)
{
  Bytes bytes;
  for (const ArrayInfo& info : list)
  {
    const Bytes numbers = ToBytes(std::vector<Packed>{ { info.Type, info.Components,
      info.HasOneType, info.HoldsIds, info.Least, info.Most, info.Count, info.Name.size() } });
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
        numbers.Most, numbers.Count, numbers.HasOneType != 0, numbers.HoldsIds != 0 });
    at += numbers.NameLength;
  }
}

} // namespace

std::vector<ArrayInfo> UniteArrays(const std::vector<ArrayInfo>& mine, Ranks& ranks)
{
  std::vector<ArrayInfo> list;
  for (const Bytes& bytes : ranks.Gather(Pack(mine)))
  {
    Unpack(bytes, list);
  }
  return list;
}

std::vector<ArrayInfo> ListArrays(const std::vector<InputBlock>& blocks)
{
  std::vector<ArrayInfo> list;
  for (const InputBlock& block : blocks)
  {
    for (const std::string& name : block.Arrays->Names())
    {
      const auto array = block.Arrays->Find(name);
      ArrayInfo info{ name, array->Type, array->Components, std::numeric_limits<double>::max(),
        std::numeric_limits<double>::lowest(), 1, true, block.Arrays->HoldsIds(name) };
      for (Index tuple = 0; tuple < array->Tuples; ++tuple)
      {
        const double value = array->Get(tuple, 0);
        info.Least = value < info.Least ? value : info.Least;
        info.Most = value > info.Most ? value : info.Most;
      }
      if (array->Tuples > 0)
      {
        AddArray(list, info);
      }
    }
  }
  return list;
}

} // namespace vfm
