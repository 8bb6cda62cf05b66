/// Input files of solvers: numbers in narrow fields, the same bytes from any number of ranks, and
/// meshes whose numbers do not fit.
#include "FileCases.h"
#include "Meshes/Decks/DeckCards.h"
#include "Meshes/Decks/DeckModel.h"
#include "Meshes/WriteMesh.h"
#include "Report/UniqueNames.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

using namespace vfm;
using namespace vfm::testing;

namespace
{

std::string Format(double value, std::size_t width, RealForm form)
{
  return std::string(DeckReal(value, width, form).Text());
}

/// Returns the number that a solver reads; Nastran's exponents have no letter.
double ReadBack(std::string text)
{
  const std::size_t sign = text.find_last_of("+-");
  if (sign != std::string::npos && sign > 0 && text[sign - 1] != 'e')
  {
    text.insert(sign, "e");
  }
  return std::stod(text);
}

TEST(DeckReal, TextsOfNumbers)
{
  for (const auto& [value, plain, compact, nastran] :
    std::vector<std::tuple<double, const char*, const char*, const char*>>{ { 0, "0", "0", "0." },
      { 1, "1", "1", "1." }, { -0.5, "-0.5", "-.5", "-.5" }, { 0.25, "0.25", ".25", ".25" },
      { 1e-5, "1e-05", "1e-5", "1.-5" }, { -2.5e-10, "-2.5e-10", "-2.5e-10", "-2.5-10" },
      { 1e30, "1e+30", "1e+30", "1.+30" }, { 10.5, "10.5", "10.5", "10.5" },
      { -1. / 3, "-0.3333333333", "-.33333333333", "-.33333333333" },
      { -1e-5 / 3, "-3.333333e-06", "-3.3333333e-6", "-3.33333333-6" } })
  {
    EXPECT_EQ(Format(value, 13, RealForm::Plain), plain);
    EXPECT_EQ(Format(value, 13, RealForm::Compact), compact);
    EXPECT_EQ(Format(value, 13, RealForm::Nastran), nastran);
  }
}

TEST(DeckReal, NumbersFitAndLoseFewDigits)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-90, 90), digit(-10, 10);
  for (int i = 0; i < 20000; ++i)
  {
    const double value = digit(random) * std::pow(10, exponent(random));
    for (RealForm form : { RealForm::Plain, RealForm::Compact, RealForm::Nastran })
    {
      for (std::size_t width : { 10, 16, 20 })
      {
        const std::string text = Format(value, width, form);
        ASSERT_LE(text.size(), width);
        const double error = 5 * std::pow(10, 6 - static_cast<double>(width));
        ASSERT_NEAR(ReadBack(text), value, error * std::abs(value)) << text;
      }
    }
  }
}

TEST(WriteDecks, SameBytesOnRanks)
{
  const Folder folder;
  for (const char* suffix : { ".inp", ".k", ".rad", ".bdf", ".feb" })
  {
    for (int count : { 1, 3 })
    {
      WithMesh(count, MakeHexMesh,
        [&](const FileCase& part, Ranks& ranks)
        { WriteMesh(part.Mesh, folder / (std::to_string(count) + suffix), ranks); });
    }
    const std::string one = ReadBytes(folder / (std::string("1") + suffix));
    EXPECT_GT(one.size(), 1000u);
    EXPECT_TRUE(one == ReadBytes(folder / (std::string("3") + suffix))) << suffix;
  }
}

/// Lines of a deck: their number, the longest one, and the first signs of those that begin a
/// keyword, a comment or a directive.
struct DeckLines
{
  std::size_t Count = 0, Longest = 0;
  std::string Signs;
};

DeckLines ReadLines(const std::string& path)
{
  DeckLines lines;
  std::istringstream stream(ReadBytes(path));
  for (std::string line; std::getline(stream, line); ++lines.Count)
  {
    lines.Longest = std::max(lines.Longest, line.size());
    const std::size_t first = line.find_first_not_of(" \t");
    const bool isSign =
      first != std::string::npos && std::string_view("*$#/").find(line[first]) != std::string::npos;
    lines.Signs += isSign ? line.substr(first, 1) : "";
    EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= ' ' && c <= '~'; }))
      << line;
  }
  return lines;
}

