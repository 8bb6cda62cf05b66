/**
 * GmshFile: writes numbers of the mesh format of Gmsh (MSH), as text or binary.
 */
#pragma once

#include "Meshes/Files/OutputFile.h"

namespace vfm
{

/// A file of sections. Numbers of a line are separated by spaces in text files; binary files have
/// no lines outside of texts. Binary numbers have the byte order of the machine, which the header
/// of the file states.
class GmshFile
{
public:
  GmshFile(const std::string& path, bool isBinary, OutputSet& files) :
    File(path, files), IsBinary(isBinary)
  {
  }

  void Begin(const std::string& section);
  void End(const std::string& section);
  /// Writes a line of text, also in binary files.
  void Line(const std::string& text);
  ///@{ Writes a number, in binary files of 4 or 8 bytes. Real writes the shortest text that reads
  /// back as the same double.
  void Int(std::int64_t number);
  void Size(std::int64_t number);
  void Real(double number);
  ///@}
  /// Ends a line of numbers in text files.
  void EndLine();
  void Close() { this->File.Close(); }

private:
  void Separate();

  OutputFile File;
  const bool IsBinary;
  bool IsInLine = false; ///< whether a number precedes in the line
};

} // namespace vfm
