# Finds HiGHS by its header and library. Defines the target HiGHS::HiGHS.

find_path(HiGHS_INCLUDE_DIR Highs.h PATH_SUFFIXES highs)
find_library(HiGHS_LIBRARY highs)
mark_as_advanced(HiGHS_INCLUDE_DIR HiGHS_LIBRARY)

if(HiGHS_INCLUDE_DIR AND EXISTS "${HiGHS_INCLUDE_DIR}/HConfig.h")
  file(STRINGS "${HiGHS_INCLUDE_DIR}/HConfig.h" HiGHS_VERSION
       REGEX "^#define HIGHS_VERSION_(MAJOR|MINOR|PATCH) [0-9]+")
  list(TRANSFORM HiGHS_VERSION REPLACE "^.* " "")
  list(JOIN HiGHS_VERSION "." HiGHS_VERSION)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HiGHS REQUIRED_VARS HiGHS_LIBRARY HiGHS_INCLUDE_DIR
                                  VERSION_VAR HiGHS_VERSION)

if(HiGHS_FOUND AND NOT TARGET HiGHS::HiGHS)
  find_package(Threads QUIET)
  add_library(HiGHS::HiGHS UNKNOWN IMPORTED)
  set_target_properties(HiGHS::HiGHS PROPERTIES
    IMPORTED_LOCATION "${HiGHS_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${HiGHS_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "$<TARGET_NAME_IF_EXISTS:Threads::Threads>")
endif()
