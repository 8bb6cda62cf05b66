/**
 * Geometry that the mesh resolves: volumes, surfaces, curves and vertices.
 */
#pragma once

#include "Elements/MeshReport.h"
#include "Geometry/GivenSides.h"

namespace vfm
{

/// Classifies the points of the mesh on volumes, surfaces, curves and vertices.
///
/// - Volume: a fragment.
/// - Surface: the facets between two volumes, between a volume and unmeshed space, or on one side
///   of the domain. An interface with edges consists of several surfaces, its sides.
/// - Curve: the facet edges where the same surfaces meet.
/// - Vertex: a point where curves meet or end, or where surfaces touch.
///
/// A curve or surface may consist of several components. Numbers are those of all ranks; a rank
/// stores the rows of the surfaces and curves that it touches. Each point of an owned element
/// belongs to the lowest-dimensional entity on which it lies.
///
/// Fills mesh.Surfaces, Curves, Vertices, Tables, GeometryDimension, the GeometryId of points on
/// facets, and the counts of the report. Facets, edges and points that no owned element touches may
/// have the number 0.
/// @param facets  facets of the mesh
/// @param divided  sides of the facets (DivideInterfaces)
/// @param[in,out] mesh  mesh with final point positions; GeometryId of points inside volumes is set
/// @param[out] report  NumberOfSurfaces, NumberOfCurves and NumberOfVertices are set
/// @throws InputError  on all ranks if 32 bits cannot number the surfaces, curves or vertices
/// @pre Collective.
void ClassifyGeometry(const std::vector<Facet>& facets, const DividedFacets& divided,
  Runtime& runtime, Mesh& mesh, MeshReport& report);

} // namespace vfm
