/// Arrays that are selected as materials by name, type and range.
#include "Materials/ChooseMaterials.h"
#include "Input/ArrayNames.h"
#include "Input/FractionChecks.h"

#include <gtest/gtest.h>

using namespace vfm;

namespace
{

using Names = std::vector<std::string>;
using List = std::vector<ArrayInfo>;
constexpr int Byte = ValueType::UnsignedChar, Int = ValueType::Int, Real = ValueType::Double;

ArrayInfo Make(const std::string& name, int type, double least, double most, bool areWhole = false)
{
  ArrayInfo info{ name, type, 1, least, most };
  info.AreWhole = areWhole || !IsRealType(type);
  return info;
}

MaterialChoice Choose(const List& arrays, const Names& others = {})
{
  ChoiceRules rules;
  rules.Others = others;
  return ChooseMaterials(arrays, rules);
}

ArrayContent ContentOf(const ArrayInfo& array)
{
  return FindContents({ array }, {})[0].Content;
}

void ExpectFractions(const MaterialChoice& choice, const Names& names, bool isClear)
{
  EXPECT_EQ(choice.Fractions, names) << choice.Problem;
  EXPECT_EQ(choice.Labels, "");
  EXPECT_EQ(choice.IsClear, isClear);
  EXPECT_EQ(choice.Problem, "");
}

void ExpectLabels(const MaterialChoice& choice, const std::string& name, bool isClear)
{
  EXPECT_EQ(choice.Labels, name) << choice.Problem;
  EXPECT_TRUE(choice.Fractions.empty());
  EXPECT_EQ(choice.IsClear, isClear);
  EXPECT_EQ(choice.Problem, "");
}

void ExpectProblem(const MaterialChoice& choice, const Names& parts)
{
  EXPECT_TRUE(choice.Fractions.empty() && choice.Labels.empty());
  for (const std::string& part : parts)
  {
    EXPECT_NE(choice.Problem.find(part), std::string::npos) << choice.Problem;
  }
}

const ArrayInfo Ball = Make("ball", Real, 0.0, 1.0);
const ArrayInfo Heat = Make("heat", ValueType::Float, 0.0, 300.5);

} // namespace

TEST(ChooseMaterials, TakesRealsInUnitRangeAndBytes)
{
  const ArrayInfo bytes = Make("bytes", Byte, 0.0, 255.0), few = Make("few", Byte, 0.0, 20.0);
  const ArrayInfo whole = Make("whole", Int, 0.0, 1.0);
  ArrayInfo vector = Make("vector", Real, 0.0, 1.0);
  vector.Components = 3;
  ExpectFractions(
    Choose({ Ball, Heat, bytes, whole, vector }), { "ball", "bytes", "whole" }, false);
  ExpectFractions(Choose({ bytes, few }), { "bytes", "few" }, false); // one scale for all bytes
  ExpectFractions(Choose({ Ball, bytes }, { "ball" }), { "bytes" }, true);
  ExpectProblem(Choose({ Heat }), { "'heat' (real numbers from 0 to 300.5" });
}

TEST(ChooseMaterials, ToleratesRounding)
{
  EXPECT_EQ(ContentOf(Make("a", Real, -1e-7, 1.0 + 1e-7)), ArrayContent::Fraction);
  EXPECT_EQ(ContentOf(Make("a", Real, -1e-5, 1.0)), ArrayContent::Grey);
}

TEST(ChooseMaterials, PrefersNamesOfSpyPlotInTheOrderOfTheirNumbers)
{
  const std::string name = "Material volume fraction - ";
  const ArrayInfo ten = Make(name + "10", Real, 0.0, 2.0);
  const ArrayInfo two = Make("Volume Fraction - 2", Real, 0.0, 1.0);
  ExpectFractions(Choose({ ten, Ball, two }), { "Volume Fraction - 2", name + "10" }, true);
}

TEST(ChooseMaterials, PrefersNamesThatSayVolumeFraction)
{
  const ArrayInfo tin = Make("vf_tin", Real, 0.0, 1.0), empty = Make("void_vf", Real, 0.0, 1.0);
  const ArrayInfo mass = Make("mass, tin", Real, 0.0, 1e-3);
  ExpectFractions(Choose({ Ball, tin, empty, mass }), { "vf_tin" }, true);
  for (const char* own : { "VOLM+1", "VolumeFraction_tin", "volfrac-3", "vf2", "alpha.water",
         "matvf_01", "vofm_1", "FVOL_1", "frac_vol_1", "VFRC1", "fraction volumique" })
  {
    ExpectFractions(Choose({ Ball, Make(own, Real, 0.0, 1.0) }), { own }, true);
  }
  // Void and masses are no materials, even if nothing else is there.
  ExpectFractions(Choose({ Ball, Make("Void", Real, 0.0, 1.0), mass }), { "ball" }, true);
  ExpectProblem(Choose({ empty, mass }), { "named void", "named as a mass" });
  ExpectFractions(Choose({ tin, Make("vf_vacuum", Real, 0.0, 1.0) }), { "vf_tin" }, true);
}

