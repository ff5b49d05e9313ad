# overfly_module(NAME SOURCES a.cpp ... [LINKS module ...] [PRIVATE_LINKS library ...])
# One static library for a folder of src/. LINKS are the modules below it whose headers its own headers use;
# PRIVATE_LINKS are the third-party libraries that only its .cpp files see.
function(overfly_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS;PRIVATE_LINKS")
  add_library(overfly_${name} STATIC ${arg_SOURCES})
  list(TRANSFORM arg_LINKS PREPEND overfly_)
  target_link_libraries(overfly_${name} PUBLIC ${arg_LINKS} PRIVATE overfly_options ${arg_PRIVATE_LINKS})
  target_include_directories(overfly_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
endfunction()

# overfly_test(MODULE SOURCES a_test.cpp ... [LINKS target ...])
# One test program for a folder of tests/, each of its cases known to CTest by name.
function(overfly_test module)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS")
  add_executable(overfly_${module}_test ${arg_SOURCES})
  target_include_directories(overfly_${module}_test PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(overfly_${module}_test PRIVATE overfly_${module} overfly_options GTest::gtest_main ${arg_LINKS})
  target_compile_definitions(overfly_${module}_test PRIVATE OVERFLY_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                                            OVERFLY_SHARED_DATA="${OVERFLY_SHARED_DATA}")
  gtest_discover_tests(overfly_${module}_test DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()
