#include "ExodusFile.h"

#include "Base/Runtime.h"

#include "vtk_exodusII.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace vfm
{
namespace
{

/// Why the last call of the library failed. NetCDF since 4.9.3 no longer tells what the system said.
std::string FindReason()
{
  const int saidBySystem = errno;
  const char *message = nullptr, *function = nullptr;
  int code = 0;
  ex_get_err(&message, &function, &code);
  const std::string reason = ex_strerror(code);
  const bool isKnown = reason.find("Unknown") == std::string::npos || saidBySystem == 0;
  return (isKnown ? reason : std::strerror(saidBySystem)) + ".";
}

} // namespace

ExodusFile::ExodusFile(const std::string& path, int mode) :
  Path(path), OldOptions(ex_opts(0)) // the library's own messages go nowhere
{
  errno = 0;
  int memoryWord = sizeof(double), fileWord = sizeof(double);
  this->FileId =
    ex_create(path.c_str(), EX_CLOBBER | EX_ALL_INT64_API | mode, &memoryWord, &fileWord);
  if (this->FileId < 0)
  {
    const std::string reason = FindReason(); // the next call forgets it
    ex_opts(this->OldOptions);
    throw InputError(reason);
  }
}

ExodusFile::~ExodusFile()
{
  if (this->FileId >= 0)
  {
    ex_close(this->FileId);
    ex_opts(this->OldOptions);
  }
  std::error_code ignored;
  if (!this->IsKept && std::filesystem::is_regular_file(this->Path, ignored))
  {
    std::filesystem::remove(this->Path, ignored);
  }
}

void ExodusFile::Check(int status) const
{
  if (status < 0) // warnings are positive
  {
    throw InputError(FindReason());
  }
}

void ExodusFile::Close()
{
  this->Check(ex_update(this->FileId)); // ex_close fails without a reason
  const int id = this->FileId;
  this->FileId = -1; // a second attempt would be an error of its own
  const int status = ex_close(id);
  ex_opts(this->OldOptions);
  if (status < 0)
  {
    throw InputError("The file cannot be closed.");
  }
}

} // namespace vfm