TEST(ChooseMaterials, StatesAreNoMaterials)
{
  for (const char* name : { "damage", "Plastic_Strain", "damage - 1", "eqps", "PorositySand" })
  {
    const ArrayInfo state = Make(name, Real, 0.0, 1.0);
    ExpectFractions(Choose({ Ball, state }), { "ball" }, true);
    ExpectProblem(Choose({ state }), { "named as a state of the material" });
  }
  ExpectLabels(Choose({ Make("damage", Int, 0.0, 3.0) }), "damage", true);
  ExpectFractions(Choose({ Make("strain_vf", Real, 0.0, 1.0) }), { "strain_vf" }, true);
}

TEST(ChooseMaterials, KeepsNamedFractionsWithValuesOutOfRange)
{
  const ArrayInfo tin = Make("vf_tin", Real, 0.0, 1.0);
  for (const ArrayInfo& other : { Make("vf_a", Real, 0.0, 1.00001), Make("vf_a", Real, 0.0, 1.5),
         Make("vf_a", Real, -0.5, 1.0), Make("vf_a", Real, 0.0, 2.0, true) })
  {
    ExpectFractions(Choose({ other, tin, Ball }), { "vf_a", "vf_tin" }, true); // mesher: --clip
  }
  ExpectProblem(Choose({ Make("vf_a", Real, 0.0, 1.05) }), { "--clip" });
}

TEST(ChooseMaterials, DoesNotGuessBetweenFractionsAndNamedLabels)
{
  const ArrayInfo confidence = Make("Confidence Index", ValueType::Float, 0.0, 1.0);
  const ArrayInfo contrast = Make("BandContrast", Byte, 0.0, 255.0);
  for (const char* name : { "FeatureIds", "GrainIds", "labels" })
  {
    const ArrayInfo labels = Make(name, Int, 0.0, 40.0);
    ExpectProblem(Choose({ confidence, labels }), { name, "'Confidence Index'" });
    ExpectProblem(Choose({ labels, contrast }), { name, "'BandContrast'" });
    ExpectFractions(Choose({ labels, Make("vf_tin", Real, 0.0, 1.0) }), { "vf_tin" }, true);
  }
  ExpectFractions(Choose({ Make("FeatureIds", Int, 0.0, 0.0), Ball }), { "ball" }, false);
  const ArrayInfo mask = Make("mask", Real, 0.0, 1.0, true), zone = Make("zone", Int, 0.0, 5.0);
  ExpectProblem(Choose({ mask, zone }), { "Labels 'zone'", "'mask'" });
  ExpectFractions(Choose({ mask, Ball, zone }), { "mask", "ball" }, false);
  ExpectFractions(Choose({ mask, Make(LabelsName, Int, 0.0, 5.0) }), { "mask" }, false);
}

TEST(ChooseMaterials, BytesBelow128AreLabelsOrMasks)
{
  ExpectLabels(Choose({ Make("mask", Byte, 0.0, 1.0) }), "mask", true);
  ExpectLabels(Choose({ Make("tissue", Byte, 0.0, 29.0) }), "tissue", true);
  ExpectLabels(Choose({ Make("tissue", Byte, 0.0, LargestEmptyByte) }), "tissue", true);
  ExpectFractions(Choose({ Make("a", Byte, 0.0, 255.0) }), { "a" }, true);
  const List masks{ Make("liver", Byte, 0.0, 1.0), Make("none", Byte, 0.0, 0.0),
    Make("spleen", Byte, 0.0, 1.0) };
  ExpectFractions(Choose(masks), { "liver", "none", "spleen" }, true);
  ExpectProblem(Choose({ Make("a", Byte, 0.0, 3.0), Make("b", Byte, 0.0, 29.0) }),
    { "'a' (integers from 0 to 3)", "'b' (integers from 0 to 29)" });
  // Bytes above 127 of which none is full may be both, unless their name tells.
  const ArrayInfo most = Make("a", Byte, 0.0, 200.0), mask = Make("b", Byte, 0.0, 1.0);
  ExpectProblem(Choose({ most }), { "Labels or volume fractions: 'a' (unsigned char up to 200" });
  ExpectProblem(Choose({ most, mask }), { "'b' (unsigned char up to 1, next to 200" });
  ExpectProblem(Choose({ most, Ball }), { "Labels or volume fractions" });
  ExpectLabels(Choose({ Make("labels", Byte, 0.0, 200.0) }), "labels", true);
  ExpectFractions(Choose({ Make("vf", Byte, 0.0, 200.0) }), { "vf" }, true);
  ExpectFractions(Choose({ Make("vf", Byte, 0.0, 100.0) }), { "vf" }, true); // mesher: no elements
  // Image files store labels as bytes.
  ChoiceRules image;
  image.IsImage = true;
  EXPECT_EQ(ChooseMaterials({ Make("scan", Byte, 0.0, 255.0) }, image).Labels, "scan");
}

