/**
 * TransferState: conservative transfer of state from cells to elements. For every material, volume,
 * mass, momentum, energy and all requested quantities are conserved up to rounding. Values stay
 * within the range of nearby cells. The transfer is of second order, and bitwise identical on any
 * number of ranks and threads.
 *
 * Method. The *content* of a cell in a quantity is its value times the volume or mass of the
 * material, such as a mass or a momentum. A fragment has the same volume in its cells and in its
 * elements only in total. So contents first move across the faces of cells, within each fragment,
 * until the volume in each cell equals the volume of the elements in it (VolumeFluxes.h). Then the
 * contents of each cell, linearly reconstructed (Slopes.h), are distributed to the elements that
 * overlap it (Overlaps.h). This is remapping by volume fluxes (L. G. Margolin and M. Shashkov,
 * Journal of Computational Physics 184, 2003), between cells instead of along moving faces. The
 * limiter is by T. J. Barth and D. C. Jespersen (AIAA 89-0366, 1989). Conservation and bounds hold
 * by construction, so no repair is required (M. Kucharik, M. Shashkov and B. Wendroff, Journal of
 * Computational Physics 188, 2003).
 *
 * Bounds. A value stays within the range of the cells of the material at most 3 cells from the
 * element, or 5 if unresolved material is given to it. The distance is larger only where a cell
 * with almost no content passes on what it receives from other cells. Values per volume are also
 * multiplied by factors (TransferredState::Factors). A factor is within about 1e-7 of 1 if the mesh
 * conserves the volume of each fragment. It is 0 in a fragment whose cells lack its material.
 */
#pragma once

#include "Base/Runtime.h"
#include "Elements/Mesh.h"
#include "Fractions/FractionField.h"

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
  /// PerMass only: index of the quantity that multiplies the mass, such as heat capacity, or -1.
  /// That quantity is PerMass and has one component.
  int Weight = -1;
};

/// Interface that returns the values in the cells of a grid.
class StateCellValues
{
public:
  virtual ~StateCellValues() = default;
  /// Reads the values of all quantities, one after another, for a material in a cell. Called by
  /// several threads at once.
  /// @param cell  cell of the local box that contains the material
  /// @param material  0 is void
  /// @param[out] values  all components of all quantities
  virtual void Read(const Index3& cell, int material, double* values) const = 0;
};

/// A volume of a material in an owned cell that no element receives.
struct FarVolume
{
  Index Cell; ///< linear index
  int Material;
  double Volume; ///< up to the volume of the material in the cell; cubed length units
};

/// Contents that become particles: those of Far, and those of a cell without an element of their
/// material at most one cell away.
struct ParticleRequest
{
  std::vector<FarVolume> Far; ///< ascending by cell and material, distinct
  bool Clusters = false;      ///< particles of neighbour cells are joined
  double Least = 0.0;         ///< in cells; smaller particles join one in a neighbour cell
};

struct TransferRequest
{
  /// Grid of the cells, with at least GhostLayers layers of ghost cells.
  const CartesianGrid& Grid;
  /// Fractions in Grid.Local(), also in ghost cells. They are the fractions as read, before small
  /// fragments are removed and labels are smoothed.
  const FractionField& Fractions;
  const StateCellValues& Values; ///< values in Grid.Local()
  std::vector<StateQuantity> Quantities;
  /// Index of the density in Quantities: PerVolume, one component, values >= 0. -1: there is no
  /// density, and the volume of material replaces its mass.
  int Density = -1;
  int Order = 2; ///< 1: constant in each cell; 2: linear with limiter
  /// Contents of a cell without an element of their material always go to the nearest fragment of
  /// the material at most one cell away. If this is true, the distance may be up to 3 cells.
  bool GiveUnmeshed = true;
  /// Not null: contents without an element become particles, except void; GiveUnmeshed then holds
  /// for void only.
  const ParticleRequest* Particles = nullptr;
};

/// Contents of a material in an owned cell, or joined from cells around it.
struct UnmeshedRow
{
  Index Cell; ///< linear index
  int Material;
  double Volume;
  Vector3 Position; ///< centroid of the cells, weighted by volume; length units of the grid
};

/// Contents that no element receives, with the values of all columns (StateColumns).
struct UnmeshedRows
{
  std::vector<UnmeshedRow> Rows;
  std::vector<double> Values; ///< shape (rows, columns)

  void Add(const UnmeshedRow& row, const double* values, int columns)
  {
    this->Rows.push_back(row);
    this->Values.insert(this->Values.end(), values, values + columns);
  }
};

/// Totals of a material over all ranks: volume, mass, then the content of each component of all
/// quantities in turn.
using StateTotals = std::vector<double>;

struct TransferredState
{
  std::vector<Buffer<double>> Values; ///< values of each quantity, (elements, Components)
  Buffer<double> Mass;            ///< mass of each element; without a density, the volume received
  std::vector<StateTotals> Input; ///< totals of all cells, per material from 0
  /// Totals that neither elements nor particles receive, per material from 0.
  std::vector<StateTotals> Unmeshed;
  UnmeshedRows Particles; ///< of this rank, ascending by cell and material
  /// Smallest and largest factor of values PerVolume of each material, from 0. A factor is the
  /// volume in connected cells of a fragment over the volume of the elements there.
  std::vector<std::array<double, 2>> Factors;
};

/// Transfers the state of cells to elements. All contents of a material without elements count as
/// unmeshed, or are particles. Void counts only if it is meshed.
/// @param mesh  elements owned by this rank, points in their final position
/// @return values of the elements and totals over all ranks
/// @pre Collective.
TransferredState TransferState(const Mesh& mesh, const TransferRequest& request, Runtime& runtime);

} // namespace vfm
