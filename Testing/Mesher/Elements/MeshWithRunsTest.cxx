/// Numbers of points and hexes of a mesh that leaves out hexes.
#include "Elements/MeshWithRuns.h"
#include "LabelInput.h"

#include <gtest/gtest.h>

using namespace vfm;
using namespace vfm::testing;

/// Points and hexes follow in the order of their ids; corners of hexes of runs are the nodes of
/// their cells.
TEST(MeshWithRuns, NumbersInTheOrderOfIds)
{
  constexpr Index3 cells{ { 26, 20, 18 } };
  std::vector<int> labels;
  ForCells({ {}, cells }, [&](const Index3& cell) { labels.push_back(cell[0] < 12 ? 1 : 2); });
  Runtime serial;
  CellRuns leftOut;
  const MesherResult made = RunMesher(
    MakeLabelInput({ cells, 0.0, 0.5 }, labels, serial.Group()), MesherOptions(), serial, &leftOut);
  const Mesh& mesh = made.TheMesh;
  const MeshWithRuns whole(mesh, leftOut);
  std::vector<Index> pointIds, hexIds;
  std::vector<Vector3> points;
  whole.ForPoints(
    [&](Index first, Index last)
    {
      for (Index p = first; p < last; ++p)
      {
        EXPECT_EQ(whole.NumberOfPoint(p), static_cast<Index>(points.size()));
        pointIds.push_back(mesh.PointIds[p]);
        points.push_back(mesh.PointAt(p));
      }
    },
    [&](const MeshWithRuns::NodeRun& run)
    {
      EXPECT_EQ(run.Number, static_cast<Index>(points.size()));
      for (Index n = 0; n < run.Count; ++n)
      {
        pointIds.push_back(whole.FirstId(run) + HexIds.PointSlots * n);
        points.push_back(whole.PointAt(run, n));
      }
    });
  double volume = 0.0; // of runs
  whole.ForElements(
    [&](Index first, Index last) {
      hexIds.insert(hexIds.end(), mesh.ElementIds.begin() + first, mesh.ElementIds.begin() + last);
    },
    [&](const CellRuns::Run& run)
    {
      volume += whole.VolumeOf(run);
      for (Index n = 0; n < run.Count; ++n)
      {
        hexIds.push_back(whole.FirstId(run) + HexIds.ElementSlots * n);
      }
    });
  EXPECT_DOUBLE_EQ(volume, 0.125 * static_cast<double>(leftOut.Count()));
  ASSERT_EQ(whole.NumberOfPoints(), static_cast<Index>(pointIds.size()));
  ASSERT_EQ(whole.NumberOfElements(), static_cast<Index>(hexIds.size()));
  EXPECT_GT(pointIds.size(), mesh.PointIds.size());
  EXPECT_TRUE(std::is_sorted(pointIds.begin(), pointIds.end()));
  EXPECT_TRUE(std::is_sorted(hexIds.begin(), hexIds.end()));
  std::size_t hex = 0;
  whole.ForCorners(
    [&](int material, const Index* corners)
    {
      const Index id = hexIds[hex++];
      const Index cell = (id - 1) / HexIds.ElementSlots;
      EXPECT_EQ(material, labels[cell]);
      if (!std::binary_search(mesh.ElementIds.begin(), mesh.ElementIds.end(), id))
      {
        const Vector3 edge = points[corners[6]] - points[corners[0]];
        EXPECT_EQ(edge, (Vector3{ { 0.5, 0.5, 0.5 } }));
        EXPECT_EQ(points[corners[0]][0], 0.5 * static_cast<double>(cell % cells[0]));
      }
    });
}
