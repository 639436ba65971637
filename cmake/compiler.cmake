# One interface target carries what every source of the project is compiled with.
add_library(delone_flags INTERFACE)
target_compile_features(delone_flags INTERFACE cxx_std_20)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Two build types of our own beside Release and Debug: optimised with assertions on, and what sanitizers run on.
# (project() has made empty cache entries of their flags by now, so these are plain variables.)
if(NOT CMAKE_CXX_FLAGS_RELWITHASSERTS)
  set(CMAKE_CXX_FLAGS_RELWITHASSERTS "-O2")
endif()
if(NOT CMAKE_CXX_FLAGS_SANITIZE)
  set(CMAKE_CXX_FLAGS_SANITIZE "-O1 -g1")  # quick to compile
endif()

# Exact predicates need every double operation as written: no contraction of a*b+c, no fast-math, no x87.
# Users of the library inherit -ffp-contract=off (CMakeLists.txt): the linker keeps one copy of an inline function, and
# it may be theirs.
target_compile_options(delone_flags INTERFACE -ffp-contract=off)
if(CMAKE_SIZEOF_VOID_P EQUAL 4 AND CMAKE_SYSTEM_PROCESSOR MATCHES "i.86|x86")
  target_compile_options(delone_flags INTERFACE -msse2 -mfpmath=sse)
endif()
if(CMAKE_CXX_FLAGS MATCHES "-ffast-math|-Ofast|-funsafe-math")
  message(FATAL_ERROR "delone decides signs by rounding-error bounds: build it without -ffast-math")
endif()

target_compile_options(delone_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast)
if(DELONE_WARNINGS_AS_ERRORS)
  target_compile_options(delone_flags INTERFACE -Werror)
endif()
target_compile_options(delone_flags INTERFACE $<$<CONFIG:Release>:-O3>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(delone_flags INTERFACE -Wno-pedantic            # __int128
    -Wno-maybe-uninitialized   # g++ 12 mistakes unrolled loops that fill small matrices
    -Wno-restrict)             # and inlined std::string operations (its bug 105651)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(delone_flags INTERFACE -fbracket-depth=1024  # folds over the terms of a determinant
    -Wno-gnu -Wno-pedantic
    -Wno-deprecated-declarations)  # std::stable_partition of g++ 12's library uses what the library deprecates
endif()
if(DELONE_NATIVE)
  target_compile_options(delone_flags INTERFACE -march=native)
endif()
if(DELONE_SANITIZE)
  add_compile_options(-fsanitize=${DELONE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(DELONE_SANITIZE_NOT)
    add_compile_options(-fno-sanitize=${DELONE_SANITIZE_NOT})
  endif()
  add_link_options(-fsanitize=${DELONE_SANITIZE})
endif()
