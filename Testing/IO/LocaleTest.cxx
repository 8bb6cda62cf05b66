/// Files are read the same if the host program has a locale with a decimal comma.
#include "Base/ParseText.h"
#include "Blocks/BlockFile.h"
#include "FileCases.h"
#include "GridFiles/ParseOutline.h"
#include "GridFiles/VtkFileCheck.h"
#include "Images/ImageFile.h"
#include "Labels/ReadLabelNames.h"

#include <clocale>
#include <locale>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Numbers as in "1 000,5".
class CommaNumbers : public std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return ' '; }
  std::string do_grouping() const override { return "\3"; }
};

/// Sets a locale with a decimal comma: in C++ always, in C if one is installed.
class Locale : public ::testing::Test
{
protected:
  Locale()
  {
    for (const char* name : { "de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "fr_FR.utf8" })
    {
      if (std::setlocale(LC_NUMERIC, name))
      {
        break;
      }
    }
  }
  ~Locale() override
  {
    std::locale::global(this->Before);
    std::setlocale(LC_NUMERIC, "C");
  }

  std::string Save(const std::string& name, const std::string& text) const
  {
    std::ofstream file;
    file.imbue(std::locale::classic());
    file.open(this->Files / name, std::ios::binary);
    file << text;
    return this->Files / name;
  }

  const Folder Files;

private:
  const std::locale Before =
    std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
};

void ExpectPlace(const std::string& path)
{
  const ImagePlace place = OpenImageFile(path, {}).Place;
  const Vector3 origin{ { -1.5, 0.25, 1000.5 } }, spacing{ { 0.5, 0.25, 1.5 } };
  EXPECT_EQ(place.Origin, origin);
  EXPECT_EQ(place.Spacing, spacing);
}

} // namespace

TEST_F(Locale, MetaImage)
{
  const std::string header = "ObjectType = Image\nNDims = 3\nDimSize = 2 1 1\n"
                             "ElementType = MET_FLOAT\nOffset = -1.5 0.25 1000.5\n"
                             "ElementSpacing = 0.5 0.25 1.5\nBinaryData = False\n"
                             "ElementDataFile = LOCAL\n0.25 0.75\n";
  const std::string path = this->Save("a.mhd", header);
  ExpectPlace(path);
  const TypedValues values = OpenImageFile(path, {}).Read({ {}, { { 2, 1, 1 } } });
  const auto* numbers = reinterpret_cast<const float*>(values.Bytes.data());
  EXPECT_EQ(std::vector<float>(numbers, numbers + 2), (std::vector<float>{ 0.25f, 0.75f }));
}

TEST_F(Locale, Nrrd)
{
  ExpectPlace(this->Save("a.nrrd",
    "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 1 1\nencoding: raw\n"
    "space directions: (0.5,0,0) (0,0.25,0) (0,0,1.5)\nspace origin: (-1.5,0.25,1000.5)\n\n12"));
}

TEST_F(Locale, Plotfile)
{
  const std::string box = "((0,0,0) (0,0,0) (0,0,0))";
  std::filesystem::create_directory(this->Files / "Level_0");
  this->Save("Header",
    "HyperCLaw-V1.1\n1\nfrac\n3\n0.5\n0\n0 0 0\n0.5 0.5 0.5\n\n" + box +
      "\n7\n0.5 0.5 0.5\n0\n0\n0 1 0.5\n7\n0 0.5\n0 0.5\n0 0.5\nLevel_0/Cell\n");
  this->Save("Level_0/Cell_H", "1\n0\n1\n0\n(1 0\n" + box + "\n)\n1\nFabOnDisk: Cell_D 0\n");
  const std::string value("\0\0\0\0\0\0\xe8\x3f", 8); // 0.75
  this->Save("Level_0/Cell_D",
    "FAB ((8, (64 11 52 0 1 12 0 1023)),(8, (8 7 6 5 4 3 2 1)))" + box + " 1\n" + value);
  RunOnRanks(1,
    [&](ThreadRanks& ranks)
    {
      const auto file = OpenBlockFile(this->Files / "", ranks);
      EXPECT_EQ(file->Times(), std::vector<double>{ 0.5 });
      EXPECT_EQ(file->Read(0, { "frac" }, ranks).size(), 1u);
    });
}

TEST_F(Locale, VtkImage)
{
  const std::string path = this->Save("a.vti",
    "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
    "<ImageData WholeExtent=\"0 2 0 1 0 1\" Origin=\"0.5 0 0\" Spacing=\"0.5 1 1\">\n"
    "<Piece Extent=\"0 2 0 1 0 1\"><CellData><DataArray type=\"Float64\" Name=\"a\" "
    "format=\"ascii\">0.25 0.75</DataArray></CellData></Piece></ImageData></VTKFile>\n");
  EXPECT_NO_THROW(CheckVtkFile(path, { ParseVtkOutline, {} }));
}

TEST_F(Locale, LabelNamesOfRanks)
{
  RunOnRanks(2,
    [](ThreadRanks& ranks)
    {
      const LabelNames own{ { 1 + ranks.Rank(), "2nd layer" } };
      const LabelNames all{ { 1, "2nd layer" }, { 2, "2nd layer" } };
      EXPECT_EQ(UniteLabelNames(own, ranks), all);
    });
}

TEST_F(Locale, Numbers)
{
  EXPECT_EQ(ParseReal("+1.5e3"), 1500.0);
  EXPECT_EQ(ParseReal("-1e-400"), 0.0);
  for (const char* text : { "1,5", "1e400", "inf", "nan", "+-1", "", "+", "1 000" })
  {
    EXPECT_EQ(ParseReal(text), std::nullopt) << text;
  }
}
