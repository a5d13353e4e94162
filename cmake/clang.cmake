# The second compiler, for every build that uses it: the presets clang and fuzz, and the clang variants of
# tools/check_determinism (-DCMAKE_TOOLCHAIN_FILE=cmake/clang.cmake).
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_COMPILER clang++)
