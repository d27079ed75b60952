# WebAssembly by clang 19 and lld 19, without any C library: see src/base/wasm.
#   cmake -S . -B build/wasm --toolchain cmake/wasm32.cmake -DSKVALP_CORE_ONLY=ON
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_C_COMPILER_TARGET wasm32-unknown-unknown)
set(CMAKE_C_FLAGS_INIT "-nostdlib -msimd128 -mbulk-memory -mmutable-globals -matomics -mnontrapping-fptoint")
# Atomics are instructions like others: it is the linker that makes memory shared.
# Without any optimisation the kernels have more local variables than engines take: 50 000.
set(CMAKE_C_FLAGS_DEBUG_INIT "-O1")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_EXECUTABLE_SUFFIX_C .wasm)
# The linker itself: clang would run wasm-opt over the result if that happens to be installed. The
# stack lies lowest, so that overflowing it traps instead of overwriting data.
set(CMAKE_C_LINK_EXECUTABLE
    "wasm-ld-19 --no-entry --stack-first -z stack-size=262144 <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")
