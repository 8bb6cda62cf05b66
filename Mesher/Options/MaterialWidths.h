/**
 * MaterialWidths: widths of the cells of single materials, the option MaterialWidths.
 */
#pragma once

#include "Options/FindMaterial.h"
#include "Options/MesherOptions.h"

namespace vfm
{

/// Widths that the user gives.
struct MaterialWidths
{
  /// Width of all materials that fill fewer cells of the input.
  struct Small
  {
    Index Cells;
    double Width;
  };
  bool IsAutomatic = false;
  std::vector<std::pair<std::string, double>> Named; ///< name or id, and width
  std::vector<Small> OfSmall;

  bool IsUsed() const { return this->IsAutomatic || !(Named.empty() && OfSmall.empty()); }
};

/// Parses "auto", or entries name=width and small=N:width with commas between them. A name may
/// contain '=' itself.
/// @return nothing if an entry has another form, or if a width is not above 0
std::optional<MaterialWidths> ParseMaterialWidths(const std::string& text);

/// Returns whether materials have widths of their own.
bool HasMaterialWidths(const MesherOptions& options);

/// Returns the smallest width that is given for each material.
/// @param names names of all materials by id
/// @param ids,cells ids of materials 0, 1, .., and numbers of their cells in the input
/// @return one width per material; infinite for others
/// @throws InputError if a name is not one of a material
std::vector<double> FindWidths(const MaterialWidths& widths, const NamesById& names,
  const std::vector<int>& ids, const std::vector<Index>& cells);

} // namespace vfm
