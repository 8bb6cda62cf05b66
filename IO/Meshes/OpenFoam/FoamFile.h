/**
 * FoamFile: writes lists in the file format of OpenFOAM, as text or binary.
 */
#pragma once

#include "Base/IndexBox.h"
#include "Meshes/Files/OutputFile.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace vfm
{

/// The entry FoamFile at the head of a file.
struct FoamHeader
{
  std::string Class;    ///< type of the contents, such as "labelList"
  std::string Location; ///< folder in the case, such as "constant/polyMesh"
  std::string Object;   ///< name of the file
  std::string Note;     ///< may be empty
};

/// A file of lists and dictionaries. Binary files have labels of 32 bits, scalars of 64 bits and
/// the byte order of the machine, as their header states.
class FoamFile
{
public:
  /// @param folder  folder of the case, or of its part; contains header.Location
  /// @param files  set to which the file belongs
  FoamFile(const std::string& folder, const FoamHeader& header, bool isBinary, OutputSet& files);

  /// Writes text, also in binary files.
  void Text(std::string_view text) { this->File.Add(text); }
  /// Writes the list of labels label(i) for each i from 0 below count.
  template <class Label>
  void Labels(Index count, const Label& label)
  {
    this->Begin(count);
    for (Index i = 0; i < count; ++i)
    {
      this->Label(label(i));
      this->EndLine();
    }
    this->End(count);
  }
  /// Writes the list of booleans flag(i).
  template <class Flag>
  void Flags(Index count, const Flag& flag)
  {
    this->Begin(count);
    for (Index i = 0; i < count; ++i)
    {
      this->File.Add(std::string(1, static_cast<char>(flag(i) + (this->IsBinary ? 0 : '0'))));
      this->EndLine();
    }
    this->End(count);
  }
  /// Writes the list of value(i, component), each followed by a text. @pre a text file
  template <class Value>
  void Reals(Index count, int components, const Value& value, const char* after)
  {
    this->Begin(count);
    for (Index i = 0; i < count; ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        this->Text(c > 0 ? " " : components > 1 ? "(" : "");
        this->File.AddReal(value(i, c));
      }
      this->Text(components > 1 ? ")" : "");
      this->Text(after);
      this->EndLine();
    }
    this->End(count);
  }
  /// Writes a list of points, three coordinates each.
  void Points(const double* points, Index count);
  /// Writes the list of faces points(i), of which the first `corners` count.
  template <class Points>
  void Faces(Index count, int corners, const Points& points)
  {
    if (this->IsBinary)
    {
      this->Labels(count + 1, [corners](Index face) { return corners * face; });
      this->Labels(corners * count,
        [&](Index i) { return points(i / corners)[static_cast<std::size_t>(i % corners)]; });
      return;
    }
    this->Begin(count);
    for (Index face = 0; face < count; ++face)
    {
      const std::array<Index, 4> all = points(face);
      this->Face({ all.data(), static_cast<std::size_t>(corners) });
    }
    this->End(count);
  }
  /// Writes the list of faces points(i), ranges of any length.
  template <class Points>
  void Polygons(Index count, const Points& points)
  {
    if (this->IsBinary)
    {
      std::vector<Index> ends{ 0 }, all;
      for (Index i = 0; i < count; ++i)
      {
        const auto face = points(i);
        all.insert(all.end(), face.begin(), face.end());
        ends.push_back(static_cast<Index>(all.size()));
      }
      this->Labels(count + 1, [&ends](Index i) { return ends[i]; });
      this->Labels(ends.back(), [&all](Index i) { return all[i]; });
      return;
    }
    this->Begin(count);
    for (Index i = 0; i < count; ++i)
    {
      this->Face(points(i));
    }
    this->End(count);
  }
  void Close() { this->File.Close(); }

private:
  void Begin(Index count);
  void End(Index count);
  void Label(Index label);
  void Face(std::span<const Index> points);
  void EndLine();

  OutputFile File;
  const bool IsBinary;
};

} // namespace vfm
