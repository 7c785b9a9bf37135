# What makes builds quick: files of a layer are compiled together; only the layers that compute are optimized in full, and what they
# share with others is theirs; the headers of others are parsed once. With STICTION_SANITIZE Clang makes their templates then, too,
# and parses what most files of a target include.
set(STICTION_COMPUTES linear interface solid contact dynamics halfspace)
set(STICTION_PATIENCE 120) # s, for a test
if(STICTION_SANITIZE)
  set(STICTION_PATIENCE 900)
endif()

set(STICTION_OTHERS fmt/format.h Eigen/Dense algorithm chrono cmath filesystem fstream functional limits map memory numeric optional set
    sstream stdexcept string variant vector) # most files include them
list(TRANSFORM STICTION_OTHERS REPLACE "(.+)" "<\\1>")

function(precompile target) # precompile(TARGET [HEADER...]), headers of the engine or in <brackets>, for checkers
  if(STICTION_SANITIZE)
    list(TRANSFORM ARGN PREPEND ${PROJECT_SOURCE_DIR}/engine/ REGEX "^[^<]")
    target_precompile_headers(${target} PRIVATE ${STICTION_OTHERS} ${ARGN})
  elseif(STICTION_UNITY) # once for all that compile alike
    get_target_property(options ${target} COMPILE_OPTIONS)
    string(MAKE_C_IDENTIFIER "${options}" alike)
    get_property(first GLOBAL PROPERTY STICTION_PRECOMPILED_${alike})
    if(first)
      target_precompile_headers(${target} REUSE_FROM ${first})
    else()
      set_property(GLOBAL PROPERTY STICTION_PRECOMPILED_${alike} ${target})
      target_precompile_headers(${target} PRIVATE ${STICTION_OTHERS})
    endif()
  endif()
endfunction()

function(optimize target)
  if(STICTION_SANITIZE)
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()

function(optimize_little target) # what takes longer to compile than it ever runs
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # at -O1 it takes the other alternatives of a variant for read
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-Wno-maybe-uninitialized>)
  endif()
endfunction()

# Several files at a time share what their headers cost and their templates, the more the fewer texts there are, as long as every
# core has its own. What tests/exercise compiles anew stays apart.
cmake_host_system_information(RESULT STICTION_CORES QUERY NUMBER_OF_LOGICAL_CORES)
set(STICTION_TOGETHER 8)
if(STICTION_CORES LESS 5 AND NOT STICTION_SANITIZE)
  math(EXPR STICTION_TOGETHER "48 / ${STICTION_CORES}")
endif()
function(compile_together target) # compile_together(TARGET [MOST]): at most MOST files at a time, by default STICTION_TOGETHER
  if(NOT STICTION_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  set(exercised law law_text step_error stepper_audit catalog explain_numbers explain_warnings)
  list(JOIN exercised "|" apart)
  set(others ${sources})
  list(FILTER sources INCLUDE REGEX "/(${apart}).cpp$")
  list(FILTER others EXCLUDE REGEX "/(${apart}).cpp$")
  set_source_files_properties(${sources} PROPERTIES UNITY_GROUP exercised)
  list(LENGTH others count)
  set(most ${STICTION_TOGETHER} ${ARGN})
  list(GET most -1 most)
  math(EXPR texts "(${count} + ${most} - 1) / ${most}") # of like size
  set(k 0)
  foreach(file ${others})
    math(EXPR text "${k} * ${texts} / ${count}")
    set_source_files_properties(${file} PROPERTIES UNITY_GROUP ${text})
    math(EXPR k "${k} + 1")
  endforeach()
endfunction()

function(prefer_what_is_optimized program) # the linker takes the first of several copies of a template
  list(TRANSFORM STICTION_COMPUTES REPLACE "(.+)" "$<TARGET_FILE:stiction_\\1>" OUTPUT_VARIABLE archives)
  target_link_options(${program} PRIVATE -Wl,--whole-archive ${archives} -Wl,--no-whole-archive)
  if(STICTION_SANITIZE)
    target_link_options(${program} PRIVATE -fuse-ld=gold)
  endif()
endfunction()

# Test files keep local names of their own, many of them the same: each stands in a namespace of its part, after all headers.
# Alone stay those that define what belongs to a named namespace or to C.
function(together_in_parts name sources together) # together_in_parts(NAME "FILE..." OUT): OUT: what to compile
  set(alone ${sources})
  if(STICTION_UNITY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources}) # as their headers are read here
    set(alone "")
    set(shared "")
    foreach(file ${sources})
      file(STRINGS ${file} named REGEX "^(namespace stiction|extern \"C\")")
      if(named)
        list(APPEND alone ${file})
      else()
        list(APPEND shared ${file})
      endif()
    endforeach()
    while(shared)
      list(LENGTH alone count)
      list(SUBLIST shared 0 ${STICTION_TOGETHER} files)
      list(REMOVE_ITEM shared ${files})
      set(unit ${CMAKE_CURRENT_BINARY_DIR}/together/${name}_${count}.cpp)
      write_parts(${unit} "${files}")
      list(APPEND alone ${unit})
    endwhile()
  endif()
  set(${together} ${alone} PARENT_SCOPE)
endfunction()

function(write_parts unit files)
  set(headers "")
  set(parts "")
  foreach(file ${files})
    file(STRINGS ${file} included REGEX "^#include")
    list(APPEND headers ${included})
    file(RELATIVE_PATH name ${CMAKE_CURRENT_SOURCE_DIR} ${file})
    string(MAKE_C_IDENTIFIER part_${name} name)
    string(APPEND parts "namespace ${name} {\n#include \"${file}\"\n}\n")
  endforeach()
  list(REMOVE_DUPLICATES headers)
  list(JOIN headers "\n" headers)
  file(CONFIGURE OUTPUT ${unit} CONTENT "${headers}\n${parts}" @ONLY)
endfunction()
