/**
 * GeometryParts: the surfaces, curves and vertices of a rank's mesh in the numbers of its points, and what bounds what.
 */
#pragma once

#include "Base/CartesianGrid.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkIntArray;
class vtkPolyData;
class vtkUnstructuredGrid;
class vtkVolumeFractionMeshAlgorithm;

namespace vfm
{

class GeometryParts
{
public:
  /// Facets, edges or vertices; each is on one rank alone.
  struct Cells
  {
    Index Count;
    int Corners;         ///< of each; 0 without cells
    const Index* Points; ///< Corners a cell: of the mesh
    const int* Ids;      ///< of the surface, curve or vertex of each, from 1
  };

  /// Of the mesh that the mesher made last; its outputs may go afterwards.
  explicit GeometryParts(vtkVolumeFractionMeshAlgorithm& mesher);

  /// dimension: 2, 1 or 0. Numbers the points when first asked for. mesh: of the same mesher. Good as long as this.
  Cells Get(int dimension, vtkUnstructuredGrid* mesh);
  /// A table by its name, as in the field data of the filter's ports. Throws InputError when there is none such.
  vtkIntArray* GetTable(const std::string& name) const;

private:
  struct Part
  {
    vtkSmartPointer<vtkPolyData> Data;
    std::vector<Index> Points;
  };
  std::array<Part, 3> Parts; // by dimension
};

} // namespace vfm
