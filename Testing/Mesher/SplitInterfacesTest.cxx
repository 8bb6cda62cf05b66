/// Nodes of split interfaces, counted by another algorithm, and their cohesive elements.
#include "Elements/ElementFaces.h"
#include "LabelInput.h"
#include "Modify/MaterialPairs.h"
#include "RankFields.h"
#include "Report/ElementMoments.h"
#include "Report/Sets/SplitFaces.h"
#include "State/ViewMesh.h"
#include "ThreadRanks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <mutex>
#include <random>
#include <set>

using namespace vfm;
using namespace vfm::testing;

namespace
{

constexpr double LabelWidth = 0.3; // coordinates are not exact

/// Returns grains around random points of a periodic box, with labels from 1.
std::vector<int> MakeGrains(const Index3& n, int grains)
{
  std::mt19937 random(11);
  std::vector<Vector3> seeds(grains);
  for (Vector3& seed : seeds)
  {
    for (int a = 0; a < 3; ++a)
    {
      seed[a] = static_cast<double>(random() % 1000) * 1e-3 * static_cast<double>(n[a]);
    }
  }
  std::vector<int> labels;
  for (Index cell = 0; cell < n[0] * n[1] * n[2]; ++cell)
  {
    const Index3 at{ { cell % n[0], cell / n[0] % n[1], cell / (n[0] * n[1]) } };
    double least = 1e30;
    int label = 0;
    for (int g = 0; g < grains; ++g)
    {
      double distance = 0.0;
      for (int a = 0; a < 3; ++a)
      {
        const double length = static_cast<double>(n[a]);
        const double d = std::abs(static_cast<double>(at[a]) + 0.5 - seeds[g][a]);
        distance += std::min(d, length - d) * std::min(d, length - d);
      }
      label = distance < least ? g + 1 : label;
      least = std::min(least, distance);
    }
    labels.push_back(label);
  }
  return labels;
}

/// A cohesive element by ids.
struct Cohesive
{
  std::string Block;
  std::vector<Index> Points;
  bool operator==(const Cohesive& other) const
  {
    return this->Block == other.Block && this->Points == other.Points;
  }
};

/// The mesh of all ranks by global ids.
struct WholeMesh
{
  std::map<Index, Vector3> Points;
  std::map<Index, Index> Originals, Partners;
  std::map<Index, std::vector<Index>> Elements;
  std::map<Index, int> Materials;
  std::map<Index, Cohesive> CohesiveElements;
  double Volume = 0.0;
  Index AddedNodes = -1;
  int Corners = 0;

  /// Collective.
  void Add(const MesherResult& result, Ranks& ranks, std::mutex& mutex)
  {
    const MeshData mesh = ViewMesh(result.TheMesh, result.State, result.Fields);
    const std::vector<CohesiveBlock> blocks = FindCohesiveBlocks(mesh, ranks);
    const std::lock_guard<std::mutex> lock(mutex);
    EXPECT_TRUE(std::is_sorted(mesh.PointIds, mesh.PointIds + mesh.NumberOfPoints));
    this->Corners = mesh.Corners;
    for (Index p = 0; p < mesh.NumberOfPoints; ++p)
    {
      const Index id = mesh.PointIds[p];
      const Vector3 x = result.TheMesh.PointAt(p);
      const auto found = this->Points.emplace(id, x);
      EXPECT_EQ(found.first->second, x);
      this->Set(this->Originals, id, mesh.UnsplitPointIds()[p]);
      this->Set(this->Partners, id, mesh.PeriodicPartner ? mesh.PeriodicPartner[p] : id);
    }
    for (Index e = 0; e < mesh.NumberOfElements; ++e)
    {
      const Index id = mesh.ElementIds[e];
      this->Materials[id] = mesh.Material[e];
      for (int c = 0; c < mesh.Corners; ++c)
      {
        this->Elements[id].push_back(mesh.PointIds[mesh.Element(e)[c]]);
      }
    }
    for (const CohesiveBlock& block : blocks)
    {
      const std::size_t corners = CohesiveCorners(mesh);
      EXPECT_EQ(block.Points.size(), corners * block.Ids.size());
      for (std::size_t e = 0; e < block.Ids.size(); ++e)
      {
        std::vector<Index> ids;
        for (std::size_t c = 0; c < corners; ++c)
        {
          ids.push_back(mesh.PointIds[block.Points[corners * e + c]]);
        }
        EXPECT_TRUE(
          this->CohesiveElements.emplace(block.Ids[e], Cohesive{ block.Name, ids }).second);
      }
    }
    for (const ElementMoments& element : FindElementMoments(mesh))
    {
      this->Volume += element.Volume;
    }
    const std::vector<double> added = NumbersOfField(mesh.Fields, "AddedNodes");
    this->AddedNodes = added.empty() ? -1 : static_cast<Index>(added[0]);
  }

