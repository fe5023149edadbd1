// Compression spread out as the crust spreads it (an addition to paper C, section 5.2).
//
//   S = G * (|C| e₁e₁ᵀ)         G: Gaussian of `smoothing` metres;  C = |C| e₁ as in compression.h
//   C' = (s₁ - s₂) e            s₁ >= s₂ eigenvalues of S, e the eigenvector of s₁
//
// The compression of paper C ends with a step at the rigid plates' borders, and folds with it. A
// line element and its opposite are the same, so that it is the tensor that is smoothed, not C.
#pragma once

#include "foundation/context.h"
#include "tectonics/compression.h"

namespace orogen {

/// The field with C smoothed; 0 leaves it.
CompressionField smoothed_compression(const CompressionField& field, double smoothing,
                                      const Context& context);

}  // namespace orogen
