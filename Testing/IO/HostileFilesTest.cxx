/// Files that contradict themselves or name other files: an error with a message, never a wrong
/// image. Sizes, numbers, lines, special files, and text for terminals.
#include "Blocks/BlockFile.h"
#include "CellCount.h"
#include "FileCases.h"
#include "Images/ImageFile.h"
#include "InputTrust.h"
#include "Labels/ReadLabelNames.h"
#include "Ranks/PrintableText.h"
#include "ReadLine.h"

#include <hdf5.h>
#include <sys/stat.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Values of 2 x 2 x 2 voxels.
const std::string Bytes8("\0\1\2\3\4\5\6\7", 8);

std::string Save(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

/// Returns the message of an error, or "" if there is none.
template <class Work>
std::string FindMessage(const Work& work)
{
  try
  {
    work();
    return "";
  }
  catch (const InputError& error)
  {
    return error.what();
  }
}

/// Returns a request for an image of a file that holds several.
ImageRequest VolumeOf(int number)
{
  ImageRequest request;
  request.Volume = number;
  return request;
}

/// Returns the values of an image of 2 x 2 x 2 voxels.
std::vector<int> ReadValues(const std::string& path, const ImageRequest& request = {})
{
  const ImageFile file = OpenImageFile(path, request);
  const TypedValues values = file.Read({ {}, file.Place.Size });
  std::vector<int> numbers;
  VisitType(values.Type,
    [&](auto tag)
    {
      const auto* from = reinterpret_cast<const typename decltype(tag)::Type*>(values.Bytes.data());
      numbers.assign(from, from + CountCells(file.Place.Size));
    });
  return numbers;
}

/// Expects that a file cannot be read, with a message that contains a text.
void ExpectProblem(const std::string& path, const std::string& text)
{
  const std::string message = FindMessage([&] { ReadValues(path); });
  EXPECT_NE(message.find(text), std::string::npos) << path << ": '" << message << "'";
}

std::string Nrrd(const std::string& lines)
{
  return "NRRD0004\ntype: uchar\ndimension: 3\nencoding: raw\n" + lines;
}

std::string Meta(const std::string& lines, const std::string& file = "LOCAL")
{
  return "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n" + lines +
    "ElementDataFile = " + file + "\n";
}

const std::vector<int> Counted{ 0, 1, 2, 3, 4, 5, 6, 7 };
constexpr const char* Sizes = "sizes: 2 2 2\n";

} // namespace

TEST(HostileFiles, NumberOfCellsDoesNotOverflow)
{
  EXPECT_EQ(CountCells({ { 1 << 19, 1 << 19, 1 << 18 } }), Index(1) << 56);
  EXPECT_THROW(CountCells({ { 1 << 19, 1 << 19, (1 << 18) + 1 } }), InputError);
  EXPECT_THROW(CountCells({ { 1431724848, 2147380029, 6 } }), InputError); // 2^64 + 11,936
  EXPECT_EQ(CountCells({ { 5, 0, 7 } }), 0);
  const Folder folder;
  ExpectProblem(
    Save(folder / "a.nrrd", Nrrd("sizes: 1431724848 2147380029 6\ndata file: /dev/zero\n\n")),
    "1431724848 x 2147380029 x 6 is too large");
}

TEST(HostileFiles, NrrdHeaders)
{
  const Folder folder;
  const std::string path = folder / "a.nrrd";
  const auto expect = [&](const std::string& lines, const std::string& text)
  { ExpectProblem(Save(path, Nrrd(lines) + "\n" + Bytes8), text); };
  EXPECT_EQ(ReadValues(Save(path, Nrrd(Sizes) + "\n" + Bytes8)), Counted);
  for (const char* skip : { "byte skip: 4\n", "byteskip: 4\n", "byte skip: -1\n" })
  {
    EXPECT_EQ(ReadValues(Save(path, Nrrd(Sizes) + skip + "\njunk" + Bytes8)), Counted) << skip;
  }
  expect("sizes: 2 2.5 2\n", "'sizes: 2 2.5 2', where 3 integers are required");
  expect("sizes: 2 2 2 junk\n", "where 3 integers are required");
  expect("sizes: 2 2 3000000000\n", "its size is 2 x 2 x 3000000000");
  expect(std::string(Sizes) + "byte skip: -2\n", "its byte skip is -2");
  expect(std::string(Sizes) + "byte skip: 999\n", "its values are truncated: they begin at byte");
  expect(std::string(Sizes) + "byte skip:4\n", "neither 'field: value' nor 'key:=value'");
  expect(std::string(Sizes) + "lineskip: 1\n", "line skip, which is not supported");
  expect(std::string(Sizes) + "space directions: (nan,0,0) (0,1,0) (0,0,1)\n",
    "where 9 numbers are required");
  expect(std::string(Sizes) + "type: short\n", "'type' twice");
  ExpectProblem(Save(path, Nrrd(Sizes)), "names no data file and does not end");
  ExpectProblem(Save(path, "dimension: 1" + std::string(99, '8')), "it is not an NRRD file");
}

