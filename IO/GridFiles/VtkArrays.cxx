#include "GridFiles/VtkArrays.h"

#include "Base/ParseText.h"
#include "GridFiles/PackedBlocks.h"
#include "Ranks/Errors.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>

namespace vfm
{
namespace
{

constexpr std::int64_t MostValues = std::int64_t(1) << 50; // in an array
constexpr int MostComponents = 1 << 20;
constexpr std::size_t LongestWord = 1024;
constexpr std::size_t BufferSize = 1 << 16;

/// Array to check.
struct Job
{
  const OutlineElement& Array;
  const VtkStorage& Storage;
  VtkType Type;
  std::optional<std::int64_t> Values; ///< required number
  VisitVtkValue Visit;
};

std::optional<VtkType> FindType(const std::string& name)
{
  static const std::map<std::string, VtkType> types{ { "Bit", { VtkType::Bit, 1 } },
    { "Int8", { VtkType::Signed, 1 } }, { "UInt8", { VtkType::Unsigned, 1 } },
    { "Int16", { VtkType::Signed, 2 } }, { "UInt16", { VtkType::Unsigned, 2 } },
    { "Int32", { VtkType::Signed, 4 } }, { "UInt32", { VtkType::Unsigned, 4 } },
    { "Int64", { VtkType::Signed, 8 } }, { "UInt64", { VtkType::Unsigned, 8 } },
    { "Float32", { VtkType::Real, 4 } }, { "Float64", { VtkType::Real, 8 } },
    { "String", { VtkType::Signed, 1 } } };
  const auto found = types.find(name);
  return found == types.end() ? std::nullopt : std::optional<VtkType>(found->second);
}

void CheckCount(std::int64_t found, std::int64_t required, const char* unit)
{
  if (found != required)
  {
    throw InputError("holds " + std::to_string(found) + " " + unit + ", " +
      std::to_string(required) + " are required.");
  }
}

/// Opens the text of an element: it begins after the first '>', as VTK finds it.
std::unique_ptr<std::istream> OpenText(const Job& job)
{
  std::unique_ptr<std::istream> stream = job.Storage.Open();
  stream->seekg(job.Array.Place);
  for (int c = 0; c != '>' && c != std::istream::traits_type::eof();)
  {
    c = stream->get();
  }
  return stream;
}

/// Reads the next word of a text that ends with '<'.
std::string ReadWord(std::streambuf& text)
{
  constexpr int end = std::streambuf::traits_type::eof();
  std::string word;
  int c = text.sgetc();
  while (std::isspace(c))
  {
    c = text.snextc();
  }
  for (; c != end && c != '<' && !std::isspace(c) && word.size() < LongestWord; c = text.snextc())
  {
    word += static_cast<char>(c);
  }
  return word;
}

void CheckText(const Job& job)
{
  const std::unique_ptr<std::istream> stream = OpenText(job);
  std::int64_t found = 0;
  for (std::string word = ReadWord(*stream->rdbuf()); !word.empty();
       word = ReadWord(*stream->rdbuf()))
  {
    const auto value = ParseVtkNumber(word, job.Type);
    ++found;
    if (!value || word.size() == LongestWord)
    {
      RejectVtkNumber(found, word, job.Type);
    }
    if (job.Visit)
    {
      job.Visit(*value);
    }
  }
  CheckCount(found, job.Values.value_or(found), "values");
}

/// Returns the place of an array in the appended data.
std::int64_t FindAppended(const Job& job)
{
  const std::string offset = job.Array.Get("offset");
  const std::int64_t most = job.Storage.FileSize - job.Storage.Begin;
  std::int64_t place = -1;
  const char* end = offset.data() + offset.size();
  const auto parsed = std::from_chars(offset.data(), end, place);
  if (parsed.ec != std::errc() || parsed.ptr != end || place < 0 || place > most ||
    job.Storage.Encoding.empty())
  {
    throw InputError("begins at offset " + offset + " of the appended data, outside.");
  }
  return job.Storage.Begin + place;
}

/// Converts bytes to values.
class ValueDecoder
{
public:
  explicit ValueDecoder(const Job& job) : ToDo(job) {}

