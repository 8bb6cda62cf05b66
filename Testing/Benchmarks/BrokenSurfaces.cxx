/**
 * Reads broken STL files, and prints for each the volume of the fractions of its solid, or the
 * message.
 *
 * usage: BrokenSurfaces
 *
 * All are made of cubes of edge 1. A file that is read has the true volume, whatever its defects.
 */
#include "Ranks/Errors.h"
#include "Surfaces/ReadSurface.h"
#include "Surfaces/SurfaceFractions.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numeric>

#include <unistd.h>

using namespace vfm;

namespace
{

using Triangles = std::vector<Triangle>;

/// Returns a cube, of which each square is two triangles that face outwards.
Triangles MakeCube(const Vector3& lower, double edge = 1.0)
{
  Triangles triangles;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      std::array<Vector3, 4> x;
      for (int c = 0; c < 4; ++c)
      {
        x[c] = lower;
        x[c][axis] += side * edge;
        x[c][(axis + 1) % 3] += (c == 1 || c == 2) * edge;
        x[c][(axis + 2) % 3] += (c >= 2) * edge;
      }
      if (side == 0)
      {
        std::swap(x[1], x[3]);
      }
      triangles.push_back({ { x[0], x[1], x[2] } });
      triangles.push_back({ { x[0], x[2], x[3] } });
    }
  }
  return triangles;
}

Triangles Joined(Triangles a, const Triangles& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Returns triangles, of which those with turns(number) face the other way.
Triangles Turned(
  Triangles triangles, const std::function<bool(int)>& turns = [](int) { return true; })
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (turns(static_cast<int>(t)))
    {
      std::swap(triangles[t][1], triangles[t][2]);
    }
  }
  return triangles;
}

/// Returns triangles with corners that are moved apart by up to a distance.
Triangles Apart(Triangles triangles, double distance)
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int c = 0; c < 3; ++c)
    {
      triangles[t][c][(t + c) % 3] += 0.5 * distance * (static_cast<int>((t + 2 * c) % 3) - 1);
    }
  }
  return triangles;
}

/// Returns a cube with a point inside of an edge that only one side has.
Triangles WithTJunction()
{
  Triangles triangles = MakeCube({});
  const Triangle cut = triangles.back();
  const Vector3 middle{ { 0.5 * (cut[1][0] + cut[2][0]), 0.5 * (cut[1][1] + cut[2][1]),
    0.5 * (cut[1][2] + cut[2][2]) } };
  triangles.back() = { { cut[0], cut[1], middle } };
  triangles.push_back({ { cut[0], middle, cut[2] } });
  return triangles;
}

Triangles WithoutLast(Triangles triangles)
{
  triangles.pop_back();
  return triangles;
}