TEST(ChooseMaterials, MasksOfAllTypesAreMaterialsTogether)
{
  const ArrayInfo byte = Make("liver", Byte, 0.0, 1.0), whole = Make("spleen", Int, 0.0, 1.0);
  const ArrayInfo full = Make("lung", Byte, 0.0, 255.0), none = Make("none", Int, 0.0, 0.0);
  const ArrayInfo real = Make("skin", Real, 0.0, 1.0, true);
  ExpectFractions(Choose({ byte, real }), { "liver", "skin" }, true);
  ExpectFractions(Choose({ real, none, whole }), { "skin", "none", "spleen" }, true);
  ExpectFractions(Choose({ full, whole }), { "lung", "spleen" }, true);
  ExpectFractions(Choose({ whole, Ball, none }), { "spleen", "ball" }, false);
  ExpectFractions(Choose({ Make("count", Int, 1.0, 1.0), Ball }), { "ball" }, false);
  ExpectFractions(Choose({ Make(LabelsName, Int, 0.0, 1.0), Ball }), { "ball" }, false);
  ExpectProblem(Choose({ Make("damage", Int, 0.0, 1.0), Ball }), { "Labels 'damage'", "'ball'" });
  ExpectProblem(Choose({ Make("phase", Int, 0.0, 1.0), Ball }), { "Labels 'phase'", "'ball'" });
}

TEST(ChooseMaterials, TakesIntegersAsLabels)
{
  for (const char* name : { "material", "Spin", "FeatureIds", "facies", LabelsName })
  {
    ExpectLabels(Choose({ Heat, Make(name, Int, 0.0, 7.0) }), name, true);
  }
  const ArrayInfo a = Make("a", Int, 0.0, 7.0), level = Make("level", Int, 1.0, 4.0);
  ExpectLabels(Choose({ a, level }), "a", true);
  ExpectLabels(Choose({ a, Make("Phases", Int, 1.0, 2.0), Make("FeatureIds", Int, 0.0, 9.0) }),
    "FeatureIds", false);
  ExpectProblem(Choose({ a, Make("b", Int, 0.0, 3.0) }), { "Several arrays of integers", "'b'" });
  ExpectProblem(Choose({ Make("a", Int, 0.0, 0.0) }), { "hold only 0" });
  ExpectProblem(Choose({ Make("a", Int, -1.0, 3.0) }), { "'a' (integers from -1 to 3" });
  ExpectFractions(Choose({ Make(LabelsName, Byte, 0.0, 200.0), Ball }), { "ball" }, false);
}

TEST(ChooseMaterials, TakesRealsThatAreIntegersIfNothingElseQualifies)
{
  const ArrayInfo whole = Make("seg", Real, 0.0, 53.0, true);
  ExpectLabels(Choose({ whole, Heat }), "seg", true);
  ExpectFractions(Choose({ whole, Ball }), { "ball" }, true);
  ExpectLabels(Choose({ whole, Make("id", Int, 0.0, 2.0) }), "id", true);
}

TEST(ChooseMaterials, RecognisesLevelSets)
{
  const ArrayInfo phi = Make("phi", Real, -0.7, 1.3);
  EXPECT_EQ(ContentOf(phi), ArrayContent::LevelSet);
  ExpectProblem(Choose({ phi }), { "'phi' (values of both signs", "level set" });
}

TEST(ChooseMaterials, ThresholdTakesTheOnlyArray)
{
  ChoiceRules rules;
  rules.HasThreshold = true;
  ExpectLabels(ChooseMaterials({ Heat }, rules), "heat", true);
  ExpectProblem(ChooseMaterials({ Heat, Ball }, rules), { "'heat'", "'ball'" });
  rules.Others = { "ball" };
  ExpectLabels(ChooseMaterials({ Heat, Ball }, rules), "heat", true);
}
