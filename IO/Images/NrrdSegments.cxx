#include "Images/NrrdSegments.h"

#include "Base/ParseText.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>
#include <set>

namespace vfm
{
namespace
{

constexpr int MostSegments = 100000;

/// Returns an integer of a segment, or `without` if it is missing.
int FindNumber(const NrrdFields& fields, const std::string& key, int without)
{
  const auto found = fields.Pairs.find(key);
  const std::optional<int> number = found == fields.Pairs.end()
    ? without
    : ParseCount(found->second, 0, std::numeric_limits<int>::max());
  if (!number)
  {
    throw InputError("its header says '" + key + ":=" + found->second.substr(0, 80) +
      "', where an integer from 0 is required.");
  }
  return *number;
}

/// Numbers the segments, unless their values differ.
void SetLabels(std::vector<NrrdSegment>& segments)
{
  std::set<Index> values;
  for (const NrrdSegment& segment : segments)
  {
    values.insert(segment.Value);
  }
  const bool differ = values.size() == segments.size();
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    segments[i].Label = differ ? static_cast<int>(segments[i].Value) : static_cast<int>(i) + 1;
  }
}

/// Returns the segment of a value.
const NrrdSegment& FindSegment(
  const std::vector<NrrdSegment>& segments, Index layer, std::optional<Index> value)
{
  const auto found = std::find_if(segments.begin(), segments.end(),
    [&](const NrrdSegment& segment) { return segment.Layer == layer && segment.Value == value; });
  if (found == segments.end())
  {
    throw InputError("layer " + std::to_string(layer) + " holds " +
      (value ? "the value " + std::to_string(*value) : std::string("a value")) +
      " that belongs to no segment. Select one layer by its number, --volume or Volume.");
  }
  return *found;
}

/// Merges the layers of one point.
template <class Value>
int MergePoint(const Value* values, Index layers, const std::vector<NrrdSegment>& segments)
{
  const NrrdSegment* found = nullptr;
  for (Index layer = 0; layer < layers; ++layer)
  {
    const Value value = values[layer];
    if (value == Value(0))
    {
      continue;
    }
    const bool isLabel = value > Value(0) &&
      static_cast<double>(value) <= std::numeric_limits<int>::max() &&
      static_cast<Value>(static_cast<Index>(value)) == value;
    const NrrdSegment& segment = FindSegment(
      segments, layer, isLabel ? std::optional<Index>(static_cast<Index>(value)) : std::nullopt);
    if (found)
    {
      throw InputError("its segments '" + found->Name + "' and '" + segment.Name +
        "' overlap. Select one layer by its number, --volume or Volume.");
    }
    found = &segment;
  }
  return found ? found->Label : 0;
}

} // namespace

std::vector<NrrdSegment> ListSegments(const NrrdFields& fields)
{
  std::vector<NrrdSegment> segments;
  for (int number = 0; number < MostSegments; ++number)
  {
    const std::string key = "Segment" + std::to_string(number) + "_";
    const auto name = fields.Pairs.find(key + "Name"), id = fields.Pairs.find(key + "ID");
    if (name == fields.Pairs.end() && id == fields.Pairs.end())
    {
      break;
    }
    NrrdSegment segment;
    segment.Name = (name == fields.Pairs.end() ? id : name)->second;
    // Files of Slicer before 5 have one segment per layer, without these keys.
    segment.Value = FindNumber(fields, key + "LabelValue", 1);
    segment.Layer = FindNumber(fields, key + "Layer", number);
    segments.push_back(segment);
  }
  SetLabels(segments);
  return segments;
}

TypedValues TakeLayer(const TypedValues& stored, Index layers, Index layer)
{
  const Index width = WidthOfType(stored.Type);
  const Index count = static_cast<Index>(stored.Bytes.size()) / (layers * width);
  TypedValues values = MakeValues("", stored.Type, count);
  for (Index i = 0; i < count; ++i)
  {
    std::memcpy(values.Bytes.data() + i * width, stored.Bytes.data() + (i * layers + layer) * width,
      static_cast<std::size_t>(width));
  }
  return values;
}

void PutLayer(const TypedValues& values, Index layers, Index layer, TypedValues& all)
{
  const Index width = WidthOfType(values.Type);
  const Index count = static_cast<Index>(values.Bytes.size()) / width;
  for (Index i = 0; i < count; ++i)
  {
    std::memcpy(all.Bytes.data() + (i * layers + layer) * width, values.Bytes.data() + i * width,
      static_cast<std::size_t>(width));
  }
}

TypedValues MergeLayers(
  const TypedValues& stored, Index layers, const std::vector<NrrdSegment>& segments)
{
  const Index count = static_cast<Index>(stored.Bytes.size()) / (layers * WidthOfType(stored.Type));
  TypedValues labels = MakeValues("", ValueType::Int, count);
  int* to = reinterpret_cast<int*>(labels.Bytes.data());
  VisitType(stored.Type,
    [&](auto tag)
    {
      const auto* from = reinterpret_cast<const typename decltype(tag)::Type*>(stored.Bytes.data());
      for (Index i = 0; i < count; ++i)
      {
        to[i] = MergePoint(from + i * layers, layers, segments);
      }
    });
  return labels;
}

} // namespace vfm
