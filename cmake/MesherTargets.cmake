# How every target of the project is compiled, and the one way to declare a folder of the stack.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

add_library(mesher_options INTERFACE)
# A fused multiply-add rounds once where the exactness proofs of the predicates count two roundings.
target_compile_options(mesher_options INTERFACE -ffp-contract=off -Wall -Wextra -Wconversion -Wshadow -Wpedantic)
if(MESHER_WARNINGS_AS_ERRORS)
  target_compile_options(mesher_options INTERFACE -Werror)
endif()
if(MESHER_SANITIZE)
  # The checks left out stand at each pointer and take a quarter to a third of the time of the compiler. AddressSanitizer stops at null
  # pointers and objects that are too small as well; misaligned and wrongly typed pointers go unseen.
  target_compile_options(mesher_options INTERFACE -fsanitize=${MESHER_SANITIZE} -fno-sanitize=null,alignment,object-size,vptr
                         -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(mesher_options INTERFACE -fsanitize=${MESHER_SANITIZE})
endif()

# mesher_precompile(TARGET): the standard headers that nearly every source reads, read once. Reading them takes a builder without
# optimisation up to half its time. The release build does without, so that each source still has to name what it includes.
function(mesher_precompile target)
  if(MESHER_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM mesher_headers)
  endif()
endfunction()

# mesher_layer(NAME SOURCES … USES …): the static library mesher_NAME of the folder MesherCore/NAME.
# USES lists the layers below that it may include; tools/check_layers.py holds the includes to it.
function(mesher_layer name)
  cmake_parse_arguments(LAYER "" "" "SOURCES;USES" ${ARGN})
  add_library(mesher_${name} STATIC ${LAYER_SOURCES})
  target_include_directories(mesher_${name} PUBLIC "${CMAKE_SOURCE_DIR}/MesherCore")
  target_link_libraries(mesher_${name} PUBLIC mesher_options)
  mesher_precompile(mesher_${name})
  foreach(used IN LISTS LAYER_USES)
    target_link_libraries(mesher_${name} PUBLIC mesher_${used})
  endforeach()
endfunction()

# mesher_python_module(NAME OUTPUT name DIRECTORY … SOURCES … USES …): the folder MesherCore/NAME as an extension module
# of Python, held to the layers like any other.
function(mesher_python_module name)
  cmake_parse_arguments(MODULE "" "OUTPUT;DIRECTORY" "SOURCES;USES" ${ARGN})
  pybind11_add_module(mesher_${name} NO_EXTRAS ${MODULE_SOURCES})
  target_link_libraries(mesher_${name} PRIVATE mesher_options)
  target_compile_definitions(mesher_${name} PRIVATE MESHER_VERSION="${PROJECT_VERSION}")
  foreach(used IN LISTS MODULE_USES)
    target_link_libraries(mesher_${name} PRIVATE mesher_${used})
  endforeach()
  set_target_properties(mesher_${name} PROPERTIES OUTPUT_NAME ${MODULE_OUTPUT} LIBRARY_OUTPUT_DIRECTORY "${MODULE_DIRECTORY}")
endfunction()

# It is the core that has to be fast, not the tests, whose compilation takes a third to a half longer with all of the optimiser.
function(mesher_optimise_test name)
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# mesher_test(NAME SOURCES … USES …): a GoogleTest program whose cases are tests of CTest.
function(mesher_test name)
  cmake_parse_arguments(TEST "" "" "SOURCES;USES" ${ARGN})
  add_executable(${name} ${TEST_SOURCES})
  target_link_libraries(${name} PRIVATE mesher_options GTest::gtest_main)
  target_include_directories(${name} PRIVATE "${CMAKE_SOURCE_DIR}/tests")
  target_precompile_headers(${name} REUSE_FROM mesher_test_headers)
  foreach(used IN LISTS TEST_USES)
    target_link_libraries(${name} PRIVATE mesher_${used})
  endforeach()
  mesher_optimise_test(${name})
  # A test that hangs must fail, and long before the run that it is part of is given up.
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 600)
endfunction()
