#include "ArrayInfo.h"

#include "Ranks/Agreement.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>

namespace vfm
{
namespace
{

void Merge(std::vector<ArrayInfo>& list, const ArrayInfo& info)
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

std::vector<ArrayInfo> FindOwnArrays(const std::vector<vtkDataSetAttributes*>& attributes)
{
  std::vector<ArrayInfo> list;
  for (vtkDataSetAttributes* own : attributes)
  {
    for (int i = 0; i < own->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = own->GetArray(i);
      if (array && array->GetName() && array->GetNumberOfTuples() > 0)
      {
        const double* range = array->GetRange(0);
        const bool holdsIds = array == own->GetGlobalIds() || array == own->GetPedigreeIds();
        Merge(list,
          { array->GetName(), array->GetDataType(), array->GetNumberOfComponents(), range[0],
            range[1], 1, true, holdsIds });
      }
    }
  }
  return list;
}

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
    Merge(list,
      { std::string(at, at + numbers.NameLength), numbers.Type, numbers.Components, numbers.Least,
        numbers.Most, numbers.Count, numbers.HasOneType != 0, numbers.HoldsIds != 0 });
    at += numbers.NameLength;
  }
}

} // namespace

std::vector<ArrayInfo> FindArrays(
  const std::vector<vtkDataSetAttributes*>& attributes, Ranks& ranks)
{
  Bytes mine;
  WorkTogether(ranks, [&] { mine = Pack(FindOwnArrays(attributes)); });
  std::vector<ArrayInfo> list;
  for (const Bytes& bytes : ranks.Gather(mine))
  {
    Unpack(bytes, list);
  }
  return list;
}

} // namespace vfm
