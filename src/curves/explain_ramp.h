#pragma once
#include "curves/explain_page.h"
#include "curves/result.h"
#include "sdm/limits.h"

// The sections of `--explain` on the reduced build-up times of 4.0.0 (A.3.12).
namespace evc::curves {

/// T_bs_reduced for the curve that ends at `end`, for a train at `fronts_est`; `reduced`: the time used.
void explain_T_bs_reduced(ExplainPage& page, const Approached& approached, const sdm::Explanation& e, Place end,
                          Place est_front, Duration reduced);
/// T_be_reduced; `times`: those of the EBD with it.
void explain_T_be_reduced(ExplainPage& page, const Approached& approached, const sdm::Explanation& e, Place est_front,
                          Place min_safe_front, const sdm::Times& times);

}  // namespace evc::curves
