# libglitterpath.so: all of gp_core behind the C interface. Of whatever it is made, a program that
# links it needs nothing but the header and the library itself.
add_library(glitterpath SHARED ${PROJECT_SOURCE_DIR}/include/glitterpath/glitterpath.h)
set_target_properties(glitterpath PROPERTIES
  LINKER_LANGUAGE CXX
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/glitterpath.map)
target_include_directories(glitterpath INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(glitterpath PRIVATE gp_warnings $<LINK_LIBRARY:WHOLE_ARCHIVE,gp_core>)
target_link_options(glitterpath PRIVATE
  -Wl,--version-script=${PROJECT_SOURCE_DIR}/cmake/glitterpath.map)
if(NOT GP_SANITIZE)
  # Sanitizers' own symbols come with the program; everything else must be there.
  target_link_options(glitterpath PRIVATE -Wl,--no-undefined)
endif()
add_library(glitterpath::glitterpath ALIAS glitterpath)
