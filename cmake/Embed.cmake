# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# hardball_embed(TARGET target NAMESPACE ns FILES file...): embeds files, text or binary and of any size, in a target.
# Its sources then include "<target>_files.hpp", which has for each file a function in the namespace that returns its
# bytes, named after the file with all but letters, digits and underscores replaced by underscores:
# std::string_view ns::report_css(). The assembler reads the files when the target is built, and again when they change;
# that of WebAssembly cannot, so that there they become text of C++.
function(hardball_embed)
  cmake_parse_arguments(PARSE_ARGV 0 embed "" "TARGET;NAMESPACE" "FILES")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(declarations "")
  set(contents "")
  set(paths "")
  foreach(file IN LISTS embed_FILES)
    get_filename_component(path ${file} ABSOLUTE)
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER ${name} function)
    string(MAKE_C_IDENTIFIER ${embed_TARGET}_${name} symbol)
    string(APPEND declarations "
extern \"C\" const char ${symbol}_bytes[];
extern \"C\" const std::uint64_t ${symbol}_size;
/// The bytes of ${name}.
inline std::string_view ${function}() {
  return {${symbol}_bytes, static_cast<std::size_t>(${symbol}_size)};
}
")
    list(APPEND paths ${path})
    if(EMSCRIPTEN)
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
      file(READ ${path} bytes HEX)
      string(LENGTH "${bytes}" digits)
      string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
      string(APPEND contents "
#include <cstdint>
extern \"C\" const char ${symbol}_bytes[];
extern \"C\" const std::uint64_t ${symbol}_size;
const char ${symbol}_bytes[] = \"${bytes}\";
const std::uint64_t ${symbol}_size = ${digits} / 2;
")
      continue()
    endif()
    string(APPEND contents "
asm(\".section .rodata\\n\"
    \".globl ${symbol}_bytes, ${symbol}_size\\n\"
    \".balign 8\\n\"
    \"${symbol}_size: .quad 2f - 1f\\n\"
    \"${symbol}_bytes:\\n\"
    \"1: .incbin \\\"${path}\\\"\\n\"
    \"2: .text\\n\");
")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/${embed_TARGET}_files.hpp @ONLY CONTENT
"#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace @embed_NAMESPACE@ {
@declarations@
}  // namespace @embed_NAMESPACE@
")
  set(source ${folder}/${embed_TARGET}_files.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "@contents@" @ONLY)
  # Link-time optimization does not see what assembly defines.
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS "${paths}" COMPILE_OPTIONS -fno-lto)
  target_sources(${embed_TARGET} PRIVATE ${source})
  target_include_directories(${embed_TARGET} PRIVATE ${folder})
endfunction()
