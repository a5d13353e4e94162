#pragma once
#include <string>

// Places that tests read from. Only test_paths.cpp is compiled with them: everything else of a test is the same in
// every checkout, and a compiler cache serves them all.
namespace evc::test {

/// The folder of the checkout.
std::string source_folder();
/// The folder of material that is not part of the product: OPENEVC_SHARED, or `shared` beside the checkout. It may be
/// missing.
std::string shared_folder();
/// The command `evc` of this build; empty if the build has none.
std::string evc_command();

}  // namespace evc::test
