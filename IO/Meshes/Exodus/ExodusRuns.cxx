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

} // namespace

NetcdfParts PartsOfCoordinates(const MeshWithRuns* mesh, int axis)
{
  if (!mesh)
  {
    return {};
  }
  return [mesh, axis](const PutValues& put)
  {
    Collected<double> values(put);
    int place = 0;
    AddPoints(*mesh,
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
    values.Flush();
  };
}

NetcdfParts PartsOfNodes(const MeshWithRuns* mesh, int material)
{
  if (!mesh)
  {
    return {};
  }
  return [mesh, material](const PutValues& put)
  {
    Collected<Index> values(put);
    mesh->ForCorners(
      [&](int own, const Index* corners)
      {
        for (int c = 0; own == material && c < 8; ++c)
        {
          values.Add(corners[c] + 1);
        }
      });
    values.Flush();
  };
}

NetcdfParts PartsOfPointArray(const MeshWithRuns* mesh, const MeshArray& array)
{
  if (!mesh)
  {
    return {};
  }
  return [mesh, &array](const PutValues& put)
  {
    Collected<double> values(put);
    AddPointValues(
      *mesh, array, [&](std::string_view bytes) { AddNumbers(array.Type, bytes, values); });
    values.Flush();
  };
}

NetcdfParts PartsOfElementArray(const MeshWithRuns* mesh, const MeshArray& array, int material)
{
  if (!mesh)
  {
    return {};
  }
  return [mesh, &array, material](const PutValues& put)
  {
    Collected<double> values(put);
    AddElementValues(
      *mesh, array, [&](std::string_view bytes) { AddNumbers(array.Type, bytes, values); },
      material);
    values.Flush();
  };
}

NetcdfParts PartsOfPointIds(const MeshWithRuns* mesh, const MeshData& stored)
{
  if (!mesh)
  {
    return {};
  }
  return [mesh, &stored](const PutValues& put)
  {
    Collected<Index> values(put);
    AddPointValues(*mesh, GetArray(stored.PointArrays, "GlobalPointIds"),
      [&](std::string_view bytes) { AddNumbers(ValueType::Id, bytes, values); });
    values.Flush();
  };
}

NetcdfParts PartsOfElementIds(
  const MeshWithRuns* mesh, const MeshData& stored, std::vector<int> materials)
{
  if (!mesh)
  {
    return {};
  }
  return [mesh, &stored, materials = std::move(materials)](const PutValues& put)
  {
    Collected<Index> values(put);
    for (int material : materials)
    {
      AddElementValues(
        *mesh, GetArray(stored.ElementArrays, "GlobalCellIds"),
        [&](std::string_view bytes) { AddNumbers(ValueType::Id, bytes, values); }, material);
    }
    values.Flush();
  };
}

} // namespace vfm
