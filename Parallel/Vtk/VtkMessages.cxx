#include "VtkMessages.h"

#include "Base/ParseText.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <algorithm>
#include <regex>

namespace vfm
{
namespace
{

void AddOnce(std::vector<std::string>& list, const std::string& text)
{
  if (!text.empty() && std::find(list.begin(), list.end(), text) == list.end())
  {
    list.push_back(text);
  }
}

/// Output window that stores errors and warnings in VtkMessages and discards other texts.
class MessageWindow : public vtkOutputWindow
{
public:
  static MessageWindow* New();
  vtkTypeMacro(MessageWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { this->Messages->AddError(text); }
  void DisplayWarningText(const char* text) override { this->Messages->AddWarning(text); }
  void DisplayGenericWarningText(const char* text) override { this->Messages->AddWarning(text); }
  void DisplayDebugText(const char*) override {}

  VtkMessages* Messages = nullptr;
};
vtkStandardNewMacro(MessageWindow);

} // namespace

std::string CleanVtkMessage(const std::string& message)
{
  const auto remove = [](const std::string& text, const std::regex& what)
  { return std::regex_replace(text, what, "", std::regex_constants::format_first_only); };
  static const std::regex place("^(ERROR|Warning|Generic Warning): In [^\n]*, line [0-9]+\n");
  static const std::regex object("^[A-Za-z_0-9:]* ?\\((0x)?[0-9a-f]+\\): ");
  const std::string text = remove(remove(message, place), object);
  const std::size_t first = text.find_first_not_of(" \n");
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

VtkMessages::VtkMessages() : Observer(vtkSmartPointer<vtkCallbackCommand>::New())
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(&VtkMessages::Take);
}

VtkMessages::~VtkMessages()
{
  for (const vtkWeakPointer<vtkObject>& object : this->Watched)
  {
    if (object)
    {
      object->RemoveObserver(this->Observer);
    }
  }
}

void VtkMessages::Watch(vtkObject* object)
{
  object->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  object->AddObserver(vtkCommand::WarningEvent, this->Observer);
  this->Watched.emplace_back(object);
  if (vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    this->Watch(algorithm->GetExecutive());
  }
}

void VtkMessages::Take(vtkObject*, unsigned long event, void* self, void* text)
{
  VtkMessages* messages = static_cast<VtkMessages*>(self);
  const std::string message = static_cast<const char*>(text);
  if (event == vtkCommand::WarningEvent)
  {
    messages->AddWarning(message);
  }
  else
  {
    messages->AddError(message);
  }
}

const std::vector<std::string>& VtkMessages::GetErrors() const
{
  return this->Errors.empty() ? this->Failures : this->Errors;
}

std::string VtkMessages::GetErrorText() const
{
  std::string joined = JoinTexts(this->GetErrors(), " ");
  std::replace(joined.begin(), joined.end(), '\n', ' ');
  return joined;
}

void VtkMessages::AddError(const std::string& message)
{
  // VTK writes "Algorithm vtkName (0x...) returned failure for request: " and a
  // dump of the request.
  static const std::regex failure(
    "^Algorithm ([A-Za-z0-9_]+) ?\\([^)]*\\) returned failure for request");
  const std::string text = CleanVtkMessage(message);
  std::smatch match;
  const bool isFailure = std::regex_search(text, match, failure);
  AddOnce(
    isFailure ? this->Failures : this->Errors, isFailure ? match[1].str() + " failed." : text);
}

void VtkMessages::AddWarning(const std::string& message)
{
  AddOnce(this->Warnings, CleanVtkMessage(message));
}

VtkSilence::VtkSilence(VtkMessages& messages)
{
  vtkSmartPointer<MessageWindow> window = vtkSmartPointer<MessageWindow>::New();
  window->Messages = &messages;
  vtkOutputWindow::SetInstance(window);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkSilence::~VtkSilence()
{
  vtkOutputWindow::SetInstance(nullptr);
}

} // namespace vfm
