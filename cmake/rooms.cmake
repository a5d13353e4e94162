# Flags and the shape of a room: evc_room(name [KERNEL] [MAIN file] [PROGRAM_TESTS] [DEPENDS rooms...] [LIBRARIES targets...]
# [TEST_LIBRARIES targets...]) makes the library evc_<name> from src/<name>/*.cpp (without MAIN) and the test <name>_test
# from *_test.cpp; with PROGRAM_TESTS these run the program `evc`.

include(GNUInstallDirs)

# Required by everything that compiles our headers, host programs included: C++20, the headers, and the same bits from
# every compiler and level (docs/architecture.md), because the headers contain computations. No contraction, no fast-math.
add_library(openevc_headers INTERFACE)
add_library(openevc::headers ALIAS openevc_headers)
set_target_properties(openevc_headers PROPERTIES EXPORT_NAME headers)
target_compile_features(openevc_headers INTERFACE cxx_std_20)
target_compile_options(openevc_headers INTERFACE -ffp-contract=off)
target_include_directories(openevc_headers INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

# Internal: the rooms' headers, and warnings. It does not apply to a host program.
add_library(evc_private INTERFACE)
target_link_libraries(evc_private INTERFACE openevc_headers)
target_include_directories(evc_private INTERFACE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include/openevc)
target_compile_options(evc_private INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                                             -Wold-style-cast -Wnon-virtual-dtor)
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(evc_private INTERFACE -Werror)  # a host's newer compiler may warn
endif()
# Under -fsanitize (the Debug build) g++ 12 has false positives: sign conversions of promoted unsigned shifts.
target_compile_options(evc_private INTERFACE $<$<CONFIG:Debug>:-Wno-sign-conversion>)
# g++ 12 reports false overlaps in std::string's operator+ (GCC bug 105651), at -O2 and above.
target_compile_options(evc_private INTERFACE
                       $<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<CONFIG:RelWithDebInfo>>>:-Wno-restrict>)
if(EVC_COVERAGE)
  target_compile_options(evc_private INTERFACE --coverage)
  target_link_options(evc_private INTERFACE --coverage)
endif()

set(EVC_TEST_OPTIONS "" CACHE STRING "Further options for the sources of tests, such as -O0: they are half of the build")

set_property(GLOBAL PROPERTY EVC_KERNEL_ROOMS "")
include(cmake/precompiled.cmake)

# The paths that tests read from are compiled in here and nowhere else (src/base/test_paths.h).
if(EVC_TESTS)
  add_library(evc_test_paths STATIC ${PROJECT_SOURCE_DIR}/src/base/test_paths.cpp)
  target_link_libraries(evc_test_paths PUBLIC evc_private)
  target_compile_definitions(evc_test_paths PRIVATE
                             EVC_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                             $<$<TARGET_EXISTS:evc>:EVC_COMMAND="$<$<TARGET_EXISTS:evc>:$<TARGET_FILE:evc>>">)
endif()

# Those that take longest, under sanitizers too, the longest first: what starts last must not be left alone at the end.
set(EVC_LONG_TESTS scenarios whole.journey exploration app through_step run track airgap sdm lang curves)
# Journeys do not count as coverage, because they do not check every line that they reach (tools/check_sanitizers).
set(EVC_JOURNEYS "^(whole[.].*|app|sim|run|curves|language|readme|random_lines)$")

# evc_add_test(name COMMAND...): add_test, with what it needs when all tests run (ctest -j).
function(evc_add_test name)
  add_test(NAME ${name} COMMAND ${ARGN})
  list(FIND EVC_LONG_TESTS ${name} place)
  if(place GREATER_EQUAL 0)
    math(EXPR cost "100 - ${place}")
    set_tests_properties(${name} PROPERTIES COST ${cost})
  endif()
  if(EVC_COVERAGE AND name MATCHES "${EVC_JOURNEYS}")
    set_tests_properties(${name} PROPERTIES ENVIRONMENT GCOV_PREFIX=${PROJECT_BINARY_DIR}-journeys)
  endif()
endfunction()

# evc_link_first(target PRIVATE|INTERFACE libraries...): these are linked whole, in front of all objects.
function(evc_link_first target scope)
  foreach(library IN LISTS ARGN)
    target_link_options(${target} ${scope} LINKER:--whole-archive,$<TARGET_FILE:${library}>,--no-whole-archive)
  endforeach()
endfunction()

# evc_test(name [JSON] [MAIN library] SOURCES... LINKS libraries... [FIRST libraries...]): the executable of tests;
# JSON if they include the JSON library. MAIN: gtest where the sources have a main of their own. FIRST, for tests that
# run long: of an inline function or an instance of a template the linker takes the first copy that it meets, for all.
# Those of these libraries come before those of the test's sources, which are compiled with EVC_TEST_OPTIONS (-O0).
function(evc_test name)
  cmake_parse_arguments(TEST "JSON" "MAIN" "SOURCES;LINKS;FIRST" ${ARGN})
  if(NOT TEST_MAIN)
    set(TEST_MAIN gtest_main)
  endif()
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE ${TEST_LINKS} evc_private evc_test_paths GTest::${TEST_MAIN})
  target_compile_options(${name} PRIVATE ${EVC_TEST_OPTIONS})
  evc_link_first(${name} PRIVATE ${TEST_FIRST})
  if(TEST_JSON)
    evc_precompiled(${name} TEST JSON)
  else()
    evc_precompiled(${name} TEST)
  endif()
  evc_together(${name})
