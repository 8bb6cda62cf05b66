#include "Input/FractionChecks.h"

#include "Base/ParseText.h"
#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Input/ArrayNames.h"
#include "Input/InputArrays.h"
#include "Ranks/Agreement.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

/// An array of bytes 0 and 1 as signed char, the smallest type whose values are not divided by 255.
class Mask : public BlockArray
{
public:
  explicit Mask(std::shared_ptr<const BlockArray> bytes) : Bytes(std::move(bytes))
  {
    this->Type = ValueType::SignedChar;
    this->Tuples = this->Bytes->Tuples;
    this->Memory = this->Bytes->Memory;
  }

  double Get(Index tuple, int component) const override
  {
    return this->Bytes->Get(tuple, component);
  }
  void Copy(Index first, Index count, void* to) const override
  {
    this->Bytes->Copy(first, count, to);
  }

private:
  std::shared_ptr<const BlockArray> Bytes;
};

/// Returns the largest value of an array of bytes in cells that are not blanked; the search ends
/// above LargestEmptyByte.
Index FindLargest(const InputBlock& block, const std::shared_ptr<const BlockArray>& array)
{
  const Column<Index> column(array);
  std::vector<Index> row(block.Box.Size(0));
  Index largest = 0;
  for (Index k = block.Box.Lower[2]; k < block.Box.Upper[2]; ++k)
  {
    for (Index j = block.Box.Lower[1]; j < block.Box.Upper[1]; ++j)
    {
      if (largest <= LargestEmptyByte)
      {
        ReadRow(block, column, { { block.Box.Lower[0], j, k } }, block.Box.Size(0), row.data());
        largest = std::max(largest, *std::max_element(row.begin(), row.end()));
      }
    }
  }
  return largest;
}

[[noreturn]] void RejectBytes(const std::vector<std::string>& names,
  const std::vector<Index>& largest, const std::string& labelsOption)
{
  std::vector<std::string> texts;
  for (std::size_t m = 0; m < names.size(); ++m)
  {
    if (largest[m] > 0)
    {
      texts.push_back("'" + names[m] + "' holds values up to " + std::to_string(largest[m]));
    }
  }
  throw InputError("Volume fraction arrays of type unsigned char: " + JoinTexts(texts) +
    ". 255 is a full cell, or 1 if no value exceeds 1, so these arrays fill no cell by half. " +
    "If the values are material ids, choose " +
    (names.size() == 1 ? "the array as labels (" + labelsOption + " " + names[0] + ")."
                       : "one array as labels (--labels).") +
    " If they are fractions, convert them to numbers of type float in [0, 1].");
}

/// Rejects masks next to fractions of 255: a cell is full at different values.
[[noreturn]] void RejectMasks(
  const std::vector<std::string>& names, const std::vector<Index>& largest)
{
  const auto mask = std::find(largest.begin(), largest.end(), 1) - largest.begin();
  const auto full = std::max_element(largest.begin(), largest.end()) - largest.begin();
  throw InputError("Volume fraction arrays of type unsigned char: '" + names[mask] +
    "' holds values up to 1, and '" + names[full] + "' holds values up to " +
    std::to_string(largest[full]) + " or more, so 1 is full in one of them and 255 in the other. " +
    "Convert both to numbers of type float in [0, 1].");
}

std::array<Index, 3> Order(const Index3& cell)
{
  return { { cell[2], cell[1], cell[0] } };
}

} // namespace

bool AreMasks(const std::vector<InputBlocks>& levels, const std::vector<std::string>& names,
  const std::string& labelsOption, Ranks& ranks)
{
  std::vector<Index> largest(names.size(), 0);
  bool haveNames = true;
  WorkTogether(ranks,
    [&]
    {
      for (const InputBlocks& level : levels)
      {
        for (const InputBlock& block : level.Blocks)
        {
          for (std::size_t m = 0; m < names.size(); ++m)
          {
            const auto array = FindMaterialArray(block, names[m]);
            if (array->Type == ValueType::UnsignedChar)
            {
              largest[m] = std::max(largest[m], FindLargest(block, array));
              haveNames = haveNames && IsFractionName(names[m]);
            }
          }
        }
      }
    });
  for (Index& value : largest)
  {
    value = static_cast<Index>(ranks.Max(static_cast<double>(value)));
  }
  haveNames = !ranks.Any(!haveNames);
  const Index most = largest.empty() ? 0 : *std::max_element(largest.begin(), largest.end());
  if (most > 1 && most <= LargestEmptyByte && !haveNames)
  {
    RejectBytes(names, largest, labelsOption);
  }
  if (most > LargestEmptyByte && !haveNames &&
    std::find(largest.begin(), largest.end(), 1) != largest.end())
  {
    RejectMasks(names, largest);
  }
  return most <= 1;
}

