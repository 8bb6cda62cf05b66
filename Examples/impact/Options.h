/**
 * Options: settings of the command line.
 */
#pragma once

#include <cstdint>
#include <string>

namespace impact
{

struct Options
{
  std::int64_t Cells = 80; ///< number of cells along x, 16 to 1024
  std::int64_t Steps = 0;  ///< number of time steps; 0: until EndTime
  std::int64_t Every = 0;  ///< number of steps between outputs; 0: 1/24 of the run
  double EndTime = 2.6;    ///< microseconds
  double Speed = 3.;       ///< speed of the ball, km/s
  double Angle = 58.;      ///< angle of the ball's path to the plate's normal, degrees
  double Diameter = 2.;    ///< diameter of the ball, mm
  double Thickness = .75;  ///< thickness of the plate, mm
  // Output is written only if its file or folder is not empty.
  std::string Dump;     ///< folder of the fields
  std::string Restart;  ///< folder of the fields with the state of each body
  std::string History;  ///< file of totals at each step
  std::string Sculptor; ///< folder of the meshes made by the C interface
  std::string Catalyst; ///< script of ParaView Catalyst
  bool Help = false;
};

/// Reads the command line.
/// @throws std::invalid_argument  if an option is unknown, or its value is missing or wrong
Options ParseOptions(int argc, char** argv);

/// Returns the text that --help prints.
std::string DescribeOptions();

} // namespace impact
