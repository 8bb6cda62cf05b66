/**
 * GaussRule: points and weights of Gauss on [0, 1], exact for polynomials of degree 5.
 */
#pragma once

namespace vfm
{

constexpr double GaussPoints[3] = { 0.1127016653792583, 0.5, 0.8872983346207417 };
constexpr double GaussWeights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };

} // namespace vfm