TEST(HostileFiles, MetaImageHeaders)
{
  const Folder folder;
  const std::string path = folder / "a.mha", binary = "BinaryData = True\n";
  const auto expect = [&](const std::string& lines, const std::string& text)
  { ExpectProblem(Save(path, Meta(lines) + Bytes8), text); };
  EXPECT_EQ(ReadValues(Save(path, Meta(binary) + Bytes8)), Counted);
  EXPECT_EQ(ReadValues(Save(path, Meta(binary + "HeaderSize = -1\n") + "junk" + Bytes8)), Counted);
  expect(binary + "HeaderSize = 10\n", "its HeaderSize is 10");
  expect(binary + "HeaderSize = -2\n", "its HeaderSize is -2");
  expect(binary + "HeaderSize = 1.5\n", "where 1 integer is required");
  expect("BinaryData = maybe\n", "where True or False is required");
  expect(binary + "ElementNumberOfChannels = 1e30\n", "where 1 integer is required");
  expect(binary + "ElementSpacing = 1 nan 1\n", "where 3 numbers are required");
  Save(folder / "s0.raw", Bytes8.substr(0, 4));
  ExpectProblem(
    Save(folder / "list.mhd", Meta(binary, "LIST") + "s0.raw\ns1.raw\n"), "s1.raw: No such file");
}

TEST(HostileFiles, NumbersInText)
{
  const Folder folder;
  const std::string path = folder / "a.mha", start = Meta("BinaryData = False\n");
  EXPECT_EQ(ReadValues(Save(path, start + "0 1 2.0 3 4e0 +5 6 7")), Counted);
  for (const char* wrong : { "1.5", "256", "-1", "1e30", "nan", "0x1", "x" })
  {
    ExpectProblem(Save(path, start + "0 0 0 0 0 0 0 " + wrong),
      "value 8 is '" + std::string(wrong) + "', where an integer from 0 to 255 is required");
  }
  ExpectProblem(Save(path, start + "0 0 0 0 0 0 0       "), "there are 7");
}

TEST(HostileFiles, FilesOutsideOfTheFolder)
{
  const Folder folder;
  std::filesystem::create_directory(folder / "in");
  std::filesystem::create_directory_symlink("..", folder / "in/link");
  Save(folder / "a.raw", Bytes8);
  Save(folder / "in/a.raw", Bytes8);
  const std::string path = folder / "in/a.nhdr";
  const auto save = [&](const std::string& name)
  { Save(path, Nrrd(Sizes) + "data file: " + name + "\n\n"); };
  for (const std::string& name :
    { std::string("../a.raw"), folder / "a.raw", std::string("link/a.raw") })
  {
    save(name);
    ExpectProblem(path, "outside of its folder");
    const InputTrust trust(true);
    EXPECT_EQ(ReadValues(path), Counted) << name;
  }
  for (const std::string& name : { std::string("a.raw"), folder / "in/a.raw" })
  {
    save(name);
    EXPECT_EQ(ReadValues(path), Counted) << name;
  }
  ExpectProblem(Save(folder / "in/a.mhd", Meta("BinaryData = True\n", "../a.raw")), "outside");
  const std::string spy = Save(folder / "in/a.spcth", "spycase\n../b.spcth\n");
  Ranks alone;
  EXPECT_NE(FindMessage([&] { OpenBlockFile(spy, alone); }).find("outside"), std::string::npos);
}

TEST(HostileFiles, SpecialFiles)
{
  const Folder folder;
  for (const char* name : { "f.nrrd", "f.mha", "f.nii", "f.tif", "f.dream3d" })
  {
    ASSERT_EQ(mkfifo((folder / name).c_str(), 0600), 0);
    ExpectProblem(folder / name, "it is not a regular file");
  }
  ExpectProblem(Save(folder / "a.nhdr", Nrrd(Sizes) + "data file: f.nrrd\n\n"),
    "f.nrrd: it is not a regular file");
  const std::string message = FindMessage([&] { ReadLabelNames(folder / "f.nrrd"); });
  EXPECT_NE(message.find("it is not a regular file"), std::string::npos) << message;
}

TEST(HostileFiles, LinesHaveABound)
{
  std::istringstream stream(std::string(LongestLine, 'a') + "\nb");
  std::string line;
  EXPECT_TRUE(ReadLine(stream, line));
  EXPECT_EQ(line.size(), LongestLine);
  EXPECT_TRUE(ReadLine(stream, line) && line == "b" && stream.eof());
  EXPECT_FALSE(ReadLine(stream, line));
  const std::string longer(LongestLine + 1, 'a');
  std::istringstream first(longer), second(longer);
  EXPECT_THROW(ReadLine(first, line), InputError);
  const InputTrust trust(true);
  EXPECT_TRUE(ReadLine(second, line));
  EXPECT_EQ(line, longer);
}

