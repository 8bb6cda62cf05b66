#include "PackedValues.h"

#include <algorithm>

namespace vfm
{

void PackedValues::Append(const double* values, Index count)
{
  this->Tuples += count;
  while (count > 0)
  {
    const Index taken = std::min(PageSize - static_cast<Index>(this->Last.size()), count);
    this->Last.insert(this->Last.end(), values, values + taken);
    values += taken;
    count -= taken;
    if (static_cast<Index>(this->Last.size()) == PageSize)
    {
      this->AddPage();
    }
  }
}

void PackedValues::Finish()
{
  if (!this->Last.empty())
  {
    this->Last.resize(PageSize, this->Last.back());
    this->AddPage();
  }
  this->Pages.shrink_to_fit();
}

void PackedValues::AddPage()
{
  const bool isSame = std::all_of(
    this->Last.begin(), this->Last.end(), [this](double value) { return value == this->Last[0]; });
  const auto known = isSame ? this->Same.find(this->Last[0]) : this->Same.end();
  std::uint32_t page = this->Count;
  if (known != this->Same.end())
  {
    page = known->second;
  }
  else
  {
    if (this->Count % PagesOfChunk == 0)
    {
      this->Chunks.emplace_back().reserve(PagesOfChunk * PageSize);
    }
    this->Chunks.back().insert(this->Chunks.back().end(), this->Last.begin(), this->Last.end());
    ++this->Count;
    if (isSame)
    {
      this->Same[this->Last[0]] = page;
    }
  }
  this->Pages.push_back(page);
  this->Last.clear();
}

void PackedValues::Copy(Index first, Index count, void* to) const
{
  auto* values = static_cast<double*>(to);
  for (Index i = 0; i < count; ++i)
  {
    values[i] = this->Get(first + i, 0);
  }
}

} // namespace vfm
