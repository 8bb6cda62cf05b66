/// Blocks of several levels, passed to the C interface and distributed to the ranks in any way,
/// compared with the filter on vtkOverlappingAMR: the results are bitwise identical.
#include "BlockHost.h"
#include "MeshView.h"

#include "vtkOverlappingAMR.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeFractionToHex.h"
#include "vtkVolumeFractionToTet.h"

#include <gtest/gtest.h>

#include <functional>

using namespace vfm;
using namespace vfm::testing;

namespace
{

struct Kind
{
  const char* Name;
  bool Tets, Ids;
  std::vector<std::pair<std::string, std::string>> Options;
  std::function<void(vtkVolumeFractionMeshAlgorithm&)> Set; ///< sets the same options on a filter
};

std::vector<Kind> Kinds()
{
  using Mesher = vtkVolumeFractionMeshAlgorithm;
  const auto method = [](int number)
  {
    return [number](Mesher& mesher)
    { vtkVolumeFractionToTet::SafeDownCast(&mesher)->SetMethod(number); };
  };
  return { { "hexes", false, false, {}, [](Mesher&) {} },
    { "hexes of ids", false, true, {}, [](Mesher&) {} },
    { "hexes across levels", false, false, { { "FineInterfaces", "Off" } },
      [](Mesher& mesher) { mesher.SetFineInterfaces(false); } },
    { "tets by Cells", true, false, { { "Method", "Cells" } },
      method(vtkVolumeFractionToTet::METHOD_CELLS) },
    { "tets by Lattice", true, false, { { "Method", "Lattice" } },
      method(vtkVolumeFractionToTet::METHOD_LATTICE) } };
}

/// Returns the digest of the filter's mesh of all blocks on rank 0;
/// *elements: number of its elements.
std::uint64_t DigestOfFilter(const Kind& kind, const std::vector<Place>& places,
  const Vector3& spacing, std::int64_t* elements = nullptr)
{
  std::uint64_t digest = 0;
  if (MyRank() == 0)
  {
    vtkSmartPointer<vtkVolumeFractionMeshAlgorithm> mesher;
    mesher.TakeReference(kind.Tets
        ? static_cast<vtkVolumeFractionMeshAlgorithm*>(vtkVolumeFractionToTet::New())
        : vtkVolumeFractionToHex::New());
    mesher->SetController(nullptr);
    kind.Set(*mesher);
    if (kind.Ids)
    {
      mesher->SetMaterialIdArray("id");
    }
    else
    {
      mesher->AddVolumeFractionArray("ball");
      mesher->AddVolumeFractionArray("plate");
    }
    mesher->AddStateArray("velocity");
    mesher->SetInputDataObject(MakeOverlapping(places, spacing));
    mesher->Update();
    const MeshView mesh = ViewOf(mesher->GetOutput());
    EXPECT_GT(mesh.Elements, 0);
    digest = Digest(mesh);
    if (elements)
    {
      *elements = mesh.Elements;
    }
  }
  return SumOverRanks(digest);
}

class SculptorBlocks : public ::testing::TestWithParam<int>
{
};

} // namespace

TEST_P(SculptorBlocks, AreThoseOfTheFilter)
{
  const Kind kind = Kinds()[GetParam()];
  std::int64_t elements = 0;
  const std::uint64_t expected = DigestOfFilter(kind, NestedPlaces(), Decimal, &elements);
  Host host;
  for (const auto& option : kind.Options)
  {
    ASSERT_EQ(
      sculptor_set_option(host.Sculptor, option.first.c_str(), option.second.c_str()), SCULPTOR_OK);
  }
  for (Distribute distribution : { Distribute::InTurn, Distribute::InTurnButToTheLast,
         Distribute::FromBehind, Distribute::ToTheLast })
  {
    host.Distribute(
      distribution == Distribute::FromBehind ? CutPlaces() : NestedPlaces(), Decimal, distribution);
    host.HandOver(kind.Ids);
    EXPECT_EQ(host.Mesh(kind.Tets), expected)
      << kind.Name << ", deal " << static_cast<int>(distribution);
  }
  if (MyRank() == 0)
  {
    std::printf("%s: %lld elements, the same in four distributions to %d ranks\n", kind.Name,
      static_cast<long long>(elements), NumberOfRanks());
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, SculptorBlocks, ::testing::Range(0, 5));

TEST(SculptorBlocks, SeveralOfLevelZero)
{
  Host host;
  host.Distribute(CutPlaces(), Binary, Distribute::InTurn);
  host.HandOver();
  EXPECT_EQ(host.Mesh(), DigestOfFilter(Kinds()[0], CutPlaces(), Binary));
}

/// The same sculptor receives another grid each time, then the same grid
/// with other values in place.
TEST(SculptorBlocks, GridsThatChange)
{
  Host host;
  for (const std::vector<Place>& places : { NestedPlaces(), LeafPlaces(), NestedPlaces() })
  {
    host.Distribute(places, Binary, Distribute::InTurn);
    host.HandOver();
    EXPECT_EQ(host.Mesh(), DigestOfFilter(Kinds()[0], places, Binary));
  }
  const std::uint64_t before = host.Mesh();
  for (LevelBlock& block : host.Blocks)
  {
    std::fill(block.Velocity.begin(), block.Velocity.end(), 1.0);
  }
  const std::uint64_t after = host.Mesh();
  EXPECT_NE(after, before);
  EXPECT_EQ(host.Mesh(), after);
}

/// A box of level 0 replaces all blocks, and blocks replace the box.
TEST(SculptorBlocks, OneBoxInstead)
{
  const HostFields fields(MyRank(), NumberOfRanks());
  const auto mesh = [&fields](Host& host)
  {
    const int s = host.Sculptor;
    sculptor_set_box(s, fields.Bounds.data(), fields.Intervals.data());
    sculptor_set_neighbours(s, fields.Neighbours.data());
    sculptor_clear_fields(s);
    sculptor_add_material(s, "ball", fields.Ball.data());
    sculptor_add_state(s, "velocity", 3, fields.Velocity.data());
    return host.Mesh();
  };
  Host fresh, host;
  const std::uint64_t expected = mesh(fresh);
  host.Distribute(NestedPlaces(), Binary, Distribute::InTurn);
  host.HandOver();
  const std::uint64_t blocks = host.Mesh();
  EXPECT_EQ(mesh(host), expected);
  host.HandOver();
  EXPECT_EQ(sculptor_set_neighbours(host.Sculptor, nullptr), SCULPTOR_OK);
  EXPECT_EQ(host.Mesh(), blocks);
}

/// One block of level 0 per rank, with neighbours, gives the same as sculptor_set_box.
TEST(SculptorBlocks, NeighboursOfOneBlock)
{
  const HostFields fields(MyRank(), NumberOfRanks());
  std::uint64_t digests[2];
  for (int asBlock = 0; asBlock < 2; ++asBlock)
  {
    Host host;
    const int s = host.Sculptor;
    if (asBlock)
    {
      sculptor_add_block(s, 0, fields.Bounds.data(), fields.Intervals.data());
    }
    else
    {
      sculptor_set_box(s, fields.Bounds.data(), fields.Intervals.data());
    }
    sculptor_set_neighbours(s, fields.Neighbours.data());
    sculptor_add_material(s, "ball", fields.Ball.data());
    sculptor_add_state(s, "velocity", 3, fields.Velocity.data());
    digests[asBlock] = host.Mesh();
  }
  EXPECT_EQ(digests[0], digests[1]);
}
