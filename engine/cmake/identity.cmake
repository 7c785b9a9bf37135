# Bakes version, commit, compiler and flags into stiction_core at every build, recompiling one file on a change.
set(identity_file ${CMAKE_CURRENT_BINARY_DIR}/build_identity.cpp)
string(TOUPPER "${CMAKE_BUILD_TYPE}" identity_type)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${identity_type}}" identity_flags)
add_custom_target(stiction_identity
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DOUTPUT=${identity_file} -DVERSION=${PROJECT_VERSION}
          "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
          "-DFLAGS=${identity_flags} $<JOIN:$<TARGET_PROPERTY:stiction_flags,INTERFACE_COMPILE_OPTIONS>, >"
          -DBUILD_TYPE=${CMAKE_BUILD_TYPE} -P ${CMAKE_CURRENT_SOURCE_DIR}/core/build_identity.cmake
  BYPRODUCTS ${identity_file} COMMENT "Naming this build" VERBATIM)
target_sources(stiction_core PRIVATE ${identity_file})
add_dependencies(stiction_core stiction_identity)
