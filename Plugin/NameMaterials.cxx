#include "NameMaterials.h"

#include "vtkNew.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <vector>

namespace vfm
{
namespace
{

using Colour = std::array<double, 3>;

/// Returns the colour of material 0, 1, 2, ...: a few selected colours, then hues with maximum
/// distance, in three tones. An id has the same colour in all meshes.
Colour ColourOf(int id)
{
  constexpr std::array<Colour, 6> First = { { { 0.58, 0.50, 0.74 }, { 0.36, 0.62, 0.80 },
    { 0.91, 0.62, 0.36 }, { 0.79, 0.42, 0.45 }, { 0.55, 0.72, 0.42 }, { 0.86, 0.78, 0.40 } } };
  if (id >= 0 && id < static_cast<int>(First.size()))
  {
    return First[id];
  }
  constexpr double GoldenRatio = 0.6180339887498949;
  constexpr double Turn = 6.283185307179586;
  const double hue = Turn * (GoldenRatio * id - std::floor(GoldenRatio * id));
  const double middle = 0.52 + 0.13 * (std::abs(id) % 3);
  Colour colour;
  for (int c = 0; c < 3; ++c)
  {
    colour[c] = middle + 0.18 * std::cos(hue - Turn * c / 3);
  }
  return colour;
}

std::vector<double> ColoursWithoutValues(vtkSMProxy* colourMap)
{
  std::vector<double> points = vtkSMPropertyHelper(colourMap, "RGBPoints").GetDoubleArray();
  for (std::size_t p = 0; p < points.size(); p += 4)
  {
    points[p] = 0.0; // the range follows the data
  }
  return points;
}

/// Returns whether a colour map has the colours of a new one.
bool IsUnchanged(vtkSMProxy* colourMap)
{
  vtkSmartPointer<vtkSMProxy> fresh;
  fresh.TakeReference(colourMap->GetSessionProxyManager()->NewProxy(
    colourMap->GetXMLGroup(), colourMap->GetXMLName()));
  vtkNew<vtkSMParaViewPipelineController> controller;
  controller->PreInitializeProxy(fresh);
  controller->PostInitializeProxy(fresh);
  return vtkSMPropertyHelper(colourMap, "Annotations").GetNumberOfElements() == 0 &&
    vtkSMPropertyHelper(colourMap, "ColorSpace").GetAsInt() ==
    vtkSMPropertyHelper(fresh, "ColorSpace").GetAsInt() &&
    ColoursWithoutValues(colourMap) == ColoursWithoutValues(fresh);
}

/// Alternating ids and names, and the colours of the ids; there may be more colours.
struct Legend
{
  std::vector<std::string> Texts;
  std::vector<double> Colours;
};

/// Returns the index of an id in the legend, or -1.
int FindId(const Legend& legend, int id)
{
  for (std::size_t t = 0; t + 1 < legend.Texts.size(); t += 2)
  {
    if (legend.Texts[t] == std::to_string(id))
    {
      return static_cast<int>(t);
    }
  }
  return -1;
}

void AddColour(std::vector<double>& colours, std::size_t place, int id)
{
  if (colours.size() >= 3 * (place + 1))
  {
    return; // the user chose a palette with this colour
  }
  for (std::size_t own = colours.size(); own > 0 && colours.size() < 3 * place;)
  {
    colours.push_back(colours[colours.size() % own]); // a map with fewer colours repeats them
  }
  colours.resize(3 * place);
  const Colour colour = ColourOf(id);
  colours.insert(colours.end(), colour.begin(), colour.end());
}

/// Adds names to a legend. Returns whether anything changed.
bool AddNames(Legend& legend, const MaterialNames& names, MaterialNames& given)
{
  bool changed = false;
  for (const auto& [id, name] : names)
  {
    const int place = FindId(legend, id);
    if (place < 0)
    {
      AddColour(legend.Colours, legend.Texts.size() / 2, id);
      legend.Texts.insert(legend.Texts.end(), { std::to_string(id), name });
      changed = true;
    }
    else if (legend.Texts[place + 1] != name)
    {
      auto old = given.find(id);
      if (old == given.end() || old->second != legend.Texts[place + 1])
      {
        continue; // name given by the user
      }
      legend.Texts[place + 1] = name;
      changed = true;
    }
    given[id] = name;
  }
  return changed;
}

Legend ReadLegend(vtkSMProxy* colourMap)
{
  Legend legend;
  vtkSMPropertyHelper texts(colourMap, "Annotations");
  for (unsigned int t = 0; t < texts.GetNumberOfElements(); ++t)
  {
    legend.Texts.emplace_back(texts.GetAsString(t));
  }
  if (vtkSMPropertyHelper(colourMap, "IndexedLookup").GetAsInt() != 0)
  {
    legend.Colours = vtkSMPropertyHelper(colourMap, "IndexedColors").GetDoubleArray();
  }
  return legend;
}

void WriteLegend(vtkSMProxy* colourMap, const Legend& legend)
{
  vtkSMPropertyHelper texts(colourMap, "Annotations");
  texts.SetNumberOfElements(static_cast<unsigned int>(legend.Texts.size()));
  for (std::size_t t = 0; t < legend.Texts.size(); ++t)
  {
    texts.Set(static_cast<unsigned int>(t), legend.Texts[t].c_str());
  }
  vtkSMPropertyHelper(colourMap, "IndexedColors")
    .Set(legend.Colours.data(), static_cast<unsigned int>(legend.Colours.size()));
}

} // namespace

bool NameMaterials(vtkSMProxy* colourMap, const MaterialNames& names, MaterialNames& given)
{
  constexpr std::size_t MaximumNames = 256; // longer legends are unreadable
  vtkSMPropertyHelper categories(colourMap, "IndexedLookup");
  const bool isNew = categories.GetAsInt() == 0;
  if (names.empty() || (names.size() > MaximumNames && given.empty()) ||
    (isNew && !IsUnchanged(colourMap)))
  {
    return false;
  }
  Legend legend = ReadLegend(colourMap);
  if (AddNames(legend, names, given))
  {
    categories.Set(legend.Texts.size() / 2 > MaximumNames ? 0 : 1);
    WriteLegend(colourMap, legend);
    vtkSMPropertyHelper(colourMap, "AnnotationsInitialized").Set(1);
    colourMap->UpdateVTKObjects();
  }
  return isNew;
}

} // namespace vfm
