/**
 * @class   vtkVolumeFractionFilter
 * @brief   base of the filters that make or read meshes: ranks, pieces and options
 *
 * All ranks of the Controller must update together. Each one requests its piece of the input.
 */
#ifndef vtkVolumeFractionFilter_h
#define vtkVolumeFractionFilter_h

#include "vtkUnstructuredGridAlgorithm.h"
#include "vtkVolumeFractionMeshFiltersModule.h" // for export macro

#include <memory> // for member

/**
 * Sets and returns an option of the mesher by name (Mesher/Options/OptionTable.cxx). Choices, and
 * integers except options for tetrahedra, are clamped to their range. Other numbers out of range
 * are errors of the update.
 */
#define vfmNumberOption(name, type)                                                                \
  void Set##name(type value)                                                                       \
  {                                                                                                \
    this->SetNumber(#name, static_cast<double>(value));                                            \
  }                                                                                                \
  type Get##name()                                                                                 \
  {                                                                                                \
    return static_cast<type>(this->GetNumber(#name));                                              \
  }
#define vfmSwitchOption(name)                                                                      \
  vfmNumberOption(name, bool);                                                                     \
  void name##On()                                                                                  \
  {                                                                                                \
    this->Set##name(true);                                                                         \
  }                                                                                                \
  void name##Off()                                                                                 \
  {                                                                                                \
    this->Set##name(false);                                                                        \
  }
#define vfmTextOption(name)                                                                        \
  void Set##name(const char* text)                                                                 \
  {                                                                                                \
    this->SetText(#name, text);                                                                    \
  }                                                                                                \
  const char* Get##name()                                                                          \
  {                                                                                                \
    return this->GetText(#name);                                                                   \
  }

class vtkMultiProcessController;

namespace vfm
{
struct MesherOptions;
} // namespace vfm

class VTKVOLUMEFRACTIONMESHFILTERS_EXPORT vtkVolumeFractionFilter :
  public vtkUnstructuredGridAlgorithm
{
public:
  vtkTypeMacro(vtkVolumeFractionFilter, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Ranks that have pieces of the input. Default: the global controller.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkVolumeFractionFilter();
  ~vtkVolumeFractionFilter() override = 0; // an abstract class

  vtkExecutive* CreateDefaultExecutive() override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  void SetNumber(const char* option, double value);
  double GetNumber(const char* option) const;
  void SetText(const char* option, const char* value);
  const char* GetText(const char* option) const;

  vtkMultiProcessController* Controller = nullptr;
  std::unique_ptr<vfm::MesherOptions> Options;

private:
  vtkVolumeFractionFilter(const vtkVolumeFractionFilter&) = delete;
  void operator=(const vtkVolumeFractionFilter&) = delete;
};

#endif
