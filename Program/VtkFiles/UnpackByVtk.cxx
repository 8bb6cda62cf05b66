#include "VtkFiles/UnpackByVtk.h"

#include "vtkLZ4DataCompressor.h"
#include "vtkLZMADataCompressor.h"
#include "vtkNew.h"
#include "vtkZLibDataCompressor.h"

namespace vfm
{
namespace
{

template <class Compressor>
bool Unpack(const std::vector<unsigned char>& packed, std::vector<unsigned char>& unpacked)
{
  const vtkNew<Compressor> compressor;
  const std::size_t size =
    compressor->Uncompress(packed.data(), packed.size(), unpacked.data(), unpacked.size());
  return size == unpacked.size();
}

} // namespace

UnpackVtkBlock UnpackByVtk()
{
  return [](const std::string& compressor, const std::vector<unsigned char>& packed,
           std::vector<unsigned char>& unpacked)
  {
    return compressor == "vtkZLibDataCompressor" ? Unpack<vtkZLibDataCompressor>(packed, unpacked)
      : compressor == "vtkLZ4DataCompressor"     ? Unpack<vtkLZ4DataCompressor>(packed, unpacked)
                                                 : Unpack<vtkLZMADataCompressor>(packed, unpacked);
  };
}

} // namespace vfm