  void operator()(const unsigned char* bytes, std::size_t count)
  {
    for (std::size_t b = 0; this->ToDo.Visit && b < count; ++b)
    {
      this->Value[this->Held++] = bytes[b];
      if (this->Held == this->ToDo.Type.Bytes)
      {
        const bool isBigEndian = this->ToDo.Storage.IsBigEndian;
        this->ToDo.Visit(DecodeVtkNumber(this->Value, this->ToDo.Type, isBigEndian));
        this->Held = 0;
      }
    }
  }

private:
  const Job& ToDo;
  unsigned char Value[8] = {};
  int Held = 0;
};

/// Reads values that are not compressed.
void ReadPlain(const Job& job, StoredBytes& stored, std::int64_t bytes, const TakeBytes& take)
{
  const std::int64_t left = stored.CountLeft();
  const auto reject = [bytes]
  {
    throw InputError(
      "has fewer bytes than its header says, " + std::to_string(bytes) + ": the data end.");
  };
  if (bytes > left)
  {
    reject();
  }
  if (!job.Visit)
  {
    if (!stored.Skip(bytes))
    {
      reject();
    }
    return;
  }
  std::vector<unsigned char> buffer(BufferSize);
  while (bytes > 0)
  {
    const auto part = std::min<std::size_t>(BufferSize, static_cast<std::size_t>(bytes));
    if (stored.Read(buffer.data(), part) < part)
    {
      reject();
    }
    take(buffer.data(), part);
    bytes -= static_cast<std::int64_t>(part);
  }
}

void CheckBytes(const Job& job, bool isInline)
{
  StoredBytes stored(job.Storage,
    isInline ? std::int64_t(OpenText(job)->tellg()) : FindAppended(job),
    isInline || job.Storage.Encoding == "base64");
  ValueDecoder decoder(job);
  const TakeBytes take = std::ref(decoder);
  const auto checkSize = [&job](std::int64_t bytes)
  {
    const std::int64_t width = job.Type.Bytes, bits = job.Type.Kind == VtkType::Bit ? 8 : 1;
    const std::int64_t required =
      job.Values ? (*job.Values + bits - 1) / bits * width : bytes / width * width;
    CheckCount(bytes, required, "bytes");
  };
  if (job.Storage.Compressor.empty())
  {
    const std::int64_t bytes = ReadVtkLength(stored, job.Storage);
    checkSize(bytes);
    ReadPlain(job, stored, bytes, take);
  }
  else
  {
    PackedBlocks blocks(stored, job.Storage);
    checkSize(blocks.CountBytes());
    blocks.Unpack(take);
  }
  if (isInline)
  {
    stored.CheckEnd();
  }
}

void CheckValues(const Job& job)
{
  const bool isAppended = job.Array.Attributes.count("offset") > 0;
  if (isAppended || job.Array.Get("format") == "binary")
  {
    if (job.Values.value_or(1) > 0) // VTK does not read empty arrays
    {
      CheckBytes(job, !isAppended);
    }
    return;
  }
  CheckText(job);
}

/// Checks texts, each of which ends with 0.
void CheckTexts(Job job, std::int64_t texts)
{
  std::int64_t ends = 0;
  job.Values.reset();
  job.Visit = [&ends](double letter) { ends += letter == 0.0; };
  if (texts > 0)
  {
    CheckValues(job);
    CheckCount(ends, texts, "texts");
  }
}

} // namespace

void CheckVtkArray(const OutlineElement& array, std::optional<std::int64_t> tuples,
  const VtkStorage& storage, const VisitVtkValue& visit)
{
  PrefixErrors("the file is truncated or damaged: its array '" + array.Get("Name") + "' ",
    [&]
    {
      const std::string name = array.Get("type"), count = array.Get("NumberOfComponents");
      const auto type = FindType(name);
      if (!type)
      {
        throw InputError("has the unknown type '" + name + "'.");
      }
      const auto components = count.empty() ? 1 : ParseCount(count, 0, MostComponents);
      if (!components)
      {
        throw InputError("has " + count + " components.");
      }
      const std::int64_t width = std::max(*components, 1);
      if (tuples && *tuples > MostValues / width)
      {
        throw InputError("has too many values.");
      }
      const auto values = tuples ? std::optional<std::int64_t>(*tuples * width) : std::nullopt;
      const Job job{ array, storage, *type, values, visit };
      name == "String" ? CheckTexts(job, values.value_or(0)) : CheckValues(job);
    });
}

} // namespace vfm
