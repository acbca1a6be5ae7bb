# What tests, examples and benchmarks have in common.

set(CGAL_DATA_DIR "$ENV{CGAL_DATA_DIR}" CACHE PATH
    "The folder of CGAL's data, which contains meshes/; runs that need it are skipped without")

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

# Applies to our own sources what a user's project need not bear; only where tests are built, a warning
# is an error.
function(quad_layouts_compile_strictly target)
  target_compile_options(${target} PRIVATE -Wall -Wextra
                                           $<$<BOOL:${QUAD_LAYOUTS_BUILD_TESTS}>:-Werror>)
endfunction()

# Adds the program `name`, made of `name`.cpp or of another source that is given.
function(quad_layouts_add_program name)
  set(source ${ARGN})
  if(NOT source)
    set(source ${name}.cpp)
  endif()
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE CGAL::Quad_layouts_GLPK)
  if(CGAL_DATA_DIR)
    target_compile_definitions(${name} PRIVATE CGAL_DATA_DIR="${CGAL_DATA_DIR}")
  endif()
  quad_layouts_compile_strictly(${name})
endfunction()

# Adds one program for each of the sources. With CMAKE_UNITY_BUILD they are one program, `all`, because
# most of what is compiled is the library, which is in headers. Either way, the list command_of_NAME
# is what runs NAME.
function(quad_layouts_add_programs all sources)
  set(includes "")
  set(programs "")
  set(calls "")
  foreach(source IN LISTS sources)
    get_filename_component(name "${source}" NAME_WE)
    if(NOT CMAKE_UNITY_BUILD)
      quad_layouts_add_program(${name})
      set(command_of_${name} ${name} PARENT_SCOPE)
      continue()
    endif()
    # each has a namespace of its own, so what they include, and on which conditions, comes first
    file(STRINGS "${source}" directives REGEX "^#")
    list(JOIN directives "\n" directives)
    string(APPEND includes "${directives}\n\n")
    get_filename_component(path "${source}" ABSOLUTE)
    string(APPEND programs "namespace ${name} {\n#include \"${path}\"\n} // namespace ${name}\n\n")
    string(APPEND calls "  if (name == \"${name}\")\n    return run(${name}::main, argc - 1, argv + 1);\n")
    set(command_of_${name} ${all} ${name} PARENT_SCOPE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
  endforeach()
  if(CMAKE_UNITY_BUILD)
    configure_file("${PROJECT_SOURCE_DIR}/cmake/all_programs.cpp.in" ${all}.cpp @ONLY)
    quad_layouts_add_program(${all} "${CMAKE_CURRENT_BINARY_DIR}/${all}.cpp")
  endif()
endfunction()
