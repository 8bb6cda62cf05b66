/// Data passed to Catalyst 2: every box, field, level, number and time, in the host's memory; and
/// the error message if an implementation fails.
#include "CatalystAdaptor.h"
#include "CatalystDouble.h"

#include <catalyst_conduit_blueprint.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>

namespace
{

using conduit_cpp::Node;

/// Receives each call for the current test.
std::function<catalyst_status(const std::string& call, const Node& node)> receiver;

} // namespace

catalyst_status ReceiveFromCatalyst(const char* call, const conduit_node* node)
{
  return receiver(call, conduit_cpp::cpp_node(const_cast<conduit_node*>(node)));
}

namespace vfm
{
namespace testing
{
namespace
{

constexpr Vector3 Origin{ { -0.7, 0.3, 2.1 } }, Spacing{ { 0.1, 0.125, 0.11 } };
constexpr int Failed = 102; // a status of ParaView

/// A box of the grid of 4 x 4 x 2 cells: its halves are level 0; level 1 covers [1,3) x [1,3) x
/// [0,1). With three ranks, the first has two boxes and the last none.
struct Place
{
  int Level;
  IndexBox Cells;
  int Rank;
};
const Place Places[] = { { 0, { { { 0, 0, 0 } }, { { 2, 4, 2 } } }, 0 },
  { 0, { { { 2, 0, 0 } }, { { 4, 4, 2 } } }, 1 }, { 1, { { { 2, 2, 0 } }, { { 6, 6, 2 } } }, 0 } };

template <class Value>
std::vector<Value> Count(Index size, Value first)
{
  std::vector<Value> values(size);
  std::iota(values.begin(), values.end(), first);
  return values;
}

struct Box
{
  explicit Box(std::size_t place) :
    Where(Places[place]),
    Doubles(Count(this->Cells(), 0.5 * place)),
    Floats(Count(this->Cells(), 0.25f)),
    Ints(Count(this->Cells(), -3)),
    Bytes(Count<unsigned char>(this->Cells(), 7)),
    Vectors(Count(3 * this->Cells(), 1.5))
  {
  }
  Index Cells() const { return this->Where.Cells.NumberOfCells(); }
  HostBox Describe() const
  {
    return { this->Where.Cells,
      { MakeHostArray("ball", this->Doubles.data()), MakeHostArray("plate", this->Floats.data()),
        MakeHostArray("id", this->Ints.data()), MakeHostArray("marks", this->Bytes.data()),
        MakeHostArray("rate [m/s]", this->Vectors.data(), 3) },
      this->Where.Level };
  }

  Place Where;
  std::vector<double> Doubles;
  std::vector<float> Floats;
  std::vector<int> Ints;
  std::vector<unsigned char> Bytes;
  std::vector<double> Vectors;
};

class CatalystNodes : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    MPI_Comm_rank(MPI_COMM_WORLD, &Rank);
    MPI_Comm_size(MPI_COMM_WORLD, &Ranks);
    receiver = [](const std::string& call, const Node& node)
    {
      EXPECT_EQ(call, "initialize");
      Start.set_node(node);
      return catalyst_status_ok;
    };
    const std::vector<std::string> scripts{ VFM_SOURCE "/Examples/catalyst_mesh.py",
      "/no/such/script.py" };
    Catalyst = std::make_unique<CatalystAdaptor>(MPI_COMM_WORLD, scripts);
  }
  static void TearDownTestSuite()
  {
    int ended = 0;
    receiver = [&ended](const std::string& call, const Node&)
    {
      ended += call == "finalize";
      return catalyst_status_ok;
    };
    Catalyst.reset();
    EXPECT_EQ(ended, 1);
  }

  CatalystNodes()
  {
    for (std::size_t p = 0; p < std::size(Places); ++p)
    {
      if (Places[p].Rank % Ranks == Rank)
      {
        this->Boxes.emplace_back(p);
      }
    }
  }
  HostGrid Describe() const
  {
    HostGrid grid{ Origin, Spacing, { { 4, 4, 2 } }, {} };
    for (const Box& box : this->Boxes)
    {
      grid.Boxes.push_back(box.Describe());
    }
    return grid;
  }
  /// Returns whether the step succeeded. Counts the calls and passes their data to `look`.
  bool Process(
    const HostGrid& grid, int step, const std::function<catalyst_status(const Node&)>& look)
  {
    this->Calls = 0;
    receiver = [&](const std::string& call, const Node& node)
    {
      EXPECT_EQ(call, "execute");
      ++this->Calls;
      return look(node);
    };
    return Catalyst->Process(grid, 0.125 * step, step, { { "Fragments", 2.0 } }, step == 3);
  }

