#include "SurfaceInput.h"

#include "Base/ParseText.h"
#include "Base/ThreadRuntime.h"
#include "Input/PlainArrays.h"
#include "Options/CellWidths.h"
#include "PackedValues.h"
#include "Ranks/PrintableText.h"
#include "Ranks/WorkTogether.h"
#include "ReaderSteps.h"
#include "Shapes/PlaceGrid.h"
#include "Surfaces/ReadInputSurfaces.h"
#include "Surfaces/SurfaceFractions.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <ostream>

namespace vfm
{
namespace
{

constexpr int DefaultCells = 64;              // along the longest side
constexpr Index CellsOfPart = Index(1) << 25; // whose fractions are computed at once

/// Surfaces with the grid around them.
struct PlacedSurfaces
{
  std::shared_ptr<const InputSurfaces> Surfaces;
  GridPlace Place;
  std::string Warning;
};

GridPlace PlaceAround(const InputSurfaces& surfaces, const Arguments& arguments)
{
  const PlaceBounds bounds = FindBounds(surfaces);
  return arguments.GridWidths ? PlaceCellsOfWidth(bounds, *arguments.GridWidths)
                              : PlaceCells(bounds, arguments.Cells.value_or(DefaultCells));
}

PlacedSurfaces ReadAndPlace(const Arguments& arguments)
{
  ChooseTime(arguments, {});
  for (const std::string& path : arguments.SurfaceFiles)
  {
    CheckInputFile(path);
  }
  PlacedSurfaces placed;
  placed.Surfaces = std::make_shared<const InputSurfaces>(ReadInputSurfaces(arguments.SurfaceFiles,
    [&placed](const std::string& note)
    { placed.Warning += (placed.Warning.empty() ? "" : " ") + note; }));
  placed.Place = PlaceAround(*placed.Surfaces, arguments);
  return placed;
}

/// Computes the fractions of a slab, some layers of cells at a time.
std::shared_ptr<const BlockArrays> MakeArrays(const std::array<std::vector<double>, 3>& nodes,
  const IndexBox& slab, const InputSurfaces& surfaces, Runtime& runtime)
{
  std::vector<std::shared_ptr<PackedValues>> packed;
  for (std::size_t b = 0; b < surfaces.Bodies.size(); ++b)
  {
    packed.push_back(std::make_shared<PackedValues>());
  }
  const Index layers = std::max<Index>(CellsOfPart / (slab.Size(0) * slab.Size(1)), 1);
  IndexBox part = slab;
  for (; part.Lower[2] < slab.Upper[2]; part.Lower[2] = part.Upper[2])
  {
    part.Upper[2] = std::min(part.Lower[2] + layers, slab.Upper[2]);
    const std::vector<Buffer<double>> fractions =
      FractionsOfSurfaces(nodes, part, surfaces, runtime);
    for (std::size_t b = 0; b < fractions.size(); ++b)
    {
      packed[b]->Append(fractions[b].data(), static_cast<Index>(fractions[b].size()));
    }
  }
  auto arrays = std::make_shared<PlainArrays>(slab.NumberOfCells());
  for (std::size_t b = 0; b < packed.size(); ++b)
  {
    packed[b]->Finish();
    arrays->Add(surfaces.Bodies[b].Name, packed[b]);
  }
  return arrays;
}

InputBlock MakeBlock(const PlacedSurfaces& placed, const IndexBox& slab, int threads, Ranks& ranks)
{
  const std::array<std::vector<double>, 3> nodes = ListNodes(placed.Place);
  InputBlock block;
  block.Box = slab;
  for (int a = 0; a < 3; ++a)
  {
    block.Coordinates[a].assign(
      nodes[a].begin() + slab.Lower[a], nodes[a].begin() + slab.Upper[a] + 1);
  }
  FinishBlock(block, -1, ranks);
  ThreadRuntime runtime(ChooseThreads(threads, ranks.Count()));
  block.Arrays = MakeArrays(nodes, slab, *placed.Surfaces, runtime);
  return block;
}

template <class... Values>
std::string Print(const char* format, Values... values)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, values...);
  return text;
}

/// Returns the names of the patches that have one.
std::string NamePatches(const BodySurface& body)
{
  std::vector<std::string> names;
  std::copy_if(body.PatchNames.begin(), body.PatchNames.end(), std::back_inserter(names),
    [](const std::string& name) { return !name.empty(); });
  return JoinTexts(names);
}

void PrintBodies(const InputSurfaces& surfaces, std::ostream& to)
{
  std::size_t width = 28;
  for (const BodySurface& body : surfaces.Bodies)
  {
    width = std::max(width, MakePrintable(body.Name).size() + 2);
  }
  const int w = static_cast<int>(width);
  to << "\n" << Print("%-*s%11s%9s%14s\n", w, "surface", "triangles", "patches", "volume");
  for (const BodySurface& body : surfaces.Bodies)
  {
    std::string name = MakePrintable(body.Name);
    name.resize(width, ' ');
    to << name
       << Print("%11zu%9zu%14.6g", body.Boundary.Triangles.size(), body.PatchNames.size(),
            MeasureVolume(body.Boundary));
    const std::string patches = NamePatches(body);
    to << (patches.empty() ? "" : "  " + MakePrintable(patches)) << "\n";
  }
}

} // namespace

Input ReadSurfaces(const Arguments& arguments, Ranks& ranks)
{
  PlacedSurfaces placed;
  CollectedBlocks blocks;
  WorkInStage(ranks, ErrorCode::UnreadableInput,
    [&]
    {
      placed = ReadAndPlace(arguments);
      const IndexBox slab = FindSlab(placed.Place.Cells, ranks);
      if (slab.NumberOfCells() > 0)
      {
        blocks.Blocks.push_back(MakeBlock(placed, slab, arguments.Mesher.NumberOfThreads, ranks));
      }
    });
  Input input = MakeInput(std::move(blocks), true);
  input.Warning = placed.Warning;
  for (const BodySurface& body : placed.Surfaces->Bodies)
  {
    input.Materials.push_back(body.Name);
  }
  input.Surfaces = std::move(placed.Surfaces);
  return input;
}

void ListSurfaces(const Arguments& arguments, Ranks& ranks, std::ostream& to)
{
  PlacedSurfaces placed;
  WorkInStage(ranks, ErrorCode::UnreadableInput, [&] { placed = ReadAndPlace(arguments); });
  if (ranks.Rank() > 0)
  {
    return;
  }
  const PlaceBounds bounds = FindBounds(*placed.Surfaces);
  const GridPlace& grid = placed.Place;
  to << MakePrintable(arguments.Input) << "\n"
     << Print("x %g to %g, y %g to %g, z %g to %g\n", bounds.Lower[0], bounds.Upper[0],
          bounds.Lower[1], bounds.Upper[1], bounds.Lower[2], bounds.Upper[2])
     << Print("grid around %s: %lld x %lld x %lld cells of %g x %g x %g (--cells, --cell-width)\n",
          placed.Surfaces->Bodies.size() == 1 ? "it" : "them",
          static_cast<long long>(grid.Cells[0]), static_cast<long long>(grid.Cells[1]),
          static_cast<long long>(grid.Cells[2]), grid.Widths[0], grid.Widths[1], grid.Widths[2]);
  PrintBodies(*placed.Surfaces, to);
  to << (placed.Warning.empty() ? "" : "\n" + MakePrintable(placed.Warning) + "\n");
}

} // namespace vfm
