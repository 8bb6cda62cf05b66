/**
 * ExodusFile: an Exodus file that is being written; it is removed unless it is to be kept.
 */
#pragma once

#include <string>

namespace vfm
{

class ExodusFile
{
public:
  /// mode: of ex_create. All integers are passed to the library as 64-bit ones, whatever the file holds; reals are doubles.
  /// Throws InputError, as all below, which tells why.
  ExodusFile(const std::string& path, int mode);
  ~ExodusFile();
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  /// For the calls of the library.
  int Id() const { return this->FileId; }
  /// status: what a call of the library returned.
  void Check(int status) const;
  void Close();
  /// The file stays when this ends.
  void Keep() { this->IsKept = true; }

private:
  std::string Path;
  int FileId = -1, OldOptions = 0;
  bool IsKept = false;
};

} // namespace vfm
