// Meshes a ball in the memory of this program as hexahedra, without VTK and MPI, and prints the
// number of elements and the volume. It uses the component Mesher of the package:
//   find_package(VolumeFractionMesh REQUIRED COMPONENTS Mesher)
//   add_executable(mesh_in_cxx mesh_in_cxx.cxx)
//   target_link_libraries(mesh_in_cxx VolumeFractionMesh::Mesher)
#include <Base/ThreadRuntime.h>
#include <Input/InputLevels.h>
#include <Input/PlainArrays.h>
#include <Mesher.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

int main()
try
{
  const int size = 12; // cells along each axis, of width 1
  std::vector<double> nodes, ball;
  for (int i = 0; i <= size; ++i)
  {
    nodes.push_back(i);
  }
  for (int cell = 0; cell < size * size * size; ++cell) // x fastest
  {
    const double x = cell % size - 5.5, y = cell / size % size - 5.5, z = cell / size / size - 5.5;
    ball.push_back(std::clamp(4.5 - std::sqrt(x * x + y * y + z * z), 0.0, 1.0)); // radius 4
  }

  vfm::ThreadRuntime runtime(vfm::ChooseThreads(0, 1)); // all cores
  const auto arrays = std::make_shared<vfm::PlainArrays>(size * size * size);
  arrays->Add("ball", vfm::ValueType::Double, arrays->NumberOfTuples(), 1, ball.data());
  vfm::CollectedBlocks blocks;
  blocks.Blocks.resize(1);
  blocks.Blocks[0].Arrays = arrays;
  blocks.Blocks[0].Coordinates = { { nodes, nodes, nodes } };
  vfm::FinishBlock(blocks.Blocks[0], -1, runtime.Group());

  vfm::MesherInput input;
  input.Levels = vfm::FindInputLevels(std::move(blocks), runtime.Group());
  input.Arrays.Fractions = { "ball" };
  const vfm::MesherResult result = vfm::RunMesher(input, vfm::MesherOptions(), runtime);
  std::printf("%zu hexes, volume %.4f of %.4f\n", result.TheMesh.ElementIds.size(),
    result.Report.MeshVolume.at(1), result.Report.TargetVolume.at(1));
  return 0;
}
catch (const std::exception& error) // InputError: what is wrong with input or options
{
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
