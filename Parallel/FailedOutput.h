/**
 * What an algorithm leaves where it failed: empty outputs that say why. RequestData returns 1 then nevertheless. Of 0 VTK makes a
 * second message, runs no filter behind, and a view of ParaView that was told so twice in a row does not ask again.
 */
#pragma once

class vtkAlgorithm;
class vtkDataObject;
class vtkInformationVector;

namespace vfm
{

/// Empties the outputs of an algorithm, but for the extent of an image; the value of their field data MeshError (vtkStringArray) is the text.
void MarkFailed(vtkInformationVector* outputs, const char* text) noexcept;

/// And reports the error.
void Fail(vtkAlgorithm* algorithm, vtkInformationVector* outputs, const char* text);

/// The text, "" of data that were made, or null. Valid as long as the data.
const char* FindFailure(vtkDataObject* data) noexcept;

} // namespace vfm
