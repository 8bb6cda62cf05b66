/**
 * NrrdSegments: segments of a segmentation of 3D Slicer (.seg.nrrd), which are stored as labels in
 * one or several layers.
 */
#pragma once

#include "Images/NrrdFields.h"
#include "TypedValues.h"

#include <string>
#include <vector>

namespace vfm
{

/// Segment: the points of a layer that have a value.
struct NrrdSegment
{
  std::string Name;
  Index Value = 1; ///< stored value
  Index Layer = 0; ///< number of the layer, from 0
  int Label = 0;   ///< label in an image of all layers
};

/// Returns the segments that a header describes. Their labels are the stored values if these
/// differ, otherwise the numbers of the segments, from 1.
/// @throws InputError  if a segment has an invalid value or layer
std::vector<NrrdSegment> ListSegments(const NrrdFields& fields);

/// Returns one layer of an image.
/// @param stored  values of all layers, which follow one another for each point
TypedValues TakeLayer(const TypedValues& stored, Index layers, Index layer);

/// Stores one layer among the values of all layers, which follow one another for each point.
void PutLayer(const TypedValues& values, Index layers, Index layer, TypedValues& all);

/// Returns the labels of the segments in all layers; 0 where there is none.
/// @param stored  values of all layers, which follow one another for each point
/// @throws InputError  if two segments have a common point, or if a value belongs to no segment
TypedValues MergeLayers(
  const TypedValues& stored, Index layers, const std::vector<NrrdSegment>& segments);

} // namespace vfm
