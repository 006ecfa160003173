# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# cmake -D SOURCE=... -D HEADER=... -P commit.cmake: writes the commit of the source tree to a header, if it changed.
cmake_minimum_required(VERSION 3.22)

# git archive puts the commit here.
string(SUBSTRING "$Format:%H$" 0 12 commit)
if(commit MATCHES "Format")
  set(commit unknown)
  # A repository around the source tree that is not its own has no commit of it.
  execute_process(COMMAND git -C ${SOURCE} rev-parse --show-prefix
                  OUTPUT_VARIABLE prefix RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(status EQUAL 0 AND prefix STREQUAL "")
    execute_process(COMMAND git -C ${SOURCE} describe --always --exclude=* --abbrev=12 --dirty
                    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(described)
      set(commit ${described})
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#pragma once

namespace hardball::cli {

/// The commit that the program was built from.
inline constexpr char kCommit[] = \"@commit@\";

}  // namespace hardball::cli
" @ONLY)
