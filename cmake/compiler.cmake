# One interface target carries what every source of the project is compiled with.
add_library(delone_flags INTERFACE)
target_compile_features(delone_flags INTERFACE cxx_std_20)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Exact predicates need every double operation as written: no contraction of a*b+c, no fast-math, no x87.
target_compile_options(delone_flags INTERFACE -ffp-contract=off)
if(CMAKE_CXX_FLAGS MATCHES "-ffast-math|-Ofast|-funsafe-math")
  message(FATAL_ERROR "delone decides signs by rounding-error bounds: build it without -ffast-math")
endif()

target_compile_options(delone_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast -Werror)
target_compile_options(delone_flags INTERFACE $<$<CONFIG:Release>:-O3>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(delone_flags INTERFACE -Wno-pedantic)  # __int128
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(delone_flags INTERFACE -Wno-gnu -Wno-c++20-extensions)
endif()
if(DELONE_NATIVE)
  target_compile_options(delone_flags INTERFACE -march=native)
endif()
if(DELONE_SANITIZE)
  add_compile_options(-fsanitize=${DELONE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${DELONE_SANITIZE})
endif()
