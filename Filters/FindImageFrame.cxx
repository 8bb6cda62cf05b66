#include "FindImageFrame.h"

#include "CollectBlocks.h"
#include "Ranks/WorkTogether.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

namespace vfm
{
namespace
{

ImageFrame FrameOf(const InputPart& part)
{
  vtkImageData* image = vtkImageData::SafeDownCast(part.Data);
  if (!image)
  {
    return {};
  }
  std::array<double, 9> axes;
  std::copy_n(image->GetDirectionMatrix()->GetData(), 9, axes.begin());
  const double* origin = image->GetOrigin();
  return MakeImageFrame(axes, { { origin[0], origin[1], origin[2] } }, part.Name);
}

} // namespace

ImageFrame FindImageFrame(const std::vector<InputPart>& parts, Ranks& ranks)
{
  std::vector<ImageFrame> frames;
  WorkTogether(ranks,
    [&]
    {
      for (const InputPart& part : parts)
      {
        if (part.HasPoints()) // a rank without cells may lack the matrix
        {
          frames.push_back(FrameOf(part));
        }
      }
    });
  return AgreeOnFrame(std::move(frames), ranks);
}

} // namespace vfm
