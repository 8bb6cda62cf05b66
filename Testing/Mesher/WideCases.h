/**
 * WideCases: inputs of wider cells, and their meshes on ranks.
 */
#pragma once

#include "LabelInput.h"
#include "Mesher.h"
#include "RankFields.h"

#include <map>

namespace vfm
{
namespace testing
{

constexpr Index3 GridSize{ { 20, 18, 24 } };
constexpr LabelGrid TheGrid{ GridSize, -0.3, 0.1 };

/// Returns labels of the nearest of four seeds, 0 (void) to 3.
std::vector<int> MakeGrains(const Index3& cells);

/// Returns an input with a state that differs from cell to cell, in cells of any level.
MesherInput WithState(bool isConserved, MesherInput input);

/// Returns grains in TheGrid.
MesherInput MakeGrainsInput(Ranks& ranks);

/// Returns grains of two levels.
MesherInput MakeLevels(Ranks& ranks);

/// Returns the values of a field, or none.
template <class Values>
Values ValuesOf(const FieldArrays& fields, const std::string& name)
{
  const auto found = std::find_if(
    fields.begin(), fields.end(), [&](const FieldArray& field) { return field.Name == name; });
  return found == fields.end() ? Values() : std::get<Values>(found->Values);
}

/// Points and elements of the meshes of all ranks with their state, by id.
struct MeshById
{
  std::map<Index, std::array<double, 3>> Points;
  std::map<Index, std::vector<double>> Elements;

  void Add(const MesherResult& result)
  {
    const Mesh& mesh = result.TheMesh;
    for (std::size_t p = 0; p < mesh.PointIds.size(); ++p)
    {
      std::copy_n(mesh.Points.data() + 3 * p, 3, this->Points[mesh.PointIds[p]].begin());
    }
    for (std::size_t e = 0; e < mesh.ElementIds.size(); ++e)
    {
      std::vector<double>& values = this->Elements[mesh.ElementIds[e]];
      values.push_back(mesh.Material[e]);
      for (const TransferredArray& array : result.State.Arrays)
      {
        const double* tuple = reinterpret_cast<const double*>(array.Values.data());
        values.insert(
          values.end(), tuple + array.Components * e, tuple + array.Components * (e + 1));
      }
    }
  }
};

MeshById MeshOnRanks(
  int count, const MesherOptions& options, const std::function<MesherInput(Ranks&)>& makeInput);

/// Expects the same points and elements with their state on 1, 2, 3 and 8 ranks.
void ExpectSameOnRanks(
  const MesherOptions& options, const std::function<MesherInput(Ranks&)>& makeInput);

/// Expects that mass, momentum and energy of the mesh, and all sums of its input, are those of the
/// input meshed as read; kinetic energy of the mesh changes by its reconstruction.
void ExpectConserved(
  const MesherOptions& options, const std::function<MesherInput(Ranks&)>& makeInput);

} // namespace testing
} // namespace vfm
