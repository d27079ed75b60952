# Writes OUTPUT, a C file that holds the scenes of SCENES (a list of JSON files separated by '|', in
# order of presentation) as the table of builtin.h, without indentation, and the pictures they name. If
# ALONE is on, those with bodies, several fluids or a picture have a text that asks for bodies instead.
#   cmake -DSCENES=a.json|b.json -DOUTPUT=builtin_table.c [-DALONE=ON] -P builtin.cmake

# Appends an array of bytes, which are hexadecimal digits here.
function(append_bytes name hex)
    string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
    string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "    \\1\n"
           bytes "${bytes}")
    string(APPEND texts "static const unsigned char ${name}[] = {\n${bytes}\n};\n\n")
    set(texts "${texts}" PARENT_SCOPE)
endfunction()

string(REPLACE "|" ";" scenes "${SCENES}")
set(texts "")
set(table "")
set(number 0)
foreach(scene IN LISTS scenes)
    file(READ "${scene}" json)
    string(JSON picture ERROR_VARIABLE none GET "${json}" world picture)
    set(painted false)
    set(pictured "NULL, 0")
    string(JSON bodies ERROR_VARIABLE no_bodies LENGTH "${json}" bodies)
    string(JSON fluids ERROR_VARIABLE no_fluids LENGTH "${json}" fluids)
    string(REGEX REPLACE "\n +" "\n" text "${json}")
    if(ALONE AND "${none};${no_bodies};${no_fluids}" MATCHES "NOTFOUND")
        set(text "{\"bodies\":[{}]}")
    elseif(none STREQUAL "NOTFOUND")
        get_filename_component(folder "${scene}" DIRECTORY)
        file(READ "${folder}/${picture}" hex HEX)
        append_bytes(picture${number} "${hex}")
        set(painted true)
        set(pictured "picture${number}, sizeof picture${number}")
    endif()
    string(HEX "${text}" hex)
    append_bytes(text${number} "${hex}")
    string(APPEND table "    {{")
    foreach(key name title description)
        string(JSON value GET "${json}" ${key})
        string(REPLACE "\\" "\\\\" value "${value}")
        string(REPLACE "\"" "\\\"" value "${value}")
        string(APPEND table "\"${value}\", ")
    endforeach()
    string(APPEND table "${painted}}, text${number}, sizeof text${number}, ${pictured}},\n")
    math(EXPR number "${number} + 1")
endforeach()
file(WRITE "${OUTPUT}" "/* Made by builtin.cmake from scenes/. */\n#include \"scene/builtin.h\"\n\n"
     "${texts}const skv_builtin skv_builtins[] = {\n${table}};\n\n"
     "const int skv_builtin_count = ${number};\n")
