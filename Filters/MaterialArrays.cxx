#include "MaterialArrays.h"

#include "Agreement.h"
#include "CollectBlocks.h"
#include "InputArrays.h"
#include "MaterialGuess.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"

#include <cstring>
#include <map>

namespace vfm
{
namespace
{

/// What the parts hold in an array of one component.
struct ArrayInfo
{
  int Association, Type;
  double Least, Most;
  Index Parts;

  void Add(const ArrayInfo& other)
  {
    this->Type = this->Type == other.Type ? this->Type : VTK_VOID; // makes it unclear
    this->Least = std::min(this->Least, other.Least);
    this->Most = std::max(this->Most, other.Most);
    this->Parts += other.Parts;
  }
};

using Key = std::pair<std::string, int>; // and the association

/// The arrays of this rank that can be meshed: ids and marks of ghosts left out, and points where they are no centres of cells.
class ArrayList
{
public:
  void Add(const InputPart& part)
  {
    this->Parts += part.HasPoints();
    this->Add(part.Data, vtkDataObject::CELL);
    if (vtkImageData::SafeDownCast(part.Data))
    {
      this->Add(part.Data, vtkDataObject::POINT);
    }
  }

  /// Collective: makes it the list of all ranks.
  void Unite(Ranks& ranks)
  {
    Bytes mine;
    for (const auto& array : this->Arrays)
    {
      const std::string& name = array.first.first;
      const std::size_t length = name.size();
      const auto append = [&mine](const void* data, std::size_t size)
      {
        const char* bytes = static_cast<const char*>(data);
        mine.insert(mine.end(), bytes, bytes + size);
      };
      append(&array.second, sizeof(ArrayInfo));
      append(&length, sizeof(length));
      append(name.data(), length);
    }
    this->Arrays.clear();
    for (const Bytes& message : ranks.Gather(mine))
    {
      this->Read(message);
    }
    std::vector<Index> parts{ this->Parts };
    ranks.Sum(parts);
    this->Parts = parts[0];
  }

  const std::map<Key, ArrayInfo>& Get() const { return this->Arrays; }

  MaterialGuess Guess(const ArrayInfo& array) const
  {
    const MaterialGuess guess = GuessMaterial(array.Type, array.Least, array.Most);
    const bool isWhole = array.Parts == this->Parts || guess == MaterialGuess::Nothing;
    return isWhole ? guess : MaterialGuess::Unclear;
  }

private:
  void Add(vtkDataObject* data, int association)
  {
    vtkDataSetAttributes* attributes = data->GetAttributes(association);
    for (int i = 0; attributes && i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      if (array && array->GetName() && array->GetNumberOfComponents() == 1 &&
        array->GetNumberOfTuples() > 0 && IsOffered(array->GetName()) &&
        !HoldsIds(attributes, array->GetName()))
      {
        const double* range = array->GetRange(0);
        this->Add({ array->GetName(), association },
          { association, array->GetDataType(), range[0], range[1], 1 });
      }
    }
  }

  void Add(const Key& key, const ArrayInfo& array)
  {
    const auto added = this->Arrays.emplace(key, array);
    if (!added.second)
    {
      added.first->second.Add(array);
    }
  }

  void Read(const Bytes& message)
  {
    for (std::size_t at = 0; at < message.size();)
    {
      ArrayInfo array;
      std::size_t length;
      std::memcpy(&array, message.data() + at, sizeof(array));
      std::memcpy(&length, message.data() + at + sizeof(array), sizeof(length));
      at += sizeof(array) + sizeof(length);
      this->Add({ std::string(message.data() + at, length), array.Association }, array);
      at += length;
    }
  }

  std::map<Key, ArrayInfo> Arrays;
  Index Parts = 0;
};

/// Collective.
ArrayList FindArrays(vtkDataObject* input, Ranks& ranks)
{
  ArrayList list;
  WorkTogether(ranks,
    [&]
    {
      for (const InputPart& part : FindParts(input, ranks.Rank(), ranks.Count() == 1))
      {
        list.Add(part);
      }
    });
  list.Unite(ranks);
  return list;
}

/// Collective: that which alone can be meant.
MaterialArrays FindSingleArray(vtkDataObject* input, Ranks& ranks)
{
  const ArrayList list = FindArrays(input, ranks);
  MaterialArrays found;
  int candidates = 0;
  for (const auto& array : list.Get())
  {
    const MaterialGuess guess = list.Guess(array.second);
    const ChosenArray chosen{ array.first.first, array.second.Association };
    candidates += guess != MaterialGuess::Nothing;
    if (guess == MaterialGuess::Fraction)
    {
      found.Fractions.push_back(chosen);
    }
    else if (guess == MaterialGuess::Labels)
    {
      found.Labels = chosen;
    }
  }
  if (candidates != 1 || (found.Fractions.empty() && !found.HasLabels()))
  {
    throw InputError("No array is chosen. Tick Volume Fraction Arrays, one a material, or choose "
                     "the Material Id Array, labels.");
  }
  return found;
}

/// Collective: of an array that is chosen for both.
MaterialArrays KeepOneRole(vtkDataObject* input, MaterialArrays chosen, Ranks& ranks)
{
  bool isReal = false;
  const ArrayList list = FindArrays(input, ranks);
  for (const auto& array : list.Get())
  {
    isReal = isReal || (array.first.first == chosen.Labels.Name && IsRealType(array.second.Type));
  }
  return isReal ? MaterialArrays{ {}, chosen.Labels } : MaterialArrays{ chosen.Fractions, {} };
}

} // namespace

MaterialArrays FindMaterialArrays(vtkDataObject* input, MaterialArrays chosen, Ranks& ranks)
{
  if (chosen.Fractions.empty() && !chosen.HasLabels())
  {
    return FindSingleArray(input, ranks);
  }
  if (chosen.HasLabels() && chosen.Fractions.size() == 1 &&
    chosen.Fractions[0].Name == chosen.Labels.Name)
  {
    return KeepOneRole(input, std::move(chosen), ranks);
  }
  if (chosen.HasLabels() && !chosen.Fractions.empty())
  {
    throw InputError("Both Volume Fraction Arrays and the Material Id Array '" +
      chosen.Labels.Name + "' are chosen. Choose one or the other.");
  }
  return chosen;
}

} // namespace vfm
