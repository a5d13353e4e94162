#pragma once
#include <string>

namespace evc::scenario {

/// Steps two units through the inputs of a scenario (inputs_of): one through the kernel's interface, one through that
/// of C. Empty if the outputs of C are those of the kernel in every cycle; otherwise the first difference.
std::string compare_through_c(const std::string& inputs);

}  // namespace evc::scenario
