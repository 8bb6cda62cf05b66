/// Names of arrays that belong together, and the choice of state arrays.
#include "State/ArrayStems.h"
#include "State/StateChoice.h"

#include <gtest/gtest.h>

using namespace vfm;
using Names = std::vector<std::string>;

TEST(ArrayStems, ComponentsOfVectors)
{
  for (const char* name : { "velocity_x", "velocity_y" })
  {
    const std::optional<ArrayStem> found = FindVector(name);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->Members, (Names{ "velocity_x", "velocity_y", "velocity_z" }));
    EXPECT_TRUE(IsOfVector(name, found->Name));
    EXPECT_TRUE(IsOfVector(name, "velocity_z"));
  }
  EXPECT_EQ(FindVector("X velocity")->Members, (Names{ "X velocity", "Y velocity", "Z velocity" }));
  EXPECT_FALSE(FindVector("pressure"));
  EXPECT_FALSE(FindVector("max"));
  EXPECT_FALSE(IsOfVector("pressure", ""));
}

TEST(ArrayStems, MembersByMaterial)
{
  const MaterialStems stems({ "Void", "frac_steel", "frac_copper" }, { 0, 4, 5 });
  const std::vector<ArrayStem> found = stems.FindStems("rho_copper");
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].Members, (Names{ "rho_steel", "rho_copper" }));
  const std::vector<ArrayStem> numbered = stems.FindStems("density - 5");
  ASSERT_FALSE(numbered.empty());
  EXPECT_EQ(numbered[0].Members, (Names{ "density - 4", "density - 5" }));
  EXPECT_TRUE(stems.FindStems("pressure").empty());
  EXPECT_TRUE(MaterialStems({ "Void", "frac_steel" }, { 0, 1 }).FindStems("rho_steel").empty());
}

TEST(StateChoice, ConservedIfDensitiesAreThere)
{
  EXPECT_TRUE(ConservesState(TransferMode::Automatic, { "rho" }));
  EXPECT_FALSE(ConservesState(TransferMode::Automatic, {}));
  EXPECT_FALSE(ConservesState(TransferMode::Copy, { "rho" }));
  EXPECT_TRUE(ConservesState(TransferMode::Conserve, {}));
}

TEST(StateChoice, VelocityOfThreeArrays)
{
  StateChoice choice;
  choice.IsConserved = true;
  choice.Arrays = { "T" };
  choice.Densities = { "rho" };
  choice.Velocity = "v_y";
  EXPECT_TRUE(IsCandidate("v_z", choice));
  EXPECT_FALSE(IsCandidate("T", choice));
  const StateChoice full = CompleteChoice(choice, { { "v_x", 1 }, { "v_y", 1 }, { "v_z", 1 } });
  EXPECT_EQ(full.Velocity, "v_x");
  for (const char* name : { "T", "rho", "v_x", "v_y", "v_z" })
  {
    EXPECT_EQ(std::count(full.Arrays.begin(), full.Arrays.end(), name), 1) << name;
  }
}
