# Writes the shaders as C strings: cmake -DOUTPUT=shaders.c -DINPUTS=a.glsl;b.glsl -P embed.cmake
# "splat.vert.glsl" becomes `const char skv_shader_splat_vert[]`, without comments, indentation,
# and spaces round operators.
set(text "/* Written by embed.cmake from src/render/shaders/. */\n#include \"render/shaders.h\"\n")
foreach(input IN LISTS INPUTS)
    get_filename_component(name ${input} NAME)
    string(REGEX REPLACE "\\.glsl$" "" name ${name})
    string(REPLACE "." "_" name ${name})
    file(READ ${input} glsl)
    string(REGEX REPLACE "[ ]*//[^\n]*" "" glsl "${glsl}")
    string(REGEX REPLACE "\n[ \n]+" "\n" glsl "${glsl}")
    string(REGEX REPLACE " ([=*/<>?:+]+) " "\\1" glsl "${glsl}")
    string(REPLACE ", " "," glsl "${glsl}")
    string(HEX "${glsl}" bytes)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1, " bytes "${bytes}")
    string(APPEND text "\nconst char skv_shader_${name}[] = {${bytes}0};\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
