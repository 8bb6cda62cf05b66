/**
 * Fields: what the simulation hands out at an output step, and Sink, who takes it.
 */
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace impact
{

/// Components numbers a cell, 0 in cells that hold nothing of the body.
struct StateField
{
  std::string Name; ///< of the quantity, " - " and the number of the body, from 1
  int Components;
  const double* Values;
};

/// The fields of the box of cells that a rank owns; no ghosts. Arrays run over its cells, x
/// fastest, then y, then z; they are contiguous and stay where they are, with these values, until
/// the next output step: no need to copy. Every rank owns at least 2 cells an axis; the boxes of
/// all ranks tile the grid. Units: mm, microseconds, mg.
struct Fields
{
  std::int64_t Step = 0;
  double Time = 0.;

  std::array<double, 3> Origin{};            ///< of the global grid: its lowest corner
  std::array<double, 3> Spacing{};           ///< exact in binary, so that coordinates are too
  std::array<std::int64_t, 3> GlobalCells{}; ///< cells of the global grid, an axis
  std::array<std::int64_t, 3> Lower{},
    Upper{};                       ///< cells of this rank: [Lower, Upper), global indices
  std::array<int, 6> Neighbours{}; ///< ranks across -x +x -y +y -z +z; -1 where the grid ends

  const double* Ball = nullptr;     ///< volume fraction, 0 to 1
  const double* Plate = nullptr;    ///< volume fraction, 0 to 1; Ball + Plate <= 1 up to rounding
  const double* Velocity = nullptr; ///< 3 a cell: x, y, z; mean by mass, 0 in empty cells
  const double* Density = nullptr;  ///< mass in the cell over its volume
  const double* Damage = nullptr;   ///< mean by mass, 0 intact to 1 failed

  /// Where it was asked for: what each body needs to go on, of which the grid holds all mass,
  /// momentum and energy.
  std::vector<StateField> States;

  std::int64_t NumberOfCells() const
  {
    return (Upper[0] - Lower[0]) * (Upper[1] - Lower[1]) * (Upper[2] - Lower[2]);
  }
};

class Sink
{
public:
  virtual ~Sink() = default;

  /// Collective: called on all ranks at each output step. Throws on all ranks or on none.
  virtual void Take(const Fields& fields) = 0;
  /// Whether some step failed that was not worth ending the simulation; the same on all ranks.
  virtual bool HasFailed() const { return false; }
};

} // namespace impact
