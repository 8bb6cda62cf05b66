/**
 * Checks of the mesh of a periodic case.
 */
#pragma once

#include "FuzzCase.h"

namespace vfm
{
namespace testing
{

/// Returns an empty string or the first problem: flat sides must be plane, and the mesh conforming.
/// @param mesh  mesh on a grid with copies of cells
std::string FindSideProblem(const FuzzCase& c, const Mesh& mesh);

/// Returns an empty string or the first problem of the mesh glued along its sides.
/// @param mesh  mesh of the domain
std::string FindTorusProblem(const FuzzCase& c, const Mesh& mesh, const MeshReport& report);

/// Turns a mesh on a grid with copies into a mesh of the domain. Returns an empty string or the
/// first problem: points and their partners must be exact translates, and a mesh with joined sides
/// must have each point once.
std::string LeaveTorus(const FuzzCase& c, Mesh& mesh);

/// Returns the mesh maker of a case, followed by LeaveTorus.
MeshMaker MakerOfTorus(const FuzzCase& c);

} // namespace testing
} // namespace vfm
