/// Meshes that leave out hexes far from interfaces, together with these, equal meshes of all hexes.
#include "Meshes/Files/RunValues.h"
#include "LabelInput.h"
#include "Report/MeshSummary.h"
#include "State/ViewMesh.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Returns labels: a ball of material 1 in a slab of material 2 at the side y = 0, a small ball of
/// material 1 apart from it, and void.
std::vector<int> MakeLabels(const Index3& n)
{
  std::vector<int> labels;
  ForCells({ {}, n },
    [&](const Index3& cell)
    {
      const auto isIn = [&](const Vector3& centre, double radius)
      {
        double distance = 0.0;
        for (int a = 0; a < 3; ++a)
        {
          distance += (cell[a] + 0.5 - centre[a]) * (cell[a] + 0.5 - centre[a]);
        }
        return distance < radius * radius;
      };
      const bool isBall =
        isIn({ { 15.0, 14.0, 16.0 } }, 10.5) || isIn({ { 30.0, 27.0, 24.0 } }, 5.0);
      labels.push_back(isBall ? 1 : cell[1] < 12 ? 2 : 0);
    });
  return labels;
}

template <class T>
std::string BytesOf(const T* values, Index count)
{
  return { reinterpret_cast<const char*>(values), sizeof(T) * static_cast<std::size_t>(count) };
}

/// Returns the bytes that a function adds.
template <class Add>
std::string Collect(const Add& add)
{
  std::string bytes;
  add([&bytes](std::string_view part) { bytes += part; });
  return bytes;
}

void ExpectEqual(const PartSizes& a, const PartSizes& b)
{
  EXPECT_EQ(a.Material, b.Material);
  EXPECT_EQ(a.Elements, b.Elements);
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.MinimumQuality, b.MinimumQuality);
  EXPECT_EQ(a.MeanQuality, b.MeanQuality);
  EXPECT_NEAR(a.Volume, b.Volume, 1e-12 * b.Volume);
}

void ExpectEqual(const MeshSummary& a, const MeshSummary& b)
{
  ASSERT_EQ(a.Materials.size(), b.Materials.size());
  ASSERT_EQ(a.LargestFragments.size(), b.LargestFragments.size());
  for (std::size_t m = 0; m < a.Materials.size(); ++m)
  {
    ExpectEqual(a.Materials[m], b.Materials[m]);
    EXPECT_EQ(a.Materials[m].Name, b.Materials[m].Name);
    EXPECT_EQ(a.Materials[m].TargetVolume, b.Materials[m].TargetVolume);
  }
  for (std::size_t f = 0; f < a.LargestFragments.size(); ++f)
  {
    ExpectEqual(a.LargestFragments[f], b.LargestFragments[f]);
    EXPECT_EQ(a.LargestFragments[f].Id, b.LargestFragments[f].Id);
  }
  ExpectEqual(a.Total, b.Total);
  EXPECT_EQ(a.Total.TargetVolume, b.Total.TargetVolume);
}

