/// Writes all values of five meshes, which TestDigests.py hashes: MeshValues FOLDER. It writes
/// values and not memory, because the layout of VTK's memory differs between versions.
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionShapes.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkVolumeFractionToTet.h"
#include "vtkXMLImageDataReader.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <initializer_list>
#include <string>

namespace
{

using Point = std::array<double, 3>;

/// Writes every number as a double of eight bytes: ids here are far below 2^53, reals are exact.
class Values
{
public:
  explicit Values(const std::string& path) : Stream(path, std::ios::binary) {}
  bool HasWritten() { return static_cast<bool>(this->Stream.flush()); }

  void Add(double value)
  {
    this->Stream.write(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  void Add(vtkDataArray* array)
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        this->Add(array->GetComponent(i, c));
      }
    }
  }
  void Add(vtkDataSetAttributes* arrays)
  {
    for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
    {
      this->Stream << arrays->GetArrayName(a);
      this->Add(arrays->GetArray(a));
    }
  }
  void Add(vtkPointSet* mesh, vtkCellArray* cells)
  {
    this->Add(mesh->GetPoints()->GetData());
    this->Add(cells->GetOffsetsArray());
    this->Add(cells->GetConnectivityArray());
    this->Add(mesh->GetPointData());
    this->Add(mesh->GetCellData());
  }

private:
  std::ofstream Stream;
};

/// Writes the elements and surfaces of a mesh.
bool WriteMesh(vtkVolumeFractionMeshAlgorithm* mesher, const std::string& path)
{
  mesher->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(mesher->GetOutputDataObject(0));
  auto* surfaces = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(1));
  if (mesh->GetNumberOfCells() == 0 || surfaces->GetNumberOfCells() == 0)
  {
    return false;
  }
  Values values(path);
  values.Add(mesh, mesh->GetCells());
  values.Add(surfaces, surfaces->GetPolys());
  std::printf(
    "%s: %lld elements\n", path.c_str(), static_cast<long long>(mesh->GetNumberOfCells()));
  return values.HasWritten();
}

vtkSmartPointer<vtkImageData> ReadImage(const std::string& name)
{
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName((VFM_DATA "/" + name).c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Returns fractions of a ball (Material1) on a plate (Material2) in the cells of a box, computed
/// without functions of the C library.
vtkSmartPointer<vtkImageData> BallOnPlate(const Point& low, const Point& high, int cells)
{
  vtkNew<vtkVolumeFractionShapes> shapes;
  shapes->SetShapes("sphere radius=2.5 center=4.1,4,5 material=1\n"
                    "halfspace point=0,0,2.6 normal=0,0,1 material=2");
  shapes->SetDimensions(cells, cells, cells);
  shapes->SetBounds(low[0], high[0], low[1], high[1], low[2], high[2]);
  shapes->Update();
  return vtkImageData::SafeDownCast(shapes->GetOutputDataObject(0));
}

/// Returns level 0, and level 1 over its middle.
vtkSmartPointer<vtkMultiBlockDataSet> TwoLevels()
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, BallOnPlate({ { 0, 0, 0 } }, { { 8, 8, 8 } }, 8));
  blocks->SetBlock(1, BallOnPlate({ { 2, 2, 2 } }, { { 6, 6, 6 } }, 8));
  return blocks;
}

/// Returns the number of the nearest of six seeds, 0 for the first.
vtkSmartPointer<vtkImageData> Grains()
{
  constexpr int n = 14;
  constexpr int seeds[6][3] = { { 1, 1, 2 }, { 11, 2, 3 }, { 3, 12, 4 }, { 10, 10, 1 },
    { 5, 6, 11 }, { 12, 7, 12 } };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n + 1, n + 1, n + 1);
  vtkNew<vtkIntArray> ids;
  ids->SetName("grain");
  for (int cell = 0; cell < n * n * n; ++cell)
  {
    const int x[3] = { cell % n, cell / n % n, cell / n / n };
    const auto distance = [&](int s)
    {
      int sum = 0;
      for (int a = 0; a < 3; ++a)
      {
        sum += (x[a] - seeds[s][a]) * (x[a] - seeds[s][a]);
      }
      return sum;
    };
    int nearest = 0;
    for (int s = 1; s < 6; ++s)
    {
      nearest = distance(s) < distance(nearest) ? s : nearest;
    }
    ids->InsertNextValue(nearest);
  }
  image->GetCellData()->AddArray(ids);
  return image;
}

/// Returns a ball that falls obliquely onto the plate.
vtkSmartPointer<vtkImageData> MovingBall()
{
  constexpr int n = 12;
  const vtkSmartPointer<vtkImageData> image = BallOnPlate({ { 0, 0, 0 } }, { { 8, 8, 8 } }, n);
  vtkNew<vtkDoubleArray> density, velocity;
  density->SetName("density");
  velocity->SetName("velocity");
  velocity->SetNumberOfComponents(3);
  for (int cell = 0; cell < n * n * n; ++cell)
  {
    const double x = cell % n, z = cell / n / n;
    density->InsertNextValue(2.0 + 0.125 * x + 0.03125 * z * z);
    velocity->InsertNextTuple3(1.0 + 0.25 * z, 0.0625 * x * z, z < 4.0 ? 0.0 : -8.0);
  }
  image->GetCellData()->AddArray(density);
  image->GetCellData()->AddArray(velocity);
  return image;
}

template <class Mesher>
vtkSmartPointer<Mesher> MakeMesher(
  vtkDataObject* input, std::initializer_list<const char*> fractions)
{
  auto mesher = vtkSmartPointer<Mesher>::New();
  mesher->SetInputDataObject(input);
  for (const char* name : fractions)
  {
    mesher->AddVolumeFractionArray(name);
  }
  return mesher;
}

using ToHex = vtkVolumeFractionToHex;
using ToTet = vtkVolumeFractionToTet;

bool WriteHexes(const std::string& path)
{
  return WriteMesh(MakeMesher<ToHex>(ReadImage("ball_and_plate.vti"), { "ball", "plate" }), path);
}

bool WriteTets(const std::string& path)
{
  const auto mesher = MakeMesher<ToTet>(ReadImage("fin.vti"), { "body" });
  mesher->SetMethod(ToTet::METHOD_LATTICE);
  return WriteMesh(mesher, path);
}

bool WriteLevels(const std::string& path)
{
  const auto mesher = MakeMesher<ToHex>(TwoLevels(), { "Material1", "Material2" });
  mesher->SetFineInterfaces(false);
  return WriteMesh(mesher, path);
}

bool WriteLabels(const std::string& path)
{
  const auto mesher = MakeMesher<ToTet>(Grains(), {});
  mesher->SetMaterialIdArray("grain");
  mesher->SetLabelSmoothing(3);
  mesher->SetMethod(ToTet::METHOD_CELLS);
  return WriteMesh(mesher, path);
}

bool WriteState(const std::string& path)
{
  const auto mesher = MakeMesher<ToHex>(MovingBall(), { "Material1", "Material2" });
  mesher->AddStateArray("density");
  mesher->AddStateArray("velocity");
  mesher->SetStateTransfer(ToHex::STATE_CONSERVE);
  mesher->AddDensityArray("density");
  mesher->SetVelocityArray("velocity");
  mesher->SetNodalVelocity(true);
  return WriteMesh(mesher, path);
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
