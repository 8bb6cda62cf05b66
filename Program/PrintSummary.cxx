#include "PrintSummary.h"

#include "Base/ParseText.h"
#include "Ranks/PrintableText.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace vfm
{
namespace
{

constexpr std::size_t ListedMaterials = 50;
constexpr std::size_t LeastWidth = 28; // minimum width of names

template <class... Values>
std::string Print(const char* format, Values... values)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

std::string PrintQuality(const MeshSummary& summary, const PartSizes& part)
{
  return summary.HasQuality && part.Elements > 0
    ? Print("%8.4f%9.4f", part.MinimumQuality, part.MeanQuality)
    : Print("%8s%9s", "-", "-");
}

/// Returns the length of the longest name; names are printed in full.
std::size_t FindWidth(const std::vector<std::string>& names)
{
  std::size_t width = LeastWidth;
  for (const std::string& name : names)
  {
    width = std::max(width, name.size());
  }
  return width;
}

std::string Padded(std::string name, std::size_t width)
{
  name.resize(std::max(width, name.size()), ' ');
  return name;
}

/// Returns the line of a part.
/// @param name  padded name
std::string PrintPart(const MeshSummary& summary, const std::string& name, const PartSizes& part)
{
  return name +
    Print(
      "%12lld%12lld", static_cast<long long>(part.Elements), static_cast<long long>(part.Points)) +
    PrintQuality(summary, part) + Print("%14.6g", part.Volume);
}

std::string PrintError(const PartSummary& part)
{
  const double error = 100.0 * (part.Volume - part.TargetVolume) / part.TargetVolume;
  return part.TargetVolume > 0.0 ? Print("%14.6g%+11.5f %%", part.TargetVolume, error)
                                 : Print("%14.6g%13s", part.TargetVolume, "-");
}

std::string PrintHead(const std::string& what)
{
  return what + Print("%12s%12s%8s%9s%14s", "elements", "points", "min SJ", "mean SJ", "volume");
}

void PrintMaterials(const MeshSummary& summary, std::ostream& to)
{
  const std::size_t listed = std::min(summary.Materials.size(), ListedMaterials);
  std::vector<std::string> names;
  for (std::size_t m = 0; m < listed; ++m)
  {
    const PartSummary& part = summary.Materials[m];
    names.push_back(std::to_string(part.Material) + " " + MakePrintable(part.Name));
  }
  const std::size_t width = FindWidth(names);
  to << PrintHead(Padded("material", width)) << Print("%14s%13s", "target", "error") << "\n";
  for (std::size_t m = 0; m < listed; ++m)
  {
    const PartSummary& part = summary.Materials[m];
    to << PrintPart(summary, Padded(names[m], width), part) << PrintError(part) << "\n";
  }
  if (listed < summary.Materials.size())
  {
    to << "and " << summary.Materials.size() - listed << " more materials\n";
  }
  to << PrintPart(summary, Padded("all", width), summary.Total) << PrintError(summary.Total)
     << "\n";
}

void PrintSurfaces(const MeshSummary& summary, std::ostream& to)
{
  const std::size_t listed = std::min(summary.Surfaces.size(), ListedMaterials);
  std::vector<std::string> names;
  for (std::size_t s = 0; s < listed; ++s)
  {
    const SurfaceSummary& surface = summary.Surfaces[s];
    names.push_back(std::to_string(surface.Material) + " " + MakePrintable(surface.Name));
  }
  const std::size_t width = FindWidth(names);
  to << Padded("surface", width)
     << Print("%14s%16s%12s%8s%11s", "cells across", "suggested width", "lost area", "solids",
          "fragments")
     << "\n";
  for (std::size_t s = 0; s < listed; ++s)
  {
    const SurfaceSummary& surface = summary.Surfaces[s];
    to << Padded(names[s], width)
       << Print("%14.3g%16.3g%10.3g %%%8lld%11lld", surface.Thickness, surface.SuggestedWidth,
            100.0 * surface.Lost, static_cast<long long>(surface.Solids),
            static_cast<long long>(surface.Fragments))
       << "\n";
  }
  to << "\n";
}

void PrintState(const MeshSummary& summary, std::ostream& to)
{
  to << Padded("state", LeastWidth)
     << Print("%16s%16s%14s", "of the cells", "of the mesh", "not meshed")
     << (summary.Particles ? Print("%14s", "in particles") : "") << "\n";
  for (const StateTotal& total : summary.State)
  {
    to << Padded(MakePrintable(total.Name), LeastWidth)
       << Print("%16.9g%16.9g%14.6g", total.Input, total.Mesh, total.Unmeshed)
       << (summary.Particles ? Print("%14.6g", total.Particles) : "") << "\n";
  }
  if (summary.LostToElements != 0.0 || summary.LostToNodes != 0.0)
  {
    to << Print("kinetic energy lost by averaging: %.6g in elements, %.6g more at nodes\n",
      summary.LostToElements, summary.LostToNodes);
  }
  to << "\n";
}

/// @param paths  files with the particles beside other files
void PrintParticles(
  const ParticleSummary& particles, const std::vector<std::string>& paths, std::ostream& to)
{
  to << Print(
    "particles: %lld, volume %.6g", static_cast<long long>(particles.Count), particles.Volume);
  if (particles.Mass)
  {
    to << Print(", mass %.6g", *particles.Mass);
  }
  if (particles.LostEnergy != 0.0)
  {
    to << Print(", kinetic energy lost by joining %.6g", particles.LostEnergy);
  }
  to << (paths.empty() ? "" : ", in " + JoinTexts(paths)) << "\n\n";
}

/// Prints the largest fragments by volume.
void PrintFragments(const MeshSummary& summary, std::ostream& to)
{
  to << PrintHead(Padded("fragment", LeastWidth)) << "\n";
  for (const FragmentSizes& part : summary.LargestFragments)
  {
    const std::string name =
      std::to_string(part.Id) + " of material " + std::to_string(part.Material);
    to << PrintPart(summary, Padded(name, LeastWidth), part) << "\n";
  }
  const Index listed = static_cast<Index>(summary.LargestFragments.size());
  if (listed < summary.NumberOfFragments)
  {
    to << "and " << summary.NumberOfFragments - listed << " smaller fragments\n";
  }
}

void PrintAngles(const MeshSummary& summary, std::ostream& to)
{
  to << Print(
    "dihedral angles: %.2f to %.2f degrees\n", summary.MinimumAngle, summary.MaximumAngle);
  for (std::size_t i = 0; i < summary.Angles.size(); ++i)
  {
    if (summary.Angles[i] > 0)
    {
      to << Print("%7d to %3d%12lld\n", static_cast<int>(10 * i), static_cast<int>(10 * i + 10),
        static_cast<long long>(summary.Angles[i]));
    }
  }
}

} // namespace

void PrintSummary(const MeshSummary& summary, const std::vector<std::string>& particles,
  const std::vector<StageTime>& times, std::ostream& to)
{
  PrintMaterials(summary, to);
  to << "\n";
  if (!summary.Surfaces.empty())
  {
    PrintSurfaces(summary, to);
  }
  if (!summary.State.empty())
  {
    PrintState(summary, to);
  }
  if (summary.Particles)
  {
    PrintParticles(*summary.Particles, particles, to);
  }
  PrintFragments(summary, to);
  to << "\n";
  if (summary.IsTets && summary.HasQuality)
  {
    PrintAngles(summary, to);
    to << "\n";
  }
  if (times.empty())
  {
    return;
  }
  to << "seconds:";
  for (const StageTime& time : times)
  {
    to << " " << time.Name << Print(" %.2f", time.Seconds);
  }
  to << "\n";
}

void PrintBins(const std::vector<MaterialBin>& bins, std::ostream& to)
{
  const std::size_t listed = std::min(bins.size(), ListedMaterials);
  std::vector<std::string> names;
  for (std::size_t b = 0; b < listed; ++b)
  {
    names.push_back(std::to_string(bins[b].Id) + " " + MakePrintable(bins[b].Name));
  }
  const std::size_t width = FindWidth(names);
  for (std::size_t b = 0; b < listed; ++b)
  {
    const MaterialBin& bin = bins[b];
    if (b == 0)
    {
      to << "\n"
         << Padded("bin", width) << Print("%12s%14s%14s", "elements", "volume", "mean value")
         << (bin.Elastic ? Print("%14s%14s", "density", "modulus") : "") << "\n";
    }
    to << Padded(names[b], width)
       << Print("%12lld%14.6g%14.6g", static_cast<long long>(bin.Elements), bin.Volume, bin.Mean)
       << (bin.Elastic ? Print("%14.6g%14.6g", bin.Elastic->Density, bin.Elastic->Modulus) : "")
       << "\n";
  }
  if (listed < bins.size())
  {
    to << "and " << bins.size() - listed << " more bins\n";
  }
}

} // namespace vfm
