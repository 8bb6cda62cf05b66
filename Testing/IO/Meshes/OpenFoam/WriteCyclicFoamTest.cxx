/// Cases of OpenFOAM of periodic meshes: cyclic patches, read by a parser of its own.
#include "FoamReader.h"
#include "LabelInput.h"
#include "Meshes/OpenFoam/WriteFoam.h"
#include "State/ViewMesh.h"

#include <limits>
#include <map>
#include <random>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr Index Width = 8; // cells along each axis

/// Returns the part of a rank of an image of random labels.
MesherInput MakeRandomInput(Ranks& ranks)
{
  const Index3 cells{ { Width, Width, Width } };
  return MakeLabelInput({ cells, 0.0, 1.0 }, RandomLabels(cells, 3), ranks);
}

struct Method
{
  const char* Name;
  ElementKind Elements;
  Sides Kind;
};

/// Writes the mesh of this many ranks.
void WriteCase(int count, const Method& method, const std::string& path, const FoamForm& form)
{
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      RankRuntime runtime(ranks);
      MesherOptions options;
      options.Elements = method.Elements;
      options.PeriodicSides = method.Kind;
      options.Periodic = 7;
      const MesherResult result = RunMesher(MakeRandomInput(ranks), options, runtime);
      WriteFoam(ViewMesh(result.TheMesh, result.State, result.Fields), path, ranks, form);
    });
}

/// Returns the vector between two points, in periods.
Index3 PeriodsBetween(const FoamContent& content, Index from, Index to)
{
  Index3 periods{};
  for (int a = 0; a < 3; ++a)
  {
    const double step = content.Points[3 * to + a] - content.Points[3 * from + a];
    periods[a] = std::llround(step / Width);
    EXPECT_EQ(content.Points[3 * to + a], content.Points[3 * from + a] + Width * periods[a]);
  }
  return periods;
}

/// Returns the periods that the names of the patches state, as x_min to x_max: (1, 0, 0).
Index3 PeriodsOf(const std::string& name)
{
  Index3 periods{};
  for (int a = 0; a < 3; ++a)
  {
    const std::string axis(1, "xyz"[a]);
    periods[a] = name.find(axis + "_min") != std::string::npos ? 1
      : name.find(axis + "_max") != std::string::npos          ? -1
                                                               : 0;
  }
  return periods;
}

const FoamPatchEntry& FindPatch(const FoamContent& content, const std::string& name)
{
  const auto found = std::find_if(content.Patches.begin(), content.Patches.end(),
    [&name](const FoamPatchEntry& patch) { return patch.Name == name; });
  if (found == content.Patches.end())
  {
    throw std::runtime_error("no patch " + name);
  }
  return *found;
}

class CyclicFoam : public ::testing::TestWithParam<Method>
{
};

} // namespace

/// Face i of both patches are translates; both begin at the same point and go around in opposite
/// directions.
TEST_P(CyclicFoam, FacesAreTranslates)
{
  const Folder folder;
  WriteCase(1, this->GetParam(), folder / "mesh.foam", {});
  const FoamContent content = ReadFoam(folder / "");
  std::map<std::string, Index> counts;
  for (const FoamPatchEntry& patch : content.Patches)
  {
    if (patch.Words.at("type") != "cyclic")
    {
      EXPECT_EQ(patch.Words.at("type"), "wall") << patch.Name;
      continue;
    }
    counts[patch.Name] = patch.Count();
    const FoamPatchEntry& other = FindPatch(content, patch.Words.at("neighbourPatch"));
    EXPECT_EQ(other.Words.at("neighbourPatch"), patch.Name);
    ASSERT_EQ(other.Count(), patch.Count());
    for (Index f = 0; f < patch.Count(); ++f)
    {
      const std::vector<Index>& face = content.Faces[patch.First() + f];
      std::vector<Index> copy = content.Faces[other.First() + f];
      std::reverse(copy.begin() + 1, copy.end());
      ASSERT_EQ(face.size(), copy.size());
      for (std::size_t p = 0; p < face.size(); ++p)
      {
        EXPECT_EQ(PeriodsBetween(content, face[p], copy[p]), PeriodsOf(patch.Name));
      }
    }
  }
  for (const char* name : { "x_min", "x_max", "y_min", "y_max", "z_min", "z_max" })
  {
    EXPECT_GT(counts[name], 10) << name;
  }
  EXPECT_EQ(counts.size() > 6, this->GetParam().Kind == Sides::Free); // several axes
}