std::string BinaryStl(const Triangles& triangles)
{
  std::string bytes(80, ' ');
  const auto append = [&](const auto& value)
  { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  append(static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& triangle : triangles)
  {
    bytes.append(3 * sizeof(float), '\0');
    for (const Vector3& corner : triangle)
    {
      for (double x : corner)
      {
        append(static_cast<float>(x));
      }
    }
    append(std::uint16_t(0));
  }
  return bytes;
}

struct Case
{
  const char* Name;
  double Volume; ///< true volume; 0: there is none
  std::string Bytes;
};

std::vector<Case> MakeCases()
{
  const Vector3 away{ { 2, 0, 0 } }, beside{ { 1, 0, 0 } }, across{ { 1, 1, 0 } },
    inside{ { 0.25, 0.25, 0.25 } }, half{ { 0.5, 0.5, 0.5 } };
  const Triangles cube = MakeCube({});
  Triangles flat = cube, infinite = cube;
  flat.push_back({ { cube[0][0], cube[0][1], cube[0][1] } });
  infinite[3][1][2] = 1e300 * 1e300;
  const std::string bytes = BinaryStl(cube);
  std::string solid = bytes;
  solid.replace(0, 5, "solid");
  return {
    { "intact", 1.0, bytes },
    { "corners apart by 1e-7", 1.0, BinaryStl(Apart(cube, 1e-7)) },
    { "corners apart by 1e-3", 0.0, BinaryStl(Apart(cube, 1e-3)) },
    { "each triangle twice", 1.0, BinaryStl(Joined(cube, cube)) },
    { "a triangle of no area", 1.0, BinaryStl(flat) },
    { "T-junction", 1.0, BinaryStl(WithTJunction()) },
    { "all triangles inwards", 1.0, BinaryStl(Turned(cube)) },
    { "one in three triangles inwards", 1.0,
      BinaryStl(Turned(cube, [](int t) { return t % 3 == 0; })) },
    { "two cubes, the second inwards", 2.0, BinaryStl(Joined(cube, Turned(MakeCube(away)))) },
    { "cavity, its wall facing into it", 0.875,
      BinaryStl(Joined(cube, Turned(MakeCube(inside, 0.5)))) },
    { "cavity, its wall facing outwards", 0.875, BinaryStl(Joined(cube, MakeCube(inside, 0.5))) },
    { "two cubes with a common edge", 2.0, BinaryStl(Joined(cube, MakeCube(across))) },
    { "two cubes with a common face", 2.0, BinaryStl(Joined(cube, MakeCube(beside))) },
    { "two cubes that overlap", 1.875, BinaryStl(Joined(cube, MakeCube(half))) },
    { "a triangle is missing", 0.0, BinaryStl(WithoutLast(cube)) },
    { "a coordinate is infinite", 0.0, BinaryStl(infinite) },
    { "header that begins with \"solid\"", 1.0, solid },
    { "bytes after the triangles", 1.0, bytes + "trailing" },
    { "file cut short", 0.0, bytes.substr(0, bytes.size() - 60) },
    { "empty file", 0.0, "" },
  };
}

/// Returns the volume of the fractions of a body in cells of a 32nd.
double SumFractions(BodySurface body)
{
  constexpr double Width = 1.0 / 32.0;
  std::array<std::vector<double>, 3> coordinates;
  Index3 cells;
  for (int a = 0; a < 3; ++a)
  {
    for (double x = -0.51; x < (a == 0 ? 3.1 : 2.1); x += Width)
    {
      coordinates[a].push_back(x);
    }
    cells[a] = static_cast<Index>(coordinates[a].size()) - 1;
  }
  Runtime runtime;
  const Buffer<double> fractions =
    std::move(FractionsOfSurfaces(coordinates, { {}, cells }, { { std::move(body) } }, runtime)[0]);
  return Width * Width * Width * std::accumulate(fractions.begin(), fractions.end(), 0.0);
}

void PrintCase(const Case& given, const std::string& path)
{
  std::ofstream(path, std::ios::binary) << given.Bytes;
  std::printf("| %s | ", given.Name);
  std::printf(given.Volume > 0.0 ? "%g | " : "- | ", given.Volume);
  try
  {
    SurfaceFile file = ReadSurface(path);
    std::string note;
    BodySurface body = MakeBody("body", std::move(file.Points), std::move(file.Triangles),
      std::move(file.Patches), std::move(file.PatchNames), &note);
    std::printf("%.4f | %s%s |\n", SumFractions(std::move(body)), file.Note.c_str(), note.c_str());
  }
  catch (const InputError& error)
  {
    std::printf("- | %s |\n", error.what());
  }
}

} // namespace

int main()
{
  const std::string path =
    (std::filesystem::temp_directory_path() / ("broken" + std::to_string(getpid()) + ".stl"))
      .string();
  std::printf("| input | true volume | volume | message |\n|---|---|---|---|\n");
  for (const Case& given : MakeCases())
  {
    PrintCase(given, path);
  }
  std::filesystem::remove(path);
  return 0;
}