TEST(HostileFiles, SegmentsOfSlicer)
{
  const Folder folder;
  const std::string path = folder / "a.seg.nrrd";
  const std::string names = "Segment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
                            "Segment1_Name:=left kidney\nSegment1_LabelValue:=1\n"
                            "Segment1_Layer:=1\n";
  const auto save = [&](const std::string& lines, const std::string& bytes, bool isFirst = true)
  {
    const std::string kinds = "domain domain domain", axes = "(1,0,0) (0,1,0) (0,0,1)";
    return Save(path,
      "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 2 2 2 2\nencoding: raw\n" +
        (isFirst ? "kinds: list " + kinds + "\nspace directions: none " + axes
                 : "kinds: " + kinds + " list\nspace directions: " + axes + " none") +
        "\n" + lines + "\n" + bytes);
  };
  std::string apart(16, '\0'), overlap(16, '\0');
  apart[0] = apart[3] = overlap[0] = overlap[1] = 1; // first layer of voxel 0, second of voxel 1
  save(names, apart);
  EXPECT_EQ(ReadValues(path), (std::vector<int>{ 1, 2, 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(OpenImageFile(path).Names, (LabelNames{ { 1, "liver" }, { 2, "left kidney" } }));
  EXPECT_EQ(ReadValues(path, VolumeOf(1)), (std::vector<int>{ 0, 1, 0, 0, 0, 0, 0, 0 }));
  ExpectProblem(save(names, overlap), "its segments 'liver' and 'left kidney' overlap");
  EXPECT_EQ(ReadValues(path, VolumeOf(1)), (std::vector<int>{ 1, 0, 0, 0, 0, 0, 0, 0 }));
  ExpectProblem(save("", apart), "it holds 2 images (layers)");
  apart[3] = 0;
  apart[9] = 1; // the second layer follows the first
  save(names, apart, false);
  EXPECT_EQ(ReadValues(path), (std::vector<int>{ 1, 2, 0, 0, 0, 0, 0, 0 }));
  const TypedValues row = OpenImageFile(path).Read({ { { 1, 0, 0 } }, { { 2, 2, 1 } } });
  EXPECT_EQ(row.Bytes.size(), 2 * sizeof(int));
  EXPECT_EQ(row.Bytes[0], 2);
  EXPECT_EQ(OpenImageFile(path).Names, (LabelNames{ { 1, "liver" }, { 2, "left kidney" } }));
  EXPECT_EQ(ReadValues(path, VolumeOf(1)), (std::vector<int>{ 0, 1, 0, 0, 0, 0, 0, 0 }));
}

TEST(HostileFiles, LinksOfContainers)
{
  const Folder folder;
  const auto save = [&](const char* name, bool isExternal)
  {
    const std::string path = folder / name;
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t top = H5Gcreate2(file, "DataStructure", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    for (int i = 0; !isExternal && i < 200; ++i) // 200^5 paths
    {
      const std::string link = "/DataStructure/g" + std::to_string(i);
      H5Lcreate_hard(file, "/DataStructure", file, link.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    }
    if (isExternal)
    {
      H5Lcreate_external("cycle.dream3d", "/", top, "other", H5P_DEFAULT, H5P_DEFAULT);
    }
    H5Gclose(top);
    H5Fclose(file);
    return path;
  };
  ExpectProblem(save("cycle.dream3d", false), "it holds no image geometry");
  ExpectProblem(save("external.dream3d", true), "leads to another file");
}

TEST(HostileFiles, Checkpoints)
{
  const Folder folder;
  Ranks alone;
  for (const char* first : { "CheckPointVersion_1.0", "Checkpoint file for AmrCoreAdv" })
  {
    Save(folder / "Header", std::string(first) + "\n3\n");
    const std::string message = FindMessage([&] { OpenBlockFile(folder / ".", alone); });
    EXPECT_NE(message.find("a checkpoint of AMReX, not a plotfile"), std::string::npos) << message;
  }
}

TEST(HostileFiles, TextForTerminals)
{
  EXPECT_EQ(MakePrintable("f\xc3\xa4r \xe2\x82\xac \xf0\x9f\x99\x82"),
    "f\xc3\xa4r \xe2\x82\xac \xf0\x9f\x99\x82");
  EXPECT_EQ(MakePrintable("a\nb\tc"), "a b c");
  EXPECT_EQ(MakePrintable("\x1b[31m\x07"), "\\x1b[31m\\x07");
  EXPECT_EQ(MakePrintable("\xc2\x9b"), "\\xc2\\x9b");             // control character of 8 bits
  EXPECT_EQ(MakePrintable("\xe2\x80\xae"), "\\xe2\\x80\\xae");    // right to left
  EXPECT_EQ(MakePrintable("M\xfcller \xc3"), "M\\xfcller \\xc3"); // Latin-1, truncated
  EXPECT_EQ(MakePrintable("\xc0\x9b \xed\xa0\x80"), "\\xc0\\x9b \\xed\\xa0\\x80");
}
