/**
 * LabelTable: parses a table of labels of an image and their names.
 *
 * Each line holds a label and its name, separated by spaces, a tab, a comma or a semicolon. Lines
 * that begin with # are comments. A first line that begins with id, index, label, number or value
 * is a title.
 *
 * Text that is ignored:
 * - text after a comma or semicolon if the same sign separates label and name, else after a tab
 * - text outside of double quotes (label files of ITK-SNAP)
 * - numbers, if each name is one word followed by N numbers. N is 1 (an index, if the names differ
 *   without it), 3 or 4 (a colour, as in lookup tables of FreeSurfer).
 */
#pragma once

#include "Input/LabelNames.h"

#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Table of labels and names. Fill it by ReadText or AddElement, then call MakeNames once.
class LabelTable
{
public:
  /// @param path  path of the file, for messages
  /// @param unit  unit of the entries, for messages, for instance "line "
  LabelTable(const std::string& path, const std::string& unit) : Path(path), Unit(unit) {}

  /// Adds the lines of a text.
  /// @throws InputError  if a line has no label or no name
  void ReadText(std::istream& stream);
  /// Adds one label.
  /// @param place  number of the entry in the file, from 1
  void AddElement(int place, int label, const std::string& name);
  /// Returns the name of each label.
  /// @throws InputError  if the table is empty, or contains a label or a name twice
  LabelNames MakeNames();

  /// Returns a note about the first line that was not in UTF-8 and was converted from Windows-1252;
  /// "" if there is none.
  const std::string& Note() const { return this->TheNote; }

  /// Reports a problem of the table.
  /// @param place  number of the entry, 0 for the whole table
  /// @throws InputError  always
  [[noreturn]] void Reject(int place, const std::string& problem) const;

  /// Returns the label that the whole text consists of, an integer from 0 to 2^31 - 1; nothing for
  /// any other text.
  static std::optional<int> ParseLabel(const std::string& text);

private:
  struct Row
  {
    int Place = 0; ///< number of the entry in the file, from 1
    int Label = 0;
    std::string Name;
    std::string Word; ///< first word after the label, if only numbers follow it; otherwise empty
    std::size_t Numbers = 0; ///< number of words after the first
  };

  std::string ConvertLine(const std::string& line, int number);
  std::string NamePlace(int place) const { return this->Unit + std::to_string(place); }
  void ReadLine(const std::string& line, int number);
  bool HasColumnsOfNumbers() const;

  std::string Path, Unit, TheNote;
  std::vector<Row> Rows;
};

} // namespace vfm
