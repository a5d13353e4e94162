# Headers of other libraries that many sources include (half of a build's time goes into reading them), compiled once
# with -DEVC_PRECOMPILE=ON. Ours are not among them: every source must include what it uses, which the builds without
# this option (release, clang) check. evc_precompiled(target [TEST] [JSON]) lets the sources of a target use them.

option(EVC_PRECOMPILE "Precompile the headers of GoogleTest and of the JSON library for tests and program" OFF)

function(evc_precompile name)
  target_link_libraries(${name} PRIVATE evc_private)
  target_precompile_headers(${name} PRIVATE <algorithm> <array> <cmath> <fstream> <functional> <map> <memory> <optional>
                                            <random> <set> <span> <sstream> <string> <vector> ${ARGN})
endfunction()

# One target per combination of options: a precompiled header serves only sources with the same ones, and those of a
# library are not those of a program.
if(EVC_PRECOMPILE)
  set(source ${PROJECT_BINARY_DIR}/precompiled.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "int main() {}\n")
  add_library(evc_headers_JSON OBJECT EXCLUDE_FROM_ALL ${source})
  evc_precompile(evc_headers_JSON <nlohmann/json.hpp>)
  if(EVC_TESTS)
    add_executable(evc_headers_TEST EXCLUDE_FROM_ALL ${source})
    evc_precompile(evc_headers_TEST <gtest/gtest.h>)
    add_executable(evc_headers_TEST_JSON EXCLUDE_FROM_ALL ${source})
    evc_precompile(evc_headers_TEST_JSON <gtest/gtest.h> <nlohmann/json.hpp>)
    foreach(name IN ITEMS evc_headers_TEST evc_headers_TEST_JSON)
      target_link_libraries(${name} PRIVATE GTest::gtest)
      target_compile_options(${name} PRIVATE ${EVC_TEST_OPTIONS})
    endforeach()
  endif()
endif()

function(evc_precompiled target)
  if(EVC_PRECOMPILE)
    list(JOIN ARGN "_" kind)
    target_precompile_headers(${target} REUSE_FROM evc_headers_${kind})
  endif()
endfunction()
