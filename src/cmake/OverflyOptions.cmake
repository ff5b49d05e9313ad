option(OVERFLY_BUILD_TESTS "Build the tests" ON)
option(OVERFLY_BUILD_BENCHMARKS "Build the micro-benchmarks" OFF)
option(OVERFLY_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
set(OVERFLY_SHARED_DATA "" CACHE PATH "Folder of the second suite's elevation data; empty: that suite is off")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

# What every target of the project is compiled with. Contraction is off because predicates of two neighbours must agree to
# the last bit, and a fused multiply-add gives a * b + c a second possible value.
add_library(overfly_options INTERFACE)
target_compile_options(overfly_options INTERFACE -Wall -Wextra -Wshadow -Wconversion -pedantic -Werror -ffp-contract=off)
target_include_directories(overfly_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
if(OVERFLY_SANITIZE)
  target_compile_options(overfly_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                                   -fno-omit-frame-pointer)
  target_link_options(overfly_options INTERFACE -fsanitize=address,undefined)
endif()
