#pragma once
#include <atomic>
#include <cstdlib>
namespace vfm
{
inline double Tune(const char* name, double otherwise)
{
  const char* text = std::getenv(name);
  return text ? std::atof(text) : otherwise;
}
inline std::atomic<long> CountD{ 0 }, CountE{ 0 };
inline int Phase = 0;
inline std::atomic<long> PhaseD[8]{};
inline int PhaseSweeps[8]{}, PhaseRounds[8]{};
}
#define TUNE(name, value) [] { static const double v = Tune(#name, value); return v; }()