endfunction()

function(evc_room name)
  cmake_parse_arguments(ROOM "KERNEL;PROGRAM_TESTS" "MAIN" "DEPENDS;LIBRARIES;TEST_LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*/*.cpp)
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "(_test|/test_[^/]*)\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")
  if(ROOM_MAIN)
    list(REMOVE_ITEM sources ${CMAKE_CURRENT_SOURCE_DIR}/${ROOM_MAIN})
  endif()
  set(library evc_${name})
  # With the room io its JSON library comes along.
  set(json "")
  if("io" IN_LIST ROOM_DEPENDS OR "${ROOM_LIBRARIES};${ROOM_TEST_LIBRARIES}" MATCHES "nlohmann_json")
    set(json JSON)
  endif()
  if(sources)
    add_library(${library} STATIC ${sources})
    set(scope PUBLIC)
    evc_together(${library})
    if(ROOM_KERNEL)
      # Kernel rooms need neither exceptions nor run-time types.
      target_compile_options(${library} PRIVATE -fno-exceptions -fno-rtti -fno-asynchronous-unwind-tables
                                                -fno-threadsafe-statics -fno-math-errno
                                                # clang would ask for bcmp where memcmp is written
                                                $<$<CXX_COMPILER_ID:Clang>:-fno-builtin-bcmp>)
      set_property(GLOBAL APPEND PROPERTY EVC_KERNEL_ROOMS ${library})
    elseif(json)  # a kernel room's own sources have other options, and no JSON
      evc_precompiled(${library} JSON)
    endif()
  else()
    add_library(${library} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_link_libraries(${library} ${scope} evc_private)
  foreach(other IN LISTS ROOM_DEPENDS)
    target_link_libraries(${library} ${scope} evc_${other})
  endforeach()
  if(ROOM_LIBRARIES)
    target_link_libraries(${library} ${scope} ${ROOM_LIBRARIES})
  endif()
  if(tests AND EVC_TESTS)
    evc_test(${name}_test ${json} SOURCES ${tests} LINKS ${library} ${ROOM_TEST_LIBRARIES})
    if(ROOM_PROGRAM_TESTS)
      add_dependencies(${name}_test evc)
    endif()
    evc_add_test(${name} ${name}_test)
  endif()
endfunction()

# evc_embed(room FILES... [PARTS files...]): pages are part of the program. The text of page.html becomes the string
# literal page_template, in pieces that every compiler accepts; PARTS are files used by several pages.
function(evc_embed room)
  cmake_parse_arguments(EMBED "" "" "PARTS" ${ARGN})
  set(parts ${EMBED_PARTS})
  list(TRANSFORM parts PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  foreach(file IN LISTS EMBED_UNPARSED_ARGUMENTS)
    get_filename_component(page ${file} NAME_WE)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${page}_template.cpp)
    add_custom_command(
      OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -DINPUT=${CMAKE_CURRENT_SOURCE_DIR}/${file} -DOUTPUT=${source} -DROOM=${room}
              -DNAME=${page}_template "-DINCLUDES=${EMBED_PARTS}" -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
      DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${parts} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
      VERBATIM)
    target_sources(evc_${room} PRIVATE ${source})
  endforeach()
endfunction()

# evc_link_rooms(target): links every room that exists, for tests, benchmarks and fuzz targets that
# concern the whole program.
function(evc_link_rooms target)
  foreach(room IN ITEMS paint dmi sim io texts kernel driver procedures protection sdm radio track balise brakes modes position
                        train airgap lang port terms base)
    if(TARGET evc_${room})
      target_link_libraries(${target} PRIVATE evc_${room})
    endif()
  endforeach()
endfunction()
