# The deterministic core and a program that prints its fingerprints, for compilers and machines without
# ncurses. It uses only the headers of fmt, since the installed library is for the building machine.
find_path(carom_fmt_headers fmt/format.h PATHS /usr/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/headers)
file(CREATE_LINK ${carom_fmt_headers}/fmt ${PROJECT_BINARY_DIR}/headers/fmt SYMBOLIC)
add_library(carom_fmt INTERFACE)
target_include_directories(carom_fmt SYSTEM INTERFACE ${PROJECT_BINARY_DIR}/headers)
target_compile_definitions(carom_fmt INTERFACE FMT_HEADER_ONLY)

carom_layer(geometry)
carom_physics_layer(carom_fmt)
carom_layer(level carom_physics)
carom_layer(game carom_level)
add_executable(carom-fingerprints tests/golden/golden.cpp tests/golden/trace.cpp tests/golden/print_fingerprints.cpp)
target_include_directories(carom-fingerprints PRIVATE tests)
target_link_libraries(carom-fingerprints PRIVATE carom_game)
# Shows whether the options above prevent fused multiply-adds: see .ci/run.
add_library(carom_rotation STATIC EXCLUDE_FROM_ALL tests/golden/rotation.cpp)
