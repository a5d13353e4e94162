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

# evc_tell_paths(files...): the paths for tests, only for the files that use them, directly or through a header, so
# that a compiler cache works for the others in every clone.
function(evc_tell_paths)
  foreach(file IN LISTS ARGN)
    file(STRINGS ${file} uses REGEX "EVC_SOURCE_DIR|EVC_PROGRAM|(curves|program|bit_by_bit)_test\\.h" LIMIT_COUNT 1)
    if(uses)
      set_property(SOURCE ${file} APPEND PROPERTY COMPILE_DEFINITIONS EVC_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                  EVC_PROGRAM="$<$<TARGET_EXISTS:evc>:$<TARGET_FILE:evc>>")
    endif()
  endforeach()
endfunction()

function(evc_room name)
  cmake_parse_arguments(ROOM "KERNEL;PROGRAM_TESTS" "MAIN" "DEPENDS;LIBRARIES;TEST_LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*/*.cpp)
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
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
    add_executable(${name}_test ${tests})
    target_link_libraries(${name}_test PRIVATE ${library} GTest::gtest_main ${ROOM_TEST_LIBRARIES})
    target_compile_options(${name}_test PRIVATE ${EVC_TEST_OPTIONS})
    evc_precompiled(${name}_test TEST ${json})
    evc_tell_paths(${tests})
    if(ROOM_PROGRAM_TESTS)
      add_dependencies(${name}_test evc)
    endif()
    add_test(NAME ${name} COMMAND ${name}_test)
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
  foreach(room IN ITEMS sim io texts kernel driver procedures protection sdm radio track balise brakes modes position
                        train airgap lang port terms base)
    if(TARGET evc_${room})
      target_link_libraries(${target} PRIVATE evc_${room})
    endif()
  endforeach()
  target_compile_definitions(${target} PRIVATE EVC_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
endfunction()
