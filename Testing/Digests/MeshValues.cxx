/// Writes all values of five meshes, which TestDigests.py hashes: MeshValues FOLDER. It uses only
/// the mesher, and so runs wherever that can be compiled.
#include "Input/NodeCoordinates.h"
#include "Input/PlainArrays.h"
#include "LabelInput.h"
#include "Report/MeshArrays.h"
#include "Shapes/ShapesFractions.h"
#include "Shapes/ShapesText.h"

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

using namespace vfm;

namespace
{

/// Writes every number as a double of eight bytes: ids here are far below 2^53, reals are exact.
class Values
{
public:
  explicit Values(const std::string& path) : Stream(path, std::ios::binary) {}
  bool HasWritten() { return static_cast<bool>(this->Stream.flush()); }

  template <class Number>
  void Add(Number number)
  {
    const auto value = static_cast<double>(number);
    this->Stream.write(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  template <class Numbers>
  void Add(const char* name, const Numbers& numbers)
  {
    this->Stream << name;
    for (const auto number : numbers)
    {
      this->Add(number);
    }
  }
  void Add(const Mesh& mesh)
  {
    const auto add = [this](const char* name, const auto& numbers) { this->Add(name, numbers); };
    add("Points", mesh.Points);
    add("Elements", mesh.Elements);
    VisitPointArrays(mesh, add);
    VisitElementArrays(mesh, add);
    add("Facets", mesh.Surfaces.Points);
    add("SurfaceId", mesh.Surfaces.SurfaceId);
    add("MaterialPair", mesh.Surfaces.MaterialPair);
    add("CurveEdges", mesh.Curves.Points);
    add("CurveId", mesh.Curves.CurveId);
  }
  void Add(const TransferredArray& array)
  {
    std::vector<double> numbers(array.Values.size() / sizeof(double));
    std::copy_n(array.Values.data(), array.Values.size(), reinterpret_cast<char*>(numbers.data()));
    this->Add(array.Name.c_str(), numbers);
  }

private:
  std::ofstream Stream;
};

bool WriteMesh(const MesherInput& input, const MesherOptions& options, const std::string& path)
{
  Runtime serial;
  const MesherResult result = RunMesher(input, options, serial);
  Values values(path);
  values.Add(result.TheMesh);
  for (const TransferredArray& array : result.State.Arrays)
  {
    values.Add(array);
  }
  if (result.State.NodalVelocity)
  {
    values.Add(*result.State.NodalVelocity);
  }
  std::printf("%s: %zu elements\n", path.c_str(), result.TheMesh.ElementIds.size());
  return values.HasWritten();
}

/// A cube of cells of equal width.
struct Cells
{
  int Count; ///< along each axis
  double Origin, Width;

  IndexBox Box() const { return { {}, { { this->Count, this->Count, this->Count } } }; }
  Vector3 At(double x) const { return { { x, x, x } }; }
};

/// Returns the fractions of the materials of shapes, named 1, 2 ..
std::shared_ptr<PlainArrays> FractionsOf(const std::string& shapes, const Cells& cells)
{
  const Vector3 lower = cells.At(cells.Origin);
  const Vector3 upper = cells.At(cells.Origin + cells.Count * cells.Width);
  Runtime serial;
  auto arrays = std::make_shared<PlainArrays>(cells.Box().NumberOfCells());
  int material = 0;
  for (Buffer<double>& fractions :
    FractionArraysOfShapes(EvenCoordinates(lower, cells.At(cells.Width), cells.Box()), cells.Box(),
      ParseShapes(shapes, lower, upper), DefaultShapeTolerance, serial))
  {
    arrays->Store(std::to_string(++material), ValueType::Double, std::move(fractions));
  }
  return arrays;
}

InputBlock BlockOf(const Cells& cells, std::shared_ptr<const BlockArrays> arrays)
{
  return testing::MakeBlock(cells.Box(), cells.At(cells.Origin), cells.Width, std::move(arrays));
}

MesherInput InputOf(
  std::vector<InputBlock> blocks, std::vector<std::string> fractions, std::string labels = "")
{
  Ranks alone;
  MesherInput input = testing::MakeInput(std::move(blocks), alone);
  input.Arrays.Fractions = std::move(fractions);
  input.Arrays.Labels = std::move(labels);
  return input;
}

constexpr const char* BallOnPlate = "sphere radius=2.5 center=4.1,4,5 material=1\n"
                                    "halfspace point=0,0,2.6 normal=0,0,1 material=2";
constexpr const char* BallWithFin =
  "sphere material=1 center=-0.25,0,0 radius=0.55\n"
  "box material=1 center=0.55,0,0 size=1.3,0.9,0.15 rotation=0,14,0";

bool WriteHexes(const std::string& path)
{
  const Cells cells{ 40, 0.0, 0.2 };
  return WriteMesh(
    InputOf({ BlockOf(cells, FractionsOf(BallOnPlate, cells)) }, { "1", "2" }), {}, path);
}

bool WriteTets(const std::string& path)
{
  const Cells cells{ 32, -1.4, 0.0875 };
  MesherOptions options;
  options.Elements = ElementKind::Tets;
  options.Method = TetMethod::Lattice;
  return WriteMesh(
    InputOf({ BlockOf(cells, FractionsOf(BallWithFin, cells)) }, { "1" }), options, path);
}

/// Writes the mesh of level 0, and level 1 over its middle.
bool WriteLevels(const std::string& path)
{
  const Cells coarse{ 8, 0.0, 1.0 }, fine{ 8, 2.0, 0.5 };
  MesherOptions options;
  options.FineInterfaces = false;
  return WriteMesh(InputOf({ BlockOf(coarse, FractionsOf(BallOnPlate, coarse)),
                             BlockOf(fine, FractionsOf(BallOnPlate, fine)) },
                     { "1", "2" }),
    options, path);
}

/// Writes the mesh of grains: each cell has the number of the nearest of six seeds, 0 for the
/// first.
bool WriteLabels(const std::string& path)
{
  const Cells cells{ 14, 0.0, 1.0 };
  const std::vector<Vector3> seeds{ { { 1, 1, 2 } }, { { 11, 2, 3 } }, { { 3, 12, 4 } },
    { { 10, 10, 1 } }, { { 5, 6, 11 } }, { { 12, 7, 12 } } };
  std::vector<int> labels;
  ForCells(cells.Box(),
    [&](const Index3& cell)
    {
      const Vector3 at{ { double(cell[0]), double(cell[1]), double(cell[2]) } };
      const auto isNearer = [&](const Vector3& a, const Vector3& b)
      { return Dot(at - a, at - a) < Dot(at - b, at - b); };
      labels.push_back(
        static_cast<int>(std::min_element(seeds.begin(), seeds.end(), isNearer) - seeds.begin()));
    });
  auto arrays = std::make_shared<PlainArrays>(cells.Box().NumberOfCells());
  arrays->Store("grain", ValueType::Int, std::move(labels));
  MesherOptions options;
  options.Elements = ElementKind::Tets;
  options.Method = TetMethod::Cells;
  options.LabelSmoothing = 3;
  return WriteMesh(InputOf({ BlockOf(cells, arrays) }, {}, "grain"), options, path);
}

/// Writes the mesh and state of a ball that falls obliquely onto the plate.
bool WriteState(const std::string& path)
{
  const Cells cells{ 12, 0.0, 8.0 / 12.0 };
  std::vector<double> density, velocity;
  ForCells(cells.Box(),
    [&](const Index3& cell)
    {
      const double x = static_cast<double>(cell[0]), z = static_cast<double>(cell[2]);
      density.push_back(2.0 + 0.125 * x + 0.03125 * z * z);
      velocity.insert(velocity.end(), { 1.0 + 0.25 * z, 0.0625 * x * z, z < 4.0 ? 0.0 : -8.0 });
    });
  const auto arrays = FractionsOf(BallOnPlate, cells);
  const Index tuples = cells.Box().NumberOfCells();
  arrays->Add("density", ValueType::Double, tuples, 1, density.data());
  arrays->Add("velocity", ValueType::Double, tuples, 3, velocity.data());
  MesherOptions options;
  options.StateTransfer = TransferMode::Conserve;
  options.DensityArrays = { "density" };
  options.VelocityArray = "velocity";
  options.NodalVelocity = true;
  MesherInput input = InputOf({ BlockOf(cells, arrays) }, { "1", "2" });
  input.Arrays.State = ChooseState(options, { "density", "velocity" });
  return WriteMesh(input, options, path);
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::fputs("usage: MeshValues FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = argv[1] + std::string("/");
  const bool haveAll = WriteHexes(folder + "hexes") && WriteTets(folder + "tets") &&
    WriteLevels(folder + "levels") && WriteLabels(folder + "labels") &&
    WriteState(folder + "state");
  return haveAll ? 0 : 1;
}
