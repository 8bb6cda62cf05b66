/**
 * LabelTable: what a table calls the labels of an image.
 *
 * A line is a label and its name, with blanks, a tab, a comma or a semicolon between; lines of # are comments, and a first line that begins
 * with id, index, label, number or value is a title. What follows the name is left out: after a comma or semicolon where such a one stands
 * before the name, else after a tab; outside of double quotes (label files of ITK-SNAP); and where all names are one word followed
 * by as many numbers, if these are one (an index; where the names differ without it), three or four (a colour, lookup tables of
 * FreeSurfer).
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

class LabelTable
{
public:
  /// For messages: path of the file, unit of its entries ("line ").
  LabelTable(const std::string& path, const std::string& unit) : Path(path), Unit(unit) {}

  void ReadText(std::istream& stream);
  /// place: of the element in the file, from 1.
  void AddElement(int place, int label, const std::string& name);
  /// Throws InputError when there is none, or a label or a name twice.
  LabelNames MakeNames();

  /// Throws InputError. place: of a line or element; 0: the whole table.
  [[noreturn]] void Reject(int place, const std::string& problem) const;

  /// A whole number from 0 that fills the text.
  static std::optional<int> ParseLabel(const std::string& text);

private:
  struct Row
  {
    int Place = 0; ///< in the file, from 1
    int Label = 0;
    std::string Name;
    std::string Word;        ///< of what is one word and numbers; else empty
    std::size_t Numbers = 0; ///< that follow the word
  };

  std::string NamePlace(int place) const { return this->Unit + std::to_string(place); }
  void ReadLine(const std::string& line, int number);
  bool HasColumnsOfNumbers() const;

  std::string Path, Unit;
  std::vector<Row> Rows;
};

} // namespace vfm