void ExpectEqualMeshes(const MeshData& all, const MeshData& stored, const MeshWithRuns& whole)
{
  ASSERT_EQ(whole.NumberOfPoints(), all.NumberOfPoints);
  ASSERT_EQ(whole.NumberOfElements(), all.NumberOfElements);
  EXPECT_LT(stored.NumberOfElements, all.NumberOfElements);
  EXPECT_EQ(Collect([&](const AddBytes& add) { AddPoints(whole, add); }),
    BytesOf(all.Points, 3 * all.NumberOfPoints));
  EXPECT_EQ(Collect([&](const AddBytes& add) { AddCorners(whole, add); }),
    BytesOf(all.Elements, 8 * all.NumberOfElements));
  ASSERT_EQ(stored.PointArrays.size(), all.PointArrays.size());
  ASSERT_EQ(stored.ElementArrays.size(), all.ElementArrays.size());
  for (const MeshArray& array : stored.PointArrays)
  {
    EXPECT_EQ(Collect([&](const AddBytes& add) { AddPointValues(whole, array, add); }),
      BytesOf(static_cast<const char*>(FindArray(all.PointArrays, array.Name)->Values),
        WidthOfType(array.Type) * all.NumberOfPoints))
      << array.Name;
  }
  for (const MeshArray& array : stored.ElementArrays)
  {
    EXPECT_EQ(Collect([&](const AddBytes& add) { AddElementValues(whole, array, add); }),
      BytesOf(static_cast<const char*>(FindArray(all.ElementArrays, array.Name)->Values),
        WidthOfType(array.Type) * all.NumberOfElements))
      << array.Name;
  }
  ASSERT_EQ(stored.Fields.size(), all.Fields.size());
  for (std::size_t f = 0; f < all.Fields.size(); ++f)
  {
    EXPECT_EQ(stored.Fields[f].Name, all.Fields[f].Name);
    EXPECT_EQ(stored.Fields[f].Values, all.Fields[f].Values) << all.Fields[f].Name;
  }
}

/// Meshes with all hexes and without, and compares them.
void CompareMeshes(const std::vector<int>& labels, const Index3& n, const MesherOptions& options)
{
  Runtime serial;
  const MesherInput input = MakeLabelInput({ n, -3.0, 0.375 }, labels, serial.Group());
  const MesherResult all = RunMesher(input, options, serial);
  CellRuns leftOut;
  const MesherResult part = RunMesher(input, options, serial, &leftOut);
  ASSERT_GT(leftOut.Count(), 0);
  const MeshData allData = ViewMesh(all.TheMesh, all.State, all.Fields),
                 partData = ViewMesh(part.TheMesh, part.State, part.Fields);
  const MeshWithRuns whole(part.TheMesh, leftOut);
  ExpectEqualMeshes(allData, partData, whole);
  EXPECT_EQ(part.MaterialFields.size(), all.MaterialFields.size());
  for (std::size_t f = 0; f < all.MaterialFields.size(); ++f)
  {
    EXPECT_EQ(part.MaterialFields[f].Values, all.MaterialFields[f].Values);
  }
  ExpectEqual(Summarise(partData, serial.Group(), &whole), Summarise(allData, serial.Group()));
}

constexpr Index3 Cells{ { 40, 36, 33 } };

} // namespace

TEST(RunValues, EqualsTheMeshOfAllHexes)
{
  MesherOptions options;
  options.LabelSmoothing = 4;
  CompareMeshes(MakeLabels(Cells), Cells, options);
  options.MeshVoid = true;
  CompareMeshes(MakeLabels(Cells), Cells, options);
}

TEST(RunValues, WithoutQualityOrMoves)
{
  MesherOptions options;
  options.ComputeQuality = false;
  CompareMeshes(MakeLabels(Cells), Cells, options);
  options.ComputeQuality = true;
  options.Smoothing = SmoothingMethod::Off;
  CompareMeshes(MakeLabels(Cells), Cells, options);
}

/// Labels without order in a corner: split nodes of many labels, narrow void, small fragments.
TEST(RunValues, WithNoiseInACorner)
{
  std::vector<int> labels(Cells[0] * Cells[1] * Cells[2], 2);
  const std::vector<int> noise = RandomLabels({ { 12, 12, 12 } }, 7);
  ForCells({ {}, { { 12, 12, 12 } } },
    [&](const Index3& cell) {
      labels[IndexInBox({ {}, Cells }, cell)] = noise[IndexInBox({ {}, { { 12, 12, 12 } } }, cell)];
    });
  CompareMeshes(labels, Cells, MesherOptions());
}

/// Ids of materials are those of the user.
TEST(RunValues, HasTheLabelsOfTheInput)
{
  std::vector<int> labels = MakeLabels(Cells);
  for (int& label : labels)
  {
    label = label == 0 ? 0 : 100 * label - 3;
  }
  CompareMeshes(labels, Cells, MesherOptions());
}
