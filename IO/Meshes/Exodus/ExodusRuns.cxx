#include "Meshes/Exodus/ExodusRuns.h"

namespace vfm
{
namespace
{

constexpr std::size_t ValuesOfPart = std::size_t(1) << 20;

/// Collects values and passes them on in parts.
template <class T>
class Collected
{
public:
  explicit Collected(const PutValues& put) : Put(put) {}
  void Add(T value)
  {
    this->Values.push_back(value);
    if (this->Values.size() >= ValuesOfPart)
    {
      this->Flush();
    }
  }
  void Flush()
  {
    if (!this->Values.empty())
    {
      this->Put(std::move(this->Values));
      this->Values = {};
    }
  }

private:
  const PutValues& Put;
  std::vector<T> Values;
};

/// Adds the bytes of values of a type.
template <class T>
void AddNumbers(int type, std::string_view bytes, Collected<T>& to)
{
  VisitType(type,
    [&](auto tag)
    {
      using Value = typename decltype(tag)::Type;
      const auto* values = reinterpret_cast<const Value*>(bytes.data());
      for (std::size_t i = 0; i < bytes.size() / sizeof(Value); ++i)
      {
        to.Add(static_cast<T>(values[i]));
      }
    });
}

/// Returns values that are collected while the file is written; none without a mesh.
/// @param add  add(mesh, values) adds the values; called on each pass
template <class T, class AddValues>
NetcdfParts PartsOf(const MeshWithRuns* mesh, AddValues add)
{
  if (!mesh)
  {
    return {};
  }
  return [mesh, add = std::move(add)](const PutValues& put)
  {
    Collected<T> values(put);
    add(*mesh, values);
    values.Flush();
  };
}

/// Adds the values of an array at the elements of a material.
template <class T>
void AddOfElements(
  const MeshWithRuns& mesh, const MeshArray& array, int material, Collected<T>& values)
{
  AddElementValues(
    mesh, array, [&](std::string_view bytes) { AddNumbers(array.Type, bytes, values); }, material);
}

/// Adds the values of an array at the points.
template <class T>
void AddOfPoints(const MeshWithRuns& mesh, const MeshArray& array, Collected<T>& values)
{
  AddPointValues(
    mesh, array, [&](std::string_view bytes) { AddNumbers(array.Type, bytes, values); });
}

} // namespace

NetcdfParts PartsOfCoordinates(const MeshWithRuns* mesh, int axis)
{
  return PartsOf<double>(mesh,
    [axis](const MeshWithRuns& runs, Collected<double>& values)
    {
      int place = 0;
      AddPoints(runs,
        [&](std::string_view bytes)
        {
          const auto* x = reinterpret_cast<const double*>(bytes.data());
          for (std::size_t i = 0; i < bytes.size() / sizeof(double); ++i)
          {
            if (place == axis)
            {
              values.Add(x[i]);
            }
            place = place == 2 ? 0 : place + 1;
          }
        });
    });
}

NetcdfParts PartsOfNodes(const MeshWithRuns* mesh, int material)
{
  return PartsOf<Index>(mesh,
    [material](const MeshWithRuns& runs, Collected<Index>& values)
    {
      runs.ForCorners(
        [&](int own, const Index* corners)
        {
          for (int c = 0; own == material && c < 8; ++c)
          {
            values.Add(corners[c] + 1);
          }
        });
    });
}

NetcdfParts PartsOfPointArray(const MeshWithRuns* mesh, const MeshArray& array)
{
  return PartsOf<double>(mesh,
    [&array](const MeshWithRuns& runs, Collected<double>& values)
    { AddOfPoints(runs, array, values); });
}

NetcdfParts PartsOfElementArray(const MeshWithRuns* mesh, const MeshArray& array, int material)
{
  return PartsOf<double>(mesh,
    [&array, material](const MeshWithRuns& runs, Collected<double>& values)
    { AddOfElements(runs, array, material, values); });
}

NetcdfParts PartsOfPointIds(const MeshWithRuns* mesh, const MeshData& stored)
{
  return PartsOf<Index>(mesh,
    [&stored](const MeshWithRuns& runs, Collected<Index>& values)
    { AddOfPoints(runs, GetArray(stored.PointArrays, "GlobalPointIds"), values); });
}

NetcdfParts PartsOfElementIds(
  const MeshWithRuns* mesh, const MeshData& stored, std::vector<int> materials)
{
  return PartsOf<Index>(mesh,
    [&stored, materials = std::move(materials)](const MeshWithRuns& runs, Collected<Index>& values)
    {
      const MeshArray& ids = GetArray(stored.ElementArrays, "GlobalCellIds");
      for (int material : materials)
      {
        AddOfElements(runs, ids, material, values);
      }
    });
}

} // namespace vfm
