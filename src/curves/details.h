#pragma once
#include <vector>

#include "curves/result.h"
#include "curves/tables.h"

namespace evc::curves {

/// The tables of `query.details`, in the order of their names in docs/curves.md.
std::vector<ResultTable> detail_tables(const Approached& approached);

}  // namespace evc::curves
