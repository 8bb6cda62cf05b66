/**
 * FailedOutput: the outputs of an algorithm that failed: empty, with the message
 * in their field data.
 *
 * RequestData returns 1 nevertheless. If it returned 0, VTK would report a second error and would
 * not run downstream filters, and a ParaView view would stop updating after two failures in a row.
 */
#pragma once

class vtkAlgorithm;
class vtkDataObject;
class vtkInformationVector;

namespace vfm
{

/// Empties the outputs of an algorithm (EmptyOutput) and sets the text as the field data array
/// MeshError, a vtkStringArray.
void MarkFailed(vtkInformationVector* outputs, const char* text) noexcept;

/// Empties the outputs by MarkFailed and reports the error.
void Fail(vtkAlgorithm* algorithm, vtkInformationVector* outputs, const char* text);

/// Returns the text of a failed output; "" for null and for data without an error. It is valid as
/// long as the data.
const char* FindFailure(vtkDataObject* data) noexcept;

} // namespace vfm
