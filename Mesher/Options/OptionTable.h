/**
 * OptionTable: every option of the mesher, a row each: its name, what it takes, where front ends show it, and what it means.
 *
 * SetOptions.h sets and checks options by it; scripts/generate writes from it (describe_options prints it) the properties of the
 * filters, the signatures of the Python package and the tables of the documents.
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
  Array,  ///< the name of an array
  File,   ///< a path
  Arrays, ///< names of arrays
  Kinds,  ///< words array=kind
  Boxes   ///< RefinementBoxes
};

/// Numbers that an option takes.
struct OptionRange
{
  double Least = -std::numeric_limits<double>::infinity();
  double Most = std::numeric_limits<double>::infinity();
  bool IsMinimumOpen = false, IsMaximumOpen = false; ///< not allowed themselves
  std::optional<double> Special = std::nullopt;      ///< a number with a meaning of its own
  std::string Meaning = {};                          ///< of Special: off, automatic

  bool Holds(double number) const;
};

struct Option
{
  std::string Name;
  OptionKind Kind = OptionKind::Boxes;
  double (*GetNumber)(const MesherOptions&) = nullptr; ///< of a switch 0 or 1, of a choice its word
  void (*SetNumber)(MesherOptions&, double) = nullptr;
  std::string MesherOptions::*Text = nullptr;               ///< of an array or a file
  std::vector<std::string> MesherOptions::*Texts = nullptr; ///< of arrays or kinds
  OptionRange Range;                                        ///< of integers and reals
  std::vector<std::string> Words; ///< of a choice, as panels show them; the first is number 0
  bool OnlyTets = false;
  std::string Group; ///< of the panel
  std::string
    Shown; ///< the panel hides it unless this holds (scripts/options/panel.py tells the notation); empty: always shown
  std::string Enabled; ///< the panel greys it unless this holds
  bool IsAdvanced = false;
  bool IsListed = false;       ///< the panel lists all numbers
  bool TakesVectors = false;   ///< the array may have several components
  bool IsHiddenOfTets = false; ///< has no effect on them
  std::string Python;          ///< the name there; empty: given in other ways
  std::string Argument;        ///< of sculptor, with what follows: "--iso V"; empty: by --set
  std::string Meaning;
  std::string MeaningOfTets; ///< empty: the same

  /// For messages and help: "a number above 0 and below 1".
  std::string Allowed() const;
};

using OptionTable = std::vector<Option>;

/// In the order of the panel.
const OptionTable& GetOptionTable();

} // namespace vfm
