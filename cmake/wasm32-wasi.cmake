# WebAssembly with a C library, wasi-libc, for what the core does without: see web/CMakeLists.txt.
#   cmake --preset web
include(${CMAKE_CURRENT_LIST_DIR}/wasm32.cmake)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
string(APPEND CMAKE_C_FLAGS_INIT " -isystem /usr/include/wasm32-wasi")
# Smaller than CMake's own -Os, and still smaller where loops keep their indices instead of a pointer for
# each array.
set(CMAKE_C_FLAGS_MINSIZEREL "-Oz -DNDEBUG -mllvm -disable-lsr" CACHE STRING "Flags of MinSizeRel")
# No host can give the module an assert handler: there are no texts for one.
string(APPEND CMAKE_C_FLAGS_INIT " -DSKV_ASSERT_TRAPS")
set(CMAKE_C_STANDARD_LIBRARIES_INIT
    "-L/usr/lib/wasm32-wasi -lc /usr/lib/llvm-19/lib/clang/19/lib/wasi/libclang_rt.builtins-wasm32.a")
