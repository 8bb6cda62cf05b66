#include "Options.h"

#include <cstdlib>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace impact
{
namespace
{

struct Entry
{
  std::string Name, Unit, Text;
  std::function<void(Options&, const std::string&)> Set;
  std::function<std::string(const Options&)> Show;
};

double ParseNumber(const std::string& name, const std::string& text, double least, double most)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !(value >= least && value <= most))
  {
    std::ostringstream message;
    message << name << " takes a number from " << least << " to " << most << ", not '" << text
            << "'";
    throw std::invalid_argument(message.str());
  }
  return value;
}

std::string ToText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

template <class T>
Entry MakeEntry(const std::string& name, const std::string& unit, const std::string& what,
  T Options::*member, double least, double most)
{
  return { name, unit, what,
    [=](Options& options, const std::string& text)
    {
      const double value = ParseNumber(name, text, least, most);
      options.*member = static_cast<T>(value);
      if (static_cast<double>(options.*member) != value)
      {
        throw std::invalid_argument(name + " takes an integer, not '" + text + "'");
      }
    },
    [=](const Options& options) { return ToText(static_cast<double>(options.*member)); } };
}

Entry MakeEntry(const std::string& name, const std::string& unit, const std::string& what,
  std::string Options::*member)
{
  return { name, unit, what,
    [=](Options& options, const std::string& text) { options.*member = text; },
    [](const Options&) { return std::string("none"); } };
}

std::vector<Entry> ListEntries()
{
  return {
    MakeEntry("--cells", "N", "cells along x", &Options::Cells, 16, 1024),
    MakeEntry("--steps", "N", "time steps; 0: until --time", &Options::Steps, 0, 1e9),
    MakeEntry(
      "--every", "N", "steps between outputs; 0: about 24 outputs", &Options::Every, 0, 1e9),
    MakeEntry("--time", "US", "end, microseconds", &Options::EndTime, 0., 1e3),
    MakeEntry("--speed", "V", "speed of the ball, km/s", &Options::Speed, .1, 8.),
    MakeEntry(
      "--angle", "DEG", "angle of the ball's path to the plate's normal", &Options::Angle, 0., 70.),
    MakeEntry("--diameter", "MM", "diameter of the ball", &Options::Diameter, .5, 2.5),
    MakeEntry("--thickness", "MM", "thickness of the plate", &Options::Thickness, .25, 1.5),
    MakeEntry("--dump", "DIR",
      "write impact_SSSS.pvti and impact.pvd into this folder; make it if needed", &Options::Dump),
    MakeEntry("--restart", "DIR",
      "write restart_SSSS.pvti and restart.pvd, with the state of each body", &Options::Restart),
    MakeEntry("--history", "FILE.csv", "write mass, momentum and energy of each body at each step",
      &Options::History),
    MakeEntry("--sculptor", "DIR",
      "mesh with the C interface, write impact_SSSS.pvtu into this folder", &Options::Sculptor),
    MakeEntry("--catalyst", "FILE", "run this ParaView Catalyst script (version 2) at each output",
      &Options::Catalyst),
  };
}

} // namespace

Options ParseOptions(int argc, char** argv)
{
  const std::vector<Entry> entries = ListEntries();
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name == "--help" || name == "-h")
    {
      options.Help = true;
      continue;
    }
    const Entry* found = nullptr;
    for (const Entry& entry : entries)
    {
      found = entry.Name == name ? &entry : found;
    }
    if (!found)
    {
      throw std::invalid_argument("unknown option '" + name + "'; try --help");
    }
    if (++i == argc)
    {
      throw std::invalid_argument(name + " needs a value: " + found->Unit + ", " + found->Text);
    }
    found->Set(options, argv[i]);
  }
  return options;
}

std::string DescribeOptions()
{
  std::ostringstream text;
  text << "usage: [mpiexec -n RANKS] impact [options]\n"
          "A ball of aluminium strikes a plate of steel at an angle and breaks.\n";
  for (const Entry& entry : ListEntries())
  {
    std::string name = "  " + entry.Name + " " + entry.Unit;
    name.resize(20, ' ');
    text << name << entry.Text << " (" << entry.Show(Options()) << ")\n";
  }
  return text.str();
}

} // namespace impact
