#include "Modify/PeriodImages.h"

#include "Report/DomainSides.h"

#include <cmath>

namespace vfm
{

PeriodImages::PeriodImages(const FieldArrays& fields, bool hasCopies) :
  Lengths{ { 0.0, 0.0, 0.0 } }, HasCopies(hasCopies)
{
  const std::vector<double> lengths = NumbersOfField(fields, "PeriodLengths");
  std::copy_n(lengths.begin(), std::min<std::size_t>(lengths.size(), 3), this->Lengths.begin());
  MeshData mesh;
  mesh.Fields = fields;
  this->Frame = FrameOfDomain(mesh);
  this->HasCopies = hasCopies || this->Lengths == Vector3{ { 0.0, 0.0, 0.0 } };
}

Vector3 PeriodImages::ToOwn(const Vector3& x) const
{
  return this->Frame.IsIdentity() ? x : this->Frame.ToOwn(x);
}

Vector3 PeriodImages::ImageOf(const Vector3& own, const Vector3& nearTo) const
{
  const Vector3 near = this->ToOwn(nearTo);
  Vector3 image = own;
  for (int a = 0; a < 3; ++a)
  {
    const double length = this->Lengths[a];
    image[a] += length > 0.0 ? length * std::round((near[a] - own[a]) / length) : 0.0;
  }
  return this->Frame.IsIdentity() ? image : this->Frame.ToSpace(image);
}

} // namespace vfm
