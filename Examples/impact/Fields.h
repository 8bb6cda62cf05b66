/**
 * Fields: results of the simulation at an output step. Sink: interface of classes that use them.
 */
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace impact
{

/// Values of one quantity of one body.
struct StateField
{
  std::string Name; ///< quantity, " - " and the number of the body, from 1
  int Components;
  const double* Values; ///< (cells, Components), 0 in cells without this body
};

/// Fields on the box of cells that a rank owns, without ghosts. Each rank owns at least 2 cells per
/// axis; the boxes of all ranks tile the grid. Arrays are contiguous and run over the cells of the
/// box, x fastest, then y, then z. Pointers and values stay valid until the next output step, so
/// that no copy is needed. Units: mm, microseconds, mg.
struct Fields
{
  std::int64_t Step = 0;
  double Time = 0.;

  std::array<double, 3> Origin{};            ///< lowest corner of the global grid
  std::array<double, 3> Spacing{};           ///< exact in binary, as are coordinates
  std::array<std::int64_t, 3> GlobalCells{}; ///< number of cells per axis of the global grid
  std::array<std::int64_t, 3> Lower{},
    Upper{};                       ///< cells of this rank: [Lower, Upper), global indices
  std::array<int, 6> Neighbours{}; ///< ranks across -x +x -y +y -z +z; -1 where the grid ends

  const double* Ball = nullptr;     ///< volume fraction, 0 to 1
  const double* Plate = nullptr;    ///< volume fraction, 0 to 1; Ball + Plate <= 1 up to rounding
  const double* Velocity = nullptr; ///< (cells, 3); mean weighted by mass, 0 in empty cells
  const double* Density = nullptr;  ///< mass in the cell over its volume
  const double* Damage = nullptr;   ///< mean weighted by mass, 0 (intact) to 1 (failed)

  /// State of each body, sufficient for a restart; empty unless requested. The cells hold the whole
  /// mass, momentum and energy of the body.
  std::vector<StateField> States;

  std::int64_t NumberOfCells() const
  {
    return (Upper[0] - Lower[0]) * (Upper[1] - Lower[1]) * (Upper[2] - Lower[2]);
  }
};

/// User of the fields: a writer, a mesher or a coupling to other software.
class Sink
{
public:
  virtual ~Sink() = default;

  /// Processes the fields of an output step. An exception is thrown on all ranks or on no rank.
  /// @pre Collective
  virtual void Take(const Fields& fields) = 0;
  /// Returns whether a step failed without ending the simulation; the same value on all ranks.
  virtual bool HasFailed() const { return false; }
};

} // namespace impact
