/**
 * The half-space, or the layer between two parallel planes, nearest to the fractions of a cell and of those around it.
 *
 * Everything is in the frame of the cell: the unit cube centred at the origin. The cells around it have their own
 * widths there, so nothing is assumed of how widths change. Fits start at the gradient of the fractions (layers: at
 * their moments of inertia) and minimise the squared errors of the fractions by Gauss-Newton steps that keep the volume
 * in the cell, so that what is flat is found to rounding (LVIRA; Pilliod, Puckett 2004).
 */
#pragma once

#include "Base/CartesianGrid.h"

namespace vfm
{

/// A cell and the fraction of it that is filled.
struct FractionSample
{
  Vector3 Centre, Size;
  double Value;  ///< 0..1
  double Weight; ///< >= 0
};

/// Points with Lower < Normal.x < Upper. Lower of a half-space is -infinity.
struct Layer
{
  Vector3 Normal; ///< unit
  double Lower, Upper;
};

/// The part of a box that lies in the layer.
double FractionInLayer(const Layer& layer, const Vector3& centre, const Vector3& size);

struct LayerFit
{
  bool IsFound = false;
  Layer Region;
  double Error = 1.0; ///< weighted root mean square of the errors of the fractions
};

/// samples: first the cell itself, 0 < Value < 1. Not found where the fractions show no direction.
LayerFit FitHalfSpace(const std::vector<FractionSample>& samples);

/// Of a film thinner than about a cell and a half.
LayerFit FitFilm(const std::vector<FractionSample>& samples);

} // namespace vfm