  Index OriginalOf(Index id) const { return this->Originals.at(id); }

  /// Returns the faces of an element as points before the split.
  std::vector<std::set<Index>> FacesOf(Index element) const
  {
    const ElementFaces table(this->Corners);
    std::vector<std::set<Index>> faces;
    for (int side = 0; side < table.Count; ++side)
    {
      faces.emplace_back();
      for (Index id : table.PointsOf(this->Elements.at(element).data(), side))
      {
        if (id >= 0)
        {
          faces.back().insert(this->OriginalOf(id));
        }
      }
    }
    return faces;
  }

private:
  static void Set(std::map<Index, Index>& to, Index id, Index value)
  {
    EXPECT_EQ(to.emplace(id, value).first->second, value);
  }
};

WholeMesh MakeWhole(
  const Index3& n, const std::vector<int>& labels, const MesherOptions& options, int count = 1)
{
  WholeMesh whole;
  std::mutex mutex;
  RunOnRanks(count,
    [&](ThreadRanks& ranks)
    {
      RankRuntime runtime(ranks);
      MesherInput input = MakeLabelInput({ n, 0.1, LabelWidth }, labels, ranks);
      whole.Add(RunMesher(input, options, runtime), ranks, mutex);
    });
  return whole;
}

using IsCut = bool (*)(int, int); // of two different materials

/// Checks the nodes of every element against a flood over uncut faces around each node before the
/// split: all elements that the flood reaches have the same copy, others another one.
void CheckCopies(const WholeMesh& mesh, IsCut isCut)
{
  std::map<std::set<Index>, std::vector<Index>> elementsOfFace;
  std::map<Index, std::set<Index>> elementsOfNode;
  for (const auto& element : mesh.Elements)
  {
    for (const std::set<Index>& face : mesh.FacesOf(element.first))
    {
      elementsOfFace[face].push_back(element.first);
    }
    for (Index id : element.second)
    {
      elementsOfNode[mesh.OriginalOf(id)].insert(element.first);
    }
  }
  const auto copyIn = [&](Index element, Index node)
  {
    for (Index id : mesh.Elements.at(element))
    {
      if (mesh.OriginalOf(id) == node)
      {
        return id;
      }
    }
    return Index(-1);
  };
  Index next = elementsOfNode.rbegin()->first;
  for (auto& [node, around] : elementsOfNode)
  {
    bool isFirst = true;
    while (!around.empty()) // one group each time, by its lowest element
    {
      std::vector<Index> reached{ *around.begin() };
      const Index copy = copyIn(reached[0], node);
      ASSERT_EQ(copy, isFirst ? node : ++next);
      isFirst = false;
      around.erase(around.begin());
      for (std::size_t r = 0; r < reached.size(); ++r)
      {
        const Index element = reached[r];
        ASSERT_EQ(copyIn(element, node), copy);
        for (const std::set<Index>& face : mesh.FacesOf(element))
        {
          for (Index other : face.count(node) > 0 ? elementsOfFace[face] : std::vector<Index>())
          {
            const int a = mesh.Materials.at(element), b = mesh.Materials.at(other);
            if (around.count(other) > 0 && (a == b || !isCut(a, b)))
            {
              around.erase(other);
              reached.push_back(other);
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(next, elementsOfNode.rbegin()->first + mesh.AddedNodes);
  EXPECT_EQ(static_cast<Index>(mesh.Points.size()),
    static_cast<Index>(elementsOfNode.size()) + mesh.AddedNodes);
}

bool IsAlwaysCut(int, int)
{
  return true;
}

/// The choice of SomePairs.
bool IsSometimesCut(int a, int b)
{
  const std::array<int, 2> pair{ { std::min(a, b), std::max(a, b) } };
  using Pair = std::array<int, 2>;
  return pair[0] == 1 || pair == Pair{ { 2, 3 } } || pair == Pair{ { 40, 50 } } ||
    pair == Pair{ { 7, 9 } } || (pair[0] > 20 && pair[0] % 2 == 0 && pair[1] == pair[0] + 1);
}

const std::string SomePairs = []
{
  std::string text = "1/*, 3/2, 40/50, 7 / 9";
  for (int g = 22; g < 100; g += 2)
  {
    text += "," + std::to_string(g) + "/" + std::to_string(g + 1);
  }
  return text;
}();

constexpr Index3 GrainCells{ { 15, 14, 16 } };
const std::vector<int>& Grains()
{
  static const std::vector<int> labels = MakeGrains(GrainCells, 100);
  return labels;
}

class SplitGrains : public ::testing::TestWithParam<ElementKind>
{
protected:
  MesherOptions Options(const std::string& pairs) const
  {
    MesherOptions options;
    options.Elements = this->GetParam();
    options.SplitInterfaces = pairs;
    options.SplitConnection = ConnectionKind::Cohesive;
    return options;
  }

  /// Returns the mesh with all interfaces split, made once for all tests.
  const WholeMesh& AllSplit() const
  {
    static std::map<ElementKind, WholeMesh> meshes;
    const ElementKind elements = this->GetParam();
    if (meshes.count(elements) == 0)
    {
      meshes[elements] = MakeWhole(GrainCells, Grains(), this->Options("all"));
    }
    return meshes[elements];
  }
};

using Vector = std::array<double, 3>;

Vector Area(const WholeMesh& mesh, const Index* ids, int corners)
{
  Vector area{};
  const Vector3 first = mesh.Points.at(ids[0]);
  for (int c = 1; c + 1 < corners; ++c)
  {
    const Vector3 a = mesh.Points.at(ids[c]) - first, b = mesh.Points.at(ids[c + 1]) - first;
    for (int i = 0; i < 3; ++i)
    {
      area[i] += 0.5 * (a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
    }
  }
  return area;
}

} // namespace

TEST_P(SplitGrains, EachGroupOfElementsHasItsCopy)
{
  const WholeMesh before = MakeWhole(GrainCells, Grains(), this->Options(""));
  EXPECT_EQ(before.AddedNodes, -1);
  const WholeMesh& all = this->AllSplit();
  CheckCopies(all, IsAlwaysCut);
  EXPECT_GT(all.AddedNodes, 3000);
  const WholeMesh some = MakeWhole(GrainCells, Grains(), this->Options(SomePairs));
  CheckCopies(some, IsSometimesCut);
  EXPECT_GT(some.AddedNodes, 50);
  for (const WholeMesh* mesh : { &all, &some })
  {
    EXPECT_EQ(mesh->Volume, before.Volume);
    EXPECT_EQ(mesh->Materials, before.Materials);
    for (const auto& [id, x] : mesh->Points)
    {
      EXPECT_EQ(x, before.Points.at(mesh->OriginalOf(id)));
    }
  }
}

/// Each face between two grains has one cohesive element from the lower to the higher grain.
TEST_P(SplitGrains, CohesiveElementsFillTheFaces)
{
  const WholeMesh& mesh = this->AllSplit();
  std::map<std::set<Index>, std::set<int>> grains; // of each face
  std::map<int, std::set<Index>> nodes;            // of each grain
  for (const auto& [id, points] : mesh.Elements)
  {
    for (const std::set<Index>& face : mesh.FacesOf(id))
    {
      grains[face].insert(mesh.Materials.at(id));
    }
    nodes[mesh.Materials.at(id)].insert(points.begin(), points.end());
  }
  std::size_t inner = 0;
  for (const auto& face : grains)
  {
    inner += face.second.size() == 2 ? 1 : 0;
  }
  EXPECT_EQ(mesh.CohesiveElements.size(), inner);
  Index next = mesh.Elements.rbegin()->first;
  const int corners = ShapeOf(mesh.Corners).CornersOfFace;
  for (const auto& [id, element] : mesh.CohesiveElements)
  {
    ASSERT_EQ(id, ++next);
    std::set<Index> face;
    for (int c = 0; c < corners; ++c)
    {
      const Index first = element.Points[c], second = element.Points[c + corners];
      ASSERT_NE(first, second);
      ASSERT_EQ(mesh.OriginalOf(first), mesh.OriginalOf(second));
      face.insert(mesh.OriginalOf(first));
    }
    const std::set<int>& pair = grains.at(face);
    const int low = *pair.begin(), high = *pair.rbegin();
    ASSERT_EQ(element.Block,
      "Material " + std::to_string(low) + "_to_Material " + std::to_string(high) + "_cohesive");
    for (int c = 0; c < corners; ++c)
    {
      ASSERT_EQ(nodes.at(low).count(element.Points[c]), 1u);
      ASSERT_EQ(nodes.at(high).count(element.Points[c + corners]), 1u);
    }
    grains.erase(face); // each face once
  }
}

TEST_P(SplitGrains, CohesiveElementsPointToTheHigherGrain)
{
  const WholeMesh& mesh = this->AllSplit();
  const int corners = ShapeOf(mesh.Corners).CornersOfFace;
  std::map<std::vector<Index>, Index> elementOfFace; // outward faces, from their lowest point
  const auto rotated = [](std::vector<Index> ids)
  {
    std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
    return ids;
  };
  for (const auto& [id, points] : mesh.Elements)
  {
    const ElementFaces table(mesh.Corners);
    for (int side = 0; side < table.Count; ++side)
    {
      const FaceIds face = table.PointsOf(points.data(), side);
      elementOfFace[rotated({ face.begin(), face.begin() + corners })] = id;
    }
  }
  for (const auto& [id, element] : mesh.CohesiveElements)
  {
    const std::vector<Index> first(element.Points.begin(), element.Points.begin() + corners);
    std::vector<Index> second(element.Points.begin() + corners, element.Points.end());
    ASSERT_EQ(Area(mesh, first.data(), corners), Area(mesh, second.data(), corners));
    std::reverse(second.begin(), second.end());
    // The first face is counterclockwise seen from outside of its element, the second clockwise.
    ASSERT_EQ(elementOfFace.count(rotated(first)), 1u);
    ASSERT_EQ(elementOfFace.count(rotated(second)), 1u);
    ASSERT_LT(mesh.Materials.at(elementOfFace.at(rotated(first))),
      mesh.Materials.at(elementOfFace.at(rotated(second))));
  }
}

TEST_P(SplitGrains, RanksGiveTheSameMesh)
{
  const WholeMesh& alone = this->AllSplit();
  for (int count : { 2, 3 })
  {
    const WholeMesh joined = MakeWhole(GrainCells, Grains(), this->Options("all"), count);
    EXPECT_TRUE(joined.Points == alone.Points);
    EXPECT_TRUE(joined.Originals == alone.Originals);
    EXPECT_TRUE(joined.Elements == alone.Elements);
    EXPECT_TRUE(joined.CohesiveElements == alone.CohesiveElements);
    EXPECT_EQ(joined.AddedNodes, alone.AddedNodes);
  }
}

/// The nodes at the tips of splits are those of several ranks.
TEST_P(SplitGrains, RanksGiveTheSameTips)
{
  const WholeMesh alone = MakeWhole(GrainCells, Grains(), this->Options(SomePairs));
  const WholeMesh joined = MakeWhole(GrainCells, Grains(), this->Options(SomePairs), 3);
  EXPECT_TRUE(joined.Points == alone.Points);
  EXPECT_TRUE(joined.Elements == alone.Elements);
  EXPECT_TRUE(joined.CohesiveElements == alone.CohesiveElements);
}

INSTANTIATE_TEST_SUITE_P(Elements, SplitGrains,
  ::testing::Values(ElementKind::Hexes, ElementKind::Tets),
  [](const auto& info) { return info.param == ElementKind::Hexes ? "Hexes" : "Tets"; });

/// The mesh with Joined sides needs no partners: its nodes are the pairs of the mesh with Free
/// sides.
TEST(SplitPeriodic, PartnersAreTheNodesOfJoinedSides)
{
  const std::vector<int> labels = MakeGrains(GrainCells, 30);
  MesherOptions options;
  options.SplitInterfaces = "all";
  options.Periodic = 7;
  options.PeriodicSides = Sides::Joined;
  const WholeMesh joined = MakeWhole(GrainCells, labels, options);
  CheckCopies(joined, IsAlwaysCut);
  options.PeriodicSides = Sides::Free;
  for (int count : { 1, 3 })
  {
    const WholeMesh free = MakeWhole(GrainCells, labels, options, count);
    ASSERT_EQ(free.Elements.size(), joined.Elements.size());
    std::map<Index, Index> nodeOf, partnerOf; // of partners, and of joined nodes
    for (const auto& [id, points] : free.Elements)
    {
      for (std::size_t c = 0; c < points.size(); ++c)
      {
        const Index partner = free.Partners.at(points[c]), node = joined.Elements.at(id)[c];
        ASSERT_LE(partner, points[c]);
        ASSERT_EQ(nodeOf.emplace(partner, node).first->second, node);
        ASSERT_EQ(partnerOf.emplace(node, partner).first->second, partner);
      }
    }
    EXPECT_EQ(nodeOf.size(), joined.Points.size());
  }
}

TEST(SplitPeriodic, CopiesAreExactTranslates)
{
  const std::vector<int> labels = MakeGrains(GrainCells, 30);
  for (ElementKind elements : { ElementKind::Hexes, ElementKind::Tets })
  {
    MesherOptions options;
    options.Elements = elements;
    options.SplitInterfaces = "all";
    options.SplitConnection = ConnectionKind::Cohesive;
    options.Periodic = 5; // x and z
    const WholeMesh alone = MakeWhole(GrainCells, labels, options);
    std::size_t pairs = 0;
    for (const auto& [id, partner] : alone.Partners)
    {
      const Vector3 &x = alone.Points.at(id), &y = alone.Points.at(partner);
      for (int a = 0; a < 3; ++a)
      {
        const double period = a == 1 ? 0.0 : LabelWidth * static_cast<double>(GrainCells[a]);
        const double distance = std::abs(x[a] - y[a]);
        EXPECT_NEAR(distance, distance > 0.5 * period ? period : 0.0, 1e-12);
      }
      pairs += id != partner ? 1 : 0;
    }
    EXPECT_GT(pairs, 500u);
    const WholeMesh ranks = MakeWhole(GrainCells, labels, options, 3);
    EXPECT_TRUE(ranks.Partners == alone.Partners);
    EXPECT_TRUE(ranks.Points == alone.Points);
  }
}

TEST(MaterialPairs, AreNamesOrIds)
{
  const std::map<int, std::string> names{ { 0, "Void" }, { 1, "steel" }, { 2, "a/b" },
    { 30, "copper" } };
  const MaterialPairs pairs("SplitInterfaces", "steel/copper, 2/0", names);
  EXPECT_TRUE(pairs.Contains(1, 30));
  EXPECT_TRUE(pairs.Contains(30, 1));
  EXPECT_TRUE(pairs.Contains(0, 2));
  EXPECT_FALSE(pairs.Contains(1, 2));
  EXPECT_FALSE(pairs.Contains(1, 1));
  const MaterialPairs named("SplitInterfaces", "a/b / *", names);
  EXPECT_TRUE(named.Contains(30, 2));
  EXPECT_FALSE(named.Contains(30, 1));
  const MaterialPairs all("SplitInterfaces", "All", names);
  EXPECT_TRUE(all.Contains(30, 0));
  EXPECT_FALSE(all.Contains(30, 30));
}

TEST(MaterialPairs, RejectsOthers)
{
  const std::map<int, std::string> names{ { 0, "Void" }, { 1, "steel" }, { 3, "copper" } };
  for (const char* text : { "steel", "steel/lead", "1/2", "steel/1", "1/3,", "1-3" })
  {
    try
    {
      MaterialPairs("SplitInterfaces", text, names);
      ADD_FAILURE() << text;
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find("steel (1), copper (3)."), std::string::npos);
    }
  }
}
