/**
 * VtkArrays: checks that an array of an XML file of VTK is intact, as VTK's readers read it.
 */
#pragma once

#include "GridFiles/VtkNumbers.h"
#include "GridFiles/VtkStorage.h"
#include "GridFiles/XmlOutline.h"

namespace vfm
{

/// Reads the values of an array: text, base64 or raw bytes, compressed or not. The memory does not
/// depend on their number.
/// @param array  element DataArray, or Array with texts
/// @param tuples  number of tuples that the grid requires; nothing if it does not say
/// @param visit  receives each value, if not empty
/// @throws InputError  if the type, number of components or place is invalid, if a value is not of
///   the type or out of its range, if compressed or base64 data are damaged, or if there are fewer
///   or more values than the grid requires; the message does not contain the path
void CheckVtkArray(const OutlineElement& array, std::optional<std::int64_t> tuples,
  const VtkStorage& storage, const VisitVtkValue& visit = nullptr);

} // namespace vfm
