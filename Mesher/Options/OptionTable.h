/**
 * OptionTable: all options of the mesher, one row per option: name, allowed values, display in
 * front ends, and help text.
 *
 * SetOptions.h sets and checks options by this table. scripts/generate reads it from
 * describe_options and writes the properties of the filters, the signatures of the Python package
 * and the tables of the pages.
 */
#pragma once

#include "Options/MesherOptions.h"

#include <limits>
#include <optional>

namespace vfm
{

enum class OptionKind
{
  Switch,
  Integer,
  Real,
  Choice,
  Array,  ///< name of an array
  File,   ///< path of a file
  Arrays, ///< names of arrays
  Kinds,  ///< entries array=kind
  Pairs,  ///< pairs of materials
  Ranges, ///< ranges of values
  Widths, ///< one width, or one per axis
  Sizes,  ///< widths of materials
  Boxes   ///< RefinementBoxes
};

/// Numbers that an option accepts.
struct OptionRange
{
  double Least = -std::numeric_limits<double>::infinity();
  double Most = std::numeric_limits<double>::infinity();
  bool IsMinimumOpen = false, IsMaximumOpen = false; ///< the limits are excluded
  std::optional<double> Special = std::nullopt;      ///< number with a special meaning
  std::string Meaning = {};                          ///< meaning of Special: off, automatic

  /// Returns whether the number is in the range or equal to Special.
  bool Holds(double number) const;
};

/// A row of the table. The kind determines which of GetNumber, Text and Texts is set.
struct Option
{
  std::string Name;
  OptionKind Kind = OptionKind::Boxes;
  /// Reads a number; 0 or 1 for a switch, the index of the word for a choice. Null for texts.
  double (*GetNumber)(const MesherOptions&) = nullptr;
  void (*SetNumber)(MesherOptions&, double) = nullptr;
  std::string MesherOptions::*Text = nullptr; ///< set for an array, a file, pairs or ranges
  std::vector<std::string> MesherOptions::*Texts = nullptr; ///< set for arrays or kinds
  OptionRange Range;                                        ///< range of integers and reals
  std::vector<std::string> Words; ///< words of a choice, as in panels; the first is number 0
  bool OnlyTets = false;
  std::string Group; ///< group in the panel
  /// Condition under which the panel shows the option, in the notation of scripts/options/panel.py;
  /// empty: always.
  std::string Shown;
  std::string Enabled; ///< condition under which the panel enables the option; empty: always
  bool IsAdvanced = false;
  bool IsListed = false;       ///< the panel lists all numbers
  bool TakesVectors = false;   ///< the array may have several components
  bool IsHiddenOfTets = false; ///< no effect on tetrahedra
  std::string Python;          ///< name in Python; empty: the package sets it in other ways
  std::string Argument;        ///< argument of sculptor: "--iso V"; empty: only by --set
  std::string Meaning;         ///< help text; the first sentence is a summary
  std::string MeaningOfTets;   ///< help text for tetrahedra; empty: the same

  /// Returns the allowed values, for messages and help: "a number above 0 and below 1".
  std::string Allowed() const;
};

using OptionTable = std::vector<Option>;

/// Returns all options in the order of the panel.
const OptionTable& GetOptionTable();

} // namespace vfm
