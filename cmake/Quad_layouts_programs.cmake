# What tests, examples and benchmarks have in common.

set(CGAL_DATA_DIR "$ENV{CGAL_DATA_DIR}" CACHE PATH
    "The folder of CGAL's data, which contains meshes/; runs that need it are skipped without")

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

# Applies to our own sources what a user's project need not bear.
function(quad_layouts_compile_strictly target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Werror)
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