/// Faces of cyclic patches are in no zone, also between two materials.
TEST_P(CyclicFoam, ZonesHaveInnerFaces)
{
  const Folder folder;
  WriteCase(1, this->GetParam(), folder / "mesh.foam", {});
  const FoamContent content = ReadFoam(folder / "");
  ASSERT_EQ(content.FaceZones.size(), 1u);
  const FoamZoneEntry& zone = content.FaceZones[0];
  EXPECT_TRUE(std::is_sorted(zone.Members.begin(), zone.Members.end()));
  Index firstOfPatches = std::numeric_limits<Index>::max();
  for (const FoamPatchEntry& patch : content.Patches)
  {
    firstOfPatches = std::min(firstOfPatches, patch.First());
  }
  ASSERT_GT(zone.Members.size(), 10u);
  EXPECT_LT(zone.Members.back(), firstOfPatches);
}

TEST_P(CyclicFoam, WholeMeshOfThreeRanks)
{
  const Folder one, three;
  WriteCase(1, this->GetParam(), one / "mesh.foam", {});
  WriteCase(3, this->GetParam(), three / "mesh.foam", { true, false });
  for (const char* name : { "points", "faces", "owner", "neighbour", "boundary", "faceZones" })
  {
    const std::string file = std::string("constant/polyMesh/") + name;
    EXPECT_TRUE(ReadBytes(one / file) == ReadBytes(three / file)) << name;
  }
}

/// Faces of parts are those of the whole mesh that faceProcAddressing names. Cyclic faces whose
/// copy is on another rank are in patches of type processorCyclic, in the same order on both ranks.
TEST_P(CyclicFoam, RanksWriteTheDecomposedCase)
{
  constexpr int count = 3;
  const Folder whole, folder;
  WriteCase(1, this->GetParam(), whole / "mesh.foam", {});
  WriteCase(count, this->GetParam(), folder / "mesh.foam", {});
  const FoamContent content = ReadFoam(whole / "");
  std::vector<int> seen(content.Faces.size());
  std::map<std::string, std::vector<Index>> numbers; // in the whole mesh, of processorCyclic faces
  for (int rank = 0; rank < count; ++rank)
  {
    const FoamContent part = ReadFoam(folder / ("processor" + std::to_string(rank)));
    const std::vector<Index>&faces = part.Addressing.at("face"),
          &points = part.Addressing.at("point");
    for (std::size_t f = 0; f < part.Faces.size(); ++f)
    {
      std::vector<Index> face;
      for (Index point : part.Faces[f])
      {
        face.push_back(points[point]);
      }
      if (faces[f] < 0)
      {
        std::reverse(face.begin() + 1, face.end());
      }
      ++seen[std::abs(faces[f]) - 1];
      ASSERT_EQ(face, content.Faces[std::abs(faces[f]) - 1]) << f;
    }
    for (const FoamPatchEntry& patch : part.Patches)
    {
      if (patch.Words.at("type") == "processorCyclic")
      {
        EXPECT_EQ(patch.Name,
          "procBoundary" + std::to_string(rank) + "to" + patch.Words.at("neighbProcNo") +
            "through" + patch.Words.at("referPatch"));
        const FoamPatchEntry& cyclic = FindPatch(content, patch.Words.at("referPatch"));
        for (Index f = 0; f < patch.Count(); ++f)
        {
          numbers[patch.Name].push_back(faces[patch.First() + f] - 1 - cyclic.First());
        }
        const std::string back = "procBoundary" + patch.Words.at("neighbProcNo") + "to" +
          std::to_string(rank) + "through" + cyclic.Words.at("neighbourPatch");
        if (numbers.count(back) > 0)
        {
          EXPECT_EQ(numbers[patch.Name], numbers[back]);
        }
      }
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 0), 0);
  EXPECT_GE(numbers.size(), 2u);
  EXPECT_EQ(numbers.size() % 2, 0u);
}

INSTANTIATE_TEST_SUITE_P(Methods, CyclicFoam,
  ::testing::Values(Method{ "FlatHexes", ElementKind::Hexes, Sides::Flat },
    Method{ "FreeHexes", ElementKind::Hexes, Sides::Free },
    Method{ "FlatTets", ElementKind::Tets, Sides::Flat }),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(CyclicFoamErrors, JoinedSides)
{
  const Folder folder;
  const Method joined{ "", ElementKind::Hexes, Sides::Joined };
  EXPECT_THROW(WriteCase(1, joined, folder / "mesh.foam", {}), InputError);
}
