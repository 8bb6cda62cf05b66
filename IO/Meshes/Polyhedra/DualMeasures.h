/**
 * DualMeasures: volumes and centres of polyhedra as finite volumes measure them.
 *
 * A face consists of triangles around the mean of its points, a cell of pyramids on its faces.
 */
#pragma once

#include "Base/Vector3.h"
#include "Meshes/Polyhedra/DualMesh.h"

namespace vfm
{

struct FaceMeasure
{
  Vector3 Area{}; ///< its normal, out of the owner, whose length is the area
  Vector3 Centre{};
};

FaceMeasure MeasureFace(const DualMesh& dual, Index face);

struct CellMeasures
{
  std::vector<FaceMeasure> Faces;
  std::vector<double> Volumes;
  std::vector<Vector3> Centres;
};

CellMeasures MeasureCells(const DualMesh& dual);

/// A face of a cell.
struct CellFace
{
  Index Face;
  double Sign; ///< 1 if the cell is its owner, else -1
};

/// Returns the faces of each cell, ascending.
std::vector<std::vector<CellFace>> FacesOfCells(const DualMesh& dual);

/// Sets the volume and the centre of a cell from its faces.
void MeasureCell(const std::vector<CellFace>& faces, Index cell, CellMeasures& cells);

/// What finite volumes ask of a face.
struct FaceQuality
{
  double Depth;    ///< of the centres of its cells below it, in widths of the cell: the lesser
  double Cosine;   ///< of the angle between its normal and the line between the centres
  double Skewness; ///< distance of its centre from this line, as OpenFOAM scales it
};

FaceQuality QualityOf(const DualMesh& dual, const CellMeasures& cells, Index face);

/// Returns whether finite volumes may reject a face: the centre of a cell is behind it, the line
/// between the centres of its cells is nearly along it, or meets its plane far from it.
bool IsPoor(const DualMesh& dual, const CellMeasures& cells, Index face);
/// Returns whether checkMesh of OpenFOAM rejects a face, with a small margin.
bool IsRejected(const DualMesh& dual, const CellMeasures& cells, Index face);

Vector3 PointOfDual(const DualMesh& dual, Index point);

/// Calls visit(face, cell, sign) for the cells of each face: 1 for the owner, -1 for the neighbour.
template <class Visit>
void ForFaces(const DualMesh& dual, const Visit& visit)
{
  for (Index face = 0; face < dual.NumberOfFaces(); ++face)
  {
    visit(face, dual.Owners[face], 1.0);
    if (face < dual.NumberOfInnerFaces())
    {
      visit(face, dual.Neighbours[face], -1.0);
    }
  }
}

} // namespace vfm
