/**
 * Files of a mesh with all hexes, and of one that leaves hexes out.
 */
#pragma once

#include "FileCases.h"
#include "LabelInput.h"
#include "Meshes/WriteMesh.h"

namespace vfm
{
namespace testing
{

/// Returns a step of material 2 below material 1, and void in a corner.
inline MesherInput MakeStepInput(Ranks& ranks)
{
  const LabelGrid grid{ { { 40, 24, 28 } }, 1.0, 0.5 };
  std::vector<int> labels;
  ForCells({ {}, grid.Cells },
    [&](const Index3& cell)
    {
      const bool isVoid = cell[0] > 30 && cell[1] > 15 && cell[2] > 10;
      labels.push_back(isVoid ? 0 : cell[2] < (cell[0] < 20 ? 9 : 14) ? 2 : 1);
    });
  return MakeLabelInput(grid, labels, ranks);
}

///@{ Write the mesh and return the path.
inline std::string WriteAll(const std::string& path)
{
  Runtime serial;
  const MesherResult all = RunMesher(MakeStepInput(serial.Group()), MesherOptions(), serial);
  MeshData mesh = ViewMesh(all.TheMesh, all.State, all.Fields);
  mesh.Time = 0.25;
  WriteMesh(mesh, path, serial.Group());
  return path;
}
inline std::string WriteWithRuns(const std::string& path)
{
  Runtime serial;
  CellRuns leftOut;
  const MesherResult part =
    RunMesher(MakeStepInput(serial.Group()), MesherOptions(), serial, &leftOut);
  EXPECT_GT(leftOut.Count(), 5000);
  MeshData mesh = ViewMesh(part.TheMesh, part.State, part.Fields);
  mesh.Time = 0.25;
  WriteMesh(mesh, MeshWithRuns(part.TheMesh, leftOut), path);
  return path;
}
///@}

/// Returns a file in which the date and time of the Exodus QA record are set to zeros.
inline std::string ReadWithoutDate(const std::string& path)
{
  std::string bytes = ReadBytes(path);
  constexpr std::size_t recordLength = 33;
  const std::size_t record = bytes.rfind("VolumeFractionMesh");
  const std::size_t first = record + 2 * recordLength, last = record + 4 * recordLength;
  for (std::size_t i = first; path.find(".e") != std::string::npos && i < last; ++i)
  {
    bytes[i] = std::isdigit(static_cast<unsigned char>(bytes[i])) ? '0' : bytes[i];
  }
  return bytes;
}

} // namespace testing
} // namespace vfm