TEST(WriteDecks, NamesAreNoKeywordsAndNoComments)
{
  const Folder folder;
  const std::vector<std::string> names{ "*NODE", "*END", "$x", "#include other.inc", "//x", "/END",
    "  *PART", "a\n*END\r\n/END", "\x01\x7f", std::string(3000, 'x'), "", "gr\xc3\xb6\xc3\x9f",
    "M\xfcller", "&x", "\t#y" };
  for (const char* suffix : { ".k", ".rad", ".bdf", ".inp" })
  {
    TwoCubes plain;
    Ranks alone;
    plain.Data.Fields[1].Values = std::vector<std::string>{ std::string(200, 'y'), "b" };
    WriteMesh(plain.Data, folder / (std::string("plain") + suffix), alone);
    const DeckLines expected = ReadLines(folder / (std::string("plain") + suffix));
    for (const std::string& name : names)
    {
      TwoCubes cubes;
      cubes.Data.Fields[1].Values = std::vector<std::string>{ name, name };
      const std::string path = folder / (std::string("mesh") + suffix);
      WriteMesh(cubes.Data, path, alone);
      const DeckLines lines = ReadLines(path);
      EXPECT_EQ(lines.Signs, expected.Signs) << suffix << " " << name;
      EXPECT_EQ(lines.Count, expected.Count) << suffix << " " << name;
      EXPECT_LE(lines.Longest, expected.Longest) << suffix << " " << name;
    }
  }
}

TEST(WriteMesh, NamesOfAnyBytesGiveValidTexts)
{
  const Folder folder;
  TwoCubes cubes;
  const std::vector<double> values(2, 0.5);
  cubes.Data.Fields[1].Values = std::vector<std::string>{ "M\xfcller\n\"x\"", "\x81\x01<&" };
  cubes.Data.ElementArrays.push_back({ "gr\xf6\xdf"
                                       "e\n\x02",
    ValueType::Double, 1, {}, values.data() });
  for (const char* name : { "m.vtu", "m.pvtu", "m.xdmf", "m.msh", "m.inp", "m.k", "m.foam" })
  {
    Ranks alone;
    WriteMesh(cubes.Data, folder / name, alone);
  }
  for (const char* name : { "m.vtu", "m.pvtu", "m/m_0.vtu", "m.xdmf", "m_facets.xdmf", "m.msh",
         "m.inp", "m.k", "constant/polyMesh/cellZones", "constant/polyMesh/boundary" })
  {
    const std::string text = ReadBytes(folder / name);
    EXPECT_TRUE(IsUtf8(text)) << name;
    EXPECT_FALSE(text.empty()) << name;
    EXPECT_TRUE(std::all_of(text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) >= ' ' || c == '\n'; }))
      << name;
  }
}

TEST(DeckModel, NumbersThatDoNotFit)
{
  MeshData mesh;
  mesh.NumberOfPoints = 99999999;
  mesh.NumberOfElements = 99999999;
  DeckModel model{ {}, mesh, {}, ConnectionKind::Cohesive, {} };
  EXPECT_NO_THROW(RequireNumbers(model, 99999999, "this", ".e"));
  model.Cohesive = { { 9, "1_to_2_cohesive", { 1, 2 }, {}, {}, { 100000000 } } };
  EXPECT_NO_THROW(RequireNumbers(model, 100000000, "this", ".e"));
  try
  {
    RequireNumbers(model, 99999999, "LS-DYNA", ".rad, .e");
    ADD_FAILURE();
  }
  catch (const InputError& error)
  {
    EXPECT_STREQ(error.what(),
      "The mesh has more than 99999999 nodes or elements, which LS-DYNA cannot number. Formats "
      "that can: .rad, .e.");
  }
}

} // namespace
