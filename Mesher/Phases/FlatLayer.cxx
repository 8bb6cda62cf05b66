#include "Phases/FlatLayer.h"

#include "Elements/SelectPoints.h"
#include "Geometry/MeasureMaterials.h"
#include "Geometry/Quality.h"
#include "Report/FlatData.h"

namespace vfm
{
namespace
{

/// Returns the values of each element twice.
Buffer<char> Twice(const Buffer<char>& values, std::size_t elements)
{
  const std::size_t size = elements > 0 ? values.size() / elements : 0;
  Buffer<char> twice(2 * values.size());
  for (std::size_t e = 0; e < elements; ++e)
  {
    const char* from = values.data() + size * e;
    std::copy_n(from, size, std::copy_n(from, size, twice.data() + 2 * size * e));
  }
  return twice;
}

/// Gives both triangles of a quad its values.
void DivideState(const Mesh& mesh, OutputState& state)
{
  for (TransferredArray& array : state.Arrays)
  {
    if (array.IsExtensive)
    {
      throw InputError("The array " + array.Name +
        " holds sums over elements, which triangles of a plane cannot have: make quads.");
    }
    array.Values = Twice(array.Values, mesh.ElementIds.size());
  }
}

} // namespace

int FindFlatAxis(const Cells& cells, const MeshOptions& options)
{
  const IndexBox& domain = cells.Fields.Grid.Domain();
  std::string sizes;
  int axis = -1;
  for (int a = 0; a < 3; ++a)
  {
    const Index count = domain.Upper[a] - domain.Lower[a];
    sizes += (a > 0 ? " x " : "") + std::to_string(count);
    axis = count == 1 ? a : axis;
  }
  if (axis < 0)
  {
    throw InputError("The option Flat needs one layer of cells, but the input has " + sizes +
      " cells: choose a slice of it.");
  }
  if (options.Levels.Refinements > 0)
  {
    throw InputError("The option Flat needs cells of one level: set Refinement to Off, and "
                     "MaterialWidths to None.");
  }
  return axis;
}

void FlattenResult(
  const MesherJob& job, int axis, FlatElement kind, const CartesianGrid& grid, MesherResult& result)
{
  Mesh& mesh = result.TheMesh;
  MeshReport& report = result.Report;
  const double height = grid.Width(axis, grid.Domain().Lower[axis]);
  for (std::vector<double>* volumes :
    { &report.TargetVolume, &report.MeshVolume, &report.Fragments.Volumes })
  {
    for (double& volume : *volumes)
    {
      volume /= height;
    }
  }
  if (kind == FlatElement::Triangle)
  {
    DivideState(mesh, result.State);
  }
  const std::vector<Index> kept = FlattenMesh(axis, kind, job.Run, mesh);
  if (std::optional<TransferredArray>& velocity = result.State.NodalVelocity)
  {
    velocity->Values = Select(velocity->Values, kept, job.Run, 3 * sizeof(double));
  }
  report.NumberOfSurfaces = 0;
  if (job.Options.ComputeQuality)
  {
    ComputeQuality(mesh, job.Run, report);
  }
  MeasureMaterials(mesh, job.Run.Group(), report, nullptr);
}

void FlattenBounds(int axis, std::vector<FieldArray>& fields)
{
  double thickness = 0.0;
  for (FieldArray& field : fields)
  {
    if (field.Name == "DomainBounds")
    {
      auto& bounds = std::get<std::vector<double>>(field.Values);
      thickness = bounds[2 * axis + 1] - bounds[2 * axis];
      bounds[2 * axis + 1] = bounds[2 * axis];
    }
  }
  fields.insert(fields.begin(), { FlatAxisName, std::vector<int>{ axis } });
  fields.push_back({ FlatThicknessName, std::vector<double>{ thickness } });
}

} // namespace vfm
