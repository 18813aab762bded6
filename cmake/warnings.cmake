# gp_warnings: what every target of ours is compiled with, sanitizers included.
add_library(gp_warnings INTERFACE)
target_compile_options(gp_warnings INTERFACE -Wall -Wextra -Wconversion -Wshadow)
if(GP_WERROR)
  target_compile_options(gp_warnings INTERFACE -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12 sees ghosts in an inlined std::string operator+ (its bugs 105329 and 105651), depending
    # even on how long the path of the checkout is: seen, but no reason to fail.
    target_compile_options(gp_warnings INTERFACE -Wno-error=array-bounds -Wno-error=restrict
                                                 -Wno-error=stringop-overflow)
  endif()
endif()
if(GP_SANITIZE)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC 12 sees ghosts in libstdc++'s <regex> and <functional> where it instruments them.
    target_compile_options(gp_warnings INTERFACE -Wno-maybe-uninitialized)
  endif()
  target_compile_options(gp_warnings INTERFACE -fsanitize=${GP_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(gp_warnings INTERFACE -fsanitize=${GP_SANITIZE})
  if(GP_SANITIZE MATCHES "undefined")
    # C callers may put any number into an enum: we read it and then refuse it, as tests do.
    target_compile_options(gp_warnings INTERFACE -fno-sanitize-recover=undefined -fno-sanitize=enum)
  endif()
endif()
if(GP_FUZZ)
  target_compile_options(gp_warnings INTERFACE -fsanitize=fuzzer-no-link)
endif()
