/**
 * TransferState: conservative transfer of state from cells to elements. For every material, volume,
 * mass, momentum, energy and all requested quantities are conserved up to rounding. Values stay
 * within the bounds of the cells. The transfer is of second order, and bitwise identical on any
 * number of ranks and threads.
 *
 * Method. The volumes of a material in cells and elements agree only in total, per fragment. So
 * contents first move across the faces of cells, within each fragment, until each cell contains the
 * volume that the mesh has in it (VolumeFluxes.h). Then each cell gives its contents, linearly
 * reconstructed (Slopes.h), to the elements that overlap it (Overlaps.h). This is remapping by
 * volume fluxes (L. G. Margolin and M. Shashkov, Journal of Computational Physics 184, 2003),
 * between cells instead of along moving faces. The limiter is by T. J. Barth and D. C. Jespersen
 * (AIAA 89-0366, 1989). Conservation and bounds hold by construction, so no repair is required
 * (M. Kucharik, M. Shashkov and B. Wendroff, Journal of Computational Physics 188, 2003).
 *
 * Bounds. A value stays within the range of the cells of the material at most 3 cells from the
 * element, or 5 if unresolved material is given to it. The distance is larger only where cells with
 * almost no content pass on what they receive. Values per volume are also multiplied by factors,
 * which are returned. They are within about 1e-7 of 1 if the mesh conserves the volume of each
 * fragment, and 0 in a fragment whose cells contain none of its material.
 */
#pragma once

#include "Base/Runtime.h"
#include "Fractions/FractionField.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace vfm
{

/// Kind of a quantity, which determines the conserved content.
enum class StateKind
{
  PerVolume, ///< value per volume of the material, such as density; conserves value x volume
  /// Value per mass, such as velocity or specific energy; conserves value x mass, or value x volume
  /// without a density.
  PerMass
};

struct StateQuantity
{
  StateKind Kind = StateKind::PerMass;
  int Components = 1;
  /// PerMass only: number of a quantity that multiplies the mass, such as heat capacity, or -1. It
  /// is PerMass and has one component.
  int Weight = -1;
};

/// Interface that returns the values in the cells of a grid.
class StateCellValues
{
public:
  virtual ~StateCellValues() = default;
  /// Reads the values of all quantities, one after another, for a material in a cell of the local
  /// box that contains it; 0 is void. Called by several threads at once.
  virtual void Read(const Index3& cell, int material, double* values) const = 0;
};

struct TransferRequest
{
  /// Grid of the cells that give, with at least GhostLayers layers of ghost cells.
  const CartesianGrid& Grid;
  /// Fractions in Grid.Local(), ghost cells too, as read: before removal
  /// of small fragments and smoothing.
  const FractionField& Fractions;
  const StateCellValues& Values; ///< values in Grid.Local()
  std::vector<StateQuantity> Quantities;
  /// Number of the density, a quantity PerVolume with one component, >= 0; -1: mass is volume.
  int Density = -1;
  int Order = 2; ///< 1: constant in each cell; 2: linear with limiter
  /// Whether cells at most 3 cells from elements of their material give it to the nearest fragment;
  /// if false, only cells next to such elements do.
  bool GiveUnmeshed = true;
};

/// Totals of a material over all ranks: volume, mass, then the content of
/// each component of each quantity.
using StateTotals = std::vector<double>;

struct TransferredState
{
  std::vector<Buffer<double>> Values; ///< values of each quantity, (elements, Components)
  Buffer<double> Mass;                ///< mass of each element; without density, volume in cells
  std::vector<StateTotals> Input;     ///< totals of all cells, per material from 0
  std::vector<StateTotals> Unmeshed;  ///< totals not given to elements, per material from 0
  /// Smallest and largest factor of values PerVolume of each material, from 0: volume in cells over
  /// volume of elements of connected donors. Both are 1 if these volumes agree.
  std::vector<std::array<double, 2>> Factors;
};

/// Transfers the state of cells to elements. Materials without elements count as unmeshed. Void
/// counts only if it is meshed.
/// @param mesh  elements owned by this rank, points in their final position
/// @return values of the elements and totals over all ranks
/// @pre Collective.
TransferredState TransferState(const Mesh& mesh, const TransferRequest& request, Runtime& runtime);

} // namespace vfm
