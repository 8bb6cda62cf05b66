#include "TextFile.h"

#include "Base/Runtime.h"

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>

namespace vfm
{
namespace
{

constexpr std::size_t BufferSize = 1 << 20;

} // namespace

TextFile::TextFile(const std::string& path) : Path(path), File(std::fopen(path.c_str(), "wb"))
{
  if (!this->File)
  {
    throw InputError(std::strerror(errno));
  }
  std::setvbuf(this->File, nullptr, _IONBF, 0); // the buffer is here
  this->Buffer.reserve(2 * BufferSize);
}

TextFile::~TextFile()
{
  if (this->File)
  {
    std::fclose(this->File);
    std::error_code ignored;
    if (std::filesystem::is_regular_file(this->Path, ignored)) // not a device
    {
      std::filesystem::remove(this->Path, ignored);
    }
  }
}

void TextFile::Add(std::string_view text)
{
  this->Buffer.append(text);
  if (this->Buffer.size() >= BufferSize)
  {
    this->Flush();
  }
}

void TextFile::Add(std::int64_t number)
{
  char text[24];
  this->Add(std::string_view(text, std::to_chars(text, text + sizeof(text), number).ptr - text));
}

void TextFile::Flush()
{
  errno = 0;
  if (std::fwrite(this->Buffer.data(), 1, this->Buffer.size(), this->File) != this->Buffer.size())
  {
    throw InputError(std::strerror(errno));
  }
  this->Buffer.clear();
}

void TextFile::Close()
{
  this->Flush();
  std::FILE* file = this->File;
  if (std::fflush(file) != 0)
  {
    throw InputError(std::strerror(errno));
  }
  this->File = nullptr;
  if (std::fclose(file) != 0) // some file systems tell only now
  {
    const int reason = errno;
    std::error_code ignored;
    std::filesystem::remove(this->Path, ignored);
    throw InputError(std::strerror(reason));
  }
}

} // namespace vfm
