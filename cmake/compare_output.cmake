# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# cmake -D PROGRAM=... [-D EMULATOR=...] -D EXPECTED=... -P compare_output.cmake: fails unless the program prints the
# expected file. Lines may end as they do in Windows.
execute_process(COMMAND ${EMULATOR} ${PROGRAM} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
string(REPLACE "\r\n" "\n" printed "${printed}")
file(READ ${EXPECTED} expected)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} failed: ${status}")
elseif(NOT printed STREQUAL expected)
  message(FATAL_ERROR "the output differs.\nExpected (${EXPECTED}):\n${expected}Printed:\n${printed}")
endif()
