// What several devices gain: one picture in parts, and a film.
#pragma once

#include "tests/bench/cuda/cuda_cases.h"

namespace suffuse {

/// Seconds by one device and by all, medians of so many runs, nine at the most.
Result<std::vector<CudaFact>> timesOnSeveralDevices(const CudaCase &c, int runs);

} // namespace suffuse
