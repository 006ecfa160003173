# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT

# cmake -D PROGRAM=... -D EXPECTED=... -P compare_output.cmake: fails unless the program prints the expected file.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed RESULT_VARIABLE status)
file(READ ${EXPECTED} expected)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} failed: ${status}")
elseif(NOT printed STREQUAL expected)
  message(FATAL_ERROR "the output differs.\nExpected (${EXPECTED}):\n${expected}Printed:\n${printed}")
endif()
