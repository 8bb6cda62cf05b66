/**
 * MeshData: one rank's mesh with its named arrays, in the form that reports and files are made from.
 *
 * All pointers are views: whoever made the MeshData owns the memory and keeps it.
 */
#pragma once

#include "Base/CartesianGrid.h"
#include "Input/FieldArray.h"
#include "Input/ValueType.h"

#include <optional>
#include <string>
#include <vector>

namespace vfm
{

/// Values of points or elements, shape (tuples, Components), row-major.
struct MeshArray
{
  std::string Name;
  int Type = ValueType::Double; ///< type of the numbers in memory, one of ValueType
  int Components = 1;
  std::vector<std::string> ComponentNames; ///< empty, or one per component
  const void* Values = nullptr;
};

/// A face of an element on an interface of materials or on a side of the domain.
struct MeshFacet
{
  Index Element;  ///< of this rank, from 0
  int Side;       ///< of the element, as vtkHexahedron and vtkTetra number their faces, from 0
  int Behind;     ///< material on the other side; 0 void; NothingBehind at the end of the mesh
  int Surface;    ///< smooth side of the interface, from 1 over all ranks; 0 where it has only one
  int DomainSide; ///< -1, or 0..5 for -x +x -y +y -z +z
};

struct MeshData
{
  int Corners = 8; ///< of an element: 8 hexahedra, 4 tetrahedra
  Index NumberOfPoints = 0, NumberOfElements = 0;
  const double* Points = nullptr;  ///< (points, 3)
  const Index* Elements = nullptr; ///< (elements, Corners), points of this rank from 0, VTK's order
  const Index* PointIds = nullptr; ///< global, from 1, ascending
  const Index* ElementIds = nullptr;                 ///< global, from 1, ascending
  const int* Material = nullptr;                     ///< material id of each element; 0 void
  std::vector<MeshArray> PointArrays, ElementArrays; ///< all that files contain, those above too
  std::vector<FieldArray> Fields;                    ///< of the whole mesh, the same on all ranks
  std::optional<double> Time;
};

} // namespace vfm
