#include "Meshes/Files/RunValues.h"

#include <stdexcept>

namespace vfm
{
namespace
{

using NodeRun = MeshWithRuns::NodeRun;
using CellRun = CellRuns::Run;

constexpr std::size_t ValuesOfPart = 16384;

/// Collects values and passes them on in parts.
template <class T>
class Parts
{
public:
  explicit Parts(const AddBytes& add) : Pass(add) {}
  void Add(T value)
  {
    this->Values.push_back(value);
    if (this->Values.size() >= ValuesOfPart)
    {
      this->Flush();
    }
  }
  void AddAll(const T* values, Index count)
  {
    for (Index i = 0; i < count; ++i)
    {
      this->Add(values[i]);
    }
  }
  void Flush()
  {
    this->Pass(
      { reinterpret_cast<const char*>(this->Values.data()), sizeof(T) * this->Values.size() });
    this->Values.clear();
  }

private:
  const AddBytes& Pass;
  std::vector<T> Values;
};

/// Adds the values of an array of points.
/// @param valueAt  valueAt(run, n) returns the value of point n of a run
template <class T, class ValueAt>
void AddOfPoints(
  const MeshWithRuns& mesh, const MeshArray& array, const AddBytes& add, const ValueAt& valueAt)
{
  const T* values = static_cast<const T*>(array.Values);
  Parts<T> parts(add);
  mesh.ForPoints([&](Index first, Index last) { parts.AddAll(values + first, last - first); },
    [&](const NodeRun& run)
    {
      for (Index n = 0; n < run.Count; ++n)
      {
        parts.Add(valueAt(run, n));
      }
    });
  parts.Flush();
}

/// The same of elements of a material.
template <class T, class ValueAt>
void AddOfElements(const MeshWithRuns& mesh, const MeshArray& array, const AddBytes& add,
  std::optional<int> material, const ValueAt& valueAt)
{
  const T* values = static_cast<const T*>(array.Values);
  Parts<T> parts(add);
  mesh.ForElements(
    [&](Index first, Index last)
    {
      for (Index e = first; e < last; ++e)
      {
        if (!material || mesh.Stored().Material[e] == *material)
        {
          parts.Add(values[e]);
        }
      }
    },
    [&](const CellRun& run)
    {
      const bool isAdded = !material || run.Material == *material;
      for (Index n = 0; isAdded && n < run.Count; ++n)
      {
        parts.Add(valueAt(run, n));
      }
    });
  parts.Flush();
}

[[noreturn]] void RejectArray(const MeshArray& array)
{
  throw std::logic_error("Hexes that are left out have no values of the array " + array.Name + ".");
}

} // namespace

void AddPoints(const MeshWithRuns& mesh, const AddBytes& add)
{
  Parts<double> parts(add);
  mesh.ForPoints([&](Index first, Index last)
    { parts.AddAll(mesh.Stored().Points.data() + 3 * first, 3 * (last - first)); },
    [&](const NodeRun& run)
    {
      for (Index n = 0; n < run.Count; ++n)
      {
        parts.AddAll(mesh.PointAt(run, n).data(), 3);
      }
    });
  parts.Flush();
}

void AddCorners(const MeshWithRuns& mesh, const AddBytes& add)
{
  Parts<Index> parts(add);
  mesh.ForCorners([&](int, const Index* corners) { parts.AddAll(corners, 8); });
  parts.Flush();
}

void AddPointValues(const MeshWithRuns& mesh, const MeshArray& array, const AddBytes& add)
{
  if (array.Name == "GlobalPointIds")
  {
    AddOfPoints<Index>(mesh, array, add,
      [&mesh](const NodeRun& run, Index n) { return mesh.FirstId(run) + HexIds.PointSlots * n; });
  }
  else if (array.Name == "GeometryDimension")
  {
    AddOfPoints<int>(mesh, array, add, [](const NodeRun&, Index) { return 3; });
  }
  else if (array.Name == "GeometryId")
  {
    AddOfPoints<int>(mesh, array, add, [](const NodeRun& run, Index) { return run.Fragment; });
  }
  else
  {
    RejectArray(array);
  }
}

void AddElementValues(const MeshWithRuns& mesh, const MeshArray& array, const AddBytes& add,
  std::optional<int> material)
{
  if (array.Name == "MaterialId")
  {
    AddOfElements<int>(
      mesh, array, add, material, [](const CellRun& run, Index) { return run.Material; });
  }
  else if (array.Name == "FragmentId")
  {
    AddOfElements<int>(
      mesh, array, add, material, [](const CellRun& run, Index) { return run.Fragment; });
  }
  else if (array.Name == "GlobalCellIds")
  {
    AddOfElements<Index>(mesh, array, add, material,
      [&mesh](const CellRun& run, Index n) { return mesh.FirstId(run) + HexIds.ElementSlots * n; });
  }
  else if (array.Name == "ScaledJacobian")
  {
    AddOfElements<float>(mesh, array, add, material, [](const CellRun&, Index) { return 1.0f; });
  }
  else
  {
    RejectArray(array);
  }
}

} // namespace vfm
