/**
 * FarContents: collects the contents of cells that become particles.
 */
#pragma once

#include "State/Transfer/StateColumns.h"

namespace vfm
{

/// Returns the centre of a cell.
Vector3 CentreOfCell(const CartesianGrid& grid, const Index3& cell);

/// Rows of the owned cells, one per cell and material.
class FarContents
{
public:
  /// @param request  null: there are no particles; must outlive this object
  FarContents(
    const CartesianGrid& grid, const StateColumns& columns, const ParticleRequest* request) :
    Grid(grid), Columns(columns), Request(request)
  {
  }

  /// Adds the far volume of a material in a cell.
  /// @param volume  volume of the material in the cell
  /// @param values  values of all columns
  /// @return the rest of the volume
  double Take(Index cell, int material, double volume, const double* values);
  /// Adds contents that no element receives.
  /// @return false if they do not become a particle
  bool TakeRest(Index cell, int material, double volume, const double* values);

  UnmeshedRows Rows;

private:
  void Add(Index cell, int material, double volume, const double* values);

  const CartesianGrid& Grid;
  const StateColumns& Columns;
  const ParticleRequest* Request;
};

} // namespace vfm
