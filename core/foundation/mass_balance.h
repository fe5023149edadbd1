// What a stage moved. Volumes in m³, summed in double.
#pragma once

#include <cmath>

namespace orogen {

struct MassBalance {
  double eroded_m3 = 0.0;
  double deposited_m3 = 0.0;
  double exported_m3 = 0.0;  // left through the sea or an open side
  double supplied_m3 = 0.0;  // uplift, rain, sources
  double stored_m3 = 0.0;    // change of what is on its way (suspended)
  double residual_m3 = 0.0;  // what the books do not explain

  MassBalance& operator+=(const MassBalance& other) {
    eroded_m3 += other.eroded_m3;
    deposited_m3 += other.deposited_m3;
    exported_m3 += other.exported_m3;
    supplied_m3 += other.supplied_m3;
    stored_m3 += other.stored_m3;
    residual_m3 += other.residual_m3;
    return *this;
  }

  /// |residual| over the larger of what was eroded and supplied.
  double relative_residual() const {
    const double throughput = std::fmax(std::fmax(eroded_m3, supplied_m3), 1e-300);
    return std::fabs(residual_m3) / throughput;
  }
};

}  // namespace orogen
