// Measures of a fold skeleton (paper C, section 7.3, Table 3 and Fig. 16), over the map's
// rectangle.
//
// Nodes are the points where crests begin, bend or meet. A fold is a line between ends and joints;
// their number is half the number of crests at those, so that folds cut by the border count in
// part. The wavelength is measured from crest to crest: from the middle of each crest along ±C to
// the next crest, weighted by the crest's length across C, as straight sections through the folds
// would give.
#pragma once

#include <array>

#include "folding/fold_skeleton.h"

namespace orogen {

struct FoldStatistics {
  static constexpr int kAngleBins = 18, kWavelengthBins = 30;

  int nodes = 0;
  int ends = 0;                                      // nodes with one crest
  int joints = 0;                                    // nodes with three or more
  double mean_length = 0.0;                          // of a fold, over λ
  double mean_wavelength = 0.0;                      // crest to crest, over λ
  std::array<double, kAngleBins> angle{};            // shares by 5°: fold normal against C
  std::array<double, kWavelengthBins> wavelength{};  // shares by 0.1 λ: crest to crest
};

FoldStatistics fold_statistics(const CompressionField& field, const FoldWavelength& wavelength,
                               const FoldSkeleton& skeleton);

}  // namespace orogen
