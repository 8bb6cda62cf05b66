/**
 * Options: what the command line sets.
 */
#pragma once

#include <cstdint>
#include <string>

namespace impact
{

struct Options
{
  std::int64_t Cells = 80; ///< along x; 16 to 1024
  std::int64_t Steps = 0;  ///< 0: until EndTime
  std::int64_t Every = 0;  ///< steps from one output to the next; 0: a 24th of the run
  double EndTime = 2.6;    ///< microseconds
  double Speed = 3.;       ///< of the ball, km/s
  double Angle = 58.;      ///< between the ball's path and the plate's normal, degrees
  double Diameter = 2.;    ///< of the ball, mm
  double Thickness = .75;  ///< of the plate, mm
  std::string Dump;        ///< folder of the files; empty: none
  std::string Restart;  ///< folder of the files that hold the state of each body, too; empty: none
  std::string History;  ///< file of totals step by step; empty: none
  std::string Sculptor; ///< folder of the meshes by the C interface; empty: none
  std::string Catalyst; ///< script of ParaView Catalyst; empty: none
  bool Help = false;
};

/// Throws std::invalid_argument: an unknown option, a missing or wrong value.
Options ParseOptions(int argc, char** argv);

/// What --help prints.
std::string DescribeOptions();

} // namespace impact
