/**
 * FoamLayer: the layer of prisms that a mesh of a plane is in OpenFOAM, which has cells of three
 * dimensions only.
 *
 * The prisms are as high as the layer from which the plane was made is thick. Points are those of
 * the plane, then in the same order those above it. Faces are those over the edges, then the lower
 * faces of all prisms, then the upper ones.
 */
#pragma once

#include "Meshes/OpenFoam/FoamMesh.h"

namespace vfm
{

/// Returns the coordinates of all points.
/// @pre IsFlat(mesh), with elements
std::vector<double> PointsOfLayer(const MeshData& mesh);

/// Returns the points of a face, counterclockwise seen from outside of its owner, from the lowest
/// one; in a periodic mesh from the one with the lowest partner.
/// @param face  from 0 below foam.NumberOfFaces()
std::vector<Index> PointsOfLayerFace(const FoamMesh& foam, Index face);

} // namespace vfm