  static std::unique_ptr<CatalystAdaptor> Catalyst;
  static Node Start;
  static int Rank, Ranks;
  std::vector<Box> Boxes;
  int Calls = 0;
};

std::unique_ptr<CatalystAdaptor> CatalystNodes::Catalyst;
Node CatalystNodes::Start;
int CatalystNodes::Rank, CatalystNodes::Ranks;

constexpr const char* LeftOut = "Script /no/such/script.py cannot be read.";

TEST_F(CatalystNodes, StartReportsScriptsAndCommunicator)
{
  EXPECT_EQ(Start["catalyst/scripts"].number_of_children(), 1);
  EXPECT_EQ(Start["catalyst/scripts/script0/filename"].as_string(),
    VFM_SOURCE "/Examples/catalyst_mesh.py");
  const auto handle = static_cast<MPI_Fint>(Start["catalyst/mpi_comm"].to_int64());
  int order = MPI_UNEQUAL;
  MPI_Comm_compare(MPI_Comm_f2c(handle), MPI_COMM_WORLD, &order);
  EXPECT_EQ(order, MPI_CONGRUENT); // a duplicate
  EXPECT_EQ(Catalyst->GetError(), LeftOut);
}

void ExpectCells(const Box& box, const Node& mesh)
{
  const Node coordinates = mesh["coordsets/coords"];
  EXPECT_EQ(coordinates["type"].as_string(), "uniform");
  for (int a = 0; a < 3; ++a)
  {
    const std::string axis(1, "xyz"[a]), index(1, "ijk"[a]);
    const double spacing = std::ldexp(Spacing[a], -box.Where.Level);
    const Index first = box.Where.Cells.Lower[a];
    EXPECT_EQ(coordinates["dims"][index].to_int64(), box.Where.Cells.Size(a) + 1);
    EXPECT_EQ(coordinates["origin"][axis].to_float64(), Origin[a] + first * spacing);
    EXPECT_EQ(coordinates["spacing"]["d" + axis].to_float64(), spacing);
    EXPECT_EQ(mesh["topologies/mesh/elements/origin"][index + "0"].to_int64(), first);
  }
  EXPECT_EQ(mesh["state/level"].to_int64(), box.Where.Level);
}

/// Expects that the field at this index is the host's memory.
template <class Value>
void ExpectMemory(const Box& box, const Node& mesh, int index, const std::string& name,
  const std::vector<Value>& values, int components = 1)
{
  const Node fields = mesh["fields"];
  const Node field = fields.child(index);
  const bool hasSlash = name.find('/') != std::string::npos;
  EXPECT_EQ(field.name(), hasSlash ? "{" + name + "}" : name);
  EXPECT_EQ(hasSlash ? field["display_name"].as_string() : name, name);
  EXPECT_EQ(field["association"].as_string(), "element");
  EXPECT_EQ(field["topology"].as_string(), "mesh");
  const Node all = field["values"];
  ASSERT_EQ(all.number_of_children(), components == 1 ? 0 : components);
  for (int c = 0; c < components; ++c)
  {
    conduit_node* one = components == 1 ? conduit_cpp::c_node(&all)
                                        : conduit_node_child(conduit_cpp::c_node(&all), c);
    const conduit_datatype* type = conduit_node_dtype(one);
    EXPECT_EQ(conduit_node_element_ptr(one, 0), values.data() + c);
    EXPECT_EQ(conduit_datatype_number_of_elements(type), box.Cells());
    EXPECT_EQ(conduit_datatype_stride(type), components * static_cast<Index>(sizeof(Value)));
    EXPECT_EQ(conduit_datatype_element_bytes(type), static_cast<Index>(sizeof(Value)));
    EXPECT_EQ(conduit_datatype_is_floating_point(type), std::is_floating_point_v<Value>);
    EXPECT_EQ(conduit_datatype_is_unsigned_integer(type), std::is_unsigned_v<Value>);
  }
}

/// Expects that coarse cells below the finer box are hidden.
void ExpectHidden(const Box& box, const Node& mesh)
{
  EXPECT_EQ(mesh["fields"].has_child("vtkGhostType"), box.Where.Level == 0);
  if (box.Where.Level == 0)
  {
    const Node types = mesh["fields/vtkGhostType/values"];
    ASSERT_EQ(types.dtype().number_of_elements(), box.Cells());
    const auto* type = static_cast<const unsigned char*>(types.element_ptr(0));
    ForCells(box.Where.Cells,
      [&](const Index3& cell)
      {
        const auto isInside = [&](int a) { return cell[a] == 1 || cell[a] == 2; };
        const bool isHidden = isInside(0) && isInside(1) && cell[2] == 0;
        EXPECT_EQ(*type++, isHidden ? 32 : 0) << cell[0] << " " << cell[1] << " " << cell[2];
      });
  }
}

void ExpectBox(const Box& box, const Node& mesh)
{
  ExpectCells(box, mesh);
  ExpectMemory(box, mesh, 0, "ball", box.Doubles);
  ExpectMemory(box, mesh, 1, "plate", box.Floats);
  ExpectMemory(box, mesh, 2, "id", box.Ints);
  ExpectMemory(box, mesh, 3, "marks", box.Bytes);
  ExpectMemory(box, mesh, 4, "rate [m/s]", box.Vectors, 3);
  ExpectHidden(box, mesh);
  const Node fields = mesh["fields"];
  EXPECT_EQ(fields.number_of_children(), box.Where.Level == 0 ? 6 : 5);
}

/// Expects an empty mesh: all ranks have the same number of meshes.
void ExpectNoCells(const Node& mesh)
{
  EXPECT_EQ(mesh["coordsets/coords/dims/i"].to_int64(), 0);
  EXPECT_FALSE(mesh.has_path("fields"));
}

TEST_F(CatalystNodes, EveryBoxFieldAndNumberIsHandedOver)
{
  for (int step = 0; step < 4; ++step)
  {
    const auto look = [&](const Node& node)
    {
      const Node state = node["catalyst/state"], channel = node["catalyst/channels/input"];
      EXPECT_EQ(state["timestep"].to_int64(), step);
      EXPECT_EQ(state["cycle"].to_int64(), step);
      EXPECT_EQ(state["time"].to_float64(), 0.125 * step);
      EXPECT_EQ(state["last"].to_int64(), step == 3);
      EXPECT_EQ(channel["type"].as_string(), "multimesh");
      const Node meshes = channel["data"];
      const int most = Ranks == 1 ? 3 : 2;
      EXPECT_EQ(meshes.number_of_children(), most);
      for (int m = 0; m < most; ++m)
      {
        const Node mesh = meshes.child(m);
        Node info;
        EXPECT_TRUE(conduit_cpp::Blueprint::verify("mesh", mesh, info));
        EXPECT_EQ(mesh.name(), "box" + std::to_string(m));
        EXPECT_EQ(mesh["state/fields/Fragments"].to_float64(), 2.0);
        const bool isOwn = m < static_cast<int>(this->Boxes.size());
        isOwn ? ExpectBox(this->Boxes[m], mesh) : ExpectNoCells(mesh);
      }
      return catalyst_status_ok;
    };
    EXPECT_FALSE(this->Process(this->Describe(), step, look)); // a script was left out
    EXPECT_EQ(this->Calls, 1);
    EXPECT_EQ(Catalyst->GetNumberOfStepsMade(), step + 1);
    EXPECT_EQ(Catalyst->GetError(), LeftOut);
  }
}

/// Box numbers count the boxes of all ranks.
TEST_F(CatalystNodes, DomainsAreNumberedOverAllRanks)
{
  std::vector<int> mine(8, 0), all(8, 0);
  const auto look = [&](const Node& node)
  {
    const Node meshes = node["catalyst/channels/input/data"];
    for (conduit_index_t m = 0; m < meshes.number_of_children(); ++m)
    {
      const Node mesh = meshes.child(m);
      ++mine.at(mesh["state/domain_id"].to_int64());
    }
    return catalyst_status_ok;
  };
  this->Process(this->Describe(), 4, look);
  MPI_Allreduce(mine.data(), all.data(), 8, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
  for (int domain = 0; domain < 3; ++domain)
  {
    EXPECT_EQ(all[domain], 1);
  }
  EXPECT_EQ(*std::max_element(all.begin() + 3, all.end()), Ranks == 1 ? 0 : Ranks == 2 ? 1 : 2);
}

TEST_F(CatalystNodes, WrongGridsAreNotHandedOver)
{
  HostGrid grid = this->Describe();
  if (Rank == 0)
  {
    grid.Boxes[0].Cells.Upper[0] = 5;
  }
  const auto look = [](const Node&) { return catalyst_status_ok; };
  EXPECT_FALSE(this->Process(grid, 5, look));
  EXPECT_NE(Catalyst->GetError().find("leaves the grid along x"), std::string::npos);
  grid.Boxes.clear();
  EXPECT_FALSE(this->Process(grid, 5, look));
  EXPECT_EQ(Catalyst->GetError(), LeftOut + std::string("\nThe grid has no boxes on any rank."));
  EXPECT_EQ(this->Calls, 0);
  EXPECT_EQ(Catalyst->GetNumberOfStepsMade(), 5);
}

/// This must be the last test: afterwards no data are passed any more.
TEST_F(CatalystNodes, AFailureOnOneRankIsReportedOnAll)
{
  const auto look = [](const Node&)
  { return Rank == Ranks - 1 ? static_cast<catalyst_status>(Failed) : catalyst_status_ok; };
  const std::string told =
    LeftOut + std::string("\nCatalyst failed at step 6: status 102 of its implementation.");
  EXPECT_FALSE(this->Process(this->Describe(), 6, look));
  EXPECT_EQ(this->Calls, 1);
  EXPECT_EQ(Catalyst->GetError(), told);
  EXPECT_FALSE(this->Process(this->Describe(), 7, look));
  EXPECT_EQ(this->Calls, 0);
  EXPECT_EQ(Catalyst->GetError(), told);
}

} // namespace
} // namespace testing
} // namespace vfm
