/**
 * State carried from cells to elements so that nothing is lost: volume, mass, momentum, energy and whatever else is asked
 * for, of every material, to rounding; within the bounds of the cells; of second order; the same bits on any ranks and threads.
 *
 * A cell and an element agree on the volume of a material only in total, by fragment. So what cells hold is first moved, along
 * the faces of cells of a fragment, until each holds what the mesh has in it (VolumeFluxes.h); then each gives all it has to the
 * elements that overlap it (Overlaps.h), linearly reconstructed (Slopes.h). This is remapping by volume fluxes (Margolin and
 * Shashkov, Journal of Computational Physics 184, 2003), between cells instead of along moving faces, with the limiter of Barth and Jespersen
 * (AIAA 89-0366, 1989). Contents and bounds hold by construction, so nothing is left for a repair (Kucharik, Shashkov and Wendroff, Journal of
 * Computational Physics 188, 2003).
 *
 * Bounds: values of cells of the material at most 3 cells from the element; 5 where spray is given, and more only where cells that hold
 * next to nothing pass on what they get. Values per volume are then multiplied by factors, which are told: 1 but for 1e-7 or so where the
 * mesh has each fragment's volume, 0 in a fragment whose cells hold nothing of its material.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace vfm
{

/// What the values of a quantity are, and so what is conserved.
enum class StateKind
{
  PerVolume, ///< of the material's own volume, as density: value x volume
  PerMass    ///< as velocity and specific energy: value x mass (without a density x volume)
};

struct StateQuantity
{
  StateKind Kind = StateKind::PerMass;
  int Components = 1;
  int Weight =
    -1; ///< PerMass: the quantity, PerMass of one component (heat capacity), that multiplies the mass; -1: none
};

/// The values in the cells of a grid.
class StateCellValues
{
public:
  virtual ~StateCellValues() = default;
  /// The values of all quantities, one after another, of a material (0 void) in a cell of the local box that holds some of it.
  /// Called by several threads.
  virtual void Read(const Index3& cell, int material, double* values) const = 0;
};

struct TransferRequest
{
  const CartesianGrid&
    Grid; ///< of the cells that give, GhostLayers or more around those that this rank meshes
  const FractionField&
    Fractions; ///< in Grid.Local(), ghost cells too: as read, before anything was removed or smoothed
  const StateCellValues& Values; ///< in Grid.Local()
  std::vector<StateQuantity> Quantities;
  int Density =
    -1; ///< the quantity, PerVolume of one component, >= 0, that gives mass; -1: mass is volume
  int Order = 2; ///< 1: cells are constant; 2: linear, limited
  bool GiveUnmeshed =
    true; ///< what lies apart from all elements of its material goes to the nearest fragment within reach
};

/// Totals of a material over all ranks: the volume, the mass, then what each component of each quantity conserves.
using StateTotals = std::vector<double>;

struct TransferredState
{
  std::vector<Buffer<double>> Values; ///< of each quantity: Components an element
  Buffer<double> Mass; ///< of each element; without a density the volume that cells have in it
  std::vector<StateTotals> Input;    ///< of each material from 0: of all cells
  std::vector<StateTotals> Unmeshed; ///< of each material from 0: of cells that gave to no element
  /// Of each material from 0 the smallest and largest factor, cells' volume over mesh's, that values PerVolume had to be multiplied
  /// with because its pieces have other volumes as elements than as cells; 1 and 1 where they agree.
  std::vector<std::array<double, 2>> Factors;
};

/// Collective. mesh: of the owned elements. Materials that are not meshed give nothing and count as unmeshed; void counts only where
/// it is meshed.
TransferredState TransferState(const Mesh& mesh, const TransferRequest& request, Runtime& runtime);

} // namespace vfm
