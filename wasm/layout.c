/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* Where the members of the structs of the C API lie in the memory of the module, as package/layout.js has it.
 */
#include <stddef.h>

#include "hardball.h"

#define LIES_AT(type, member, offset) _Static_assert(offsetof(type, member) == (offset), #type "." #member)
#define HAS_SIZE(type, size) _Static_assert(sizeof(type) == (size), #type)

HAS_SIZE(hb_array, 12);
LIES_AT(hb_array, stride, 4);
LIES_AT(hb_array, type, 8);
HAS_SIZE(hb_const_array, 12);
HAS_SIZE(hb_error, 16);
LIES_AT(hb_error, problem, 4);
LIES_AT(hb_error, where, 8);
LIES_AT(hb_error, remedy, 12);
HAS_SIZE(hb_limits, 40);
LIES_AT(hb_limits, until, 8);
LIES_AT(hb_limits, contacts, 16);
LIES_AT(hb_limits, steps, 24);
LIES_AT(hb_limits, stop, 32);
