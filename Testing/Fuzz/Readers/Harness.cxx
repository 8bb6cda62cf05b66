#include "Harness.h"

#include "Ranks/Errors.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace vfm
{
namespace testing
{

namespace
{

/// Folder of this process; it is removed at the end of the program, unless it crashes.
struct InputFolder
{
  const std::filesystem::path Path =
    std::filesystem::temp_directory_path() / ("vfm-fuzz-" + std::to_string(getpid()));
  ~InputFolder()
  {
    std::error_code error;
    std::filesystem::remove_all(this->Path, error);
  }
};

} // namespace

std::string WriteInput(const std::string& name, const std::string& bytes)
{
  static const InputFolder folder;
  const std::filesystem::path path = folder.Path / name;
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

std::string TakeUntil(std::string& bytes, const std::string& separator)
{
  const std::size_t end = bytes.find(separator);
  const std::string first = bytes.substr(0, end);
  bytes.erase(0, end == std::string::npos ? end : end + separator.size());
  return first;
}

} // namespace testing
} // namespace vfm

int LLVMFuzzerTestOneInput(const unsigned char* data, unsigned long size)
{
  try
  {
    vfm::testing::ReadBytes(std::string(reinterpret_cast<const char*>(data), size));
  }
  catch (const vfm::InputError& error)
  {
    if (std::string(error.what()).empty())
    {
      throw std::logic_error("an error without a message");
    }
  }
  return 0;
}
