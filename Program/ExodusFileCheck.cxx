#include "ExodusFileCheck.h"

#include "NetcdfHeader.h"
#include "ReaderSteps.h"

#include <algorithm>
#include <filesystem>

namespace vfm
{
namespace
{

constexpr const char* TruthTable = "elem_var_tab"; // which element blocks have which variables

/// Those of an Exodus file itself may be floats.
bool IsReadableAttribute(const NetcdfHeader::Attribute& attribute)
{
  const auto isOf = [&](NetcdfType type) { return attribute.Type == static_cast<int>(type); };
  return isOf(NetcdfType::Char) || isOf(NetcdfType::Int) || isOf(NetcdfType::Double) ||
    attribute.Name == "api_version" || attribute.Name == "version";
}

/// The library that reads the file ends the program by assertions on these.
void CheckAssertions(const std::string& path, const NetcdfHeader& header)
{
  const auto isSpace = [](const NetcdfHeader::Dimension& dimension)
  { return dimension.Name == "num_dim" && dimension.Length >= 1 && dimension.Length <= 3; };
  if (std::none_of(header.Dimensions.begin(), header.Dimensions.end(), isSpace))
  {
    RejectInput("Cannot read the input " + path +
      ": the file is damaged or no Exodus file: it does not tell a number of dimensions, num_dim.");
  }
  for (const NetcdfHeader::Attribute& attribute : header.Attributes)
  {
    if (!IsReadableAttribute(attribute))
    {
      RejectInput("Cannot read the input " + path +
        ": the file is damaged, or an attribute of it is neither text nor 32-bit integers nor "
        "64-bit real numbers.");
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
        TruthTable + "' holds other numbers than 0 and 1.");
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
    RejectInput("Cannot read the input " + path + ": the file is cut off or damaged.");
  }
  if (other && header->Records != other->Records)
  {
    RejectInput("Cannot read the input " + path + ": it holds " + std::to_string(header->Records) +
      " times, but " + first + " holds " + std::to_string(other->Records) + ".");
  }
  CheckAssertions(path, *header);
}

} // namespace vfm
