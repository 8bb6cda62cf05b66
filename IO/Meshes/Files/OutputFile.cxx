#include "Meshes/Files/OutputFile.h"

#include "Ranks/Errors.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace vfm
{
namespace
{

constexpr std::size_t BufferSize = 1 << 20;

[[noreturn]] void ThrowReason()
{
  throw InputError(std::strerror(errno) + std::string("."));
}

} // namespace

OutputFile::OutputFile(const std::string& path) : Own(std::make_unique<OutputSet>(path))
{
  this->Open(this->Own->Create(path));
}

OutputFile::OutputFile(const std::string& path, OutputSet& set)
{
  this->Open(set.Create(path));
}

OutputFile::~OutputFile()
{
  if (this->File >= 0)
  {
    close(this->File);
  }
}

void OutputFile::Open(const std::string& path)
{
  this->File = open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  if (this->File < 0)
  {
    ThrowReason();
  }
  struct stat status
  {
  };
  this->IsSeekable = fstat(this->File, &status) == 0 && S_ISREG(status.st_mode);
  this->Buffer.reserve(2 * BufferSize);
}

void OutputFile::Add(std::string_view text)
{
  this->Buffer.append(text);
  if (this->Buffer.size() >= BufferSize && (this->IsSeekable || !this->HasReserved))
  {
    this->Flush();
  }
}

void OutputFile::Add(std::int64_t number)
{
  char text[24];
  this->Add(std::string_view(text, std::to_chars(text, text + sizeof(text), number).ptr - text));
}

void OutputFile::AddReal(double number)
{
  char text[32];
  this->Add(std::string_view(text, std::to_chars(text, text + sizeof(text), number).ptr - text));
}

void OutputFile::Flush()
{
  const char* next = this->Buffer.data();
  const char* const end = next + this->Buffer.size();
  while (next < end)
  {
    const ssize_t written = write(this->File, next, static_cast<std::size_t>(end - next));
    if (written < 0 && errno != EINTR)
    {
      ThrowReason();
    }
    next += std::max<ssize_t>(written, 0);
  }
  this->Written += static_cast<std::int64_t>(this->Buffer.size());
  this->Buffer.clear();
}

std::int64_t OutputFile::Reserve(std::size_t size)
{
  const std::int64_t place = this->Written + static_cast<std::int64_t>(this->Buffer.size());
  this->HasReserved = true;
  this->Add(std::string(size, ' '));
  return place;
}

void OutputFile::Fill(std::int64_t place, std::string_view bytes)
{
  this->HasReserved = false;
  if (place >= this->Written)
  {
    this->Buffer.replace(static_cast<std::size_t>(place - this->Written), bytes.size(), bytes);
    return;
  }
  while (!bytes.empty())
  {
    const ssize_t written = pwrite(this->File, bytes.data(), bytes.size(), place);
    if (written < 0 && errno != EINTR)
    {
      ThrowReason();
    }
    place += std::max<ssize_t>(written, 0);
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

void OutputFile::Close()
{
  this->Flush();
  if (fsync(this->File) != 0 && errno != EINVAL) // EINVAL: a pipe or a device
  {
    ThrowReason();
  }
  if (close(std::exchange(this->File, -1)) != 0) // some file systems report errors only here
  {
    ThrowReason();
  }
  if (this->Own)
  {
    this->Own->Rename();
  }
}

} // namespace vfm
