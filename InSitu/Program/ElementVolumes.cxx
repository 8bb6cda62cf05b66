#include "ElementVolumes.h"

#include "Vector3.h"

#include "vtkCellArray.h"
#include "vtkUnstructuredGrid.h"

namespace vfm
{
namespace
{

double TripleProduct(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return Dot(Cross(a, b), c);
}

double TetVolume(const std::array<Vector3, 8>& p)
{
  return TripleProduct(p[1] - p[0], p[2] - p[0], p[3] - p[0]) / 6.0;
}

/// Three triple products (Grandy, "Efficient computation of volume of hexahedral cells", 1997).
double HexVolume(const std::array<Vector3, 8>& p)
{
  return (TripleProduct((p[3] - p[1]) + (p[7] - p[2]), p[6] - p[3], p[2] - p[0]) +
           TripleProduct((p[4] - p[3]) + (p[5] - p[7]), p[6] - p[4], p[7] - p[0]) +
           TripleProduct((p[1] - p[4]) + (p[2] - p[5]), p[6] - p[1], p[5] - p[0])) /
    12.0;
}

} // namespace

std::vector<double> FindElementVolumes(vtkUnstructuredGrid* mesh)
{
  std::vector<double> volumes(mesh->GetNumberOfCells());
  std::array<Vector3, 8> corners{};
  for (std::size_t e = 0; e < volumes.size(); ++e)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    mesh->GetCells()->GetCellAtId(static_cast<vtkIdType>(e), size, points);
    for (vtkIdType c = 0; c < size; ++c)
    {
      mesh->GetPoint(points[c], corners[c].data());
    }
    volumes[e] = size == 4 ? TetVolume(corners) : HexVolume(corners);
  }
  return volumes;
}

} // namespace vfm
