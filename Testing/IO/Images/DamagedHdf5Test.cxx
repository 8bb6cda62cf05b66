/// Files of DREAM.3D whose HDF5 structure is damaged: an error with a message, where the HDF5
/// library would read or write beyond its memory.
#include "FileCases.h"
#include "Images/ImageFile.h"

#include <array>
#include <hdf5.h>

using namespace vfm;
using namespace vfm::testing;

namespace
{

/// Writes an attribute of three values.
void WriteThree(hid_t group, const char* name, hid_t type, double value)
{
  const hsize_t three = 3;
  const std::array<double, 3> values{ { value, value, value } };
  const hid_t space = H5Screate_simple(1, &three, nullptr);
  const hid_t attribute = H5Acreate2(group, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data());
  H5Aclose(attribute);
  H5Sclose(space);
}

/// Writes an image of 2 x 2 x 2 labels, 0 to 7.
/// @param version  oldest version of the library that can read the file
std::string WriteImage(const std::string& path, H5F_libver_t version = H5F_LIBVER_EARLIEST)
{
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_libver_bounds(access, version, H5F_LIBVER_LATEST);
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  const hid_t parents = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_create_intermediate_group(parents, 1);
  const hid_t grid = H5Gcreate2(file, "DataStructure/Grid", parents, H5P_DEFAULT, H5P_DEFAULT);
  WriteThree(grid, "_DIMENSIONS", H5T_STD_U64LE, 2.0);
  WriteThree(grid, "_SPACING", H5T_IEEE_F32LE, 1.0);
  WriteThree(grid, "_ORIGIN", H5T_IEEE_F32LE, 0.0);
  const std::array<hsize_t, 3> size{ { 2, 2, 2 } };
  const std::array<int, 8> labels{ { 0, 1, 2, 3, 4, 5, 6, 7 } };
  const hid_t storage = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(storage, 3, size.data());
  H5Pset_deflate(storage, 6);
  const hid_t space = H5Screate_simple(3, size.data(), nullptr);
  const hid_t data =
    H5Dcreate2(grid, "Cells/FeatureIds", H5T_STD_I32LE, space, parents, storage, H5P_DEFAULT);
  H5Dwrite(data, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, labels.data());
  H5Lcreate_hard(file, "/", file, "Cycle", H5P_DEFAULT, H5P_DEFAULT);
  H5Lcreate_soft("/DataStructure/Grid", file, "soft", H5P_DEFAULT, H5P_DEFAULT);
  H5Gclose(H5Gcreate2(file, "Empty", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Gclose(H5Gcreate2(file, "Removed", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Ldelete(file, "Removed", H5P_DEFAULT);
  H5Dclose(data);
  H5Sclose(space);
  H5Pclose(storage);
  H5Gclose(grid);
  H5Fclose(file);
  H5Pclose(parents);
  H5Pclose(access);
  return path;
}

std::vector<int> ReadLabels(const std::string& path)
{
  const ImageFile file = OpenImageFile(path);
  const TypedValues values = file.Read({ {}, file.Place.Size });
  const auto* first = reinterpret_cast<const int*>(values.Bytes.data());
  return { first, first + 8 };
}

/// Bytes that replace others.
struct Damage
{
  std::string Mark;  ///< text before the place
  std::size_t Shift; ///< place behind the beginning of the mark
  std::string Bytes;
  std::string Problem; ///< part of the message
};

std::string Word(std::uint64_t number)
{
  std::string bytes;
  for (int i = 0; i < 8; ++i)
  {
    bytes += static_cast<char>(number >> (8 * i));
  }
  return bytes;
}

} // namespace

TEST(DamagedHdf5, IntactFilesOfAllVersions)
{
  const Folder folder;
  const std::vector<int> labels{ 0, 1, 2, 3, 4, 5, 6, 7 };
  for (const H5F_libver_t version : { H5F_LIBVER_EARLIEST, H5F_LIBVER_V18, H5F_LIBVER_LATEST })
  {
    EXPECT_EQ(ReadLabels(WriteImage(folder / "a.dream3d", version)), labels) << version;
  }
  const std::string bytes = ReadBytes(folder / "a.dream3d");
  std::ofstream(folder / "b.dream3d", std::ios::binary) << std::string(1024, ' ') << bytes;
  EXPECT_EQ(ReadLabels(folder / "b.dream3d"), labels) << "behind other data";
}

TEST(DamagedHdf5, StructureIsCheckedBeforeTheLibraryReadsIt)
{
  const Folder folder;
  const std::string intact = ReadBytes(WriteImage(folder / "a.dream3d"));
  const std::string root = "\x89HDF";
  const std::uint64_t tree = intact.find("TREE");
  const std::string integers("\x10\x08\0\0\4\0\0\0\0\0\x20\0", 12);
  const std::string reals("\x11\x20\x1f\0\4\0\0\0\0\0\x20\0\x17\x08\0\x17", 16);
  const std::string outside = "a number has bits outside of its bytes";
  const Damage damages[] = {
    { integers, 10, "\x18", "FeatureIds holds numbers of an unusual type" },
    { integers, 10, "\x90", outside },
    { integers, 10, std::string("\0", 1), outside },
    { integers, 8, "\1", outside },
    { reals, 10, "\x90", outside },
    { reals, 2, "\x20", outside },
    { reals, 12, "\x19", outside },
    { reals, 13, std::string("\0", 1), outside },
    { reals, 15, "\xff", outside },
    { integers, 4, std::string("\0\0\0\xff", 4), "a type is unknown" },
    { integers, 0, "\x1f", "a type is unknown" },
    { std::string("\3\0\x10\0\1\0\0\0", 8) + integers, 0, "\x83", "FeatureIds cannot be read" },
    { "\3\2\4", 12, std::string("\0\3", 2), "chunks that are larger than its shape" },
    { std::string("_DIMENSIONS\0", 12), 40, Word(1 << 20),
      "an attribute is shorter than its values" },
    { std::string("_DIMENSIONS\0", 12), 11, "....", "" },
    { "HEAP", 8, Word(0), "a group has no names" },
    { "HEAP", 24, Word(1 << 30), "an address is behind its end" },
    { "TREE", 5, "\1", "has no tree of its entries" },
    { "TREE", 32, Word(tree), "a tree of a group repeats itself" },
    { "SNOD", 6, "\xff\xff", "entries of a group are damaged" },
    { "SNOD", 8, Word(1 << 20), "a name of a group has no end" },
    { root, 13, "\4", "its version is unknown" },
    { root, 96 + 8, "\xff\xff\xff\x7f", "an address is behind its end" },
    { root, 96, "\7", "an object is unknown" },
    { root, 96 + 4, "\1", "an object has more links than it counts" },
  };
  for (const Damage& damage : damages)
  {
    std::string bytes = intact;
    bytes.replace(intact.find(damage.Mark) + damage.Shift, damage.Bytes.size(), damage.Bytes);
    std::ofstream(folder / "b.dream3d", std::ios::binary) << bytes;
    std::string message;
    try
    {
      ReadLabels(folder / "b.dream3d");
    }
    catch (const InputError& error)
    {
      message = error.what();
    }
    EXPECT_NE(message.find(damage.Problem), std::string::npos)
      << damage.Mark << " + " << damage.Shift << ": '" << message << "'";
    EXPECT_FALSE(message.empty()) << damage.Mark << " + " << damage.Shift;
  }
}
