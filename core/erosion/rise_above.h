// How far a point stands above its receiver after an implicit step of the stream power law.
//
//   per_dt x + g x^n = c      x > 0, for c > 0
//
// x rise (m); per_dt 1 / length of the step (1/yr), 0 for an infinite one; g = k A^m / length^n; c
// (m/yr) uplift and what stood above the receiver before, over the step. Newton's iteration inside
// a bracket, begun on the side from which it never passes the root; closed form for n = 1. Relative
// error some 1e-12 for n from 0.5 to 4.
#pragma once

namespace orogen {

/// `guess` (m): where to begin, if it is near.
double rise_above(double c, double per_dt, double g, double n, double guess);

}  // namespace orogen
