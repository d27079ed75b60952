# Writes OUTPUT, a C file that holds the scenes of SCENES (a list of JSON files separated by '|', in
# order of presentation) as the table of builtin.h, without indentation.
#   cmake -DSCENES=a.json|b.json -DOUTPUT=builtin_table.c -P builtin.cmake
string(REPLACE "|" ";" scenes "${SCENES}")
set(texts "")
set(table "")
set(number 0)
foreach(scene IN LISTS scenes)
    file(READ "${scene}" json)
    string(REGEX REPLACE "\n +" "\n" json "${json}")
    string(HEX "${json}" hex)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
    string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "    \\1\n"
           bytes "${bytes}")
    string(APPEND texts "static const unsigned char text${number}[] = {\n${bytes}\n};\n\n")
    string(APPEND table "    {{")
    foreach(key name title description)
        string(JSON value GET "${json}" ${key})
        string(REPLACE "\\" "\\\\" value "${value}")
        string(REPLACE "\"" "\\\"" value "${value}")
        string(APPEND table "\"${value}\", ")
    endforeach()
    string(APPEND table "}, text${number}, sizeof text${number}},\n")
    math(EXPR number "${number} + 1")
endforeach()
file(WRITE "${OUTPUT}" "/* Made by builtin.cmake from scenes/. */\n#include \"scene/builtin.h\"\n\n"
     "${texts}const skv_builtin skv_builtins[] = {\n${table}};\n\n"
     "const int skv_builtin_count = ${number};\n")
