#include "Fractions/FractionField.h"

#include "Base/Runtime.h"

#include <cmath>
#include <sstream>

namespace vfm
{
namespace
{

constexpr double Negligible = 1e-9; // smaller fractions count as 0
constexpr Index RowLength = 4096;   // cells read at a time

bool IsOutside(double value, double tolerance)
{
  return !(value >= -tolerance && value <= 1.0 + tolerance); // NaN too
}

double CheckedFraction(
  double value, const FractionField::Reader& reader, int material, const Index3& cell)
{
  if (IsOutside(value, reader.Tolerance()))
  {
    std::ostringstream text;
    text << "Volume fraction array '" << reader.Name(material) << "' holds " << value << " in "
         << TextOf(cell) << ": "
         << (std::isfinite(value) ? "volume fractions lie in [0, 1]."
                                  : "volume fractions must be finite numbers.");
    throw InputError(text.str());
  }
  return std::min(std::max(value, 0.0), 1.0);
}

/// Returns whether the parts of a cell sum above 1 by more than the rounding
/// of their materials explains.
bool IsOverfull(const std::vector<FractionField::Part>& parts, const FractionField::Reader& reader,
  int numberOfMaterials, const Index3& cell)
{
  double sum = 0.0;
  for (const FractionField::Part& part : parts)
  {
    sum += part.Fraction;
  }
  if (sum <= 1.0 + FractionTolerance)
  {
    return false;
  }
  double ofParts = FractionTolerance, ofAll = reader.Tolerance();
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
    text << "The volume fractions of " << TextOf(cell) << " sum to " << sum
         << ": more than 1. Choose arrays of separate materials.";
    throw InputError(text.str());
  }
  return sum > 1.0 + ofParts;
}

} // namespace

FractionField::FractionField(const CartesianGrid& grid, int numberOfMaterials) :
  Materials(numberOfMaterials), Entry(grid, 0), Offset(1, 0)
{
}

void FractionField::SetParts(Index cell, const std::vector<Part>& parts)
{
  this->Entry.Set(cell, this->StoreParts(parts));
}

void FractionField::CopyParts(Index cell, Range parts)
{
  this->Entry.Set(cell, this->StoreCopy(parts));
}

void FractionField::CopyCell(Index cell, const FractionField& from, Index other)
{
  this->Entry.Set(
    cell, from.IsMixed(other) ? this->StoreCopy(from.Parts(other)) : from.Label(other));
}

/// Stores the parts of a cell and returns its entry.
int FractionField::StoreParts(const std::vector<Part>& parts)
{
  double sum = 0.0;
  for (const Part& part : parts)
  {
    sum += part.Fraction;
  }
  const double rest = 1.0 - sum;
  if (parts.empty())
  {
    return 0;
  }
  if (parts.size() == 1 && rest <= Negligible)
  {
    return parts[0].Material;
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
  return this->CloseParts();
}

int FractionField::StoreCopy(Range parts)
{
  if (parts.end() - parts.begin() == 1)
  {
    return parts.First->Material;
  }
  this->List.insert(this->List.end(), parts.begin(), parts.end());
  return this->CloseParts();
}

/// Returns the entry of a cell that consists of the parts added last.
int FractionField::CloseParts()
{
  this->Offset.push_back(static_cast<Index>(this->List.size()));
  return static_cast<int>(~(static_cast<Index>(this->Offset.size()) - 2));
}

void FractionField::RowWriter::Start(Index first)
{
  this->First = first;
}

void FractionField::RowWriter::AddLabel(int label, Index count)
{
  if (count < PagedArray<int>::PageSize)
  {
    this->Entries.insert(this->Entries.end(), count, label);
    return;
  }
  this->Finish();
  PagedArray<int>& entry = this->Field.Entry;
  const Index last = this->First + count;
  const bool isAtStart = entry.InRow(this->First) == 1;
  const bool isAtEnd = entry.InRow(last) == entry.RowLength() - 1;
  entry.Fill(this->First - isAtStart, last + isAtEnd, label);
  this->First = last;
}

void FractionField::RowWriter::AddParts(const std::vector<Part>& parts)
{
  this->Entries.push_back(this->Field.StoreParts(parts));
}

void FractionField::RowWriter::CopyParts(Range parts)
{
  this->Entries.push_back(this->Field.StoreCopy(parts));
}

void FractionField::RowWriter::CopyCell(const FractionField& from, Index other)
{
  if (from.IsMixed(other))
  {
    this->CopyParts(from.Parts(other));
    return;
  }
  this->AddLabel(from.Label(other));
}

void FractionField::RowWriter::Finish()
{
  if (this->Entries.empty())
  {
    return;
  }
  PagedArray<int>& entry = this->Field.Entry;
  const Index last = this->First + static_cast<Index>(this->Entries.size());
  entry.Write(this->First, last, this->Entries.data());
  if (entry.InRow(this->First) == 1 && this->Entries.front() >= 0)
  {
    entry.Fill(this->First - 1, this->First, this->Entries.front());
  }
  if (entry.InRow(last) == entry.RowLength() - 1 && this->Entries.back() >= 0)
  {
    entry.Fill(last, last + 1, this->Entries.back());
  }
  this->First = last;
  this->Entries.clear();
}

FractionField FractionField::FromReader(
  const CartesianGrid& grid, int numberOfMaterials, const Reader& reader)
{
  FractionField field(grid, numberOfMaterials);
  const IndexBox& box = grid.Local();
  std::vector<double> values(RowLength);
  std::vector<std::vector<Part>> cells(RowLength);
  std::vector<bool> isClipped(RowLength, false);
  RowWriter row(field);
  const auto readRow = [&](const Index3& first, Index count)
  {
    const auto cellAt = [&first](Index c) {
      return Index3{ { first[0] + c, first[1], first[2] } };
    };
    for (int m = 1; m <= numberOfMaterials; ++m)
    {
      reader.Read(m, first, count, values.data());
      for (Index c = 0; c < count; ++c)
      {
        const double value = CheckedFraction(values[c], reader, m, cellAt(c));
        isClipped[c] = isClipped[c] || IsOutside(values[c], FractionTolerance);
        if (value > Negligible)
        {
          cells[c].push_back({ m, value });
        }
      }
    }
    row.Start(grid.Linear(first));
    for (Index c = 0; c < count; ++c)
    {
      const bool isOwned = grid.Owned().Contains(cellAt(c));
      field.Normalised += IsOverfull(cells[c], reader, numberOfMaterials, cellAt(c)) && isOwned;
      field.Clipped += isClipped[c] && isOwned;
      isClipped[c] = false;
      row.AddParts(cells[c]);
      cells[c].clear();
    }
    row.Finish();
  };
  ForRows(box,
    [&](Index j, Index k)
    {
      for (Index i = box.Lower[0]; i < box.Upper[0]; i += RowLength)
      {
        readRow({ { i, j, k } }, std::min(RowLength, box.Upper[0] - i));
      }
    });
  return field;
}

int MaterialOfParts(FractionField::Range parts, double isoValue)
{
  int best = 0;
  double largest = 0.0, empty = 0.0;
  for (const FractionField::Part& part : parts)
  {
    if (part.Material == 0)
    {
      empty = part.Fraction;
    }
    else if (part.Fraction > largest)
    {
      largest = part.Fraction;
      best = part.Material;
    }
  }
  return empty > 1.0 - isoValue ? 0 : best;
}

std::size_t FractionField::MemoryInBytes() const
{
  return this->Entry.MemoryInBytes() + this->Offset.capacity() * sizeof(Index) +
    this->List.capacity() * sizeof(Part);
}

} // namespace vfm
