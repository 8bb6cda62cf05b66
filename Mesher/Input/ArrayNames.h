/**
 * ArrayNames: content of arrays by their names, as codes and file formats use them.
 */
#pragma once

#include <string>

namespace vfm
{

/// Name of label arrays in meshes and in the output of voxel readers.
constexpr const char* LabelsName = "MaterialId";

/// Returns whether a name is that of an array that marks ghost and blanked cells or points.
bool IsGhostName(const std::string& name);

/// Returns whether a name is used for ids of cells or points by VTK, ParaView or this project.
bool IsIdName(const std::string& name);

/// Returns whether panels list an array of that name; internal arrays of VTK and ParaView are not.
bool IsOffered(const std::string& name);

/// Returns whether a name is that of a volume fraction in a SpyPlot file.
bool IsSpyPlotFraction(const std::string& name);

/// Returns whether a name says volume fraction: "vf_steel", "VOLFRAC-2", "Volume Fraction".
bool IsFractionName(const std::string& name);

/// Returns whether a name says void, such as "Void volume fraction" or "vf_vacuum".
bool IsVoidName(const std::string& name);

/// Returns whether a name says mass or density, such as "mass fraction" or "rho".
bool IsMassName(const std::string& name);

/// Returns whether a name says state of the material, such as "damage" or "plastic_strain".
bool IsStateName(const std::string& name);

/// Returns whether a name says level set or distance, such as "phi" or "signed_distance".
bool IsDistanceName(const std::string& name);

/// Returns whether a name says processor, refinement level or number of a cell.
bool IsBookkeepingName(const std::string& name);

/// Returns the rank of a conventional name of labels, 0 for the first choice (MaterialId); -1 if
/// the name is not conventional.
int FindLabelsRank(const std::string& name);

} // namespace vfm
