#include "Base/ParseText.h"
#include "CellCount.h"
#include "Hdf5.h"
#include "Hdf5Check.h"
#include "Images/ImageFile.h"
#include "InputTrust.h"
#include "OpenFile.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <iterator>
#include <set>
#include <vector>

namespace vfm
{
namespace
{

std::string Join(const std::string& group, const std::string& name)
{
  return group + "/" + name;
}

constexpr const char* NoHdf5 = "it is not an HDF5 file, or it is damaged.";

std::string CannotRead(const std::string& path)
{
  return path + " cannot be read.";
}

/// Tests whether a path leads to an object of a kind, H5I_GROUP or H5I_DATASET.
/// @throws InputError  if the object cannot be opened
bool IsKind(hid_t file, const std::string& path, H5I_type_t kind)
{
  const bool isThere = H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0 &&
    H5Oexists_by_name(file, path.c_str(), H5P_DEFAULT) > 0; // no: a soft link to nothing
  if (!isThere)
  {
    return false;
  }
  const Hdf5Handle item(H5Oopen(file, path.c_str(), H5P_DEFAULT), H5Oclose, CannotRead(path));
  return H5Iget_type(item) == kind;
}

/// Returns the names of the links of a group; of none if there is no such group.
std::vector<std::string> ListNames(hid_t file, const std::string& group)
{
  std::vector<std::string> names;
  if (!IsKind(file, group, H5I_GROUP))
  {
    return names;
  }
  const auto take = [](hid_t, const char* name, const H5L_info_t*, void* list)
  {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return herr_t(0);
  };
  if (H5Literate_by_name(
        file, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &names, H5P_DEFAULT) < 0)
  {
    throw InputError(CannotRead(group));
  }
  return names;
}

/// Returns the identity of an object, which is equal for all links to it.
std::string Identify(hid_t file, const std::string& path)
{
#if H5_VERSION_GE(1, 12, 0)
  H5O_info2_t info;
  const bool isFound =
    H5Oget_info_by_name3(file, path.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) >= 0;
  const auto& identity = info.token;
#else
  H5O_info_t info;
  const bool isFound =
    H5Oget_info_by_name2(file, path.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) >= 0;
  const haddr_t& identity = info.addr;
#endif
  return isFound ? std::string(reinterpret_cast<const char*>(&identity), sizeof(identity)) : path;
}

/// Checks that no chunk is larger than the largest size of its data set: the library reads such
/// chunks beyond their values.
void CheckChunks(hid_t data, hid_t storage, const std::string& path)
{
  const Hdf5Handle space(H5Dget_space(data), H5Sclose, CannotRead(path));
  const int rank = std::max(H5Sget_simple_extent_ndims(space), 0);
  std::vector<hsize_t> most(rank), chunk(rank);
  H5Sget_simple_extent_dims(space, nullptr, most.data());
  const bool isGood = H5Pget_chunk(storage, rank, chunk.data()) == rank &&
    std::equal(chunk.begin(), chunk.end(), most.begin(), std::less_equal<hsize_t>());
  if (!isGood)
  {
    throw InputError(path + " has chunks that are larger than its shape.");
  }
}

/// Checks that the values of a data set are in its file, unless the file is trusted.
void CheckStorage(hid_t data, const std::string& path)
{
  const Hdf5Handle storage(H5Dget_create_plist(data), H5Pclose, CannotRead(path));
  const bool isElsewhere =
    H5Pget_layout(storage) == H5D_VIRTUAL || H5Pget_external_count(storage) > 0;
  if (isElsewhere && !InputTrust::IsGiven())
  {
    throw InputError(path + " has its values in other files. " + InputTrust::Advice);
  }
  if (H5Pget_layout(storage) == H5D_CHUNKED)
  {
    CheckChunks(data, storage, path);
  }
}

/// Checks that values are numbers of a usual type. The library writes beyond its buffers if a
/// damaged type has, for instance, more bits than bytes.
void CheckType(hid_t type, const std::string& path)
{
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_INTEGER && kind != H5T_FLOAT)
  {
    throw InputError(path + " holds no numbers.");
  }
  const hid_t usual[] = { H5T_STD_I8LE, H5T_STD_I8BE, H5T_STD_U8LE, H5T_STD_U8BE, H5T_STD_I16LE,
    H5T_STD_I16BE, H5T_STD_U16LE, H5T_STD_U16BE, H5T_STD_I32LE, H5T_STD_I32BE, H5T_STD_U32LE,
    H5T_STD_U32BE, H5T_STD_I64LE, H5T_STD_I64BE, H5T_STD_U64LE, H5T_STD_U64BE, H5T_IEEE_F32LE,
    H5T_IEEE_F32BE, H5T_IEEE_F64LE, H5T_IEEE_F64BE };
  if (std::none_of(std::begin(usual), std::end(usual),
        [type](hid_t known) { return H5Tequal(type, known) > 0; }))
  {
    throw InputError(path +
      " holds numbers of an unusual type. Supported: integers of 8 to 64 "
      "bits, and IEEE 754 numbers of 32 and 64 bits.");
  }
}

/// Reads three numbers of a data set, or of an attribute of a group. Returns whether there is one.
bool ReadThree(hid_t file, const std::string& group, const std::string& name, Vector3& numbers)
{
  const std::string path = Join(group, name);
  const htri_t found = H5Aexists_by_name(file, group.c_str(), name.c_str(), H5P_DEFAULT);
  if (found < 0)
  {
    throw InputError(CannotRead(path));
  }
  const bool isAttribute = found > 0;
  if (!isAttribute && !IsKind(file, path, H5I_DATASET))
  {
    return false;
  }
  const Hdf5Handle item(isAttribute
      ? H5Aopen_by_name(file, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT)
      : H5Dopen2(file, path.c_str(), H5P_DEFAULT),
    isAttribute ? H5Aclose : H5Dclose, CannotRead(path));
  if (!isAttribute)
  {
    CheckStorage(item, path);
  }
  const Hdf5Handle type(
    isAttribute ? H5Aget_type(item) : H5Dget_type(item), H5Tclose, CannotRead(path));
  CheckType(type, path);
  const Hdf5Handle space(
    isAttribute ? H5Aget_space(item) : H5Dget_space(item), H5Sclose, CannotRead(path));
  const bool isRead = H5Sget_simple_extent_npoints(space) == 3 &&
    (isAttribute
        ? H5Aread(item, H5T_NATIVE_DOUBLE, numbers.data())
        : H5Dread(item, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data())) >= 0;
  if (!isRead)
  {
    throw InputError(path + " is not three numbers.");
  }
  return true;
}

/// Grid of cells, and the group that holds its arrays.
struct Geometry
{
  std::string Group;
  ImagePlace Place;
};

/// Reads the place of an image geometry; returns whether the group has one.
/// @param names  names of size, spacing and origin
bool ReadGeometry(
  hid_t file, const std::string& group, const std::array<const char*, 3>& names, ImagePlace& place)
{
  Vector3 size{};
  if (!ReadThree(file, group, names[0], size))
  {
    return false;
  }
  for (int a = 0; a < 3; ++a)
  {
    place.Size[a] = ToSize(size[a]);
  }
  if (!ReadThree(file, group, names[1], place.Spacing) ||
    !ReadThree(file, group, names[2], place.Origin))
  {
    throw InputError(group + " has no spacing or no origin.");
  }
  CheckPlace(place);
  return true;
}

/// Finds the image geometries below a group: in DREAM.3D 6, /DataContainers/NAME/_SIMPL_GEOMETRY;
/// in DREAM3D-NX, groups of /DataStructure.
/// @param depth  number of levels of nested groups that are searched
/// @param visited  identities of the groups that were searched; each is searched once
void FindGeometries(hid_t file, const std::string& group, int depth, std::vector<Geometry>& found,
  std::set<std::string>& visited)
{
  for (const std::string& name : ListNames(file, group))
  {
    const std::string path = Join(group, name), simpl = Join(path, "_SIMPL_GEOMETRY");
    if (!IsKind(file, path, H5I_GROUP) || !visited.insert(Identify(file, path)).second)
    {
      continue;
    }
    ImagePlace place;
    if ((IsKind(file, simpl, H5I_GROUP) &&
          ReadGeometry(file, simpl, { "DIMENSIONS", "SPACING", "ORIGIN" }, place)) ||
      ReadGeometry(file, path, { "_DIMENSIONS", "_SPACING", "_ORIGIN" }, place))
    {
      found.push_back({ path, place });
    }
    else if (depth > 0)
    {
      FindGeometries(file, path, depth - 1, found, visited);
    }
  }
}

/// Returns the sizes of a data set; the first index changes slowest.
std::vector<hsize_t> GetShape(hid_t data)
{
  const Hdf5Handle space(H5Dget_space(data), H5Sclose, "a shape cannot be read.");
  std::vector<hsize_t> shape(std::max(H5Sget_simple_extent_ndims(space), 0));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

/// Returns the sizes of a data set without a last size of 1, the number of components.
std::vector<hsize_t> GetCellShape(hid_t data)
{
  std::vector<hsize_t> shape = GetShape(data);
  if ((shape.size() == 4 || shape.size() == 2) && shape.back() == 1)
  {
    shape.pop_back();
  }
  return shape;
}

/// Tests whether a data set has one value per cell: its shape is z, y, x, or the number of cells.
bool FitsCells(const std::vector<hsize_t>& shape, const Index3& size)
{
  const auto isSame = [](hsize_t a, Index b) { return static_cast<Index>(a) == b; };
  return std::equal(shape.begin(), shape.end(), size.rbegin(), size.rend(), isSame) ||
    (shape.size() == 1 && isSame(shape[0], size[0] * size[1] * size[2]));
}

std::string DescribeShape(const std::vector<hsize_t>& shape)
{
  std::vector<std::string> sizes;
  std::transform(shape.begin(), shape.end(), std::back_inserter(sizes),
    [](hsize_t size) { return std::to_string(size); });
  return JoinTexts(sizes, " x ");
}

struct CellArray
{
  std::string Path;
  ImagePlace Place;
  bool FitsCells = false; ///< false: listed only for messages
  std::string Shape;      ///< shape of the data set, for messages
};

/// Lists the arrays of all grids.
std::vector<CellArray> ListCellArrays(hid_t file, const std::vector<Geometry>& geometries)
{
  std::vector<CellArray> found;
  std::set<std::string> visited;
  for (const Geometry& geometry : geometries)
  {
    for (const std::string& matrix : ListNames(file, geometry.Group))
    {
      const std::string group = Join(geometry.Group, matrix);
      if (!IsKind(file, group, H5I_GROUP) || !visited.insert(Identify(file, group)).second)
      {
        continue;
      }
      for (const std::string& name : ListNames(file, group))
      {
        const std::string path = Join(group, name);
        if (matrix != "_SIMPL_GEOMETRY" && IsKind(file, path, H5I_DATASET))
        {
          const Hdf5Handle data(
            H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose, CannotRead(path));
          const bool fits = FitsCells(GetCellShape(data), geometry.Place.Size);
          found.push_back({ path, geometry.Place, fits, DescribeShape(GetShape(data)) });
        }
      }
    }
  }
  return found;
}

/// Type of values in memory, one of ValueType and the type of HDF5.
struct MemoryType
{
  int Type;
  hid_t Hdf5;
};

/// Returns a type in memory for a stored type. Integers that may exceed a label are read as long
/// long, so that a value out of range does not become another label.
MemoryType ChooseType(hid_t stored, const std::string& path)
{
  CheckType(stored, path);
  const std::size_t size = H5Tget_size(stored);
  if (H5Tget_class(stored) == H5T_FLOAT)
  {
    return size > 4 ? MemoryType{ ValueType::Double, H5T_NATIVE_DOUBLE }
                    : MemoryType{ ValueType::Float, H5T_NATIVE_FLOAT };
  }
  const bool isLong = size > 4 || (size == 4 && H5Tget_sign(stored) == H5T_SGN_NONE);
  return isLong ? MemoryType{ ValueType::LongLong, H5T_NATIVE_LLONG }
                : MemoryType{ ValueType::Int, H5T_NATIVE_INT };
}

/// Tests whether a path ends with `end`, which may not begin inside a name of the path.
bool EndsWith(const std::string& path, const std::string& end)
{
  const std::string whole = end.compare(0, 1, "/") == 0 ? end : "/" + end;
  return path.size() >= whole.size() &&
    path.compare(path.size() - whole.size(), whole.size(), whole) == 0;
}

/// Checks that a file does not refer to other files, unless it is trusted.
void CheckLinks(hid_t file)
{
  const auto check = [](hid_t, const char* name, const H5L_info_t* info, void* text)
  {
    if (info->type == H5L_TYPE_HARD || info->type == H5L_TYPE_SOFT)
    {
      return herr_t(0);
    }
    *static_cast<std::string*>(text) = name;
    return herr_t(1);
  };
  std::string found;
  // Each group is visited once, also if links form cycles.
  const herr_t end =
    InputTrust::IsGiven() ? 0 : H5Lvisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, check, &found);
  if (end < 0)
  {
    throw InputError(NoHdf5);
  }
  if (end > 0)
  {
    throw InputError("its link '" + found + "' leads to another file. " + InputTrust::Advice);
  }
}

hid_t Open(const std::string& path)
{
  CheckHdf5(path);
  return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

/// Returns the array whose path ends with a name; there must be exactly one.
CellArray Choose(const std::vector<CellArray>& arrays, const std::string& name)
{
  CellArray chosen;
  std::vector<std::string> others, misfits;
  for (const CellArray& array : arrays)
  {
    const std::string own = array.Path.substr(array.Path.rfind('/') + 1);
    if (!array.FitsCells)
    {
      misfits.push_back(own + " (" + array.Shape + ")");
    }
    else if (!EndsWith(array.Path, name))
    {
      others.push_back(own);
    }
    else if (chosen.Path.empty())
    {
      chosen = array;
    }
    else
    {
      throw InputError("it holds two cell arrays " + name + ": " + chosen.Path + " and " +
        array.Path + ". Select one of them by its path.");
    }
  }
  if (chosen.Path.empty())
  {
    throw InputError("it holds no cell array '" + name +
      "' with one value per cell. Other arrays: " + (others.empty() ? "none" : JoinTexts(others)) +
      (misfits.empty() ? "." : ". Arrays of other sizes: " + JoinTexts(misfits) + ".") +
      (others.empty() ? ""
                      : " Choose one of them: --labels " + QuoteName(others[0]) +
            " (sculptor) or Cell Array (ParaView)."));
  }
  return chosen;
}

/// Reads a part of a data set.
/// @param first,count  begin and size of the part along each index
void ReadSlab(hid_t data, hid_t type, const std::string& array, const std::vector<hsize_t>& first,
  const std::vector<hsize_t>& count, char* to)
{
  const Hdf5Handle stored(H5Dget_space(data), H5Sclose, CannotRead(array));
  const Hdf5Handle memory(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
    H5Sclose, CannotRead(array));
  if (H5Sselect_hyperslab(stored, H5S_SELECT_SET, first.data(), nullptr, count.data(), nullptr) <
      0 ||
    H5Dread(data, type, memory, stored, H5P_DEFAULT, to) < 0)
  {
    throw InputError("the values of " + array + " cannot be read.");
  }
}

/// Reads a box of values that are stored in one row, x fastest: all rows of a layer at once.
/// @param width  bytes per value
/// @param read  reads `length` values from value `begin` on
void ReadFlat(const Index3& size, const IndexBox& box, Index width, char* to,
  const std::function<void(Index begin, Index length, char* to)>& read)
{
  const Index rows = box.Size(1), length = box.Size(0) * width;
  std::vector<char> layer(static_cast<std::size_t>(rows * size[0] * width));
  for (Index k = box.Lower[2]; k < box.Upper[2]; ++k)
  {
    read((k * size[1] + box.Lower[1]) * size[0], rows * size[0], layer.data());
    for (Index j = 0; j < rows; ++j)
    {
      std::memcpy(to, layer.data() + (j * size[0] + box.Lower[0]) * width, length);
      to += length;
    }
  }
}

/// @param size  number of cells of the grid along each axis
TypedValues ReadBox(
  const std::string& path, const std::string& array, const Index3& size, const IndexBox& box)
{
  const Hdf5Silence silence;
  const Hdf5Handle file(Open(path), H5Fclose, NoHdf5);
  const Hdf5Handle data(H5Dopen2(file, array.c_str(), H5P_DEFAULT), H5Dclose, CannotRead(array));
  CheckStorage(data, array);
  const Hdf5Handle storedType(H5Dget_type(data), H5Tclose, CannotRead(array));
  const MemoryType type = ChooseType(storedType, array);
  TypedValues values = MakeValues("", type.Type, box.NumberOfCells());
  std::vector<hsize_t> first(GetShape(data).size(), 0), count(first.size(), 1);
  if (first.size() > 2)
  {
    for (int a = 0; a < 3; ++a)
    {
      first[2 - a] = static_cast<hsize_t>(box.Lower[a]);
      count[2 - a] = static_cast<hsize_t>(box.Size(a));
    }
    ReadSlab(data, type.Hdf5, array, first, count, values.Bytes.data());
    return values;
  }
  ReadFlat(size, box, WidthOfType(type.Type), values.Bytes.data(),
    [&](Index begin, Index length, char* to)
    {
      first[0] = static_cast<hsize_t>(begin);
      count[0] = static_cast<hsize_t>(length);
      ReadSlab(data, type.Hdf5, array, first, count, to);
    });
  return values;
}

} // namespace

ImageFile OpenDream3d(const std::string& path, const ImageRequest& request)
{
  const Hdf5Silence silence;
  const Hdf5Handle file(Open(path), H5Fclose, NoHdf5);
  CheckLinks(file);
  std::vector<Geometry> geometries;
  constexpr int depth = 4; // levels of nested groups
  std::set<std::string> visited;
  FindGeometries(file, "/DataContainers", 0, geometries, visited);
  FindGeometries(file, "/DataStructure", depth, geometries, visited);
  ImagePlace place;
  const std::string old = "/VoxelDataContainer";
  if (IsKind(file, old, H5I_GROUP) &&
    ReadGeometry(file, old, { "DIMENSIONS", "SPACING", "ORIGIN" }, place))
  {
    geometries.push_back({ old, place });
  }
  if (geometries.empty())
  {
    throw InputError("it holds no image geometry of DREAM.3D (/DataContainers, "
                     "/VoxelDataContainer) or DREAM3D-NX (/DataStructure).");
  }
  const CellArray chosen = Choose(ListCellArrays(file, geometries), request.Array);
  ImageFile image;
  image.Place = chosen.Place;
  image.IsOfCells = true;
  CheckLength(path, 0, CountCells(image.Place.Size), true);
  image.Read = [path, array = chosen.Path, size = chosen.Place.Size](const IndexBox& box)
  { return ReadBox(path, array, size, box); };
  return image;
}

} // namespace vfm
