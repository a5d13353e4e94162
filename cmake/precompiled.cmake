# Two ways to a build in less time, both with -DEVC_PRECOMPILE=ON (presets dev, asan and fuzz, determinism builds; why and
# at what price: docs/decisions/0016-sources-are-compiled-together.md).
# Headers of other libraries that many sources include (half of a build's time goes into reading them), compiled once:
# evc_precompiled(target [TEST] [JSON]) lets the sources of a target use them. Ours are not among them.
# Sources of a target compiled together: evc_together(target).
# Every source must include what it uses and compile alone, which the builds without this option check.

set(EVC_TOGETHER 12 CACHE STRING "With EVC_PRECOMPILE: how many sources of a target are compiled at a time; 0: all")
option(EVC_PRECOMPILE "Precompile headers of other libraries, and compile the sources of a target together" OFF)

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

# evc_together(target): its sources are compiled EVC_TOGETHER at a time, so that headers are read and templates
# instantiated once for all of them. Names in unnamed namespaces must differ between the sources of a target, and each
# source must compile alone too (docs/development.md).
function(evc_together target)
  if(EVC_PRECOMPILE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${EVC_TOGETHER})
  endif()
endfunction()

# evc_in_two(target NAME PATTERN): two objects instead, unity_NAME of the sources that match, and unity_rest.
function(evc_in_two target name pattern)
  if(EVC_PRECOMPILE)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      set(group rest)
      if(source MATCHES "${pattern}")
        set(group ${name})
      endif()
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
    endforeach()
  endif()
endfunction()
