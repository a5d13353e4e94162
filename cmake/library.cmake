# Libraries for hosts (docs/embedding.md): openevc::kernel, openevc::curves, openevc::language, openevc::sim, and the C
# interface openevc::c. Each is one archive of the rooms' objects; no object is in two of them.
# openevc::core is their common part; a host need not name it.

# evc_library(name OBJECTS objects... DEPENDS public libraries...): openevc::<name>, libopenevc_<name>.a
function(evc_library name)
  cmake_parse_arguments(LIBRARY "" "" "OBJECTS;DEPENDS" ${ARGN})
  add_library(openevc_${name} STATIC ${LIBRARY_OBJECTS})
  add_library(openevc::${name} ALIAS openevc_${name})
  set_target_properties(openevc_${name} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_link_libraries(openevc_${name} PUBLIC openevc_headers)
  foreach(other IN LISTS LIBRARY_DEPENDS)
    target_link_libraries(openevc_${name} PUBLIC openevc_${other})
  endforeach()
endfunction()

# The objects of rooms; those of header-only rooms are none.
function(evc_objects variable)
  set(objects "")
  foreach(room IN LISTS ARGN)
    get_target_property(type evc_${room} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      list(APPEND objects $<TARGET_OBJECTS:evc_${room}>)
    endif()
  endforeach()
  set(${variable} ${objects} PARENT_SCOPE)
endfunction()

set(core base terms lang train)
set(curves sdm)
set(kernel ${EVC_KERNEL_ROOM_NAMES})
list(REMOVE_ITEM kernel ${core} ${curves})
foreach(part IN ITEMS core curves kernel)
  evc_objects(${part}_objects ${${part}})
endforeach()
evc_library(core OBJECTS ${core_objects})
evc_library(curves OBJECTS ${curves_objects} DEPENDS core)
evc_library(kernel OBJECTS ${kernel_objects} DEPENDS core curves)

if(NOT EVC_KERNEL_ONLY)
  # Of io the JSON of telegrams, its parser and its errors are the language's; the rest reads lines, trains and inputs.
  set(language_sources "/(telegram_(decode|encode|text)|language|json_parser|diagnostic)[.]cpp")
  set(language "${language_sources}|/unity_language_")
  foreach(room IN ITEMS io embed)
    evc_in_two(evc_${room} language ${language_sources})
  endforeach()
  set(io_objects $<TARGET_OBJECTS:evc_io> $<TARGET_OBJECTS:evc_embed>)
  evc_library(language OBJECTS $<FILTER:${io_objects},INCLUDE,${language}> DEPENDS core)
  evc_library(sim OBJECTS $<TARGET_OBJECTS:evc_sim> $<TARGET_OBJECTS:evc_texts> $<FILTER:${io_objects},EXCLUDE,${language}> DEPENDS kernel language)
endif()
