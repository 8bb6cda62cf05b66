#include "FractionField.h"

#include "Runtime.h"

#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double RangeTolerance = 1e-6; // outside [0,1]
constexpr double SumTolerance = 1e-3;   // above 1, at least
constexpr double Negligible = 1e-9;     // fractions below are none
constexpr Index RowLength = 4096;       // cells read at a time

std::string Where(const Index3& first, Index offset)
{
  std::ostringstream text;
  text << "cell (" << first[0] + offset << ", " << first[1] << ", " << first[2] << ")";
  return text.str();
}

double CheckedFraction(double value, const FractionField::Reader& reader, int material,
  const Index3& first, Index offset)
{
  if (!(value >= -RangeTolerance && value <= 1.0 + RangeTolerance))
  {
    std::ostringstream text;
    text << "Volume fraction array '" << reader.Name(material) << "' holds " << value << " in "
         << Where(first, offset) << ": "
         << (std::isfinite(value) ? "volume fractions lie in [0, 1]."
                                  : "volume fractions must be finite numbers.");
    throw InputError(text.str());
  }
  return std::min(std::max(value, 0.0), 1.0);
}

/// Whether the parts of a cell sum above 1 by more than the rounding of their materials explains.
bool IsOverfull(const std::vector<FractionField::Part>& parts, const FractionField::Reader& reader,
  int numberOfMaterials, const Index3& first, Index offset)
{
  double sum = 0.0;
  for (const FractionField::Part& part : parts)
  {
    sum += part.Fraction;
  }
  if (sum <= 1.0 + RangeTolerance)
  {
    return false;
  }
  double ofParts = RangeTolerance, ofAll = 0.0;
  for (const FractionField::Part& part : parts)
  {
    ofParts += reader.Rounding(part.Material);
  }
  for (int m = 1; m <= numberOfMaterials; ++m)
  {
    ofAll += reader.Rounding(m);
  }
  if (sum > 1.0 + std::max(SumTolerance, ofAll))
  {
    std::ostringstream text;
    text << "The volume fractions of " << Where(first, offset) << " sum to " << sum
         << ": more than 1. Choose arrays of separate materials.";
    throw InputError(text.str());
  }
  return sum > 1.0 + ofParts;
}

} // namespace

FractionField::FractionField(const CartesianGrid& grid, int numberOfMaterials) :
  Materials(numberOfMaterials), Entry(grid.NumberOfEntries(), 0), Offset(1, 0)
{
}

void FractionField::SetParts(Index cell, const std::vector<Part>& parts)
{
  double sum = 0.0;
  for (const Part& part : parts)
  {
    sum += part.Fraction;
  }
  const double rest = 1.0 - sum;
  if (parts.empty())
  {
    this->Entry[cell] = 0;
    return;
  }
  if (parts.size() == 1 && rest <= Negligible)
  {
    this->Entry[cell] = parts[0].Material;
    return;
  }
  const double scale = rest <= Negligible ? 1.0 / sum : 1.0;
  if (rest > Negligible)
  {
    this->List.push_back({ 0, rest });
  }
  for (const Part& part : parts)
  {
    this->List.push_back({ part.Material, part.Fraction * scale });
  }
  this->CloseParts(cell);
}

void FractionField::CopyParts(Index cell, Range parts)
{
  this->List.insert(this->List.end(), parts.begin(), parts.end());
  this->CloseParts(cell);
}

/// Gives the parts added last to a cell.
void FractionField::CloseParts(Index cell)
{
  this->Entry[cell] = static_cast<int>(~(static_cast<Index>(this->Offset.size()) - 1));
  this->Offset.push_back(static_cast<Index>(this->List.size()));
}

FractionField FractionField::FromReader(
  const CartesianGrid& grid, int numberOfMaterials, const Reader& reader)
{
  FractionField field(grid, numberOfMaterials);
  const IndexBox& box = grid.Local();
  std::vector<double> values(RowLength);
  std::vector<std::vector<Part>> cells(RowLength);
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    for (Index j = box.Lower[1]; j < box.Upper[1]; ++j)
    {
      for (Index i = box.Lower[0]; i < box.Upper[0]; i += RowLength)
      {
        const Index3 first{ { i, j, k } };
        const Index count = std::min(RowLength, box.Upper[0] - i);
        for (int m = 1; m <= numberOfMaterials; ++m)
        {
          reader.Read(m, first, count, values.data());
          for (Index c = 0; c < count; ++c)
          {
            const double value = CheckedFraction(values[c], reader, m, first, c);
            if (value > Negligible)
            {
              cells[c].push_back({ m, value });
            }
          }
        }
        const Index base = grid.Linear(first);
        for (Index c = 0; c < count; ++c)
        {
          field.Normalised += IsOverfull(cells[c], reader, numberOfMaterials, first, c) &&
            grid.Owned().Contains({ { i + c, j, k } });
          field.SetParts(base + c, cells[c]);
          cells[c].clear();
        }
      }
    }
  }
  return field;
}

std::size_t FractionField::MemoryInBytes() const
{
  return this->Entry.capacity() * sizeof(int) + this->Offset.capacity() * sizeof(Index) +
    this->List.capacity() * sizeof(Part);
}

} // namespace vfm
