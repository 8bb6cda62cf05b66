#include "Meshes/Files/OutputFile.h"

#include "Ranks/Errors.h"

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

void MakeFolder(const std::string& path)
{
  std::error_code error;
  std::filesystem::create_directory(path, error);
  if (error)
  {
    throw InputError(path + ": " + error.message() + ".");
  }
}

UnfinishedFile::UnfinishedFile(std::string path) : Path(std::move(path)) {}

UnfinishedFile::~UnfinishedFile()
{
  std::error_code ignored;
  if (!this->IsKept && std::filesystem::is_regular_file(this->Path, ignored))
  {
    std::filesystem::remove(this->Path, ignored);
  }
}

OutputFile::OutputFile(const std::string& path) : Path(path), File(std::fopen(path.c_str(), "wb"))
{
  if (!this->File)
  {
    throw InputError(std::strerror(errno) + std::string("."));
  }
  std::setvbuf(this->File, nullptr, _IONBF, 0); // this class has its own buffer
  this->Buffer.reserve(2 * BufferSize);
}

OutputFile::~OutputFile()
{
  if (this->File)
  {
    const UnfinishedFile removed(this->Path);
    std::fclose(this->File);
  }
}

void OutputFile::Add(std::string_view text)
{
  this->Buffer.append(text);
  if (this->Buffer.size() >= BufferSize)
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
  errno = 0;
  if (std::fwrite(this->Buffer.data(), 1, this->Buffer.size(), this->File) != this->Buffer.size())
  {
    throw InputError(std::strerror(errno) + std::string("."));
  }
  this->Buffer.clear();
}

void OutputFile::Close()
{
  this->Flush();
  UnfinishedFile closed(this->Path);
  std::FILE* file = this->File;
  this->File = nullptr;
  if (std::fclose(file) != 0) // some file systems report errors only here
  {
    throw InputError(std::strerror(errno) + std::string("."));
  }
  closed.Keep();
}

} // namespace vfm