std::shared_ptr<const BlockArray> ViewMask(std::shared_ptr<const BlockArray> array)
{
  return array->Type == ValueType::UnsignedChar ? std::make_shared<const Mask>(std::move(array))
                                                : array;
}

double SufficientTolerance(double distance)
{
  const double enough = 1.001 * distance;
  const double unit = std::pow(10.0, std::floor(std::log10(enough)) - 1.0);
  return std::min(std::ceil(enough / unit) * unit, LargestFractionTolerance);
}

void OutsideFractions::Add(const OutsideFractions& other)
{
  if (other.Largest > 0.0 && (this->Largest == 0.0 || Order(other.First) < Order(this->First)))
  {
    this->First = other.First;
    this->Value = other.Value;
    this->Material = other.Material;
  }
  this->Largest = std::max(this->Largest, other.Largest);
  if (other.Lowest < this->Lowest ||
    (other.Lowest == this->Lowest && other.LowestMaterial < this->LowestMaterial))
  {
    this->Lowest = other.Lowest;
    this->LowestMaterial = other.LowestMaterial;
  }
}

namespace
{

/// Rejects an array of values of both signs.
[[noreturn]] void RejectLevelSet(
  const OutsideFractions& outside, const std::vector<std::string>& names)
{
  const std::string& name = names[outside.LowestMaterial - 1];
  std::ostringstream text;
  text << "Volume fraction array '" << names[outside.Material - 1] << "' holds " << outside.Value
       << " in " << TextOf(outside.First) << ": volume fractions lie in [0, 1]. '" << name
       << "' holds values down to " << outside.Lowest
       << ". If it is a level set, such as a signed distance that is negative inside its material, "
       << "LevelSets Priority (--level-set " << name << ") makes volume fractions of it.";
  throw InputError(text.str());
}

} // namespace

void CheckOutside(const OutsideFractions& mine, const std::vector<std::string>& names, Ranks& ranks)
{
  const double largest = ranks.Max(mine.Largest);
  if (largest == 0.0)
  {
    return;
  }
  OutsideFractions all;
  for (const OutsideFractions& one : GatherItems(ranks, std::vector<OutsideFractions>{ mine }))
  {
    all.Add(one);
  }
  if (all.Lowest < -LargestFractionTolerance)
  {
    RejectLevelSet(all, names);
  }
  if (largest > LargestFractionTolerance)
  {
    return;
  }
  const double enough = SufficientTolerance(largest);
  std::ostringstream text;
  text << "Volume fraction array '" << names[all.Material - 1] << "' holds " << all.Value << " in "
       << TextOf(all.First) << ": volume fractions lie in [0, 1]. FractionTolerance " << enough
       << " (--clip " << enough << ") clips all values that are slightly outside.";
  throw InputError(text.str());
}

void OverfullCells::Add(const OverfullCells& other)
{
  if (other.Count > 0 && (this->Count == 0 || Order(other.First) < Order(this->First)))
  {
    this->First = other.First;
    this->FirstSum = other.FirstSum;
  }
  this->Count += other.Count;
  this->LargestSum = std::max(this->LargestSum, other.LargestSum);
}

void CheckSums(const OverfullCells& mine, Index cells, Ranks& ranks)
{
  if (!ranks.Any(mine.Count > 0))
  {
    return;
  }
  OverfullCells all;
  for (const OverfullCells& one : GatherItems(ranks, std::vector<OverfullCells>{ mine }))
  {
    all.Add(one);
  }
  std::vector<Index> total{ cells };
  ranks.Sum(total);
  const double excess = all.LargestSum - 1.0;
  std::ostringstream text;
  text << "The volume fractions of " << TextOf(all.First) << " sum to " << all.FirstSum
       << ": more than 1. The sums of " << all.Count << " of " << total[0]
       << " cells are too large, the largest is " << all.LargestSum << ".";
  if (excess <= LargestFractionTolerance)
  {
    const double enough = SufficientTolerance(excess);
    text << " If the arrays hold separate materials, FractionTolerance " << enough << " (--clip "
         << enough << ") scales these sums back to 1. Otherwise choose arrays of separate "
         << "materials.";
  }
  else
  {
    text << " Choose arrays of separate materials.";
  }
  throw InputError(text.str());
}

} // namespace vfm
