/**
 * TiffDescription: number and order of the pages of a TIFF file and the sizes of its voxels, in the
 * description that ImageJ or OME write into the first page.
 */
#pragma once

#include "Base/IndexBox.h"

#include <array>
#include <string>

namespace vfm
{

/// Content of the description of the first page.
struct TiffDescription
{
  std::string Program; ///< "ImageJ", "OME", or empty without such a description
  Index Slices = 1, Channels = 1, Times = 1;
  Index SliceStep = 1, ChannelStep = 1, TimeStep = 1; ///< numbers of pages from one to the next
  std::array<double, 2> Widths{};                     ///< widths of pixels; 0: not described
  double Distance = 0.0;                              ///< distance of slices; 0: not described
  std::string Unit; ///< unit of the resolution of the pages; empty: not described

  Index CountImages() const { return this->Slices * this->Channels * this->Times; }
  Index CountVolumes() const { return this->Channels * this->Times; }
  /// Returns the page of a slice of a volume; volumes are numbered with channels fastest.
  Index FindPage(Index volume, Index slice) const
  {
    return slice * this->SliceStep + volume % this->Channels * this->ChannelStep +
      volume / this->Channels * this->TimeStep;
  }
};

/// Parses the description of the first page. If there are several images along only one of the axes
/// slices, channels and times, these are slices, because programs confuse the axes.
/// @param samples  number of values per pixel, which OME counts as channels
TiffDescription ParseTiffDescription(const std::string& text, int samples);

} // namespace vfm
