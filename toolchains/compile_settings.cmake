# One language level and one set of rules for every target; flight code adds its own.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

find_program(TEDAVIS_CCACHE ccache)
if(TEDAVIS_CCACHE)
  # Objects are the same in every clone and every preset's folder, so the cache must not see where these lie.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${TEDAVIS_CCACHE})
endif()

add_library(tedavis_settings INTERFACE)
target_include_directories(tedavis_settings INTERFACE ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/generated)
# Names of files are those from the root, wherever it lies.
target_compile_options(tedavis_settings INTERFACE -ffile-prefix-map=${CMAKE_SOURCE_DIR}/=)
# No fused multiply-add: shared edges must be bit-equal on every machine.
target_compile_options(tedavis_settings INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                       -Wold-style-cast -Woverloaded-virtual -Wnull-dereference -Werror=return-type)
if(TEDAVIS_SANITIZE)
  # What is TEDAVIS_UNSANITIZED is compiled with the very options of the preset `host`, whose objects the compiler cache then gives.
  set(sanitized $<NOT:$<BOOL:$<TARGET_PROPERTY:TEDAVIS_UNSANITIZED>>>)
  add_compile_options($<${sanitized}:-O1>)
  # The vptr check needs run-time type information, which flight code does not have.
  target_compile_options(tedavis_settings INTERFACE
    "$<${sanitized}:-fsanitize=${TEDAVIS_SANITIZE};-fno-sanitize=vptr;-fno-omit-frame-pointer;-fno-sanitize-recover=all>")
  target_link_options(tedavis_settings INTERFACE -fsanitize=${TEDAVIS_SANITIZE})
endif()

# Flight code: no exceptions, no run-time type information.
add_library(tedavis_flight_settings INTERFACE)
target_link_libraries(tedavis_flight_settings INTERFACE tedavis_settings)
target_compile_options(tedavis_flight_settings INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-fno-exceptions -fno-rtti -fvisibility=hidden -Wconversion -Wno-sign-conversion>)
