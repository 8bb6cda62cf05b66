#include "MakeSinks.h"

#include "DumpSink.h"
#ifdef IMPACT_HAS_SCULPTOR
#include "SculptorSink.h"
#endif
#ifdef IMPACT_HAS_CATALYST
#include "CatalystSink.h"
#endif

#include <stdexcept>

namespace impact
{
namespace
{

std::unique_ptr<Sink> MakeSculptorSink(const std::string& folder)
{
#ifdef IMPACT_HAS_SCULPTOR
  return std::make_unique<SculptorSink>(MPI_COMM_WORLD, folder);
#else
  throw std::invalid_argument(
    "--sculptor " + folder + ": this program was built without libsculptor");
#endif
}

std::unique_ptr<Sink> MakeCatalystSink(const std::string& script)
{
#ifdef IMPACT_HAS_CATALYST
  return std::make_unique<CatalystSink>(MPI_COMM_WORLD, std::vector<std::string>{ script });
#else
  throw std::invalid_argument(
    "--catalyst " + script + ": this program was built without ParaView Catalyst");
#endif
}

} // namespace

std::vector<std::unique_ptr<Sink>> MakeSinks(const Options& options, const Domain& domain)
{
  std::vector<std::unique_ptr<Sink>> sinks;
  if (!options.Dump.empty())
  {
    sinks.push_back(std::make_unique<DumpSink>(domain, options.Dump, "impact", false));
  }
  if (!options.Restart.empty())
  {
    sinks.push_back(std::make_unique<DumpSink>(domain, options.Restart, "restart", true));
  }
  if (!options.Sculptor.empty())
  {
    sinks.push_back(MakeSculptorSink(options.Sculptor));
  }
  if (!options.Catalyst.empty())
  {
    sinks.push_back(MakeCatalystSink(options.Catalyst));
  }
  return sinks;
}

} // namespace impact
