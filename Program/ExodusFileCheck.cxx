#include "ExodusFileCheck.h"

#include "NetcdfHeader.h"
#include "ReaderSteps.h"

#include <algorithm>
#include <filesystem>

namespace vfm
{
namespace
{

constexpr const char* TruthTable = "elem_var_tab"; // variables of each element block

/// Returns whether the library can read an attribute. Only the two version numbers may be floats.
bool IsReadableAttribute(const NetcdfHeader::Attribute& attribute)
{
  const auto isOf = [&](NetcdfType type) { return attribute.Type == static_cast<int>(type); };
  return isOf(NetcdfType::Char) || isOf(NetcdfType::Int) || isOf(NetcdfType::Double) ||
    attribute.Name == "api_version" || attribute.Name == "version";
}

/// Rejects files for which the library of the reader would end the program by an assertion.
void CheckAssertions(const std::string& path, const NetcdfHeader& header)
{
  const auto isSpace = [](const NetcdfHeader::Dimension& dimension)
  { return dimension.Name == "num_dim" && dimension.Length >= 1 && dimension.Length <= 3; };
  if (std::none_of(header.Dimensions.begin(), header.Dimensions.end(), isSpace))
  {
    RejectInput("Cannot read the input " + path +
      ": the file is damaged or not an Exodus file: it has no number of dimensions, num_dim.");
  }
  for (const NetcdfHeader::Attribute& attribute : header.Attributes)
  {
    if (!IsReadableAttribute(attribute))
    {
      RejectInput("Cannot read the input " + path +
        ": the file is damaged, or one of its attributes is neither text nor 32-bit integer nor "
        "64-bit floating point.");
    }
  }
  for (const NetcdfHeader::Variable& variable : header.Variables)
  {
    const bool isTable = variable.Name == TruthTable && !variable.HasRecords &&
      variable.Type == static_cast<int>(NetcdfType::Int);
    const std::vector<std::int32_t> flags =
      isTable ? ReadNetcdfInts(path, variable) : std::vector<std::int32_t>();
    if (std::any_of(flags.begin(), flags.end(), [](std::int32_t flag) { return (flag & ~1) != 0; }))
    {
      RejectInput("Cannot read the input " + path + ": the file is damaged: its variable '" +
        TruthTable + "' contains numbers other than 0 and 1.");
    }
  }
}

} // namespace

void CheckExodusFile(const std::string& path, const std::string& first)
{
  const auto header = ReadNetcdfHeader(path), other = ReadNetcdfHeader(first);
  if (!header)
  {
    return;
  }
  if (static_cast<std::int64_t>(std::filesystem::file_size(path)) < header->Size)
  {
    RejectInput("Cannot read the input " + path + ": the file is truncated or damaged.");
  }
  if (other && header->Records != other->Records)
  {
    RejectInput("Cannot read the input " + path + ": it holds " + std::to_string(header->Records) +
      " times, but " + first + " holds " + std::to_string(other->Records) + ".");
  }
  CheckAssertions(path, *header);
}

} // namespace vfm
